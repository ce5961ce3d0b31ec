/* SPDX-License-Identifier: MIT */
/* Self-alignment of all lanes of a batch before the mission. */
#ifndef SCHULER_SCENARIOS_ALIGN_H
#define SCHULER_SCENARIOS_ALIGN_H

#include "mechanization/aligner.h"
#include "mechanization/alignment.h"
#include "scenarios/batch.h"
#include "scenarios/worker.h"

/** The plan's part of it: the truth at the mooring, its steps and records. Nothing when the scenario has
 *  none. *truth is to be freed with the plan.
 *  Errors   SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC */
schuler_status schuler_align_plan(simulation_plan *p, schuler_truth **truth, schuler_error *err);

/** Let the sensors of a batch run through the alignment, and start its navigators with what each lane
 *  finds.
 *  Errors   SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC, SCHULER_ERR_INTERRUPTED */
schuler_status schuler_batch_align(lane_batch_state *b, batch_tick tick, void *user,
                                   schuler_error *err);

/** How the aligner of a plan is set up: records, and the noise that it is to expect. */
schuler_alignment_setup schuler_align_setup(const simulation_plan *p);

#endif

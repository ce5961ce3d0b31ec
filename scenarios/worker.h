/* SPDX-License-Identifier: MIT */
/* One batch of lanes carried through the whole mission. */
#ifndef SCHULER_SCENARIOS_WORKER_H
#define SCHULER_SCENARIOS_WORKER_H

#include "scenarios/comparator.h"
#include "scenarios/plan.h"

/* What a batch yields, lanes in the order of its chunks and of their runs. */
typedef struct {
    lane_metrics *metrics;   /* one per lane                                              */
    double *curve_m2;        /* [chunk][report]: sum over the chunk's runs                */
    schuler_error_row *rows; /* [lane][report + 1], or NULL when not wanted               */
} batch_result;

/* Called after each block: steps done since the last call. Non-zero return stops. */
typedef int (*batch_tick)(void *user, int64_t lane_steps);

/** Simulate batch `index`.
 *  Returned   out, owned by the caller: schuler_batch_free
 *  Errors     SCHULER_ERR_NUMERIC (source, run, time), SCHULER_ERR_MEMORY, SCHULER_ERR_INTERRUPTED
 */
schuler_status schuler_batch_run(const simulation_plan *plan, size_t index, bool rows_wanted,
                                 batch_tick tick, void *user, batch_result *out,
                                 schuler_error *err);
void schuler_batch_free(batch_result *result);

#endif

/* SPDX-License-Identifier: MIT */
/* The work of a simulation, cut up: lanes into chunks, chunks into batches. A chunk is a stretch of
 * runs of one row; sums over runs are taken inside a chunk in run order and then over chunks in
 * order, so a result does not depend on how chunks are shared out. A batch is what one thread
 * carries through the whole mission over one stream of truth. */
#ifndef SCHULER_SCENARIOS_PLAN_H
#define SCHULER_SCENARIOS_PLAN_H

#include "core/truth.h"
#include "scenarios/simulation.h"
#include "scenarios/sources.h"

enum { CHUNK_LANES = 64, BATCH_LANES = 512 };

typedef struct {
    int row; /* index of a source, or plan.rows (all), plan.rows + 1 (none) */
    int first_run, runs;
} lane_chunk;

typedef struct {
    size_t first_chunk, chunks;
    int lanes;
} lane_batch;

typedef struct {
    const schuler_scenario *scenario;
    const schuler_truth *truth;
    schuler_isa isa;
    error_source sources[SOURCES_MAX];
    schuler_rows rows_are;
    int count;  /* sources                                                  */
    int rows;   /* of them, or of groups; 0: only the joint run             */
    bool drawn; /* any of them */
    int64_t steps, report_steps;
    schuler_path align_path;          /* at the mooring                             */
    const schuler_truth *align_truth; /* NULL: no self-alignment                       */
    int64_t align_steps;              /* before the mission, whole records             */
    int record_steps;                 /* between the records that it keeps             */
    size_t reports;                   /* report times, without 0 */
    lane_chunk *chunks;
    lane_batch *batches;
    size_t chunk_count, batch_count;
} simulation_plan;

/** Steps and report times of a plan whose scenario and truth are set.
 *  Errors  SCHULER_ERR_INPUT: shorter than one navigation update */
schuler_status schuler_plan_times(simulation_plan *plan, schuler_error *err);

/** Samples between two holds of the vertical channel, beside those at reports and ends of blocks: whatever the
 *  rate, in a third of a second 1 mg makes half a millimetre. */
int schuler_hold_interval(const simulation_plan *plan);

/** Cut the work. rows_wanted: error rows will be kept for each lane of a batch, so batches must
 *  stay small.
 *  Errors  SCHULER_ERR_MEMORY */
schuler_status schuler_plan_make(simulation_plan *plan, int threads, bool rows_wanted);
void schuler_plan_free(simulation_plan *plan);

/** Rows 0..rows-1 are sources, then all, then none. */
static inline int plan_row_all(const simulation_plan *p)
{
    return p->rows;
}

static inline int plan_row_none(const simulation_plan *p)
{
    return p->rows + 1;
}

/** Whether a row has source i switched on. */
bool plan_enabled(const simulation_plan *p, int row, int source);

/** Choose the rows; sources and scenario are set. */
void schuler_plan_rows(simulation_plan *p, schuler_rows rows);

/** The source that stands for a row: its own, or the first of its group. */
const error_source *schuler_plan_row_source(const simulation_plan *p, int row);

bool schuler_plan_row_drawn(const simulation_plan *p, int row);
void schuler_plan_row_id(const simulation_plan *p, int row, char id[64]);

#endif

/* SPDX-License-Identifier: MIT */
#include "scenarios/plan.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

schuler_status schuler_plan_times(simulation_plan *p, schuler_error *err)
{
    const schuler_scenario *const s = p->scenario;
    const int per_update = s->samples_per_update;
    p->steps = schuler_truth_steps(p->truth) / per_update * per_update;
    if (p->steps < 1)
        return schuler_fail(err, SCHULER_ERR_INPUT, NULL,
                            "the trajectory lasts %.6g s: less than one navigation update",
                            s->path.duration_s);
    const double updates = s->report_s * s->imu.rate_hz / per_update;
    p->report_steps = updates < 1.0 ? per_update : (int64_t)llround(updates) * per_update;
    p->reports = (size_t)((p->steps + p->report_steps - 1) / p->report_steps);
    return SCHULER_OK;
}

int schuler_hold_interval(const simulation_plan *p)
{
    const int update = p->scenario->samples_per_update;
    const int samples = (int)(0.32 * p->scenario->imu.rate_hz) / update * update;
    return samples < update ? update : samples > SCHULER_BLOCK ? SCHULER_BLOCK : samples;
}

/* Whether a source is the first of its group. */
static bool opens_group(const simulation_plan *p, int source)
{
    for (int i = 0; i < source; i++)
        if (strcmp(p->sources[i].group, p->sources[source].group) == 0) return false;
    return true;
}

void schuler_plan_rows(simulation_plan *p, schuler_rows rows)
{
    p->rows_are = rows;
    p->rows = rows == SCHULER_ROWS_NONE ? 0 : p->count;
    if (rows != SCHULER_ROWS_GROUPS) return;
    p->rows = 0;
    for (int i = 0; i < p->count; i++) p->rows += opens_group(p, i);
}

const error_source *schuler_plan_row_source(const simulation_plan *p, int row)
{
    if (p->rows_are != SCHULER_ROWS_GROUPS) return &p->sources[row];
    int i = 0;
    for (int group = -1;; i++) {
        group += opens_group(p, i);
        if (group == row) return &p->sources[i];
    }
}

bool plan_enabled(const simulation_plan *p, int row, int source)
{
    if (row >= p->rows) return row == plan_row_all(p);
    switch (p->rows_are) {
    case SCHULER_ROWS_GROUPS:
        return strcmp(schuler_plan_row_source(p, row)->group, p->sources[source].group) == 0;
    case SCHULER_ROWS_WITHOUT:
        return row != source;
    default:
        return row == source;
    }
}

bool schuler_plan_row_drawn(const simulation_plan *p, int row)
{
    for (int i = 0; i < p->count; i++)
        if (p->sources[i].drawn && plan_enabled(p, row, i)) return true;
    return false;
}

void schuler_plan_row_id(const simulation_plan *p, int row, char id[64])
{
    if (row >= p->rows)
        snprintf(id, 64, "%s", row == plan_row_all(p) ? "all" : "none");
    else if (p->rows_are == SCHULER_ROWS_GROUPS)
        snprintf(id, 64, "%s", schuler_plan_row_source(p, row)->group);
    else
        snprintf(id, 64, "%s%.52s", p->rows_are == SCHULER_ROWS_WITHOUT ? "without " : "",
                 p->sources[row].id);
}

static int row_runs(const simulation_plan *p, int row)
{
    return schuler_plan_row_drawn(p, row) ? p->scenario->runs : 1;
}

/* Time of a lane of this row, in tenths of a nanosecond a step: measured, and only for balance. */
static double lane_cost(const simulation_plan *p, int row)
{
    double cost = 120.0;
    for (int i = 0; i < p->count; i++)
        if (plan_enabled(p, row, i)) cost += 13.0 * p->sources[i].normals;
    return cost;
}

/* A batch is closed before it would cost more than its share, or hold too many lanes. */
static size_t fill_batches(simulation_plan *p, double share, int lanes_max)
{
    size_t n = 0;
    double cost = 0.0;
    for (size_t c = 0; c < p->chunk_count; c++) {
        const lane_chunk *chunk = &p->chunks[c];
        const double more = chunk->runs * lane_cost(p, chunk->row);
        if (n == 0 || cost + more > share || p->batches[n - 1].lanes + chunk->runs > lanes_max) {
            p->batches[n++] = (lane_batch){ .first_chunk = c };
            cost = 0.0;
        }
        p->batches[n - 1].chunks++;
        p->batches[n - 1].lanes += chunk->runs;
        cost += more;
    }
    return n;
}

schuler_status schuler_plan_make(simulation_plan *p, int threads, bool rows_wanted)
{
    size_t count = 0;
    for (int row = 0; row <= plan_row_none(p); row++)
        count += (size_t)(row_runs(p, row) + CHUNK_LANES - 1) / CHUNK_LANES;
    p->chunks = calloc(count, sizeof(*p->chunks));
    p->batches = calloc(count, sizeof(*p->batches));
    if (!p->chunks || !p->batches) return SCHULER_ERR_MEMORY;

    double total = 0.0;
    for (int row = 0; row <= plan_row_none(p); row++) {
        const int runs = row_runs(p, row);
        for (int first = 0; first < runs; first += CHUNK_LANES) {
            const int n = runs - first < CHUNK_LANES ? runs - first : CHUNK_LANES;
            p->chunks[p->chunk_count++] = (lane_chunk){ row, first, n };
            total += n * lane_cost(p, row);
        }
    }
    /* Several batches for each thread, so that the last to finish has not much left to do; but not
     * so small that computing the truth for each begins to count. With error rows kept, 32 MB a
     * batch; but a chunk is not cut, so very many reports take more: 80 bytes a report and lane. */
    const double share = total / (threads == 1 ? 1.0 : 5.0 * threads);
    int lanes_max = BATCH_LANES;
    if (rows_wanted) {
        const size_t row_bytes = (p->reports + 1) * sizeof(schuler_error_row);
        const size_t fit = (32u << 20) / row_bytes;
        if (fit < (size_t)lanes_max) lanes_max = (int)fit;
    }
    p->batch_count = fill_batches(p, share, lanes_max);
    return SCHULER_OK;
}

void schuler_plan_free(simulation_plan *p)
{
    schuler_path_free(&p->align_path);
    free(p->chunks);
    free(p->batches);
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/paired.h"
#include "scenarios/bootstrap.h"
#include "scenarios/metrics.h"
#include <math.h>
#include <stdlib.h>

/* A row that does not depend on the run holds one entry for all of them. */
static double drift(const schuler_budget_row *row, int run, int axis)
{
    const int i = row->runs == 1 ? 0 : run;
    return axis < 0 ? row->drift_mps[i] : fabs(row->axis_mps[axis][i]);
}

/* The statistic of some runs. values and scratch: two a run. */
static double statistic_of(schuler_statistic statistic, const schuler_budget_row *row,
                           const int *run, int n, double *values, double *scratch)
{
    const bool by_axis = statistic == SCHULER_STAT_ONE_AXIS;
    int count = 0;
    for (int i = 0; i < n; i++) {
        if (by_axis)
            for (int a = 0; a < 2; a++) values[count++] = drift(row, run[i], a);
        else
            values[count++] = drift(row, run[i], -1);
    }
    if (statistic == SCHULER_STAT_RMS) return schuler_rms(values, count);
    return schuler_percentile(values, count, schuler_statistic_percentile(statistic), scratch);
}

static double ratio_of(double a, double b)
{
    return b > 0.0 ? a / b : a > 0.0 ? (double)INFINITY : 1.0;
}

schuler_status schuler_compare_paired(schuler_statistic statistic, const schuler_budget_row *a,
                                      const schuler_budget_row *b, schuler_paired *out)
{
    const int n = a->runs > b->runs ? a->runs : b->runs;
    const size_t size = (size_t)n;
    double *const memory = malloc((4 * size + 2 * SCHULER_RESAMPLES) * sizeof(*memory));
    int *const run = malloc(size * sizeof(*run));
    if (!memory || !run) {
        free(memory);
        free(run);
        return SCHULER_ERR_MEMORY;
    }
    double *const values = memory, *const scratch = values + 2 * size;
    double *const ratios = scratch + 2 * size, *const more = ratios + SCHULER_RESAMPLES;
    for (int i = 0; i < n; i++) run[i] = i;
    schuler_paired p = { .confidence = 0.95, .upper = (double)INFINITY };
    p.ratio = ratio_of(statistic_of(statistic, a, run, n, values, scratch),
                       statistic_of(statistic, b, run, n, values, scratch));
    if (!a->drawn && !b->drawn) {
        p.lower = p.upper = p.ratio;
    } else if (n >= SCHULER_VERDICT_RUNS_MIN) {
        const double tail = 0.5 * (1.0 - p.confidence);
        for (int k = 0; k < SCHULER_RESAMPLES; k++) {
            schuler_resample(n, (uint64_t)k, run);
            ratios[k] = ratio_of(statistic_of(statistic, a, run, n, values, scratch),
                                 statistic_of(statistic, b, run, n, values, scratch));
        }
        p.pairs = n;
        p.lower = schuler_percentile(ratios, SCHULER_RESAMPLES, tail, more);
        p.upper = schuler_percentile(ratios, SCHULER_RESAMPLES, 1.0 - tail, more);
    }
    free(memory);
    free(run);
    *out = p;
    return SCHULER_OK;
}

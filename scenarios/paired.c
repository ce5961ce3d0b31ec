/* SPDX-License-Identifier: MIT */
#include "scenarios/paired.h"
#include "scenarios/bootstrap.h"
#include "scenarios/metrics.h"
#include <math.h>
#include <stdlib.h>

/* A row that does not depend on the run holds one entry for all of them. */
static double slope(const schuler_budget_row *row, int run)
{
    return row->slope_mps[row->runs == 1 ? 0 : run];
}

static double statistic_of(schuler_statistic statistic, const double *values, int n,
                           double *scratch)
{
    switch (statistic) {
    case SCHULER_STAT_RMS:
        return schuler_rms(values, n);
    case SCHULER_STAT_R95:
        return schuler_percentile(values, n, 0.95, scratch);
    case SCHULER_STAT_CEP:
        break;
    }
    return schuler_percentile(values, n, 0.50, scratch);
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
    double *const memory = malloc((3 * size + 2 * SCHULER_RESAMPLES) * sizeof(*memory));
    int *const run = malloc(size * sizeof(*run));
    if (!memory || !run) {
        free(memory);
        free(run);
        return SCHULER_ERR_MEMORY;
    }
    double *const x = memory, *const y = x + size, *const scratch = y + size;
    double *const ratios = scratch + size, *const more = ratios + SCHULER_RESAMPLES;
    for (int i = 0; i < n; i++) {
        x[i] = slope(a, i);
        y[i] = slope(b, i);
    }
    schuler_paired p = { .confidence = 0.95,
                         .ratio = ratio_of(statistic_of(statistic, x, n, scratch),
                                           statistic_of(statistic, y, n, scratch)),
                         .upper = (double)INFINITY };
    if (!a->drawn && !b->drawn) {
        p.lower = p.upper = p.ratio;
    } else if (n >= SCHULER_VERDICT_RUNS_MIN) {
        const double tail = 0.5 * (1.0 - p.confidence);
        for (int k = 0; k < SCHULER_RESAMPLES; k++) {
            schuler_resample(n, (uint64_t)k, run);
            for (int i = 0; i < n; i++) {
                x[i] = slope(a, run[i]);
                y[i] = slope(b, run[i]);
            }
            ratios[k] = ratio_of(statistic_of(statistic, x, n, scratch),
                                 statistic_of(statistic, y, n, scratch));
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

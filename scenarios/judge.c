/* SPDX-License-Identifier: MIT */
#include "scenarios/bootstrap.h"
#include "scenarios/metrics.h"
#include <math.h>
#include <stdlib.h>

/* Rms of one resample of the runs. */
static double resampled_rms(const double *squares, int n, uint64_t resample, int *run)
{
    double sum = 0.0;
    schuler_resample(n, resample, run);
    for (int i = 0; i < n; i++) sum += squares[run[i]];
    return sqrt(sum / n);
}

static schuler_status rms_bounds(const schuler_budget_row *all, schuler_judgement *out)
{
    const int n = all->runs;
    const double tail = 0.5 * (1.0 - out->confidence);
    double *squares = malloc(((size_t)n + 2 * SCHULER_RESAMPLES) * sizeof(*squares));
    int *run = malloc((size_t)n * sizeof(*run));
    if (!squares || !run) {
        free(squares);
        free(run);
        return SCHULER_ERR_MEMORY;
    }
    double *resampled = squares + n, *scratch = resampled + SCHULER_RESAMPLES;
    for (int i = 0; i < n; i++) squares[i] = all->slope_mps[i] * all->slope_mps[i];
    for (int k = 0; k < SCHULER_RESAMPLES; k++)
        resampled[k] = resampled_rms(squares, n, (uint64_t)k, run);
    out->lower_mps = schuler_percentile(resampled, SCHULER_RESAMPLES, tail, scratch);
    out->upper_mps = schuler_percentile(resampled, SCHULER_RESAMPLES, 1.0 - tail, scratch);
    free(squares);
    free(run);
    return SCHULER_OK;
}

static schuler_status percentile_bounds(const schuler_budget_row *all, double p,
                                        schuler_judgement *out)
{
    int lower, upper;
    double coverage;
    schuler_order_interval(all->runs, p, out->confidence, &lower, &upper, &coverage);
    double *sorted = malloc((size_t)all->runs * sizeof(*sorted));
    if (!sorted) return SCHULER_ERR_MEMORY;
    (void)schuler_percentile(all->slope_mps, all->runs, p, sorted); /* leaves them in order */
    if (lower > 0) out->lower_mps = sorted[lower - 1];
    if (upper <= all->runs) out->upper_mps = sorted[upper - 1];
    free(sorted);
    return SCHULER_OK;
}

/* Lower and upper bound of the statistic for runs that differ. */
static schuler_status bounds(schuler_statistic statistic, const schuler_budget_row *all,
                             schuler_judgement *out)
{
    out->lower_mps = 0.0; /* a radial slope is never below */
    out->upper_mps = HUGE_VAL;
    if (all->runs < SCHULER_VERDICT_RUNS_MIN) return SCHULER_OK;
    switch (statistic) {
    case SCHULER_STAT_RMS:
        return rms_bounds(all, out);
    case SCHULER_STAT_R95:
        return percentile_bounds(all, 0.95, out);
    case SCHULER_STAT_CEP:
        break;
    }
    return percentile_bounds(all, 0.50, out);
}

schuler_status schuler_judge(const schuler_requirement *requirement, const schuler_budget_row *all,
                             schuler_judgement *out)
{
    const double asked = requirement->confidence;
    schuler_judgement judgement = { .confidence = asked > 0.0 ? asked : 0.95,
                                    .verdict = SCHULER_VERDICT_NONE };
    if (!requirement->given) {
        *out = judgement;
        return SCHULER_OK;
    }
    switch (requirement->statistic) {
    case SCHULER_STAT_CEP:
        judgement.value_mps = all->cep_mps;
        break;
    case SCHULER_STAT_R95:
        judgement.value_mps = all->r95_mps;
        break;
    case SCHULER_STAT_RMS:
        judgement.value_mps = all->rms_slope_mps;
        break;
    }
    if (all->drawn) {
        const schuler_status rc = bounds(requirement->statistic, all, &judgement);
        if (rc != SCHULER_OK) return rc;
    } else {
        judgement.lower_mps = judgement.upper_mps = judgement.value_mps;
    }
    judgement.verdict = judgement.upper_mps <= requirement->drift_mps ? SCHULER_VERDICT_PASS
                        : judgement.lower_mps > requirement->drift_mps
                            ? SCHULER_VERDICT_FAIL
                            : SCHULER_VERDICT_INCONCLUSIVE;
    *out = judgement;
    return SCHULER_OK;
}

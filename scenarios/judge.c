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

/* What a statistic is taken of: the runs' drift, or north and east of each. Returns how many. */
static int values_of(schuler_statistic statistic, const schuler_budget_row *row, double *out)
{
    const int n = row->runs;
    for (int i = 0; i < n; i++) {
        if (statistic != SCHULER_STAT_ONE_AXIS)
            out[i] = row->drift_mps[i];
        else
            for (int a = 0; a < 2; a++) out[2 * i + a] = fabs(row->axis_mps[a][i]);
    }
    return statistic == SCHULER_STAT_ONE_AXIS ? 2 * n : n;
}

double schuler_statistic_percentile(schuler_statistic statistic)
{
    switch (statistic) {
    case SCHULER_STAT_R95:
    case SCHULER_STAT_ONE_AXIS:
        return 0.95;
    case SCHULER_STAT_R99:
        return 0.99;
    default:
        return 0.50;
    }
}

schuler_status schuler_row_required(schuler_budget_row *row, const schuler_requirement *requirement)
{
    double *const values = malloc(4 * (size_t)row->runs * sizeof(*values));
    if (!values) return SCHULER_ERR_MEMORY;
    const int n = values_of(requirement->statistic, row, values);
    row->required_mps =
        requirement->statistic == SCHULER_STAT_RMS
            ? schuler_rms(values, n)
            : schuler_percentile(values, n, schuler_statistic_percentile(requirement->statistic),
                                 values + n);
    free(values);
    return SCHULER_OK;
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
    for (int i = 0; i < n; i++) squares[i] = all->drift_mps[i] * all->drift_mps[i];
    for (int k = 0; k < SCHULER_RESAMPLES; k++)
        resampled[k] = resampled_rms(squares, n, (uint64_t)k, run);
    out->lower_mps = schuler_percentile(resampled, SCHULER_RESAMPLES, tail, scratch);
    out->upper_mps = schuler_percentile(resampled, SCHULER_RESAMPLES, 1.0 - tail, scratch);
    free(squares);
    free(run);
    return SCHULER_OK;
}

/* North and east of a run count as two: a run's two axes are as independent as runs are, when the errors are
 * circular. */
static schuler_status percentile_bounds(schuler_statistic statistic, const schuler_budget_row *all,
                                        schuler_judgement *out)
{
    int lower, upper;
    double coverage;
    double *const values = malloc(4 * (size_t)all->runs * sizeof(*values));
    if (!values) return SCHULER_ERR_MEMORY;
    const int n = values_of(statistic, all, values);
    double *const sorted = values + n;
    const double p = schuler_statistic_percentile(statistic);
    schuler_order_interval(n, p, out->confidence, &lower, &upper, &coverage);
    (void)schuler_percentile(values, n, p, sorted); /* leaves them in order */
    if (lower > 0) out->lower_mps = sorted[lower - 1];
    if (upper <= n) out->upper_mps = sorted[upper - 1];
    free(values);
    return SCHULER_OK;
}

/* Lower and upper bound of the statistic for runs that differ. */
static schuler_status bounds(schuler_statistic statistic, const schuler_budget_row *all,
                             schuler_judgement *out)
{
    out->lower_mps = 0.0; /* a radial slope is never below */
    out->upper_mps = HUGE_VAL;
    if (all->runs < SCHULER_VERDICT_RUNS_MIN) return SCHULER_OK;
    return statistic == SCHULER_STAT_RMS ? rms_bounds(all, out)
                                         : percentile_bounds(statistic, all, out);
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
    judgement.value_mps = all->required_mps;
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

double schuler_runs_to_decide(const schuler_judgement *j, double limit_mps, int runs)
{
    if (!isfinite(j->upper_mps) || j->lower_mps <= 0.0) return fmax(100.0, 2.0 * runs);
    const double gap = fabs(j->value_mps - limit_mps);
    const double width = fmax(j->upper_mps - j->value_mps, j->value_mps - j->lower_mps);
    return gap > 0.0 ? ceil(runs * (width / gap) * (width / gap)) : (double)INFINITY;
}

/* SPDX-License-Identifier: MIT */
/* Drift metrics and their confidence: what the word "nmi/h" means in numbers. */
#ifndef SCHULER_SCENARIOS_METRICS_H
#define SCHULER_SCENARIOS_METRICS_H

#include "scenarios/simulation.h"

SCHULER_BEGIN_C

/** Sample percentile p in (0, 1) of n values (n >= 1), linear between order statistics (type 7);
 * the median of an even number is the mean of the middle two. Values need not be sorted; not
 * changed. scratch: n doubles. */
SCHULER_API double schuler_percentile(const double *values, int n, double p, double *scratch);

/** Distribution-free interval of percentile p from order statistics. Each end takes half of the
 * doubt 1 - confidence (for the median this is the narrowest interval symmetric in rank). Where
 * that half is too little for the end p leans to, but the whole is enough (the 95th percentile
 * of 59..71 runs), that end is the extreme value and the other end takes what is left.
 *  Given      n              1..2^30;  p, confidence  in (0, 1)
 *  Returned   lower, upper   1-based ranks; 0 and n+1 where n is too small for a bound
 *             coverage       sum_{k=lower}^{upper-1} C(n,k) p^k (1-p)^(n-k), at least `confidence`
 *  Cost       of order n; no overflow */
SCHULER_API void schuler_order_interval(int n, double p, double confidence, int *lower, int *upper,
                                        double *coverage);

/** Slope through the origin: sum t r / sum t^2; 0 when there is nothing to fit. */
SCHULER_API double schuler_slope_through_origin(const double *t_s, const double *r_m, size_t n);

/** Root of the mean square; 0 for n = 0. No overflow below the largest double. */
SCHULER_API double schuler_rms(const double *values, int n);

/** Fill the summary members of a row (rms_*, cep, r95) from its per-run arrays.
 *  Errors     SCHULER_ERR_MEMORY, the row then is half filled */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_row_summarise(schuler_budget_row *row);

/** What a percentile statistic is: 0.5 of CEP, 0.95, 0.99. */
SCHULER_API double schuler_statistic_percentile(schuler_statistic statistic);

/** Fill required_mps of a row from its drift_mps and axis_mps.
 *  Errors     SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_row_required(schuler_budget_row *row, const schuler_requirement *requirement);

/* Below this, runs that differ give no verdict: no bounds but 0 and infinity. */
enum { SCHULER_VERDICT_RUNS_MIN = 10 };

/** About how many runs would tell a requirement from the limit: the interval shrinks with their square root.
 *  Given      j     what `runs` runs say
 *  Returned   at least 100 where there is no interval yet; INFINITY where the value is the limit */
SCHULER_API double schuler_runs_to_decide(const schuler_judgement *j, double limit_mps, int runs);

/** Judge a requirement on the drift of the joint runs.
 *  PASS: upper bound <= limit; FAIL: lower bound > limit; else INCONCLUSIVE. Percentiles by order
 *  statistics, rms by a bootstrap over runs (2000 resamples, fixed seed). When nothing was drawn
 *  (all runs the same) the bounds are the value itself. Fewer than SCHULER_VERDICT_RUNS_MIN runs of
 *  drawn sources: INCONCLUSIVE. No requirement given: NONE, values 0.
 *  Given      all     the joint row, summarised, with required_mps of this requirement
 *  Errors     SCHULER_ERR_MEMORY, out untouched */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_judge(const schuler_requirement *requirement,
                                                           const schuler_budget_row *all,
                                                           schuler_judgement *out);

SCHULER_END_C

#endif

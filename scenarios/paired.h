/* SPDX-License-Identifier: MIT */
/* Two navigators on the same mission with the same draws: how many times the one drifts as the other. */
#ifndef SCHULER_SCENARIOS_PAIRED_H
#define SCHULER_SCENARIOS_PAIRED_H

#include "scenarios/simulation.h"

SCHULER_BEGIN_C

typedef struct {
    double ratio, lower, upper; /* INFINITY where the other does not drift */
    double confidence;          /* 0.95 */
    int pairs; /* 0: nothing is drawn or too few runs: the limits are 0 and INFINITY, or
                                   the ratio itself when all runs of both are the same */
} schuler_paired;

/** Ratio of a statistic of the runs' drift, with limits from 2000 resamples of the pairs: what both have in
 *  common does not widen them.
 *  Given      a, b   joint rows of results of the same scenario, seed and number of runs
 *  Errors     SCHULER_ERR_MEMORY, out untouched */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_compare_paired(schuler_statistic statistic,
                                                                    const schuler_budget_row *a,
                                                                    const schuler_budget_row *b,
                                                                    schuler_paired *out);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Resamples of runs, for intervals of statistics that have no other. Private to scenarios. */
#ifndef SCHULER_SCENARIOS_BOOTSTRAP_H
#define SCHULER_SCENARIOS_BOOTSTRAP_H

#include <stdint.h>

enum { SCHULER_RESAMPLES = 2000 };

/** Which runs resample k holds: n of them drawn with replacement, always the same.
 *  Given      n       1..2^17
 *  Returned   run     n indices */
void schuler_resample(int n, uint64_t k, int *run);

#endif

/* SPDX-License-Identifier: MIT */
/* What a source would be worth if it were larger or smaller. */
#ifndef SCHULER_SCENARIOS_SOURCE_SIZE_H
#define SCHULER_SCENARIOS_SOURCE_SIZE_H

#include "scenarios/simulation.h"

SCHULER_BEGIN_C

/** Multiply the value of a source: all its components, fixed or drawn.
 *  Given    id      "gyro.bias"
 *  Errors   SCHULER_ERR_INPUT, with the nearest name: no such source in this scenario, or one without a value
 *           (gravity.disturbance, numerical) */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_source_scale(schuler_scenario *s,
                                                                  const char *id, double factor,
                                                                  schuler_error *err);

/** One sigma, or half of the range, or the value: the largest of the components, SI; and its dimension.
 *  Errors   as above */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_source_size(const schuler_scenario *s,
                                                                 const char *id, double *size,
                                                                 schuler_dim *dim,
                                                                 schuler_error *err);

/** By what a source may be multiplied for the requirement to be just met, the others held: in the sum of
 *  squares of the runs' drift, k^2 = 1 + ((limit/drift)^2 - 1)/share.
 *  Returned   INFINITY: it does not matter; 0: the requirement is just met without it; negative: without it
 *             the requirement is still not met. NAN without a requirement */
SCHULER_API double schuler_source_margin(const schuler_result *result,
                                         const schuler_budget_row *row);

SCHULER_END_C

#endif

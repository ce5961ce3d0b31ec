/* SPDX-License-Identifier: MIT */
/* The chi-square distribution for any real number of degrees of freedom. */
#ifndef SCHULER_SENSORS_CHI_SQUARE_H
#define SCHULER_SENSORS_CHI_SQUARE_H

#include "core/api.h"

SCHULER_BEGIN_C

/** Probability of a value below x (upper = 0) or above x (upper = 1), to about 1e-13.
 *  Domain     dof > 0; x <= 0 gives 0 below and 1 above
 *  Source     regularised incomplete gamma function P(dof/2, x/2): power series and continued
 *             fraction, e.g. M. Abramowitz, I. Stegun, 6.5.29 and 6.5.31 */
SCHULER_API double schuler_chi_square_probability(double dof, double x, int upper);

/** The value with probability p below it, to 1e-10 relative.
 *  Domain     dof > 0, 0 < p < 1; NAN otherwise. Small p of few degrees of freedom underflow to 0. */
SCHULER_API double schuler_chi_square_quantile(double dof, double p);

SCHULER_END_C

#endif

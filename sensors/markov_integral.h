/* SPDX-License-Identifier: MIT */
/* The one function of the Gauss-Markov process that loses its digits, for lane code and all other. */
#ifndef SCHULER_SENSORS_MARKOV_INTEGRAL_H
#define SCHULER_SENSORS_MARKOV_INTEGRAL_H

#include <math.h>

/* 2x - 3 + 4 e^-x - e^-2x: variance of the integral over D = x T given its start, in units of
 * sigma^2 T^2. Divided by x^2 it is the Allan variance over D in units of sigma^2. The closed form
 * loses all digits for small x: series there. At the switch the first term left out and the rounding
 * of the closed form are both below 1e-12 of the sum. */
static inline double markov_q22(double x)
{
    if (x < 2e-2)
        return x * x * x *
               (2.0 / 3.0 +
                x * (-1.0 / 2.0 +
                     x * (7.0 / 30.0 + x * (-1.0 / 12.0 + x * (31.0 / 1260.0 - x / 160.0)))));
    const double one_minus_phi = -expm1(-x);
    return 2.0 * x - one_minus_phi * (2.0 + one_minus_phi);
}

#endif

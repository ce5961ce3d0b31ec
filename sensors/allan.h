/* SPDX-License-Identifier: MIT */
/* Allan variance of recorded rates or increments, and how well it is known.
 *
 *     sigma^2(tau) = < (theta_(k+2m) - 2 theta_(k+m) + theta_k)^2 >/(2 tau^2),   tau = m dt
 *
 * theta is the phase: the angle or velocity, n + 1 values for n samples. */
#ifndef SCHULER_SENSORS_ALLAN_H
#define SCHULER_SENSORS_ALLAN_H

#include "core/error.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum { SCHULER_ALLAN_POINTS_MAX = 128 };

/** Averaging factors on a logarithmic grid: 1, then about per_decade in each decade, up to n/3.
 *  Given      n  samples;  per_decade  1 .. 20;  max  room in m (SCHULER_ALLAN_POINTS_MAX is enough)
 *  Returned   m  increasing; the function returns how many, 0 when n < 3 */
SCHULER_API int schuler_allan_factors(int64_t n, int per_decade, int64_t *m, int max);

/** Samples to phase, their mean removed (it does not enter the Allan variance, but would cost digits).
 *  Given      y      n increments (scale = 1) or rates (scale = dt); may be the same array as phase
 *  Returned   phase  n + 1 values, the first is 0; the function returns the mean of scale y */
SCHULER_API double schuler_allan_phase(const double *y, int64_t n, double scale, double *phase);

/** Overlapping Allan variances, all pairs of neighbouring means of each length.
 *  Given      phase  n + 1 values;  m  count factors, each in 1 .. n/2, at most SCHULER_ALLAN_POINTS_MAX
 *  Returned   sigma2  count variances, the unit of the phase per second, squared
 *  Errors     SCHULER_ERR_INPUT a factor is out of range; SCHULER_ERR_INTERRUPTED (stop may be NULL)
 *  Source     W. J. Riley, NIST SP 1065; D. Howe, D. Allan, J. Barnes, 1981 */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_allan_overlapping(const double *phase,
                                                                       int64_t n, double dt_s,
                                                                       const int64_t *m, int count,
                                                                       double *sigma2,
                                                                       const volatile int *stop);

/** The same of adjacent means only, the original definition. NAN when m is not in 1 .. n/2. */
SCHULER_API double schuler_allan_plain(const double *phase, int64_t n, double dt_s, int64_t m);

typedef enum {
    SCHULER_NOISE_QUANTIZATION,
    SCHULER_NOISE_WHITE,
    SCHULER_NOISE_FLICKER,
    SCHULER_NOISE_RANDOM_WALK,
    SCHULER_NOISE_KINDS,
} schuler_noise_kind;

/** The kind whose Allan variance has the slope d ln sigma^2/d ln tau nearest to this: -2, -1, 0, 1. */
SCHULER_API schuler_noise_kind schuler_noise_of_slope(double slope);

/** Equivalent degrees of freedom of an overlapping Allan variance, good to about 5 %.
 *  Given      points  phase values, n + 1;  m  averaging factor, 1 .. n/3
 *  Source     D. Howe, D. Allan, J. Barnes, Proc. 35th Freq. Control Symp., 1981; NIST SP 1065 */
SCHULER_API double schuler_allan_dof(schuler_noise_kind kind, int64_t points, int64_t m);

/** Confidence limits of a variance that has so many degrees of freedom.
 *  Given      level   0.95: both limits together
 *  Returned   limits  lower and upper */
SCHULER_API void schuler_allan_limits(double sigma2, double dof, double level, double limits[2]);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Power spectral density of recorded rates, by Welch's method: Hann window, segments that overlap by
 * half, the mean of each segment removed.
 *
 * Densities are two-sided, S(f) = S(-f), of which the bins from 0 to half the sampling rate are given:
 * the variance is the integral over negative and positive frequencies, white noise of random walk
 * coefficient N has S = N^2. The one-sided density of most data sheets is twice that.
 *  Source    P. D. Welch, IEEE Trans. Audio Electroacoust. 15(2), 1967 */
#ifndef SCHULER_SENSORS_SPECTRUM_H
#define SCHULER_SENSORS_SPECTRUM_H

#include "core/error.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum { SCHULER_SEGMENT_MIN = 8, SCHULER_SEGMENT_MAX = 1 << 24 };

/** A segment length for n samples: the largest power of two up to n/8 and to 2^18, at least 8; 0 when
 *  there are fewer than 8 samples. */
SCHULER_API int schuler_spectrum_segment(int64_t n);

/** Given      y        n samples of the rate, or of increments (then scale = 1/dt)
 *             segment  even, in SCHULER_SEGMENT_MIN .. SCHULER_SEGMENT_MAX, at most n; fast when its
 *                      only factors are 2, 3 and 5
 *             stop     or NULL
 *  Returned   density  segment/2 + 1 values at k/(segment dt), unit of scale y squared per Hz. The
 *                      transform is in single precision: what is 1e-13 of the strongest is noise.
 *                      The window spreads the first and last bins; a sinusoid of amplitude A has the
 *                      power A^2/4 around each of its two frequencies.
 *  Errors     SCHULER_ERR_INPUT segment; SCHULER_ERR_MEMORY; SCHULER_ERR_INTERRUPTED */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_spectrum_welch(const double *y, int64_t n,
                                                                    double dt_s, double scale,
                                                                    int segment, double *density,
                                                                    const volatile int *stop);

typedef struct {
    double f_hz, density; /* mean frequency and mean density of its bins */
    int bins;
} schuler_spectrum_point;

/** Bins averaged to a logarithmic grid; the bin at 0 Hz is left out.
 *  Given      bins  count of density;  step_hz  between them;  max  room in out
 *  Returned   the number of points, at most per_decade in each decade */
SCHULER_API int schuler_spectrum_log_bins(const double *density, int bins, double step_hz,
                                          int per_decade, schuler_spectrum_point *out, int max);

SCHULER_END_C

#endif

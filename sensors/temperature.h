/* SPDX-License-Identifier: MIT */
/* The temperature of the instruments over the mission. */
#ifndef SCHULER_SENSORS_TEMPERATURE_H
#define SCHULER_SENSORS_TEMPERATURE_H

#include "core/api.h"
#include <stddef.h>

SCHULER_BEGIN_C

/* Either straight lines between points in order of time (constant before the first and after the
 * last), or, without points, a warm-up T = end - (end - start) exp(-t/time). */
typedef struct {
    double
        reference_K; /* where the coefficients of the sensors are zero; same scale as the others */
    size_t count;
    const double *at_s, *is_K; /* borrowed */
    double start_K, end_K, time_s;
} schuler_temperature;

/** Temperature above the reference, K, and its rate of change, K/s (at a corner: of the line that
 *  begins there). */
SCHULER_API double schuler_temperature_at(const schuler_temperature *t, double t_s,
                                          double *rate_Kps);

SCHULER_END_C

#endif

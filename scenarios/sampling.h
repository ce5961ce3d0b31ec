/* SPDX-License-Identifier: MIT */
/* Time stamps of recorded samples: does one follow the other by the interval? */
#ifndef SCHULER_SCENARIOS_SAMPLING_H
#define SCHULER_SCENARIOS_SAMPLING_H

#include "core/error.h"
#include <stddef.h>

typedef enum {
    SAMPLING_NEXT,     /* between half and one and a half intervals later */
    SAMPLING_REPEATED, /* the same time                                   */
    SAMPLING_BACKWARD,
    SAMPLING_SOON, /* later by half an interval at most               */
    SAMPLING_GAP
} sampling_step;

sampling_step sampling_step_of(double before_s, double t_s, double interval_s);

/** What is wrong, in words. step is not SAMPLING_NEXT. */
void sampling_describe(char *text, size_t size, sampling_step step, double before_s, double t_s,
                       double interval_s);

/** Median of a few steps; puts them in order. count > 0. */
double sampling_median(double *steps_s, int count);

#endif

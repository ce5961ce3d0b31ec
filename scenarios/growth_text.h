/* SPDX-License-Identifier: MIT */
/* What to say of a source's growth: laws in words and formulas. In them t is the time, b (N, K, ...) the
 * value, g gravity, R the earth's radius, w = sqrt(g/R) = 2 pi/84.4 min, W the earth's rate, L the
 * latitude. Level: an axis in the horizontal plane. */
#ifndef SCHULER_SCENARIOS_GROWTH_TEXT_H
#define SCHULER_SCENARIOS_GROWTH_TEXT_H

#include "sensors/model.h"

SCHULER_BEGIN_C

typedef struct {
    const char
        *process;      /* how it behaves in time, or on what it acts                             */
    const char *first; /* position error while t is short against the Schuler period             */
    const char *later; /* beyond: bounded, drifting, or walking                                  */
    const char
        *depends; /* on latitude, heading, motion                                           */
} schuler_growth_text;

/* An error source that is no parameter of a sensor. */
typedef struct {
    const char *id, *doc, *formula, *example;
    schuler_growth_text text;
} schuler_growth_other;

/** Of a parameter of a triad that acts in this way; NULL for a setting. */
SCHULER_API const schuler_growth_text *schuler_growth_text_of(schuler_instrument instrument,
                                                              schuler_acts acts);
/** The others: initial.position, .velocity, .tilt, .heading, in this order, gravity.disturbance,
 *  numerical, baro.* in the order of schuler_baro_error; ended by id NULL. */
SCHULER_API const schuler_growth_other *schuler_growth_others(void);

/** Where the laws can be read up. */
SCHULER_API const char *schuler_growth_source(void);

SCHULER_END_C

#endif

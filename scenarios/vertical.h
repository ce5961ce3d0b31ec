/* SPDX-License-Identifier: MIT */
/* The vertical channels of the lanes of a batch under `vertical: baro`: each lane has a barometer
 * with the errors of its row and run, and a loop that follows it. Scalar code, some three times a
 * second: the same bits at any width. */
#ifndef SCHULER_SCENARIOS_VERTICAL_H
#define SCHULER_SCENARIOS_VERTICAL_H

#include "mechanization/mechanization.h"
#include "mechanization/vertical.h"
#include "sensors/barometer.h"

typedef struct {
    barometer sensor;
    schuler_baro_loop loop;
} vertical_lane;

/* The same for all lanes. */
typedef struct {
    schuler_baro_gains gains;
    double interval_s;
    int width; /* lanes in a vector */
} vertical_setup;

/** Samples between two updates: a third of a second at most, unless a navigation update takes longer,
 *  and a power of two that a block is a multiple of, so that updates do not depend on how a mission is
 *  cut. */
int schuler_vertical_interval(double rate_hz, int samples_per_update);

/** After the navigators' init; the lanes' barometers are started. */
void schuler_vertical_start(const vertical_setup *setup, const schuler_mechanization *frame,
                            const void *nav, vertical_lane *lanes, double true_height_m);

/** Update number k = 1, 2, ... of one vector. */
void schuler_vertical_update(const vertical_setup *setup, const schuler_mechanization *frame,
                             void *nav, vertical_lane *lanes, uint64_t k, double true_height_m);

#endif

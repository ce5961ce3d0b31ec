/* SPDX-License-Identifier: MIT */
#include "scenarios/vertical.h"
#include "core/truth.h"

enum { LANES_MAX = 8 };

int schuler_vertical_interval(double rate_hz, int samples_per_update)
{
    int samples = samples_per_update;
    while (2 * samples <= SCHULER_BLOCK && 2 * samples <= 0.32 * rate_hz) samples *= 2;
    return samples;
}

void schuler_vertical_start(const vertical_setup *setup, const schuler_mechanization *frame,
                            const void *nav, vertical_lane *lanes, double true_height_m)
{
    double height_m[LANES_MAX] __attribute__((aligned(64)));
    frame->height(nav, height_m);
    for (int l = 0; l < setup->width; l++) {
        const double reading_m = schuler_barometer_read(&lanes[l].sensor, 0, true_height_m);
        lanes[l].loop = (schuler_baro_loop){ .e_m = height_m[l] - reading_m };
    }
}

void schuler_vertical_update(const vertical_setup *setup, const schuler_mechanization *frame,
                             void *nav, vertical_lane *lanes, uint64_t k, double true_height_m)
{
    double height_m[LANES_MAX] __attribute__((aligned(64)));
    double dh_m[LANES_MAX] __attribute__((aligned(64)));
    double dv_mps[LANES_MAX] __attribute__((aligned(64)));
    frame->height(nav, height_m);
    for (int l = 0; l < setup->width; l++) {
        const double e_m = height_m[l] - schuler_barometer_read(&lanes[l].sensor, k, true_height_m);
        schuler_baro_update(&lanes[l].loop, &setup->gains, setup->interval_s, e_m, &dh_m[l],
                            &dv_mps[l]);
    }
    frame->correct_vertical(nav, dh_m, dv_mps);
}

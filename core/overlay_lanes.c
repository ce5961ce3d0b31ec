/* SPDX-License-Identifier: MIT */
#include "core/overlay_lanes.h"
#include "core/lanes.h"

enum { PARTS = OVERLAY_COLUMNS / SCHULER_LANES };

LANES_INLINE lanes power_series(const double *c, int terms, lanes x)
{
    lanes sum = lanes_set(c[terms - 1]);
    for (int k = terms - 2; k >= 0; k--) sum = sum * x + c[k];
    return sum;
}

/* Of a phase in turns. A quarter of the reduced angle lies within pi/4, where the first dropped terms are
 * below 5e-17; doubled twice, 1e-15 is left. */
LANES_INLINE void sine_cosine(lanes turns, lanes *sine, lanes *cosine)
{
    static const double of_sine[] = { 1.0,
                                      -1.0 / 6.0,
                                      1.0 / 120.0,
                                      -1.0 / 5040.0,
                                      1.0 / 362880.0,
                                      -1.0 / 39916800.0,
                                      1.0 / 6227020800.0,
                                      -1.0 / 1307674368000.0 };
    static const double of_cosine[] = { 1.0,
                                        -1.0 / 2.0,
                                        1.0 / 24.0,
                                        -1.0 / 720.0,
                                        1.0 / 40320.0,
                                        -1.0 / 3628800.0,
                                        1.0 / 479001600.0,
                                        -1.0 / 87178291200.0,
                                        1.0 / 20922789888000.0 };
    const lanes phi = (turns - lanes_round(turns)) * lanes_set(1.57079632679489661923);
    const lanes q = phi * phi;
    const lanes s = phi * power_series(of_sine, 8, q), c = power_series(of_cosine, 9, q);
    const lanes s2 = (s + s) * c, c2 = lanes_set(1.0) - (s + s) * s;
    *sine = (s2 + s2) * c2;
    *cosine = lanes_set(1.0) - (s2 + s2) * s2;
}

static double added(const lanes part[PARTS])
{
    double x[OVERLAY_COLUMNS];
    memcpy(x, part, sizeof x);
    return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

static void sum(const overlay_columns *g, double dt_s, double x[OVERLAY_CHANNELS],
                double x_dot[OVERLAY_CHANNELS])
{
    lanes value[OVERLAY_CHANNELS][PARTS], slope[OVERLAY_CHANNELS][PARTS];
    for (int c = g->first; c < g->end; c++)
        for (int p = 0; p < PARTS; p++) value[c][p] = slope[c][p] = lanes_set(0.0);
    for (size_t i = 0; i < g->count; i += OVERLAY_COLUMNS)
        for (int p = 0; p < PARTS; p++) {
            const size_t at = i + (size_t)p * SCHULER_LANES;
            const lanes f = lanes_load(&g->frequency_Hz[at]);
            const lanes omega = f * lanes_set(6.28318530717958647693);
            lanes sine, cosine;
            sine_cosine(lanes_load(&g->base_turns[at]) + f * dt_s, &sine, &cosine);
            for (int c = g->first; c < g->end; c++) {
                const lanes a = lanes_load(&g->in_phase[c][at]);
                const lanes b = lanes_load(&g->in_quadrature[c][at]);
                value[c][p] += a * cosine + b * sine;
                slope[c][p] += omega * (b * cosine - a * sine);
            }
        }
    for (int c = g->first; c < g->end; c++) {
        x[c] = added(value[c]);
        x_dot[c] = added(slope[c]);
    }
}

extern const overlay_lanes SCHULER_LANE_NAME(schuler_overlay_lanes);
const overlay_lanes SCHULER_LANE_NAME(schuler_overlay_lanes) = { .sum = sum };

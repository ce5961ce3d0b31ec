/* SPDX-License-Identifier: MIT */
/* Slowly wandering biases: first-order Gauss-Markov and random walk. Both follow one recursion,
 * exact in distribution for the bias b and for its integral I over an interval D:
 *
 *     b' = phi b + l11 w1         I = gain b + l21 w1 + l22 w2
 *
 * Gauss-Markov (sigma, T), x = D/T:  phi = e^-x, gain = T (1 - phi), q11 = sigma^2 (1 - phi^2),
 *   q12 = sigma^2 T (1 - phi)^2, q22 = sigma^2 T^2 (2x - 3 + 4 phi - phi^2), l = Cholesky factor
 *   of q; stationary start.
 * Random walk (K):  phi = 1, gain = D, l11 = K sqrt(D), l21 = K D^1.5 / 2,
 *   l22 = K D^1.5 / sqrt(12); starts at zero.
 * Source: R. G. Brown, P. Y. C. Hwang, on exact discretisation; re-derived, and tested against the
 * integrals by Monte Carlo.
 *
 * D is a whole number of samples ("slow step"): the bias and its integral are exact at the ends of
 * slow steps, and within one the increment is spread evenly over its samples. */
#ifndef SCHULER_SENSORS_DRIFT_H
#define SCHULER_SENSORS_DRIFT_H

#include "core/normal.h"
#include "core/truth.h"
#include "sensors/drift_integral.h"
#include "sensors/setup.h"
#include <assert.h>
#include <math.h>

enum {
    DRIFT_PACE_MAX = 8
}; /* divides SCHULER_BLOCK; with it a block has at least two slow steps */

typedef struct {
    lanes b[3]; /* bias at the end of the last slow step: rad/s, m/s^2 */
    lanes phi[3], gain[3], l11[3], l21[3], l22[3];
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int pace; /* samples in a slow step */
    int active;
} bias_drift;

/* The longest slow step of 1, 2, 4 or 8 samples that is no longer than a tenth of a second and a
 * twentieth of the correlation time (0 = none). */
LANES_INLINE int drift_pace(double dt_s, double shortest_s)
{
    int pace = 1;
    while (pace < DRIFT_PACE_MAX && 2 * pace * dt_s <= 0.1 &&
           (shortest_s <= 0.0 || 2 * pace * dt_s <= shortest_s / 20.0))
        pace *= 2;
    return pace;
}

LANES_INLINE void drift_setup_common(bias_drift *d, const schuler_model_setup *s, int param,
                                     unsigned number, int pace)
{
    d->run = setup_runs(s);
    d->seed = s->seed;
    d->number = number;
    d->active = setup_any(s, param, 3);
    d->pace = pace;
}

LANES_INLINE void gauss_markov_setup(bias_drift *d, const schuler_model_setup *s, int param,
                                     int time_param, unsigned number)
{
    double shortest_s = INFINITY;
    for (int l = 0; l < SCHULER_LANES; l++)
        for (int i = 0; i < 3; i++) shortest_s = fmin(shortest_s, setup_lane(s, l, time_param, i));
    drift_setup_common(d, s, param, number, drift_pace(s->dt_s, shortest_s));
    const double D = d->pace * s->dt_s;
    for (int i = 0; i < 3; i++) {
        /* The correlation time is a setting, the same in every lane. */
        const double T = setup_setting(s, time_param, i), x = D / T;
        const double phi = exp(-x), one_minus_phi = -expm1(-x);
        const double l11 = sqrt(-expm1(-2.0 * x));
        const double l21 = T * one_minus_phi * one_minus_phi / l11;
        const double l22 = sqrt(fmax(0.0, T * T * drift_q22(x) - l21 * l21));
        const lanes sigma = setup_value(s, param, i);
        d->phi[i] = lanes_set(phi);
        d->gain[i] = lanes_set(T * one_minus_phi);
        d->l11[i] = sigma * lanes_set(l11);
        d->l21[i] = sigma * lanes_set(l21);
        d->l22[i] = sigma * lanes_set(l22);
        lanes start[4];
        lanes_normals(d->seed, d->run, stream_counter(number, (unsigned)i, SCHULER_USE_START), 0, 1,
                      start);
        d->b[i] = sigma * start[0];
    }
}

LANES_INLINE void random_walk_setup(bias_drift *d, const schuler_model_setup *s, int param,
                                    unsigned number)
{
    drift_setup_common(d, s, param, number, drift_pace(s->dt_s, 0.0));
    const double D = d->pace * s->dt_s, root = sqrt(D);
    for (int i = 0; i < 3; i++) {
        const lanes K = setup_value(s, param, i);
        d->phi[i] = lanes_set(1.0);
        d->gain[i] = lanes_set(D);
        d->l11[i] = K * lanes_set(root);
        d->l21[i] = K * lanes_set(0.5 * D * root);
        d->l22[i] = K * lanes_set(D * root / sqrt(12.0));
        d->b[i] = lanes_set(0.0);
    }
}

/* Numbers 2j and 2j+1 of the stream of an axis belong to slow step j. Blocks start on a slow step.
 */
LANES_INLINE void drift_add(bias_drift *d, const schuler_model_block *b)
{
    if (!d->active) return;
    const int slow = (b->n + d->pace - 1) / d->pace;
    const uint64_t first = (uint64_t)b->first / (uint64_t)d->pace;
    const lanes share = lanes_set(1.0 / d->pace);
    for (int i = 0; i < 3; i++) {
        lanes normal[LANES_NORMALS_MAX];
        lanes_normals(d->seed, d->run, stream_counter(d->number, (unsigned)i, SCHULER_USE_SLOW),
                      first / 2, (slow + 1) / 2, normal);
        double *out = b->out + i * b->stride * SCHULER_LANES;
        lanes bias = d->b[i];
        for (int j = 0; j < slow; j++) {
            const lanes w1 = normal[2 * j], w2 = normal[2 * j + 1];
            const lanes each = (d->gain[i] * bias + (d->l21[i] * w1 + d->l22[i] * w2)) * share;
            bias = d->phi[i] * bias + d->l11[i] * w1;
            const int end = (j + 1) * d->pace < b->n ? (j + 1) * d->pace : b->n;
            for (int k = j * d->pace; k < end; k++)
                lanes_store(out + k * SCHULER_LANES, lanes_load(out + k * SCHULER_LANES) + each);
        }
        d->b[i] = bias;
    }
}

static_assert(SCHULER_BLOCK % (2 * DRIFT_PACE_MAX) == 0, "a block is a whole number of calls");
static_assert(2 * SCHULER_BLOCK <= LANES_NORMALS_MAX, "a block's drives fit in one call");

#endif

/* SPDX-License-Identifier: MIT */
/* Random walk of the bias on lanes, db/dt = K w, exact in its increments with one random number a
 * sample: with b~ the best estimate of the bias from the increments so far, in units of K sqrt(dt),
 * and p the variance of its error, the next increment, in units of K dt^1.5, is
 *
 *     I = b~ + s e,   b~' = b~ + g e,   s^2 = p + 1/3,  g = (p + 1/2)/s,  p' = p + 1 - g^2
 *
 * (the Kalman filter of b and its integral in innovations form; e white, N(0, 1)). The walk starts at
 * zero, p = 0; p settles at 1/sqrt(12) by a factor of 0.07 each step. */
#ifndef SCHULER_SENSORS_WALK_H
#define SCHULER_SENSORS_WALK_H

#include "core/normal.h"
#include "core/truth.h"
#include "sensors/setup.h"
#include <assert.h>
#include <math.h>

enum { WALK_SETTLING = 16 }; /* 0.07^16 is below the rounding of 1 */

typedef struct {
    lanes scale[3], b[3]; /* K dt^1.5; estimate in the units above */
    double s[WALK_SETTLING], g[WALK_SETTLING];
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int active;
} random_walk;

LANES_INLINE void walk_setup(random_walk *w, const schuler_model_setup *setup, int param,
                             unsigned number)
{
    double p = 0.0;
    for (int k = 0; k < WALK_SETTLING; k++) {
        w->s[k] = sqrt(p + 1.0 / 3.0);
        w->g[k] = (p + 0.5) / w->s[k];
        p += 1.0 - w->g[k] * w->g[k];
    }
    for (int i = 0; i < 3; i++) {
        w->scale[i] = setup_value(setup, param, i) * lanes_set(setup->dt_s * sqrt(setup->dt_s));
        w->b[i] = lanes_set(0.0);
    }
    w->run = setup_runs(setup);
    w->seed = setup->seed;
    w->number = number;
    w->active = setup_any(setup, param, 3);
}

/* Number k of the stream of an axis belongs to step k. */
LANES_INLINE void walk_add(random_walk *w, const schuler_model_block *b)
{
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        lanes e[SCHULER_BLOCK];
        lanes_normals(w->seed, w->run, stream_counter(w->number, (unsigned)axis, SCHULER_USE_SLOW),
                      (uint64_t)b->first / 4, (b->n + 3) / 4, e);
        for (int k = 0; k < b->n; k++) {
            const int64_t step = b->first + k;
            const int at = step < WALK_SETTLING ? (int)step : WALK_SETTLING - 1;
            const lanes I = w->b[axis] + lanes_set(w->s[at]) * e[k];
            w->b[axis] += lanes_set(w->g[at]) * e[k];
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + w->scale[axis] * I);
        }
    }
}

static_assert(SCHULER_BLOCK % 4 == 0 && (int)SCHULER_BLOCK <= (int)LANES_NORMALS_MAX,
              "numbers of a block are whole calls");

#endif

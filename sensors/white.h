/* SPDX-License-Identifier: MIT */
/* White noise of the rate, seen in increments: N sqrt(dt) w each step, N the random-walk
 * coefficient. Source: IEEE Std 952-1997 annex C (angle random walk); two-sided convention, N =
 * sqrt(S). */
#ifndef SCHULER_SENSORS_WHITE_H
#define SCHULER_SENSORS_WHITE_H

#include "core/normal.h"
#include "sensors/setup.h"
#include <math.h>

typedef struct {
    lanes sigma[3]; /* N sqrt(dt) per axis: rad or m/s */
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int active;
} white_noise;

LANES_INLINE void white_setup(white_noise *w, const schuler_model_setup *s, int param,
                              unsigned number)
{
    const lanes root_dt = lanes_set(sqrt(s->dt_s));
    for (int i = 0; i < 3; i++) {
        double gain[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) gain[l] = 1.0 + s->specs[l].noise_excess[i];
        w->sigma[i] = setup_value(s, param, i) * root_dt * lanes_load(gain);
    }
    w->run = setup_runs(s);
    w->seed = s->seed;
    w->number = number;
    w->active = setup_any(s, param, 3);
}

/* Number k of the stream of an axis belongs to step k: four steps share one call of the generator.
 */
LANES_INLINE void white_add(const white_noise *w, const schuler_model_block *b)
{
    if (!w->active) return;
    lanes normal[LANES_NORMALS_MAX];
    const int calls = (b->n + 3) / 4;
    for (int i = 0; i < 3; i++) {
        double *out = b->out + i * b->stride * SCHULER_LANES;
        lanes_normals(w->seed, w->run, stream_counter(w->number, (unsigned)i, SCHULER_USE_WHITE),
                      (uint64_t)b->first / 4, calls, normal);
        for (int k = 0; k < b->n; k++)
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + w->sigma[i] * normal[k]);
    }
}

#endif

/* SPDX-License-Identifier: MIT */
/* First-order Gauss-Markov processes on lanes: one, or the sum of a bank of them, added to increments
 * by the exact filter of sensors/markov_filter.h. */
#ifndef SCHULER_SENSORS_MARKOV_H
#define SCHULER_SENSORS_MARKOV_H

#include "core/normal.h"
#include "core/truth.h"
#include "sensors/markov_filter.h"
#include "sensors/setup.h"
#include <assert.h>

typedef struct {
    schuler_markov_filter filter[3];
    lanes scale[3]; /* of the lane: the filter's unit in rad or m/s */
    lanes x[3][SCHULER_MARKOV_MAX];
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int active;
} markov_noise;

LANES_INLINE void markov_setup(markov_noise *m, const schuler_model_setup *s, int param,
                               unsigned number)
{
    m->run = setup_runs(s);
    m->seed = s->seed;
    m->number = number;
    m->active = setup_any(s, param, 3);
    for (int i = 0; i < 3; i++) m->scale[i] = setup_value(s, param, i);
}

/* The filter of an axis, and its stationary start: number j of the stream of the start belongs to
 * member j. */
LANES_INLINE void markov_setup_axis(markov_noise *m, int axis, const schuler_markov_filter *filter)
{
    double l[SCHULER_MARKOV_MAX][SCHULER_MARKOV_MAX];
    lanes w[SCHULER_MARKOV_MAX];
    m->filter[axis] = *filter;
    schuler_markov_filter_start(filter, l);
    lanes_normals(m->seed, m->run, stream_counter(m->number, (unsigned)axis, SCHULER_USE_START), 0,
                  (filter->members + 3) / 4, w);
    for (int i = 0; i < filter->members; i++) {
        lanes sum = lanes_set(0.0);
        for (int j = 0; j <= i; j++) sum += lanes_set(l[i][j]) * w[j];
        m->x[axis][i] = sum;
    }
}

/* One member of one axis in a register. */
typedef struct {
    lanes x, phi, feed;
} markov_member;

LANES_INLINE markov_member markov_load(const markov_noise *m, int axis, int i)
{
    return (markov_member){ m->x[axis][i], lanes_set(m->filter[axis].phi[i]),
                            lanes_set(m->filter[axis].feed[i]) };
}

/* Its part of a sample. */
LANES_INLINE lanes markov_step(markov_member *p, lanes e)
{
    const lanes x = p->x;
    p->x = p->phi * x + p->feed * e;
    return x;
}

/* Members i .. i + 3 over n samples: four recursions hide each other's latency. */
LANES_INLINE void markov_four(markov_noise *m, int axis, int i, int n, const lanes *e, lanes *sum)
{
    markov_member a = markov_load(m, axis, i), b = markov_load(m, axis, i + 1);
    markov_member c = markov_load(m, axis, i + 2), d = markov_load(m, axis, i + 3);
    for (int k = 0; k < n; k++)
        sum[k] += (markov_step(&a, e[k]) + markov_step(&b, e[k])) +
                  (markov_step(&c, e[k]) + markov_step(&d, e[k]));
    m->x[axis][i] = a.x;
    m->x[axis][i + 1] = b.x;
    m->x[axis][i + 2] = c.x;
    m->x[axis][i + 3] = d.x;
}

LANES_INLINE void markov_one(markov_noise *m, int axis, int i, int n, const lanes *e, lanes *sum)
{
    markov_member a = markov_load(m, axis, i);
    for (int k = 0; k < n; k++) sum[k] += markov_step(&a, e[k]);
    m->x[axis][i] = a.x;
}

/* Number k of the stream of an axis belongs to step k. */
LANES_INLINE void markov_add(markov_noise *m, const schuler_model_block *b)
{
    for (int axis = 0; axis < 3; axis++) {
        const int members = m->filter[axis].members;
        const lanes direct = lanes_set(m->filter[axis].direct);
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        lanes e[SCHULER_BLOCK], sum[SCHULER_BLOCK];
        lanes_normals(m->seed, m->run, stream_counter(m->number, (unsigned)axis, SCHULER_USE_SLOW),
                      (uint64_t)b->first / 4, (b->n + 3) / 4, e);
        for (int k = 0; k < b->n; k++) sum[k] = direct * e[k];
        int i = 0;
        for (; i + 4 <= members; i += 4) markov_four(m, axis, i, b->n, e, sum);
        for (; i < members; i++) markov_one(m, axis, i, b->n, e, sum);
        for (int k = 0; k < b->n; k++)
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + m->scale[axis] * sum[k]);
    }
}

static_assert(SCHULER_BLOCK % 4 == 0 && (int)SCHULER_BLOCK <= (int)LANES_NORMALS_MAX,
              "numbers of a block are whole calls");
static_assert(SCHULER_MARKOV_MAX % 4 == 0, "starts are whole calls");

#endif

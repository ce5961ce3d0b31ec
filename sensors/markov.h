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

/* Adds members i .. i + count - 1 over n samples: their recursions are independent, so that several at
 * a time hide each other's latency. */
LANES_INLINE void markov_members(markov_noise *m, int axis, int i, int count, int n, const lanes *e,
                                 lanes *sum)
{
    const schuler_markov_filter *const f = &m->filter[axis];
    lanes x[4], phi[4], feed[4];
    for (int j = 0; j < count; j++) {
        x[j] = m->x[axis][i + j];
        phi[j] = lanes_set(f->phi[i + j]);
        feed[j] = lanes_set(f->feed[i + j]);
    }
    for (int k = 0; k < n; k++)
        for (int j = 0; j < count; j++) {
            sum[k] += x[j];
            x[j] = phi[j] * x[j] + feed[j] * e[k];
        }
    for (int j = 0; j < count; j++) m->x[axis][i + j] = x[j];
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
        for (; i + 4 <= members; i += 4) markov_members(m, axis, i, 4, b->n, e, sum);
        for (; i < members; i++) markov_members(m, axis, i, 1, b->n, e, sum);
        for (int k = 0; k < b->n; k++)
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + m->scale[axis] * sum[k]);
    }
}

static_assert(SCHULER_BLOCK % 4 == 0 && (int)SCHULER_BLOCK <= (int)LANES_NORMALS_MAX,
              "numbers of a block are whole calls");
static_assert(SCHULER_MARKOV_MAX % 4 == 0, "starts are whole calls");

#endif

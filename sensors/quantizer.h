/* SPDX-License-Identifier: MIT */
/* Output in whole counts, the remainder carried to the next sample, so that no angle and no
 * velocity is ever lost:  u = r + y ;  out = round(u / lsb) lsb ;  r = u - out.  The remainder at
 * the start is uniform in half a count to either side, drawn per run: where a counter stands at
 * switch-on is chance. */
#ifndef SCHULER_SENSORS_QUANTIZER_H
#define SCHULER_SENSORS_QUANTIZER_H

#include "core/random.h"
#include "sensors/setup.h"

typedef struct {
    lanes lsb[3], inverse[3]; /* 0 in lanes that do not quantize */
    lanes on[3]; /* 1 or 0: selects without a compare; multiplying by either is exact */
    lanes rest[3];
    int active;
} quantizer;

LANES_INLINE void quantizer_setup(quantizer *q, const schuler_model_setup *s, int param,
                                  unsigned number)
{
    q->active = setup_any(s, param, 3);
    for (int i = 0; i < 3; i++) {
        double inverse[SCHULER_LANES] __attribute__((aligned(64)));
        double on[SCHULER_LANES] __attribute__((aligned(64)));
        double rest[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) {
            const double lsb = setup_lane(s, l, param, i);
            const schuler_stream stream = { s->seed, s->specs[l].run, number, (unsigned)i,
                                            SCHULER_USE_START };
            on[l] = lsb != 0.0 ? 1.0 : 0.0;
            inverse[l] = lsb != 0.0 ? 1.0 / lsb : 0.0;
            rest[l] = 0.5 * lsb * schuler_stream_uniform(stream, 0);
        }
        q->lsb[i] = setup_value(s, param, i);
        q->inverse[i] = lanes_load(inverse);
        q->on[i] = lanes_load(on);
        q->rest[i] = lanes_load(rest);
    }
}

LANES_INLINE void quantizer_apply(quantizer *q, const schuler_model_block *b)
{
    if (!q->active) return;
    for (int i = 0; i < 3; i++) {
        double *out = b->out + i * b->stride * SCHULER_LANES;
        const lanes off = lanes_set(1.0) - q->on[i];
        lanes rest = q->rest[i];
        for (int k = 0; k < b->n; k++) {
            const lanes u = rest + lanes_load(out + k * SCHULER_LANES);
            const lanes counts = lanes_round(u * q->inverse[i]) * q->lsb[i];
            const lanes y = counts * q->on[i] + u * off;
            rest = u - y;
            lanes_store(out + k * SCHULER_LANES, y);
        }
        q->rest[i] = rest;
    }
}

#endif

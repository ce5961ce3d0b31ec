/* SPDX-License-Identifier: MIT */
/* The output is late by a time that need not be a whole number of samples: the accumulated increments
 * are read between the samples, by the cubic through four of them. The weights sum to one, so no
 * angle and no velocity is lost. Before the start the first increment continues. */
#include "core/truth.h"
#include "sensors/params.h"
#include "sensors/response.h"
#include "sensors/setup.h"

enum { HISTORY = SCHULER_DELAY_STEPS_MAX + 4, KEPT = HISTORY + SCHULER_BLOCK };

static const schuler_param accel_params[] = {
    PARAM_SOURCE("delay", 110, TIME, 0, 1.0, RESPONSE, "2 ms",
                 "time by which the output is late; at most 64 samples", "y(t) = x(t - d)",
                 .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("delay", 210, TIME, 0, 1.0, RESPONSE, "2 ms",
                 "time by which the output is late; at most 64 samples", "y(t) = x(t - d)",
                 .noisy = 0),
    { 0 },
};

typedef struct {
    int back[3][SCHULER_LANES]; /* whole samples                        */
    double weight[3][4][SCHULER_LANES];
    int started;
    lanes past[3][KEPT]; /* increments: HISTORY before the block, then the block's */
} delay;

static int setup(void *state, const schuler_model_setup *s)
{
    delay *m = state;
    m->started = 0;
    for (int i = 0; i < 3; i++)
        for (int l = 0; l < SCHULER_LANES; l++) {
            double weight[4];
            m->back[i][l] = schuler_delay_weights(setup_lane(s, l, 0, i) / s->dt_s, weight);
            for (int q = 0; q < 4; q++) m->weight[i][q][l] = weight[q];
        }
    return setup_any(s, 0, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    delay *m = state;
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        lanes *const past = m->past[axis];
        for (int k = 0; k < HISTORY && !m->started; k++) past[k] = lanes_load(out);
        for (int k = 0; k < b->n; k++) past[HISTORY + k] = lanes_load(out + k * SCHULER_LANES);
        for (int k = 0; k < b->n; k++)
            for (int l = 0; l < SCHULER_LANES; l++) {
                double y = 0.0;
                for (int q = 0; q < 4; q++) {
                    double x[SCHULER_LANES];
                    memcpy(x, &past[HISTORY + k - m->back[axis][l] - q], sizeof x);
                    y += m->weight[axis][q][l] * x[l];
                }
                out[k * SCHULER_LANES + l] = y;
            }
        memmove(past, past + b->n, HISTORY * sizeof *past);
    }
    m->started = 1;
}

STAGE(delay) = {
    .name = "delay",
    .summary = "the output is late",
    .source = "four-point interpolation of the accumulated output",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(delay),
    .setup = setup,
    .apply = apply,
};

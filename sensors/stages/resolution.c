/* SPDX-License-Identifier: MIT */
/* A rate output in steps without carry: what is rounded off in a sample is lost, unlike quantization of
 * an angle or a velocity. */
#include "sensors/params.h"
#include "sensors/setup.h"

#define FORMULA "y = round(x/(r dt)) r dt"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("resolution", 118, ACCEL, 0, 1e3, RESPONSE, "1 mg",
                 "step of an output of specific force, nothing is carried", FORMULA, .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("resolution", 218, RATE, 0, 1e2, RESPONSE, "0.004 deg/s",
                 "step of an output of rate, nothing is carried", FORMULA, .noisy = 0),
    { 0 },
};

typedef struct {
    lanes step[3], inverse[3]; /* over one sample; 0 in lanes without    */
    lanes on[3];               /* 1 or 0: multiplying by either is exact */
} resolution;

static int setup(void *state, const schuler_model_setup *s)
{
    resolution *m = state;
    for (int i = 0; i < 3; i++) {
        double inverse[SCHULER_LANES] __attribute__((aligned(64)));
        double on[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) {
            const double step = setup_lane(s, l, 0, i) * s->dt_s;
            on[l] = step != 0.0 ? 1.0 : 0.0;
            inverse[l] = step != 0.0 ? 1.0 / step : 0.0;
        }
        m->step[i] = setup_value(s, 0, i) * lanes_set(s->dt_s);
        m->inverse[i] = lanes_load(inverse);
        m->on[i] = lanes_load(on);
    }
    return setup_any(s, 0, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    const resolution *m = state;
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        const lanes off = lanes_set(1.0) - m->on[axis];
        for (int k = 0; k < b->n; k++) {
            const lanes x = lanes_load(out + k * SCHULER_LANES);
            const lanes y = lanes_round(x * m->inverse[axis]) * m->step[axis];
            lanes_store(out + k * SCHULER_LANES, y * m->on[axis] + x * off);
        }
    }
}

STAGE(resolution) = {
    .name = "resolution",
    .summary = "steps of a rate output, nothing carried",
    .source = "IEEE Std 2700 (digital bit depth)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(resolution),
    .setup = setup,
    .apply = apply,
};

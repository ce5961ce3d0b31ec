/* SPDX-License-Identifier: MIT */
/* A bias that wanders without limit: sensors/drift.h. */
#include "sensors/drift.h"
#include "sensors/params.h"

#define FORMULA "db/dt = K w"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("bias_random_walk", 105, ACCEL_RW, 0, 1e3, WALK, "1 ug/sqrt(h)",
                 "bias that wanders without limit, its coefficient K", FORMULA, .noisy = 2),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("bias_random_walk", 205, RRW, 0, 1e2, WALK, "0.001 deg/h/sqrt(h)",
                 "drift that wanders without limit (rate random walk), K", FORMULA, .noisy = 2),
    { 0 },
};

static int setup(void *state, const schuler_model_setup *s)
{
    bias_drift *d = state;
    random_walk_setup(d, s, 0,
                      (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[0].number);
    return d->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    drift_add(state, b);
}

STAGE(random_walk) = {
    .name = "random_walk",
    .summary = "random walk of the bias",
    .source = "IEEE Std 952-1997 annex C (rate random walk)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(bias_drift),
    .setup = setup,
    .apply = apply,
};

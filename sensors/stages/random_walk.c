/* SPDX-License-Identifier: MIT */
/* A bias that wanders without limit: sensors/walk.h. */
#include "sensors/params.h"
#include "sensors/walk.h"

#define FORMULA "db/dt = K w"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("bias_random_walk", 105, ACCEL_RW, 0, 1e3, WALK, "1 ug/sqrt(h)",
                 "bias that wanders without limit, its coefficient K", FORMULA, .noisy = 1),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("bias_random_walk", 205, RRW, 0, 1e2, WALK, "0.001 deg/h/sqrt(h)",
                 "drift that wanders without limit (rate random walk), K", FORMULA, .noisy = 1),
    { 0 },
};

static int setup(void *state, const schuler_model_setup *s)
{
    random_walk *w = state;
    walk_setup(w, s, 0, (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[0].number);
    return w->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    walk_add(state, b);
}

STAGE(random_walk) = {
    .name = "random_walk",
    .summary = "random walk of the bias, exact in its increments",
    .source = "IEEE Std 952-1997 annex C (rate random walk)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(random_walk),
    .setup = setup,
    .apply = apply,
};

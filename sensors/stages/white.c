/* SPDX-License-Identifier: MIT */
/* White noise: sensors/white.h. */
#include "sensors/white.h"
#include "sensors/params.h"

#define FORMULA "y = x + N sqrt(dt) w"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("velocity_random_walk", 103, VRW, 0, 1e3, WHITE, "0.003 m/s/sqrt(h)",
                 "white noise of the specific force, as its velocity random walk N", FORMULA,
                 .noisy = 1),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("angle_random_walk", 203, ARW, 0, 1e2, WHITE, "0.003 deg/sqrt(h)",
                 "white noise of the rate, as its angle random walk N", FORMULA, .noisy = 1),
    { 0 },
};

static int setup(void *state, const schuler_model_setup *s)
{
    white_noise *w = state;
    white_setup(w, s, 0, (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[0].number);
    return w->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    white_add(state, b);
}

STAGE(white) = {
    .name = "white",
    .summary = "white noise",
    .source = "IEEE Std 952-1997 annex C (angle random walk)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(white_noise),
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* A bias that is another one at every switch-on, beside the one that the model has. */
#include "sensors/params.h"
#include "sensors/terms.h"

#define FORMULA "y = x + b dt, b drawn per run"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("bias_repeatability", 126, ACCEL, -1e3, 1e3, CONSTANT, "{normal: 20 ug}",
                 "bias from switch-on to switch-on, on top of the model's own", FORMULA,
                 .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("bias_repeatability", 226, RATE, -1e2, 1e2, CONSTANT, "{normal: 0.005 deg/h}",
                 "drift from switch-on to switch-on, on top of the model's own", FORMULA,
                 .noisy = 0),
    { 0 },
};

static void observe(const schuler_model_setup *settings, const schuler_view *v, double *signals)
{
    (void)settings;
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < v->n; k++) signals[axis * SCHULER_BLOCK + k] = v->dt_s;
}

TERMS_STAGE(1, NULL)

STAGE(repeatability) = {
    .name = "repeatability",
    .summary = "bias from switch-on to switch-on",
    .source = "IEEE Std 528 (turn-on repeatability)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(terms),
    .signals = 1,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* A bias that grows with time from the start on: its integral over a step is exact. */
#include "sensors/params.h"
#include "sensors/terms.h"

#define FORMULA "b = R t"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("bias_ramp", 113, JERK, -1e3, 1e3, RAMP, "1 ug/h",
                 "bias that grows with the time since the start, R", FORMULA, .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("bias_ramp", 213, ANGULAR_ACCEL, -1e2, 1e2, RAMP, "0.001 deg/h/h",
                 "drift that grows with the time since the start (rate ramp), R", FORMULA,
                 .noisy = 0),
    { 0 },
};

static void observe(const schuler_model_setup *settings, const schuler_view *v, double *signals)
{
    (void)settings;
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < v->n; k++)
            signals[axis * SCHULER_BLOCK + k] =
                v->dt_s * (((double)(v->first + k) + 0.5) * v->dt_s);
}

TERMS_STAGE(1, NULL)

STAGE(ramp) = {
    .name = "ramp",
    .summary = "ramp of the bias",
    .source = "IEEE Std 952-1997 annex C (rate ramp)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(terms),
    .signals = 1,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

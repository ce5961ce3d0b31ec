/* SPDX-License-Identifier: MIT */
/* A bias that dies away after the start: b exp(-t/tau), its integral over a step is exact. */
#include "sensors/params.h"
#include "sensors/terms.h"
#include <math.h>

enum { BIAS, TIME };

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [BIAS] = PARAM_SOURCE("thermal_transient", NUMBER, DIM_, -MAX, MAX, TRANSIENT, EXAMPLE,    \
                              DOC, "b exp(-t/tau)", .companion = "thermal_transient_time"),        \
        [TIME] =                                                                                   \
            PARAM_SETTING("thermal_transient_time", TIME, 600.0, 1e-3, 1e9, "10 min",              \
                          "time constant of thermal_transient", .companion = "thermal_transient"), \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] =
    PARAMS(115, ACCEL, 1e3, "100 ug", "bias at the start that dies away as the sensor warms up");
static const schuler_param gyro_params[] = PARAMS(
    215, RATE, 1e2, "0.05 deg/h", "drift at the start that dies away as the sensor warms up");

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    for (int axis = 0; axis < 3; axis++) {
        const double tau_s = setup_setting(s, TIME, axis);
        const double step_s = -tau_s * expm1(-v->dt_s / tau_s);
        for (int k = 0; k < v->n; k++)
            signals[axis * SCHULER_BLOCK + k] =
                step_s * exp(-(double)(v->first + k) * v->dt_s / tau_s);
    }
}

TERMS_STAGE(1, NULL)

STAGE(thermal_transient) = {
    .name = "thermal_transient",
    .summary = "bias that dies away after switch-on",
    .source = "first-order warm-up",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(terms),
    .signals = 1,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

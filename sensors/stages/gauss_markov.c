/* SPDX-License-Identifier: MIT */
/* A bias that wanders as a first-order Gauss-Markov process: sensors/drift.h. */
#include "sensors/drift.h"
#include "sensors/params.h"

enum { SIGMA, TIME };

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [SIGMA] = PARAM_SOURCE("gauss_markov", NUMBER, DIM_, 0, MAX, WANDERING, EXAMPLE, DOC,      \
                               "db/dt = -b/T + sigma sqrt(2/T) w", .noisy = 2,                     \
                               .companion = "gauss_markov_time"),                                  \
        [TIME] = PARAM_SETTING("gauss_markov_time", TIME, 100.0, 1e-3, 1e9, "100 s",               \
                               "correlation time of gauss_markov", .companion = "gauss_markov"),   \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] = PARAMS(
    104, ACCEL, 1e3, "10 ug", "bias that wanders as a first-order Gauss-Markov process, its sigma");
static const schuler_param gyro_params[] =
    PARAMS(204, RATE, 1e2, "0.003 deg/h",
           "drift that wanders as a first-order Gauss-Markov process, its sigma");

static int setup(void *state, const schuler_model_setup *s)
{
    bias_drift *d = state;
    gauss_markov_setup(d, s, SIGMA, TIME,
                       (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[SIGMA].number);
    return d->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    drift_add(state, b);
}

STAGE(gauss_markov) = {
    .name = "gauss_markov",
    .summary = "first-order Gauss-Markov process, exact in its integral",
    .source = "R. G. Brown, P. Y. C. Hwang, Introduction to Random Signals and Applied Kalman "
              "Filtering (exact discretisation)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(bias_drift),
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* A bias that wanders as a first-order Gauss-Markov process: sensors/markov.h. */
#include "sensors/markov.h"
#include "sensors/params.h"

enum { SIGMA, TIME };

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [SIGMA] = PARAM_SOURCE("gauss_markov", NUMBER, DIM_, 0, MAX, WANDERING, EXAMPLE, DOC,      \
                               "db/dt = -b/T + sigma sqrt(2/T) w", .noisy = 1,                     \
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
    markov_noise *m = state;
    markov_setup(m, s, SIGMA,
                 (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[SIGMA].number);
    for (int axis = 0; axis < 3 && m->active; axis++) {
        const schuler_markov_process p = { setup_setting(s, TIME, axis), 1.0 };
        const schuler_markov_filter f = schuler_markov_filter_of(&p, 1, s->dt_s);
        markov_setup_axis(m, axis, &f);
    }
    return m->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    markov_add(state, b);
}

STAGE(gauss_markov) = {
    .name = "gauss_markov",
    .summary = "first-order Gauss-Markov process, exact in its increments",
    .source = "R. G. Brown, P. Y. C. Hwang, Introduction to Random Signals and Applied Kalman "
              "Filtering (exact discretisation)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(markov_noise),
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* A bias that wanders smoothly: sensors/gauss_markov_2.h. */
#include "sensors/gauss_markov_2.h"
#include "sensors/params.h"

enum { SIGMA, TIME };

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [SIGMA] = PARAM_SOURCE("gauss_markov_2", NUMBER, DIM_, 0, MAX, WANDERING, EXAMPLE, DOC,    \
                               "b'' + 2 b'/T + b/T^2 = 2 sigma T^-1.5 w", .noisy = 3,              \
                               .companion = "gauss_markov_2_time"),                                \
        [TIME] = PARAM_SETTING("gauss_markov_2_time", TIME, 100.0, 1e-3, 1e9, "100 s",             \
                               "time T of gauss_markov_2; correlated over about 2 T",              \
                               .companion = "gauss_markov_2"),                                     \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] =
    PARAMS(112, ACCEL, 1e3, "10 ug",
           "bias that wanders as a second-order Gauss-Markov process, its sigma");
static const schuler_param gyro_params[] =
    PARAMS(212, RATE, 1e2, "0.003 deg/h",
           "drift that wanders as a second-order Gauss-Markov process, its sigma");

static int setup(void *state, const schuler_model_setup *s)
{
    gauss_markov_2 *m = state;
    gauss_markov_2_setup(
        m, s, SIGMA, TIME,
        (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[SIGMA].number);
    return m->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    gauss_markov_2_add(state, b);
}

STAGE(gauss_markov_2) = {
    .name = "gauss_markov_2",
    .summary = "second-order Gauss-Markov process, exact in its increments",
    .source = "A. Gelb (ed.), Applied Optimal Estimation, ch. 2",
    .equation = "correlation sigma^2 exp(-|t|/T) (1 + |t|/T)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(gauss_markov_2),
    .setup = setup,
    .apply = apply,
};

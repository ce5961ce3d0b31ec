/* SPDX-License-Identifier: MIT */
/* Flicker noise of the bias (bias instability), S(f) = B^2/(2 pi f), as a bank of first-order
 * Gauss-Markov processes:
 *
 *     T_i = T_0 r^i,   sigma_i^2 = B^2 ln(r)/pi,   r = 4
 *
 * (the sum over T of 2 sigma^2 T/(1 + (2 pi f T)^2) is, for T in geometric progression, the integral
 * over dT/T: sigma^2/(2 f ln r)). The floor of the Allan deviation is sqrt(2 ln 2/pi) B with a ripple
 * of 0.024 %; within a decade of the longest time it falls off (2 % a factor of ten inside). */
#include "sensors/markov.h"
#include "sensors/params.h"
#include "sensors/processes.h"

enum { COEFFICIENT, SHORTEST, LONGEST };

#define TIME_SETTING(KEY, DEF, EXAMPLE, DOC)                                                       \
    {                                                                                              \
        .key = KEY, .dim = SCHULER_DIM_TIME, .components = 1, .def = DEF, .min = 0.0, .max = 1e9,  \
        .example = EXAMPLE, .doc = DOC                                                             \
    }

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [COEFFICIENT] =                                                                            \
            PARAM_SOURCE("bias_instability", NUMBER, DIM_, 0, MAX, WANDERING, EXAMPLE, DOC,        \
                         "S(f) = B^2/(2 pi f); floor of the Allan deviation 0.664 B", .noisy = 1), \
        [SHORTEST] =                                                                               \
            TIME_SETTING("bias_instability_shortest", SCHULER_FLICKER_SHORTEST_S, "0.1 s",         \
                         "shortest time constant of the flicker noise; 0: none, "                  \
                         "it goes on below the interval of the samples"),                          \
        [LONGEST] = TIME_SETTING("bias_instability_longest", SCHULER_FLICKER_LONGEST_S, "1e5 s",   \
                                 "longest time constant of the flicker noise"),                    \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] = PARAMS(
    111, ACCEL, 1e3, "10 ug", "flicker noise of the bias, the coefficient B of IEEE Std 952");
static const schuler_param gyro_params[] = PARAMS(
    211, RATE, 1e2, "0.003 deg/h", "flicker noise of the drift, the coefficient B of IEEE Std 952");

static int setup(void *state, const schuler_model_setup *s)
{
    markov_noise *m = state;
    markov_setup(m, s, COEFFICIENT,
                 (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[COEFFICIENT].number);
    if (!m->active) return 0;
    const schuler_flicker_bank bank = schuler_flicker_bank_of(
        setup_setting(s, SHORTEST, 0), setup_setting(s, LONGEST, 0), s->dt_s);
    schuler_markov_process p[SCHULER_MARKOV_MAX];
    for (int i = 0; i < bank.members; i++) p[i] = schuler_flicker_bank_member(&bank, 1.0, i);
    const schuler_markov_filter f = schuler_markov_filter_of(p, bank.members, s->dt_s);
    for (int axis = 0; axis < 3; axis++) markov_setup_axis(m, axis, &f);
    return m->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    markov_add(state, b);
}

STAGE(flicker) = {
    .name = "flicker",
    .summary = "flicker noise of the bias",
    .source = "IEEE Std 952-1997 annex C (bias instability); bank of Gauss-Markov processes",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(markov_noise),
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* Flicker noise of the bias (bias instability): sensors/flicker.h. */
#include "sensors/flicker.h"
#include "sensors/params.h"

enum { COEFFICIENT, SHORTEST, LONGEST };

#define TIME_SETTING(KEY, DEF, EXAMPLE, DOC)                                                       \
    {                                                                                              \
        .key = KEY, .dim = SCHULER_DIM_TIME, .components = 1, .def = DEF, .min = 1e-4, .max = 1e9, \
        .example = EXAMPLE, .doc = DOC                                                             \
    }

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [COEFFICIENT] =                                                                            \
            PARAM_SOURCE("bias_instability", NUMBER, DIM_, 0, MAX, WANDERING, EXAMPLE, DOC,        \
                         "S(f) = B^2/(2 pi f); floor of the Allan deviation 0.664 B", .noisy = 2), \
        [SHORTEST] = TIME_SETTING("bias_instability_shortest", 0.1, "0.1 s",                       \
                                  "shortest time constant of the flicker noise; at least ten "     \
                                  "samples are taken"),                                            \
        [LONGEST] = TIME_SETTING("bias_instability_longest", 1e5, "1e5 s",                         \
                                 "longest time constant of the flicker noise"),                    \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] = PARAMS(
    111, ACCEL, 1e3, "10 ug", "flicker noise of the bias, the coefficient B of IEEE Std 952");
static const schuler_param gyro_params[] = PARAMS(
    211, RATE, 1e2, "0.003 deg/h", "flicker noise of the drift, the coefficient B of IEEE Std 952");

static int setup(void *state, const schuler_model_setup *s)
{
    flicker *m = state;
    flicker_setup(m, s, COEFFICIENT, SHORTEST, LONGEST,
                  (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[0].number);
    return m->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    flicker_add(state, b);
}

STAGE(flicker) = {
    .name = "flicker",
    .summary = "flicker noise of the bias",
    .source = "IEEE Std 952-1997 annex C (bias instability); bank of Gauss-Markov processes",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(flicker),
    .setup = setup,
    .apply = apply,
};

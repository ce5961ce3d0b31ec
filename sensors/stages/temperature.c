/* SPDX-License-Identifier: MIT */
/* What the temperature does to bias and scale factor: polynomials in T - T0, T0 the reference, and a
 * bias in proportion to the rate of change (the Shupe effect of a fibre coil). */
#include "sensors/params.h"
#include "sensors/terms.h"

enum { BIAS_1, BIAS_2, BIAS_3, RATE, SCALE_1, SCALE_2, SCALE_3, TERMS };

/* Of {length, time, angle, temperature, mass, magnetic}, doubled. */
#define PARAMS(FIRST, L, T, A, MAX, UNIT, RATE_EXAMPLE)                                            \
    {                                                                                              \
        [BIAS_1] = TERM("bias_temperature", FIRST, DIM(L, T, A, -2), MAX, TRANSIENT, UNIT "/K",    \
                        "bias for each kelvin above the reference temperature", "b1 (T - T0)"),    \
        [BIAS_2] = TERM("bias_temperature_2", (FIRST) + 1, DIM(L, T, A, -4), MAX, TRANSIENT,       \
                        UNIT "/K^2", "bias, quadratic in the temperature", "b2 (T - T0)^2"),       \
        [BIAS_3] = TERM("bias_temperature_3", (FIRST) + 2, DIM(L, T, A, -6), MAX, TRANSIENT,       \
                        UNIT "/K^3", "bias, cubic in the temperature", "b3 (T - T0)^3"),           \
        [RATE] =                                                                                   \
            TERM("bias_temperature_rate", (FIRST) + 3, DIM(L, (T) + 2, A, -2), MAX, TRANSIENT,     \
                 RATE_EXAMPLE, "bias in proportion to the rate of temperature", "b dT/dt"),        \
        [SCALE_1] =                                                                                \
            TERM("scale_temperature", (FIRST) + 4, DIM(0, 0, 0, -2), 0.1, SCALE, "10 ppm/K",       \
                 "scale-factor error for each kelvin above the reference", "s1 (T - T0) x"),       \
        [SCALE_2] =                                                                                \
            TERM("scale_temperature_2", (FIRST) + 5, DIM(0, 0, 0, -4), 0.1, SCALE, "0.1 ppm/K^2",  \
                 "scale-factor error, quadratic in the temperature", "s2 (T - T0)^2 x"),           \
        [SCALE_3] = TERM("scale_temperature_3", (FIRST) + 6, DIM(0, 0, 0, -6), 0.1, SCALE,         \
                         "0.001 ppm/K^3", "scale-factor error, cubic in the temperature",          \
                         "s3 (T - T0)^3 x"),                                                       \
        { 0 },                                                                                     \
    }
#define DIM(L, T, A, K)                                                                            \
    {                                                                                              \
        L, T, A, K, 0, 0                                                                           \
    }
#define TERM(KEY, NUMBER, DIM_, MAX, ACTS_, EXAMPLE, DOC, FORMULA)                                 \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = DIM_, .components = 3, .min = -MAX, .max = MAX,       \
        .acts = SCHULER_ACTS_##ACTS_, .example = EXAMPLE, .doc = DOC, .formula = FORMULA           \
    }

static const schuler_param accel_params[] = PARAMS(119, 2, -4, 0, 1e2, "10 ug", "100 ug/(K/min)");
static const schuler_param gyro_params[] =
    PARAMS(219, 0, -2, 2, 1e1, "0.02 deg/h", "0.5 deg/h/(K/min)");

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double t = x->temperature;
    const double input = s->instrument == SCHULER_ACCEL ? x->a[0] : x->omega[0];
    B[BIAS_1] = t;
    B[BIAS_2] = t * t;
    B[BIAS_3] = t * t * t;
    B[RATE] = x->temperature_rate;
    B[SCALE_1] = t * input;
    B[SCALE_2] = t * t * input;
    B[SCALE_3] = t * t * t * input;
}

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    terms_observe(s, v, TERMS, bases, signals);
}

TERMS_STAGE(TERMS, NULL)

STAGE(temperature) = {
    .name = "temperature",
    .summary = "bias and scale factor over the temperature (imu.temperature)",
    .source = "polynomials as compensation sheets give them",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* A gyro as its data sheet has it, in the manner of the accelerometer of datasheet.c. */
#include "sensors/gyro_params.h"
#include <math.h>

enum {
    BIAS_OF_SPAN,
    SCALE_FACTOR,
    CROSS_AXIS,
    MISALIGNMENT,
    NONLINEARITY,
    G_SENSITIVITY,
    VIBRATION,
    VIBRATION_RMS,
    RANGE,
    SPAN,
    FORM,
    CROSS_FROM,
};
enum { ONE, INPUT, CROSS, CURVE, FORCE, TERMS = FORCE + 3 };

static const char *const spans[] = { "one_sided", "two_sided", NULL };
static const char *const forms[] = { "geometric", "printed", NULL };
static const char *const crosses[] = { "output", "both", NULL };

static const schuler_param params[] = {
    [BIAS_OF_SPAN] = { .key = "bias_of_span",
                       .number = 270,
                       .components = 3,
                       .min = -1.0,
                       .max = 1.0,
                       .acts = SCHULER_ACTS_CONSTANT,
                       .example = "{uniform: 0.1 %}",
                       .doc = "bias as a part of the span",
                       .formula = "B = bias_of_span R (one-sided) or 2 R (two-sided)",
                       .companion = "range" },
    [SCALE_FACTOR] = GYRO_SCALE_FACTOR("{uniform: 1 %}"),
    [CROSS_AXIS] = GYRO_TERM("cross_axis", 271, SCHULER_DIM_NONE, 0.5, CROSS, "{uniform: 2 %}",
                             "cross-axis sensitivity k_c", "k_c omega_c"),
    [MISALIGNMENT] = GYRO_TERM("misalignment", 202, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.0175 rad",
                               "misalignment N of the sensitive axis",
                               "omega_i cos N + omega_c sin N; printed: omega_i + N omega_i"),
    [NONLINEARITY] = GYRO_NONLINEARITY("range"),
    [G_SENSITIVITY] = GYRO_G_SENSITIVITY("{uniform: 0.1 deg/s/g}"),
    [VIBRATION] = GYRO_VIBRATION_RECTIFICATION,
    [VIBRATION_RMS] = GYRO_VIBRATION_RMS,
    [RANGE] = GYRO_SETTING("range", SCHULER_DIM_RATE, 6.981317007977318, 1e-3, 1e4, "500 deg/s",
                           "largest rate to one side, R; it does not clip: saturation does"),
    [SPAN] = PARAM_CHOICE("span", spans, "two_sided", "what the bias is a part of: R or 2 R"),
    [FORM] = PARAM_CHOICE("misalignment_form", forms, "geometric",
                          "geometric, or N omega_i as eq 21 prints it for accelerometers"),
    [CROSS_FROM] = PARAM_CHOICE("cross_from", crosses, "both",
                                "omega_c: the output axis, or sqrt(omega_o^2 + omega_s^2)"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double o = x->omega[1], third = x->omega[2];
    B[ONE] = 1.0;
    B[INPUT] = x->omega[0];
    B[CROSS] = setup_setting(s, CROSS_FROM, 0) == 1.0 ? sqrt(o * o + third * third) : o;
    B[CURVE] = gyro_nonlinearity(x->omega[0], setup_setting(s, RANGE, 0));
    for (int c = 0; c < 3; c++) B[FORCE + c] = x->a[c];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const double d = v[SCALE_FACTOR][axis], gain = 1.0 + d, N = v[MISALIGNMENT][axis];
    const int is_printed = v[FORM][0] == 1.0;
    const double half = sin(0.5 * N), rms = v[VIBRATION_RMS][0];
    const double along = is_printed ? N : -2.0 * half * half; /* cos N - 1 */
    const double span = v[RANGE][0] * (v[SPAN][0] == 1.0 ? 2.0 : 1.0);
    (void)s;
    c[ONE] = v[BIAS_OF_SPAN][axis] * span + v[VIBRATION][axis] * rms * rms;
    c[CROSS] = v[CROSS_AXIS][axis] + (is_printed ? 0.0 : sin(N));
    c[CURVE] = v[NONLINEARITY][axis];
    gyro_own_axes(&v[G_SENSITIVITY][3 * axis], axis, &c[FORCE]);
    for (int q = 0; q < TERMS; q++) c[q] *= gain;
    c[INPUT] = along + d + along * d;
}

/* (1 + dK/K) multiplies the noise too. */
static double noise_excess(const schuler_model_setup *s, int lane, int axis)
{
    return setup_lane(s, lane, SCALE_FACTOR, axis);
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(gyro_datasheet) = {
    .name = "gyro_datasheet",
    .summary = "a gyro from the figures of its data sheet",
    .source = "in the manner of eq 21 of T. L. Grigorie et al., Concepts for error modeling of "
              "miniature accelerometers; IEEE Std 2700",
    .equation = "omega' = (omega_i cos N + omega_c sin N + B + k_c omega_c + G a\n"
                "       + e R 3 sqrt(3)/2 z (1 - z^2) + VRC vibration_rms^2 + v)(1 + dK/K)\n"
                "z = omega_i/R, |z| < 1",
    .departures =
        "the paper has accelerometers only: G, the non-linearity e and the vibration are added for "
        "gyros. misalignment_form: printed keeps its N omega_i. Percent of span is of the "
        "one-sided "
        "range unless span: two_sided. Rows of G as in vibratory. v is the chain's white noise",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
    .noise_excess = noise_excess,
};

/* SPDX-License-Identifier: MIT */
/* An accelerometer as its data sheet has it: eq 21 of the paper. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"
#include <math.h>

enum {
    BIAS_OF_SPAN,
    SCALE_FACTOR,
    CROSS_AXIS,
    MISALIGNMENT,
    RANGE,
    SPAN,
    FORM,
    CROSS_FROM,
};
enum { ONE, INPUT, CROSS, TERMS };

static const char *const spans[] = { "one_sided", "two_sided", NULL };
static const char *const forms[] = { "geometric", "printed", NULL };
static const char *const crosses[] = { "pendulous", "both", NULL };

static const schuler_param params[] = {
    [BIAS_OF_SPAN] = { .key = "bias_of_span",
                       .number = 170,
                       .components = 3,
                       .min = -1.0,
                       .max = 1.0,
                       .acts = SCHULER_ACTS_CONSTANT,
                       .example = "{uniform: 2 %}",
                       .doc = "bias as a part of the span",
                       .formula = "B = bias_of_span R (one-sided) or 2 R (two-sided)",
                       .companion = "range" },
    [SCALE_FACTOR] = ACCEL_SCALE_FACTOR,
    [CROSS_AXIS] = ACCEL_TERM("cross_axis", 171, SCHULER_DIM_NONE, 0.5, CROSS,
                              "{uniform: [0 %, 3 %]}", "cross-axis sensitivity k_c", "k_c a_c"),
    [MISALIGNMENT] = ACCEL_TERM("misalignment", 102, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.0175 rad",
                                "misalignment N of the sensitive axis",
                                "a_i cos N + a_c sin N; printed: a_i + N a_i"),
    [RANGE] = { .key = "range",
                .dim = SCHULER_DIM_ACCEL,
                .components = 1,
                .def = 9.80665,
                .min = 1e-3,
                .max = 1e7,
                .example = "18 g",
                .doc = "largest input to one side, R; it does not clip: saturation does" },
    [SPAN] = PARAM_CHOICE("span", spans, "two_sided", "what the bias is a part of: R or 2 R"),
    [FORM] = PARAM_CHOICE("misalignment_form", forms, "printed",
                          "geometric, or N a_i as the paper prints it"),
    [CROSS_FROM] = PARAM_CHOICE("cross_from", crosses, "both",
                                "a_c: the pendulous axis, or sqrt(a_p^2 + a_o^2)"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double p = x->a[1], o = x->a[2];
    B[ONE] = 1.0;
    B[INPUT] = x->a[0];
    B[CROSS] = setup_setting(s, CROSS_FROM, 0) == 1.0 ? sqrt(p * p + o * o) : p;
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const double d = v[SCALE_FACTOR][axis], N = v[MISALIGNMENT][axis];
    const int is_printed = v[FORM][0] == 1.0;
    const double half = sin(0.5 * N);
    const double along = is_printed ? N : -2.0 * half * half; /* cos N - 1 */
    const double span = v[RANGE][0] * (v[SPAN][0] == 1.0 ? 2.0 : 1.0);
    (void)s;
    c[ONE] = (1.0 + d) * (v[BIAS_OF_SPAN][axis] * span);
    c[INPUT] = along + d + along * d;
    c[CROSS] = (1.0 + d) * (v[CROSS_AXIS][axis] + (is_printed ? 0.0 : sin(N)));
}

/* (1 + dK/K) multiplies the noise too. */
static double noise_excess(const schuler_model_setup *s, int lane, int axis)
{
    return setup_lane(s, lane, SCALE_FACTOR, axis);
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(datasheet) = {
    .name = "datasheet",
    .summary = "an accelerometer from the figures of its data sheet",
    .source =
        "eq 21 of T. L. Grigorie et al., Concepts for error modeling of miniature accelerometers",
    .equation = "a' = (a_i + N a_i + B + k_c a_c + v)(1 + dK/K), as printed",
    .departures =
        "a misalignment N couples the cross axis in, a_i cos N + a_c sin N: that is the default; "
        "the "
        "printed N a_i is a scale-factor error and is kept as misalignment_form: printed. Percent "
        "of "
        "span is of the one-sided range unless span: two_sided. v is the chain's white noise",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
    .noise_excess = noise_excess,
};

/* SPDX-License-Identifier: MIT */
/* The pendulous accelerometer of Titterton and Weston. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"

enum { BIAS, SCALE_FACTOR, MISALIGNMENT, VIBROPENDULOUS };
enum { ONE, INPUT, CROSS_P, CROSS_O, PRODUCT, TERMS };

static const schuler_param params[] = {
    [BIAS] = ACCEL_BIAS,
    [SCALE_FACTOR] = ACCEL_SCALE_FACTOR,
    [MISALIGNMENT] = ACCEL_MISALIGNMENT,
    [VIBROPENDULOUS] =
        ACCEL_TERM("vibropendulous", 130, ACCEL_PER(1), 1e-1, NON_LINEAR, "5 ug/g^2",
                   "vibro-pendulous coefficient B_v: input times pendulous axis", "B_v a_i a_p"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    (void)s;
    B[ONE] = 1.0;
    B[INPUT] = x->a[0];
    B[CROSS_P] = x->a[1];
    B[CROSS_O] = x->a[2];
    B[PRODUCT] = x->a[0] * x->a[1];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    (void)s;
    c[ONE] = v[BIAS][axis];
    c[INPUT] = v[SCALE_FACTOR][axis];
    c[CROSS_P] = v[MISALIGNMENT][cross_component(axis, 1)];
    c[CROSS_O] = v[MISALIGNMENT][cross_component(axis, 2)];
    c[PRODUCT] = v[VIBROPENDULOUS][axis];
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(titterton) = {
    .name = "titterton",
    .summary = "bias, scale factor, cross coupling and the vibro-pendulous error",
    .source =
        "D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd ed., ch. 6; "
        "eq 1 of T. L. Grigorie et al., Concepts for error modeling of miniature accelerometers",
    .equation = "a' = (1 + S) a_i + M_p a_p + M_o a_o + B_f + B_v a_i a_p",
    .departures =
        "none; the print gives the x instrument with y as its pendulous direction, the others "
        "follow by cyclic exchange. Its noise is the chain's white noise.",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

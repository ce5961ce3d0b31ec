/* SPDX-License-Identifier: MIT */
/* The matrix model of El-Diasty and Pagiatakis: what calibration finds, and what it leaves. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"

enum {
    BIAS,
    SCALE_FACTOR,
    MISALIGNMENT,
    BIAS_RESIDUAL,
    SCALE_RESIDUAL,
    MISALIGNMENT_RESIDUAL,
};
enum { ONE, INPUT, CROSS_P, CROSS_O, TERMS };

static const schuler_param params[] = {
    [BIAS] = ACCEL_BIAS,
    [SCALE_FACTOR] = ACCEL_SCALE_FACTOR,
    [MISALIGNMENT] = ACCEL_MISALIGNMENT,
    [BIAS_RESIDUAL] = ACCEL_TERM("bias_residual", 131, SCHULER_DIM_ACCEL, 1e3, CONSTANT,
                                 "{normal: 20 ug}", "bias that calibration leaves", "db"),
    [SCALE_RESIDUAL] =
        ACCEL_TERM("scale_residual", 132, SCHULER_DIM_NONE, 0.5, SCALE, "{normal: 50 ppm}",
                   "scale-factor error that calibration leaves", "dS_ii a_i"),
    [MISALIGNMENT_RESIDUAL] = ACCEL_MISALIGNMENT_OF(
        "misalignment_residual", 133, "angles xy, xz, yx, yz, zx, zy that calibration leaves"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    (void)s;
    B[ONE] = 1.0;
    B[INPUT] = x->a[0];
    B[CROSS_P] = x->a[1];
    B[CROSS_O] = x->a[2];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    (void)s;
    const int p = cross_component(axis, 1), o = cross_component(axis, 2);
    c[ONE] = v[BIAS][axis] + v[BIAS_RESIDUAL][axis];
    c[INPUT] = v[SCALE_FACTOR][axis] + v[SCALE_RESIDUAL][axis];
    c[CROSS_P] = v[MISALIGNMENT][p] + v[MISALIGNMENT_RESIDUAL][p];
    c[CROSS_O] = v[MISALIGNMENT][o] + v[MISALIGNMENT_RESIDUAL][o];
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(el_diasty) = {
    .name = "el_diasty",
    .summary = "full scale and misalignment matrices, deterministic and residual",
    .source =
        "M. El-Diasty, S. Pagiatakis, Calibration and stochastic modelling of inertial navigation "
        "sensor errors, J. Global Positioning Systems 7(2), 2008; eqs 2-5 of T. L. Grigorie et al.",
    .equation = "f' = (I + S + dS) f + b + db + w",
    .departures =
        "the print has an approximate sign, this is equality. db is the residual bias; w is the "
        "chain's white noise; a residual that wanders is its gauss_markov or bias_instability.",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

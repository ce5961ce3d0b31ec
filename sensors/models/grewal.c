/* SPDX-License-Identifier: MIT */
/* The model of Grewal, Weill and Andrews as Flenniken et al. use it. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"
#include <math.h>

enum {
    BIAS,
    BIAS_RANDOM,
    SCALE_FACTOR,
    SCALE_ASYMMETRY,
    SCALE_QUADRATIC,
    NON_ORTHOGONALITY,
    ROTATION,
};
enum { ONE, INPUT, MAGNITUDE, SQUARE, CROSS_P, CROSS_O, TERMS };

static const schuler_param params[] = {
    [BIAS] = ACCEL_BIAS,
    [BIAS_RANDOM] = ACCEL_TERM("bias_random", 134, SCHULER_DIM_ACCEL, 1e3, CONSTANT,
                               "{normal: 20 ug}", "random bias b beside the constant one c", "b"),
    [SCALE_FACTOR] = ACCEL_SCALE_FACTOR,
    [SCALE_ASYMMETRY] =
        ACCEL_TERM("scale_asymmetry", 135, SCHULER_DIM_NONE, 0.5, NON_LINEAR, "20 ppm",
                   "scale-factor asymmetry SFA: slope 1 + SF + SFA above zero, 1 + SF - SFA below",
                   "SFA |a_i|"),
    [SCALE_QUADRATIC] = ACCEL_TERM("scale_quadratic", 136, ACCEL_PER(1), 1e-1, NON_LINEAR,
                                   "10 ug/g^2", "quadratic non-linearity SFN", "SFN a_i^2"),
    [NON_ORTHOGONALITY] =
        ACCEL_TERM("non_orthogonality", 137, SCHULER_DIM_ANGLE, 0.5, CROSS, "10 arcsec",
                   "symmetric part Delta about x, y, z: two axes are 90 deg - 2 Delta apart",
                   "sin(Delta_z + delta_z) a_y + sin(Delta_y - delta_y) a_z, and cyclic"),
    [ROTATION] = ACCEL_TERM("rotation", 138, SCHULER_DIM_ANGLE, 0.5, CROSS, "10 arcsec",
                            "turn delta of the whole triad about x, y, z",
                            "sin(Delta_z + delta_z) a_y + sin(Delta_y - delta_y) a_z, and cyclic"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    (void)s;
    B[ONE] = 1.0;
    B[INPUT] = x->a[0];
    B[MAGNITUDE] = fabs(x->a[0]);
    B[SQUARE] = x->a[0] * x->a[0];
    B[CROSS_P] = x->a[1];
    B[CROSS_O] = x->a[2];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    (void)s;
    const int p = (axis + 1) % 3, o = (axis + 2) % 3;
    c[ONE] = v[BIAS][axis] + v[BIAS_RANDOM][axis];
    c[INPUT] = v[SCALE_FACTOR][axis];
    c[MAGNITUDE] = v[SCALE_ASYMMETRY][axis];
    c[SQUARE] = v[SCALE_QUADRATIC][axis];
    c[CROSS_P] = sin(v[NON_ORTHOGONALITY][o] + v[ROTATION][o]);
    c[CROSS_O] = sin(v[NON_ORTHOGONALITY][p] - v[ROTATION][p]);
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(grewal) = {
    .name = "grewal",
    .summary = "scale factor with asymmetry and quadratic term, non-orthogonality, triad rotation",
    .source = "M. S. Grewal, L. R. Weill, A. P. Andrews, Global Positioning Systems, Inertial "
              "Navigation, "
              "and Integration, 2001; W. S. Flenniken et al., ION GNSS 2005; eq 6 of T. L. "
              "Grigorie et al.",
    .equation = "a_x' = (1 + SF_x) a_x + SFA_x |a_x| + SFN_x a_x^2\n"
                "       + sin(Delta_z + delta_z) a_y + sin(Delta_y - delta_y) a_z\n"
                "       + c_x + b_x + w_x, and cyclic",
    .departures = "none in the formula, which is kept with its rows that are not unit vectors "
                  "(second order). "
                  "w, not defined in print, is the chain's white noise.",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

/* SPDX-License-Identifier: MIT */
/* Spinning-mass gyros as Titterton and Weston have them. */
#include "sensors/gyro_params.h"
#include "sensors/rotor.h"
#include <math.h>

enum {
    BIAS,
    SCALE_FACTOR,
    MISALIGNMENT,
    SCALE_ASYMMETRY,
    SCALE_QUADRATIC,
    SCALE_CUBIC,
    MASS_UNBALANCE,
    QUADRATURE,
    ANISOELASTIC,
    KIND,
};
enum {
    ONE,
    RATE,
    CROSS_O,
    CROSS_S,
    MAGNITUDE,
    SQUARE,
    CUBE,
    FORCE_I,
    FORCE_O,
    FORCE_PRODUCT,
    TERMS,
};

static const schuler_param params[] = {
    [BIAS] = GYRO_BIAS("0.01 deg/h"),
    [SCALE_FACTOR] = GYRO_SCALE_FACTOR("50 ppm"),
    [MISALIGNMENT] = GYRO_MISALIGNMENT,
    [SCALE_ASYMMETRY] = GYRO_SCALE_ASYMMETRY,
    [SCALE_QUADRATIC] = GYRO_SCALE_QUADRATIC,
    [SCALE_CUBIC] = GYRO_SCALE_CUBIC,
    [MASS_UNBALANCE] = GYRO_TERM(
        "mass_unbalance", 235, GYRO_PER_ACCEL(1), 1.0, CROSS, "0.05 deg/h/g",
        "mass unbalance B_gx: drift under specific force along the input axis", "B_gi a_i"),
    [QUADRATURE] = GYRO_TERM(
        "quadrature_unbalance", 236, GYRO_PER_ACCEL(1), 1.0, CROSS, "0.02 deg/h/g",
        "quadrature unbalance B_gy: drift under specific force along the output axis", "B_go a_o"),
    [ANISOELASTIC] =
        GYRO_TERM("anisoelastic", 237, GYRO_PER_ACCEL(2), 1.0, NON_LINEAR, "0.02 deg/h/g^2",
                  "anisoelastic coefficient B_axz: input times spin axis", "B_ais a_i a_s"),
    [KIND] = ROTOR_KIND,
    { 0 },
};

static int is_shared(const schuler_model_setup *s)
{
    return setup_setting(s, KIND, 0) == 1.0;
}

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double w = x->omega[0];
    (void)s;
    B[ONE] = 1.0;
    B[RATE] = w;
    B[CROSS_O] = x->omega[1];
    B[CROSS_S] = x->omega[2];
    B[MAGNITUDE] = 0.5 * fabs(w);
    B[SQUARE] = w * w;
    B[CUBE] = w * w * w;
    B[FORCE_I] = x->a[0];
    B[FORCE_O] = x->a[1];
    B[FORCE_PRODUCT] = x->a[0] * x->a[2];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const int rotor = rotor_of(is_shared(s), axis);
    c[ONE] = v[BIAS][axis];
    c[RATE] = v[SCALE_FACTOR][axis];
    rotor_misalignment(v[MISALIGNMENT], is_shared(s), axis, &c[CROSS_O], &c[CROSS_S]);
    c[MAGNITUDE] = v[SCALE_ASYMMETRY][axis];
    c[SQUARE] = v[SCALE_QUADRATIC][axis];
    c[CUBE] = v[SCALE_CUBIC][axis];
    c[FORCE_I] = v[MASS_UNBALANCE][rotor];
    c[FORCE_O] = v[QUADRATURE][rotor];
    c[FORCE_PRODUCT] = v[ANISOELASTIC][rotor];
}

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    rotor_room room;
    const schuler_view mine = is_shared(s) ? rotor_view(v, &room) : *v;
    terms_observe(s, &mine, TERMS, bases, signals);
}

static int setup(void *state, const schuler_model_setup *s)
{
    (void)terms_setup(state, s, TERMS, coefficients);
    return 1;
}

static void apply(void *state, const schuler_model_block *b)
{
    terms_apply(state, b, TERMS, 1);
}

MODEL(conventional) = {
    .name = "conventional",
    .summary = "a spinning-mass gyro: mass unbalance, quadrature, anisoelasticity",
    .source = "D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd ed., "
              "ch. 4; scale-factor asymmetry and powers as in IEEE Std 528",
    .equation = "omega' = (1 + S) omega_i + M_o omega_o + M_s omega_s + B_f\n"
                "         + B_gi a_i + B_go a_o\n"
                "       + B_ais a_i a_s + 1/2 s_a |omega_i| + q omega_i^2 + c omega_i^3",
    .departures =
        "the print gives the x gyro with y and the spin axis z; others follow by their axes i, o, "
        "s. "
        "For kind: tuned_rotor the y channel has B_g and B_a of x on the axes (y, -x, z), which "
        "gives "
        "the sign of its quadrature term. Its noise is the chain's white noise",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

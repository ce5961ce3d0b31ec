/* SPDX-License-Identifier: MIT */
/* Spinning-mass gyros as their test standards have them: single degree of freedom, IEEE Std 517, and
 * dynamically tuned, IEEE Std 813. */
#include "sensors/gyro_params.h"
#include "sensors/rotor.h"

enum {
    D_F,
    D_I,
    D_O,
    D_S,
    D_II,
    D_OO,
    D_SS,
    D_IS,
    D_IO,
    D_OS,
    ANISO_INERTIA,
    OUTPUT_AXIS,
    SCALE_FACTOR,
    MISALIGNMENT,
    KIND,
};
enum { CROSS_O = MISALIGNMENT, CROSS_S, TERMS }; /* up to them parameter and coefficient are one */

#define UNBALANCE(KEY, NUMBER, DOC, FORMULA)                                                       \
    GYRO_TERM(KEY, NUMBER, GYRO_PER_ACCEL(1), 1.0, CROSS, "0.05 deg/h/g", DOC, FORMULA)
#define SQUARED(KEY, NUMBER, DOC, FORMULA)                                                         \
    GYRO_TERM(KEY, NUMBER, GYRO_PER_ACCEL(2), 1.0, NON_LINEAR, "0.02 deg/h/g^2", DOC, FORMULA)

static const schuler_param params[] = {
    [D_F] = GYRO_D_F,
    [D_I] = UNBALANCE("D_I", 280, "mass unbalance: drift under a along the input axis", "D_I a_i"),
    [D_O] = UNBALANCE("D_O", 281,
                      "drift under a along the output axis; of a tuned rotor its quadrature",
                      "D_O a_o"),
    [D_S] = UNBALANCE("D_S", 282, "mass unbalance: drift under a along the spin axis", "D_S a_s"),
    [D_II] = SQUARED("D_II", 283, "square of a along the input axis", "D_II a_i^2"),
    [D_OO] = SQUARED("D_OO", 284, "square of a along the output axis", "D_OO a_o^2"),
    [D_SS] = SQUARED("D_SS", 285, "square of a along the spin axis", "D_SS a_s^2"),
    [D_IS] = SQUARED("D_IS", 286, "anisoelastic drift: m^2 (k_s - k_i)/H of the compliances k",
                     "D_IS a_i a_s"),
    [D_IO] = SQUARED("D_IO", 287, "product of input and output axis", "D_IO a_i a_o"),
    [D_OS] = SQUARED("D_OS", 288, "product of output and spin axis", "D_OS a_o a_s"),
    [ANISO_INERTIA] =
        GYRO_TERM("aniso_inertia", 238, GYRO_PER_RATE(1), 1.0, NON_LINEAR, "5e-6 s/rad",
                  "anisoinertia of the float, (I_SS - I_II)/H", "(I_SS - I_II)/H omega_i omega_s"),
    [OUTPUT_AXIS] = GYRO_TERM("output_axis", 239, SCHULER_DIM_TIME, 10.0, CROSS, "2e-3 s",
                              "coupling of the angular acceleration about the output axis, I_OO/H",
                              "I_OO/H d(omega_o)/dt"),
    [SCALE_FACTOR] = GYRO_SCALE_FACTOR("50 ppm"),
    [MISALIGNMENT] = GYRO_MISALIGNMENT,
    [KIND] = ROTOR_KIND,
    { 0 },
};

static int is_shared(const schuler_model_setup *s)
{
    return setup_setting(s, KIND, 0) == 1.0;
}

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double i = x->a[0], o = x->a[1], spin = x->a[2];
    (void)s;
    B[D_F] = 1.0;
    B[D_I] = i;
    B[D_O] = o;
    B[D_S] = spin;
    B[D_II] = i * i;
    B[D_OO] = o * o;
    B[D_SS] = spin * spin;
    B[D_IS] = i * spin;
    B[D_IO] = i * o;
    B[D_OS] = o * spin;
    B[ANISO_INERTIA] = x->omega[0] * x->omega[2];
    B[OUTPUT_AXIS] = x->alpha[1];
    B[SCALE_FACTOR] = x->omega[0];
    B[CROSS_O] = x->omega[1];
    B[CROSS_S] = x->omega[2];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const int rotor = rotor_of(is_shared(s), axis);
    for (int q = D_F; q <= SCALE_FACTOR; q++) c[q] = v[q][axis];
    for (int q = D_I; q <= D_OS; q++) c[q] = v[q][rotor];
    rotor_misalignment(v[MISALIGNMENT], is_shared(s), axis, &c[CROSS_O], &c[CROSS_S]);
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

MODEL(spinning_mass) = {
    .name = "spinning_mass",
    .summary = "a spinning-mass gyro by IEEE 517 (one axis) or 813 (tuned rotor)",
    .source = "IEEE Std 517 (single degree of freedom), IEEE Std 813 (dynamically tuned)",
    .equation = "omega' = (1 + s) omega_i + M_o omega_o + M_s omega_s\n"
                "       + D_F + D_I a_i + D_O a_o + D_S a_s + D_II a_i^2\n"
                "       + D_OO a_o^2 + D_SS a_s^2\n"
                "       + D_IS a_i a_s + D_IO a_i a_o + D_OS a_o a_s\n"
                "       + (I_SS - I_II)/H omega_i omega_s + I_OO/H d(omega_o)/dt",
    .departures =
        "written without the standards at hand, in the form that is cited from them. i, o, s are "
        "right-handed, s = i x o, which settles the signs of products with o. The "
        "drift "
        "of a tuned rotor of IEEE 813 is the same sum: D_x is D_I, D_q is D_O, D_xz is D_IS, D_yz' "
        "is "
        "D_OS; with kind: tuned_rotor the y channel has them on the axes (y, -x, z), so that D_q "
        "appears with the other sign as in print. aniso_inertia and output_axis are those of each "
        "gyro",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

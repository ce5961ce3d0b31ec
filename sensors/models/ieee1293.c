/* SPDX-License-Identifier: MIT */
/* IEEE Std 1293: linear, single-axis, non-gyroscopic accelerometers. */
#include "sensors/accel_params.h"
#include "sensors/pendulum.h"
#include "sensors/terms.h"
#include <math.h>

enum {
    K0,
    K0_ASYMMETRY,
    K1_ASYMMETRY,
    K_OQ,
    K2,
    K3,
    K4,
    K5,
    K6,
    K7,
    DELTA_O,
    DELTA_P,
    K_IP,
    K_IO,
    K_PO,
    K_PP,
    K_OO,
    K_SPIN,
    K_ANG,
    K1, /* the term that is the input itself */
    TERMS,
    TOWARD_P = TERMS,
    TOWARD_O,
    PENDULUM,
    J_I,
    J_P,
    J_O,
    PENDULOSITY,
    R_C,
    PA_SENSE,
};

static const char *const senses[] = { "toward_hinge", "toward_mass", NULL };

#define HIGHER(N, NUMBER, MAX, EXAMPLE)                                                            \
    ACCEL_TERM("K" #N, NUMBER, ACCEL_PER((N)-1), MAX, NON_LINEAR, EXAMPLE,                         \
               "non-linearity of order " #N, "K" #N " a_i^" #N)
#define BODY(KEY, DIM_, DEF, MIN, MAX, EXAMPLE, DOC)                                               \
    {                                                                                              \
        .key = KEY, .dim = DIM_, .components = 1, .def = DEF, .min = MIN, .max = MAX,              \
        .example = EXAMPLE, .doc = DOC                                                             \
    }
#define INERTIA                                                                                    \
    {                                                                                              \
        4, 0, 0, 0, 2, 0                                                                           \
    }
#define MASS_LENGTH                                                                                \
    {                                                                                              \
        2, 0, 0, 0, 2, 0                                                                           \
    }

static const schuler_param params[] = {
    [K0] = IEEE_K0,
    [K0_ASYMMETRY] =
        ACCEL_TERM("K0_asymmetry", 141, SCHULER_DIM_ACCEL, 1e3, NON_LINEAR, "5 ug",
                   "bias asymmetry K0': bias above less bias below zero input", "1/2 K0' sgn(a_i)"),
    [K1_ASYMMETRY] =
        ACCEL_TERM("K1_asymmetry", 143, SCHULER_DIM_NONE, 0.5, NON_LINEAR, "20 ppm",
                   "scale-factor asymmetry K1': relative difference above and below zero input",
                   "1/2 K1' |a_i|"),
    [K_OQ] = ACCEL_TERM("K_oq", 144, ACCEL_PER(1), 1e-1, NON_LINEAR, "5 ug/g^2",
                        "odd quadratic non-linearity", "K_oq a_i |a_i|"),
    [K2] = IEEE_K2,
    [K3] = IEEE_K3,
    [K4] = HIGHER(4, 147, 1e-3, "0.1 ug/g^4"),
    [K5] = HIGHER(5, 148, 1e-4, "0.01 ug/g^5"),
    [K6] = HIGHER(6, 149, 1e-5, "0.001 ug/g^6"),
    [K7] = HIGHER(7, 150, 1e-6, "0.0001 ug/g^7"),
    [DELTA_O] = IEEE_DELTA_O,
    [DELTA_P] = IEEE_DELTA_P,
    [K_IP] = IEEE_K_IP,
    [K_IO] = IEEE_K_IO,
    [K_PO] = IEEE_K_PO,
    [K_PP] = IEEE_K_PP,
    [K_OO] = IEEE_K_OO,
    [K_SPIN] = { .key = "K_spin",
                 .number = 160,
                 .dim = { 2, 0, -4, 0, 0, 0 },
                 .components = 3,
                 .min = -10.0,
                 .max = 10.0,
                 .acts = SCHULER_ACTS_NON_LINEAR,
                 .example = "2e-5 g/(rad/s)^2",
                 .doc = "spin correction",
                 .formula = "K_spin omega_i omega_p" },
    [K_ANG] = { .key = "K_ang",
                .number = 161,
                .dim = { 2, 0, -2, 0, 0, 0 },
                .components = 3,
                .min = -10.0,
                .max = 10.0,
                .acts = SCHULER_ACTS_CROSS,
                .example = "4e-5 g/(rad/s^2)",
                .doc = "angular-acceleration coefficient",
                .formula = "K_ang d(omega_o)/dt" },
    [K1] = ACCEL_TERM("K1", 142, SCHULER_DIM_NONE, 0.5, SCALE, "100 ppm",
                      "error k1 of the scale factor, K1 = K1n (1 + k1): multiplies everything",
                      "(1 + k1) {...}"),
    [TOWARD_P] = ACCEL_TERM("delta_toward_p", 164, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.1 mrad",
                            "misalignment in the direction-cosine form: tilt of the input axis "
                            "toward the pendulous axis; the same as delta_o",
                            "delta_p(dc) a_p"),
    [TOWARD_O] = ACCEL_TERM("delta_toward_o", 165, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.1 mrad",
                            "misalignment in the direction-cosine form: tilt of the input axis "
                            "toward the output axis; the same as -delta_p",
                            "delta_o(dc) a_o"),
    [PENDULUM] =
        ACCEL_TERM("pendulum", 166, SCHULER_DIM_NONE, 10.0, NON_LINEAR, "1",
                   "1: adds K_spin and K_ang of the pendulum that J_i, J_p, J_o, pendulosity and "
                   "r_c describe",
                   "K_spin omega_i omega_p + K_ang d(omega_o)/dt, from the inertias"),
    [J_I] = BODY("J_i", INERTIA, 0.0, 0.0, 1.0, "0.0125 gram*cm^2", "inertia about the input axis"),
    [J_P] =
        BODY("J_p", INERTIA, 0.0, 0.0, 1.0, "0.0035 gram*cm^2", "inertia about the pendulous axis"),
    [J_O] = BODY("J_o", INERTIA, 0.0, 0.0, 1.0, "0.011 gram*cm^2", "inertia about the output axis"),
    [PENDULOSITY] = BODY("pendulosity", MASS_LENGTH, 2.5e-7, 1e-12, 1.0, "0.025 gram*cm",
                         "mass times the distance of its centre from the hinge"),
    [R_C] = BODY("r_c", SCHULER_DIM_LENGTH, 0.0, -1.0, 1.0, "0.4 cm",
                 "distance along the pendulum from the hinge to the point where f is taken"),
    [PA_SENSE] = PARAM_CHOICE("pa_sense", senses, "toward_mass",
                              "where the pendulous axis points: to the hinge (the printed signs) "
                              "or to the mass"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double i = x->a[0], p = x->a[1], o = x->a[2], i2 = i * i;
    (void)s;
    B[K0] = 1.0;
    B[K0_ASYMMETRY] = i > 0.0 ? 0.5 : i < 0.0 ? -0.5 : 0.0;
    B[K1_ASYMMETRY] = 0.5 * fabs(i);
    B[K_OQ] = i * fabs(i);
    B[K2] = i2;
    B[K3] = i2 * i;
    B[K4] = i2 * i2;
    B[K5] = i2 * i2 * i;
    B[K6] = i2 * i2 * i2;
    B[K7] = i2 * i2 * i2 * i;
    B[DELTA_O] = p;
    B[DELTA_P] = -o;
    B[K_IP] = i * p;
    B[K_IO] = i * o;
    B[K_PO] = p * o;
    B[K_PP] = p * p;
    B[K_OO] = o * o;
    B[K_SPIN] = x->omega[0] * x->omega[1];
    B[K_ANG] = x->alpha[2];
    B[K1] = i;
}

/* (1 + k1) {a_i + ...} = a_i + k1 a_i + (1 + k1) (...). */
static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const double k1 = v[K1][axis], gain = 1.0 + k1, pendulum = v[PENDULUM][axis];
    (void)s;
    for (int q = 0; q < TERMS; q++) c[q] = gain * v[q][axis];
    c[K1] = k1;
    c[DELTA_O] += gain * v[TOWARD_P][axis];
    c[DELTA_P] -= gain * v[TOWARD_O][axis];
    if (pendulum != 0.0) {
        const schuler_pendulum body = { v[J_I][0], v[J_P][0], v[J_O][0], v[PENDULOSITY][0],
                                        v[R_C][0] };
        double spin, ang;
        schuler_pendulum_coefficients(&body, (schuler_pa_sense)(int)v[PA_SENSE][0], &spin, &ang);
        c[K_SPIN] += gain * pendulum * spin;
        c[K_ANG] += gain * pendulum * ang;
    }
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(ieee1293) = {
    .name = "ieee1293",
    .summary = "the full static model of IEEE 1293: asymmetries, any order, cross terms, spin",
    .source = "IEEE Std 1293-1998 (R2008); eqs 11-20 of T. L. Grigorie et al.",
    .equation = "E = K1n (1 + k1) { K0 + 1/2 K0' sgn(a_i)\n"
                "    + [1 + 1/2 K1' sgn(a_i)] a_i + K_oq a_i |a_i|\n"
                "    + K2 a_i^2 + ... + K7 a_i^7 + delta_o a_p - delta_p a_o\n"
                "    + K_ip a_i a_p + K_io a_i a_o + K_po a_p a_o\n"
                "    + K_pp a_p^2 + K_oo a_o^2\n"
                "    + K_spin omega_i omega_p + K_ang d(omega_o)/dt }",
    .departures =
        "K_po and K_op are one coefficient. sgn(0) = 0, and the true input decides, so that noise "
        "does not toggle the bias. The printed signs of K_spin and K_ang hold for a pendulous axis "
        "from "
        "the mass to the hinge; with pa_sense: toward_mass both are reversed (Newton-Euler). The "
        "printed strapdown form reuses delta_p and delta_o for tilts toward p and o: here "
        "delta_toward_p and delta_toward_o. The product with k1 is kept exact",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

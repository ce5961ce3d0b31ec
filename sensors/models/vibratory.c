/* SPDX-License-Identifier: MIT */
/* Coriolis vibratory gyros, MEMS and hemispherical. */
#include "sensors/gyro_params.h"
#include <math.h>

enum {
    G2_II,
    G2_OO,
    G2_SS,
    G2_IO,
    G2_OS,
    G2_IS,
    SCALE_FACTOR,
    SCALE_ASYMMETRY,
    SCALE_QUADRATIC,
    SCALE_CUBIC,
    NONLINEARITY,
    BIAS,
    MISALIGNMENT,
    CROSS_AXIS,
    G_SENSITIVITY,
    VIBRATION,
    ANGULAR,
    VIBRATION_RMS,
    FULL_SCALE,
};
/* Up to BIAS parameter and coefficient are one. */
enum { ONE = BIAS, CROSS_O, CROSS_S, FORCE, TURN = FORCE + 3, TERMS = TURN + 3 };

#define SQUARED(KEY, NUMBER, DOC, FORMULA)                                                         \
    GYRO_TERM(KEY, NUMBER, GYRO_PER_ACCEL(2), 1.0, NON_LINEAR, "0.1 deg/h/g^2", DOC, FORMULA)

static const schuler_param params[] = {
    [G2_II] = SQUARED("g2_ii", 240, "square of a along the input axis", "g2_ii a_i^2"),
    [G2_OO] = SQUARED("g2_oo", 241, "square of a along the output axis", "g2_oo a_o^2"),
    [G2_SS] = SQUARED("g2_ss", 242, "square of a along the third axis", "g2_ss a_s^2"),
    [G2_IO] = SQUARED("g2_io", 243, "product of input and output axis, B_axy", "g2_io a_i a_o"),
    [G2_OS] = SQUARED("g2_os", 244, "product of output and third axis, B_ayz", "g2_os a_o a_s"),
    [G2_IS] = SQUARED("g2_is", 245, "product of input and third axis, B_axz", "g2_is a_i a_s"),
    [SCALE_FACTOR] = GYRO_SCALE_FACTOR("500 ppm"),
    [SCALE_ASYMMETRY] = GYRO_SCALE_ASYMMETRY,
    [SCALE_QUADRATIC] = GYRO_SCALE_QUADRATIC,
    [SCALE_CUBIC] = GYRO_SCALE_CUBIC,
    [NONLINEARITY] = GYRO_NONLINEARITY("full_scale"),
    [BIAS] = GYRO_BIAS("5 deg/h"),
    [MISALIGNMENT] = GYRO_MISALIGNMENT,
    [CROSS_AXIS] = GYRO_TABLE("cross_axis", 271, 6, SCHULER_DIM_NONE, 0.5, CROSS, "{uniform: 1 %}",
                              "cross-axis sensitivity xy, xz, yx, yz, zx, zy, sign unknown",
                              "k_xy omega_y + k_xz omega_z, and cyclic"),
    [G_SENSITIVITY] = GYRO_G_SENSITIVITY("{normal: 5 deg/h/g}"),
    [VIBRATION] = GYRO_VIBRATION_RECTIFICATION,
    [ANGULAR] = GYRO_TABLE("angular_acceleration", 248, 9, SCHULER_DIM_TIME, 10.0, CROSS, "1e-5 s",
                           "drift under angular acceleration about x, y, z, of the x gyro, of y, "
                           "of z",
                           "A_xx d(omega_x)/dt + A_xy d(omega_y)/dt + ..., and so on"),
    [VIBRATION_RMS] = GYRO_VIBRATION_RMS,
    [FULL_SCALE] = GYRO_SETTING("full_scale", SCHULER_DIM_RATE, 6.981317007977318, 1e-3, 1e4,
                                "400 deg/s", "range that nonlinearity is a part of"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double w = x->omega[0], i = x->a[0], o = x->a[1], third = x->a[2];
    B[G2_II] = i * i;
    B[G2_OO] = o * o;
    B[G2_SS] = third * third;
    B[G2_IO] = i * o;
    B[G2_OS] = o * third;
    B[G2_IS] = i * third;
    B[SCALE_FACTOR] = w;
    B[SCALE_ASYMMETRY] = 0.5 * fabs(w);
    B[SCALE_QUADRATIC] = w * w;
    B[SCALE_CUBIC] = w * w * w;
    B[NONLINEARITY] = gyro_nonlinearity(w, setup_setting(s, FULL_SCALE, 0));
    B[ONE] = 1.0;
    B[CROSS_O] = x->omega[1];
    B[CROSS_S] = x->omega[2];
    for (int c = 0; c < 3; c++) {
        B[FORCE + c] = x->a[c];
        B[TURN + c] = x->alpha[c];
    }
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const double rms = v[VIBRATION_RMS][0];
    const int next = cross_component(axis, 1), last = cross_component(axis, 2);
    (void)s;
    for (int q = 0; q < BIAS; q++) c[q] = v[q][axis];
    c[ONE] = v[BIAS][axis] + v[VIBRATION][axis] * rms * rms;
    c[CROSS_O] = v[MISALIGNMENT][next] + v[CROSS_AXIS][next];
    c[CROSS_S] = v[MISALIGNMENT][last] + v[CROSS_AXIS][last];
    gyro_own_axes(&v[G_SENSITIVITY][3 * axis], axis, &c[FORCE]);
    gyro_own_axes(&v[ANGULAR][3 * axis], axis, &c[TURN]);
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(vibratory) = {
    .name = "vibratory",
    .summary = "a MEMS or hemispherical gyro: sensitivity to acceleration and its products",
    .source = "D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd ed., "
              "ch. 5; IEEE Std 1431; IEEE Std 2700 (non-linearity, cross-axis)",
    .equation = "omega' = (1 + S) omega_i + M_o omega_o + M_s omega_s + B\n"
                "       + G a + A d(omega)/dt\n"
                "       + 1/2 s_a |omega_i| + q omega_i^2 + c omega_i^3\n"
                "       + e R 3 sqrt(3)/2 z (1 - z^2)\n"
                "       + g2_ii a_i^2 + g2_oo a_o^2 + g2_ss a_s^2\n"
                "       + g2_io a_i a_o + g2_os a_o a_s\n"
                "       + g2_is a_i a_s + VRC vibration_rms^2,  z = omega_i/R, |z| < 1",
    .departures =
        "written without the standards at hand. IEEE 2700 defines the non-linearity as a largest "
        "deviation, e: the cubic is one curve "
        "that "
        "has it. Quadrature is a bias that follows the temperature: bias_temperature. Rows of G "
        "and "
        "A are in body axes for input axes along them, else in the axes i, o, s that take their "
        "places. Its noise is the chain's",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

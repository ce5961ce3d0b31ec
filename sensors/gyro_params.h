/* SPDX-License-Identifier: MIT */
/* Parameters that several gyro models have, with the names and numbers they share. Each gyro has an
 * input, an output and a spin axis (i, o, s), a right-handed triad; a is the specific force, omega the
 * rate. */
#ifndef SCHULER_SENSORS_GYRO_PARAMS_H
#define SCHULER_SENSORS_GYRO_PARAMS_H

#include "sensors/params.h"
#include "sensors/terms.h"
#include <math.h>

/* Exponents doubled: of length, time, angle, temperature, mass, magnetic field. */
#define GYRO_PER_RATE(N)                                                                           \
    {                                                                                              \
        0, 2 * (N), -2 * (N), 0, 0, 0                                                              \
    } /* (rad/s)^-N */
#define GYRO_PER_ACCEL(N)                                                                          \
    {                                                                                              \
        -2 * (N), 4 * (N)-2, 2, 0, 0, 0                                                            \
    } /* (rad/s)/(m/s^2)^N */

#define GYRO_TERM PARAM_TERM
/* Components ORDER of one instrument after another: 6 (xy, xz, ...) or 9 (rows). */
#define GYRO_TABLE(KEY, NUMBER, COUNT, DIM_, MAX, ACTS_, EXAMPLE, DOC, FORMULA)                    \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = DIM_, .components = COUNT, .min = -(MAX), .max = MAX, \
        .acts = SCHULER_ACTS_##ACTS_, .example = EXAMPLE, .doc = DOC, .formula = FORMULA           \
    }
/* A setting of the whole triad. */
#define GYRO_SETTING(KEY, DIM_, DEF, MIN, MAX, EXAMPLE, DOC)                                       \
    {                                                                                              \
        .key = KEY, .dim = DIM_, .components = 1, .def = DEF, .min = MIN, .max = MAX,              \
        .example = EXAMPLE, .doc = DOC                                                             \
    }

#define GYRO_BIAS(EXAMPLE)                                                                         \
    GYRO_TERM("bias", 200, SCHULER_DIM_RATE, 1e2, CONSTANT, EXAMPLE,                               \
              "constant drift of each axis", "b")
#define GYRO_SCALE_FACTOR(EXAMPLE)                                                                 \
    GYRO_TERM("scale_factor", 201, SCHULER_DIM_NONE, 0.5, SCALE, EXAMPLE,                          \
              "scale-factor error of each axis", "s omega_i")
#define GYRO_MISALIGNMENT                                                                          \
    GYRO_TABLE("misalignment", 202, 6, SCHULER_DIM_ANGLE, 0.5, CROSS, "10 arcsec",                 \
               "small angles xy, xz, yx, yz, zx, zy toward the other axes",                        \
               "M_xy omega_y + M_xz omega_z, and cyclic")
#define GYRO_D_F                                                                                   \
    GYRO_TERM("D_F", 230, SCHULER_DIM_RATE, 1e2, CONSTANT, "0.01 deg/h",                           \
              "drift that does not depend on acceleration", "D_F")
/* Optical gyros, IEEE 647 and 952. */
#define GYRO_EPSILON_K                                                                             \
    GYRO_TERM("epsilon_K", 250, SCHULER_DIM_NONE, 0.5, SCALE, "10 ppm",                            \
              "scale-factor error in the standard's sense: a positive one lowers the output",      \
              "[I + E + D] [1 + epsilon_K]^-1")
#define GYRO_THETA_X                                                                               \
    GYRO_TERM("Theta_X", 251, SCHULER_DIM_ANGLE, 0.5, CROSS, "10 arcsec",                          \
              "misalignment of the input axis, a turn about the output axis (XRA)",                \
              "-sin(Theta_X) omega_s")
#define GYRO_THETA_Y                                                                               \
    GYRO_TERM("Theta_Y", 252, SCHULER_DIM_ANGLE, 0.5, CROSS, "10 arcsec",                          \
              "misalignment of the input axis, a turn about the third axis (YRA)",                 \
              "sin(Theta_Y) omega_o")
#define GYRO_SCALE_ASYMMETRY                                                                       \
    GYRO_TERM("scale_asymmetry", 231, SCHULER_DIM_NONE, 0.5, NON_LINEAR, "20 ppm",                 \
              "scale-factor asymmetry: slope for positive rates less slope for negative ones",     \
              "1/2 s_a |omega_i|")
#define GYRO_SCALE_QUADRATIC                                                                       \
    GYRO_TERM("scale_quadratic", 232, GYRO_PER_RATE(1), 1.0, NON_LINEAR, "1 ppm/(deg/s)",          \
              "scale-factor error in proportion to the rate", "q omega_i^2")
#define GYRO_SCALE_CUBIC                                                                           \
    GYRO_TERM("scale_cubic", 233, GYRO_PER_RATE(2), 1.0, NON_LINEAR, "0.01 ppm/(deg/s)^2",         \
              "scale-factor error in proportion to the square of the rate", "c omega_i^3")
#define GYRO_G_SENSITIVITY(EXAMPLE)                                                                \
    GYRO_TABLE("g_sensitivity", 234, 9, GYRO_PER_ACCEL(1), 1.0, CROSS, EXAMPLE,                    \
               "drift under specific force along x, y, z, of the x gyro, of y, of z",              \
               "G_xx a_x + G_xy a_y + G_xz a_z, and so on")
/* Vibration that is not in the trajectory, as one figure. */
#define GYRO_VIBRATION_RECTIFICATION                                                               \
    {                                                                                              \
        .key = "vibration_rectification", .number = 246, .dim = GYRO_PER_ACCEL(2),                 \
        .components = 3, .min = -1.0, .max = 1.0, .acts = SCHULER_ACTS_CONSTANT,                   \
        .example = "1 deg/h/g^2",                                                                  \
        .doc = "drift from vibration that the trajectory does not have; never with products of a " \
               "for vibration that it does",                                                       \
        .formula = "VRC vibration_rms^2", .companion = "vibration_rms"                             \
    }
#define GYRO_VIBRATION_RMS                                                                         \
    GYRO_SETTING("vibration_rms", SCHULER_DIM_ACCEL, 0.0, 0.0, 1e5, "4 g", "rms of that vibration")
#define GYRO_NONLINEARITY(OF)                                                                      \
    GYRO_TERM("nonlinearity", 247, SCHULER_DIM_NONE, 0.5, NON_LINEAR, "{uniform: 0.05 %}",         \
              "largest deviation from the straight line between the ends, as a part of " OF        \
              "; nothing beyond it",                                                               \
              "e R 3 sqrt(3)/2 z (1 - z^2), z = omega_i/R")

/* Of data that are as IEEE 2700 has them: a cubic, zero at the ends of the range and largest, 1, at
 * 1/sqrt(3) of it. Beyond the range nothing is said. */
static inline double gyro_nonlinearity(double omega_radps, double range_radps)
{
    const double z = omega_radps / range_radps;
    return z > -1.0 && z < 1.0 ? range_radps * (2.598076211353316 * z * (1.0 - z * z)) : 0.0;
}

/* 1/(1 + epsilon_K) - 1, without a difference of nearly equal numbers. */
static inline double gyro_bracket(double epsilon_K)
{
    return -epsilon_K / (1.0 + epsilon_K);
}

/* Coefficients of the rates about XRA and YRA. */
static inline void gyro_theta(double theta_x, double theta_y, double *x, double *y)
{
    *x = sin(theta_y);
    *y = -sin(theta_x);
}

/* Coefficients of a_i, a_o, a_s from the row of a gyro in body axes. */
static inline void gyro_own_axes(const double row[3], int axis, double own[3])
{
    for (int c = 0; c < 3; c++) own[c] = row[(axis + c) % 3];
}

#endif

/* SPDX-License-Identifier: MIT */
/* Parameters that several accelerometer models have, with the names and numbers they share. Bias-like
 * coefficients are in m/s^2, those of a power n of the specific force in (m/s^2)^(1-n). */
#ifndef SCHULER_SENSORS_ACCEL_PARAMS_H
#define SCHULER_SENSORS_ACCEL_PARAMS_H

#include "sensors/params.h"

#define ACCEL_PER(N)                                                                               \
    {                                                                                              \
        -2 * (N), 4 * (N), 0, 0, 0, 0                                                              \
    } /* (m/s^2)^-N, exponents doubled */

#define ACCEL_TERM PARAM_TERM

#define ACCEL_BIAS                                                                                 \
    ACCEL_TERM("bias", 100, SCHULER_DIM_ACCEL, 1e3, CONSTANT, "50 ug",                             \
               "constant bias of each axis", "b")
#define ACCEL_SCALE_FACTOR                                                                         \
    ACCEL_TERM("scale_factor", 101, SCHULER_DIM_NONE, 0.5, SCALE, "100 ppm",                       \
               "scale-factor error of each axis", "s a_i")
#define ACCEL_MISALIGNMENT_OF(KEY, NUMBER, DOC)                                                    \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = SCHULER_DIM_ANGLE, .components = 6, .min = -0.5,      \
        .max = 0.5, .acts = SCHULER_ACTS_CROSS, .example = "10 arcsec", .doc = DOC,                \
        .formula = "M_xy a_y + M_xz a_z, and cyclic"                                               \
    }
#define ACCEL_MISALIGNMENT                                                                         \
    ACCEL_MISALIGNMENT_OF("misalignment", 102,                                                     \
                          "small angles xy, xz, yx, yz, zx, zy toward the other axes")

/* Coefficients of the IEEE standards. */
#define IEEE_K0 ACCEL_TERM("K0", 140, SCHULER_DIM_ACCEL, 1e3, CONSTANT, "50 ug", "bias", "K0")
#define IEEE_K2                                                                                    \
    ACCEL_TERM("K2", 145, ACCEL_PER(1), 1e-1, NON_LINEAR, "10 ug/g^2",                             \
               "second-order non-linearity", "K2 a_i^2")
#define IEEE_K3                                                                                    \
    ACCEL_TERM("K3", 146, ACCEL_PER(2), 1e-2, NON_LINEAR, "5 ug/g^3", "third-order non-linearity", \
               "K3 a_i^3")
#define IEEE_DELTA_O                                                                               \
    ACCEL_TERM("delta_o", 151, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.1 mrad",                          \
               "misalignment of the input axis, a turn about the output axis", "delta_o a_p")
#define IEEE_DELTA_P                                                                               \
    ACCEL_TERM("delta_p", 152, SCHULER_DIM_ANGLE, 0.5, CROSS, "0.1 mrad",                          \
               "misalignment of the input axis, a turn about the pendulous axis", "-delta_p a_o")
#define IEEE_CROSS(KEY, NUMBER, DOC, FORMULA)                                                      \
    ACCEL_TERM(KEY, NUMBER, ACCEL_PER(1), 1e-1, NON_LINEAR, "10 ug/g^2", DOC, FORMULA)
#define IEEE_K_IP                                                                                  \
    IEEE_CROSS("K_ip", 153, "cross coupling of input and pendulous axis", "K_ip a_i a_p")
#define IEEE_K_IO IEEE_CROSS("K_io", 154, "cross coupling of input and output axis", "K_io a_i a_o")
#define IEEE_K_PO                                                                                  \
    IEEE_CROSS("K_po", 155, "cross coupling of pendulous and output axis (K_op)", "K_po a_p a_o")
#define IEEE_K_PP IEEE_CROSS("K_pp", 156, "non-linearity of the pendulous axis", "K_pp a_p^2")
#define IEEE_K_OO IEEE_CROSS("K_oo", 157, "non-linearity of the output axis", "K_oo a_o^2")

#endif

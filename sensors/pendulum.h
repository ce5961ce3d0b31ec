/* SPDX-License-Identifier: MIT */
/* What the inertia of a pendulous accelerometer makes of turning, and forms of two-sided coefficients. */
#ifndef SCHULER_SENSORS_PENDULUM_H
#define SCHULER_SENSORS_PENDULUM_H

#include "core/api.h"

SCHULER_BEGIN_C

/* Which way the pendulous axis points along the pendulum. */
typedef enum { SCHULER_PA_TOWARD_HINGE, SCHULER_PA_TOWARD_MASS } schuler_pa_sense;

typedef struct {
    double J_i, J_p, J_o; /* principal inertias about the hinge, kg m^2          */
    double pendulosity;   /* mass times distance of its centre from the hinge, kg m, > 0 */
    double r_c;           /* distance from the hinge to where f is taken, m      */
} schuler_pendulum;

/** Spin and angular-acceleration coefficients, Newton-Euler about the hinge with OA = IA x PA:
 *     K_spin = +[(J_i - J_p) - P r_c]/P,   K_ang = -[J_o - P r_c]/P   for PA toward the mass,
 *  both with the other sign for PA toward the hinge (eqs 12-13 of the paper, IEEE Std 1293).
 *  Returned   K_spin, K_ang   m, that is m/s^2 per (rad/s)^2 and per rad/s^2 */
SCHULER_API void schuler_pendulum_coefficients(const schuler_pendulum *p, schuler_pa_sense sense,
                                               double *K_spin, double *K_ang);
/** Centre of percussion J_o/P, m: K_ang vanishes there. */
SCHULER_API double schuler_pendulum_percussion(const schuler_pendulum *p);

/** Two-sided coefficients from symmetric ones and back (IEEE Std 1293, eqs 17-20 of the paper):
 *  K0+- = K0 +- K0'/2,  K1+- = K1 (1 +- K1'/2). */
typedef struct {
    double K0, K0_asymmetry, K1, K1_asymmetry;
} schuler_symmetric_form;
typedef struct {
    double K0_plus, K0_minus, K1_plus, K1_minus;
} schuler_two_sided_form;
SCHULER_API schuler_two_sided_form schuler_to_two_sided(schuler_symmetric_form s);
SCHULER_API schuler_symmetric_form schuler_to_symmetric(schuler_two_sided_form t);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* The linear error of a navigator along the truth: position, velocity and attitude in ECEF, and what a
 * barometric loop holds.
 *
 *     dr' = dv                                   dr, dv   computed less true
 *     dv' = Gamma dr - 2 W x dv + f x psi + u    computed C_b_e = (I - [psi x]) C_b_e
 *     psi' = -W x psi - w                        u, w     errors of the sensors, ECEF
 *
 * and with the loop (mechanization/vertical.h), e = n.dr - (error of the barometer):
 *
 *     dr' += -k1 e n,  dv' += -(k2 e + a) n,  a' = k3 e
 *
 *  Source    K. R. Britting, Inertial Navigation Systems Analysis, 1971, in earth-fixed axes */
#ifndef SCHULER_SCENARIOS_LINEAR_ERROR_H
#define SCHULER_SCENARIOS_LINEAR_ERROR_H

#include "core/truth.h"
#include "mechanization/vertical.h"

enum { LINEAR_DR = 0, LINEAR_DV = 3, LINEAR_PSI = 6, LINEAR_A = 9, LINEAR_STATES = 10 };

typedef struct {
    double m[LINEAR_STATES][LINEAR_STATES];
} linear_matrix;

/* A stretch of the truth, about a second long. */
typedef struct {
    double T_s;
    schuler_vec3 f_e;      /* mean specific force, m/s^2            */
    schuler_vec3 r_e, v_e; /* in the middle                          */
    schuler_vec3 end_r_e, end_v_e;
} linear_stretch;

typedef struct {
    schuler_vertical vertical;
    schuler_baro_gains gains; /* of SCHULER_VERTICAL_BARO                       */
    double hold_s;            /* of SCHULER_VERTICAL_TRUTH: between two holds */
    const schuler_gravity_table *gravity;
} linear_navigator;

/** What a stretch does.
 *  Returned   transition   x(end) = transition x(begin)
 *             drive        x(end) += drive U for a constant input of integral U: columns LINEAR_DV take u T,
 *                          LINEAR_PSI -w T; LINEAR_A the error of the barometer times T */
void linear_stretch_matrices(const linear_stretch *s, const linear_navigator *n,
                             linear_matrix *transition, linear_matrix *drive);

/** Geodetic normal, up. */
schuler_vec3 linear_up(const linear_navigator *n, schuler_vec3 r_e);

#endif

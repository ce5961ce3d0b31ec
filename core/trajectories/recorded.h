/* SPDX-License-Identifier: MIT */
/* Curves through recorded rows. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_RECORDED_H
#define SCHULER_CORE_TRAJECTORIES_RECORDED_H

#include "core/trajectory_specs.h"

/* At a row: what the curve has there beside the row itself. Time from the first row, whole ticks. */
typedef struct {
    double t_s;
    schuler_vec3 v_e, a_e; /* m/s, m/s^2 */
    schuler_vec3 omega_b;  /* relative to the earth, rad/s */
    schuler_vec3 theta_b;  /* rotation vector to the next row, rad */
} recorded_knot;

/** Velocities of the cubic spline through the positions: acceleration continuous.
 *  Given     knots   t_s;  work   room for 6 n numbers */
void recorded_spline_velocity(const schuler_recorded_sample *rows, recorded_knot *knots, size_t n,
                              double *work);
/** Accelerations for which the fifth-degree curve through positions and velocities has a continuous
 *  third derivative. */
void recorded_spline_acceleration(const schuler_recorded_sample *rows, recorded_knot *knots,
                                  size_t n, double *work);
/** Rates for which the cubic rotation vectors from row to row join with continuous rate and angular
 *  acceleration; needs theta_b.
 *  Returned  1 when it has settled, 0 when not */
int recorded_spline_rate(const schuler_recorded_sample *rows, recorded_knot *knots, size_t n,
                         double *work);

/** The rotation vector's derivative for a rate of the body, at a rotation vector rho: rho' = J(rho)^-1
 *  omega. */
schuler_vec3 recorded_rotvec_rate(schuler_vec3 rho, schuler_vec3 omega);

#endif

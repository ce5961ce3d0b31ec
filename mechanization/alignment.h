/* SPDX-License-Identifier: MIT */
/* Self-alignment of a vehicle that stays at its place: the attitude, from what its own sensors say.
 *
 * In the inertial frame i that coincides with ECEF at the end, the specific force of the place turns with
 * the earth, f_i(t) = -Rz(W (end - t)) g_e; the sensors have seen the same vector in b0 (aligner.h). The
 * constant C_b0_i between the two is found
 *
 *   coarse   from the velocities of the two halves as a triad: gravity first, then its turn
 *   fine     by a Kalman filter of the three angles of the rest, which walk with the gyros' noise, from
 *            the mean specific force of every interval; gains are the same for all lanes
 *
 * With constant sensor errors both end where gyrocompassing ends: the tilt is the accelerometers' error
 * over g, the heading the east gyro's over W cos(latitude). */
#ifndef SCHULER_MECHANIZATION_ALIGNMENT_H
#define SCHULER_MECHANIZATION_ALIGNMENT_H

#include "core/earth.h"
#include "core/error.h"
#include <stddef.h>

SCHULER_BEGIN_C

typedef struct {
    double interval_s;  /* of the records                                                       */
    size_t intervals;   /* at least 4                                                           */
    double gyro_noise;  /* rad/sqrt(s), > 0: how far the angles walk between records            */
    double accel_noise; /* m/s/sqrt(s), > 0: of the specific force, sway of the place included  */
    int fine;           /* 0: coarse only                                                       */
} schuler_alignment_setup;

typedef struct schuler_alignment schuler_alignment;

/** The gains for a place.
 *  Given      g_e   gravity there, centrifugal term included, m/s^2
 *  Errors     SCHULER_ERR_MEMORY; SCHULER_ERR_NUMERIC too near to a pole to find north */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_alignment_create(
    schuler_alignment **out, const schuler_alignment_setup *setup, schuler_vec3 g_e);
SCHULER_API void schuler_alignment_free(schuler_alignment *a); /* NULL is fine */

/** Align one lane.
 *  Given      g_e      gravity as this navigator knows it at its place
 *             v_b0     intervals + 1 records of the aligner's velocity, the first one 0
 *             q_b_b0   its attitude at the end
 *  Returned   q_b_e    body to ECEF at the end */
SCHULER_API schuler_quat schuler_alignment_solve(const schuler_alignment *a, schuler_vec3 g_e,
                                                 const schuler_vec3 *v_b0, schuler_quat q_b_b0);

SCHULER_END_C

#endif

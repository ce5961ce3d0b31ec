/* SPDX-License-Identifier: MIT */
/* The true motion: pieces of polynomials in time. Position is a polynomial in ECEF metres, attitude
 * a polynomial rotation vector from a reference attitude; velocity, acceleration and angular rate
 * are their exact derivatives. Pieces join with continuous acceleration and rate. Every kind of
 * trajectory is compiled to this, so truth is evaluated in one way only. */
#ifndef SCHULER_CORE_PATH_H
#define SCHULER_CORE_PATH_H

#include "core/earth.h"
#include "core/error.h"
#include <stddef.h>

SCHULER_BEGIN_C

/* Degree of position; velocity and the rotation vector have one less. Eleven is what a quarter
 * radian of turn on each side of the middle needs for 1e-14 m/s. */
enum { SCHULER_PIECE_DEGREE = 11 };
/* |rho| that a piece may reach: the series of sines and cosines are cut for it. */
#define SCHULER_PIECE_ANGLE_RAD 0.25

/* s = (t - t0) * 2/duration - 1 in [-1, 1]. Power series in s. */
typedef struct {
    double t0_s, duration_s;                  /* multiples of a tick (core/profile.h): exact      */
    schuler_vec3 r0_e;                        /* ECEF origin of this piece, m                     */
    double dr_e[3][SCHULER_PIECE_DEGREE + 1]; /* position minus origin, ECEF, m                   */
    schuler_quat q0_b_e;                      /* reference attitude, body to ECEF                 */
    double rho_b[3][SCHULER_PIECE_DEGREE];    /* rotation vector: q_b_e = q0_b_e * q(rho), rad    */
} schuler_piece;

typedef struct {
    size_t count;
    schuler_piece *pieces; /* contiguous in time, t0 of the first = 0, owned                     */
    double duration_s;
} schuler_path;

SCHULER_API void schuler_path_free(schuler_path *path); /* NULL is fine */

/** Index of the piece that holds t: t0 <= t < t0 + duration; the first or last one outside. */
SCHULER_API size_t schuler_path_find(const schuler_path *path, double t_s);

/* How far, in s, a piece may be continued beyond its ends; further out the motion is that at the
 * limit. */
#define SCHULER_PIECE_REACH 3.0

/* Everything about one instant. */
typedef struct {
    schuler_vec3 r_e, v_e, a_e; /* position m, velocity over ground m/s, its derivative m/s^2 */
    schuler_quat q_b_e;         /* body to ECEF                                              */
    schuler_vec3 omega_eb_b;    /* rate of the body relative to the earth, body axes, rad/s  */
} schuler_motion;

/** The motion at s of one piece. */
SCHULER_API schuler_motion schuler_piece_at(const schuler_piece *piece, double s);

/** The motion at t. t outside [0, duration] continues the first or last piece (used to prime the
 *  navigator with the samples before the start). */
SCHULER_API schuler_motion schuler_path_at(const schuler_path *path, double t_s);

SCHULER_END_C

#endif

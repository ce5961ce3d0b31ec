/* SPDX-License-Identifier: MIT */
/* From equations of motion to the pieces of a path. Private to core.
 *
 * A kind of trajectory says at any instant and place what the velocity and the attitude are, and
 * how the place changes. On a piece these are solved by collocation: Chebyshev-Lobatto nodes,
 * Picard iteration of the place until it no longer changes, position as the integral of the
 * velocity polynomial. So velocity is exactly the derivative of position, both are continuous at
 * joints to rounding, and acceleration and rate to the accuracy of the fit, which the length of the
 * piece is chosen for. */
#ifndef SCHULER_CORE_PATH_BUILD_H
#define SCHULER_CORE_PATH_BUILD_H

#include "core/path.h"
#include "core/profile.h"
#include "core/xvec.h"

/* A place above the ellipsoid and the way a track runs through it. Vectors, so that no place is
 * singular. */
typedef struct {
    xvec n_e;        /* geodetic normal, up              */
    xvec u_e;        /* horizontal tangent of the track  */
    long double h_m; /* height                           */
} schuler_course;

typedef struct {
    xvec n_rate_e, u_rate_e; /* of the course, 1/s                                */
    long double h_rate_mps;  /* of its height; 0 unless set                       */
    xvec v_e;                /* velocity over ground, m/s                         */
    xvec axes_e[3];          /* body axes forward, right, down in ECEF components */
} schuler_flow;

/* The motion at t for a course. */
typedef void schuler_flow_function(const void *user, schuler_instant t,
                                   const schuler_course *course, schuler_flow *out);

enum { SCHULER_BUILD_NODES = SCHULER_PIECE_DEGREE };

/* Matrices that act on values at the nodes. */
typedef struct {
    long double s[SCHULER_BUILD_NODES]; /* -1 .. 1            */
    long double to_chebyshev[SCHULER_BUILD_NODES][SCHULER_BUILD_NODES];
    long double to_power[SCHULER_BUILD_NODES][SCHULER_BUILD_NODES];
    long double integral[SCHULER_BUILD_NODES][SCHULER_BUILD_NODES]; /* from -1 to each node */
} schuler_collocation;

typedef struct {
    schuler_path *path; /* grows; NULL: only the course is followed, to try something out */
    size_t capacity;
    size_t count; /* pieces so far, kept or not */
    size_t pieces_max;
    double t_s;     /* where the building is: ticks, exact                            */
    double trial_s; /* length of piece to try next                                    */
    /* What the highest kept coefficients may be: m/s at walking pace, more with speed; rad. */
    long double velocity_tail, attitude_tail;
    xvec r_e; /* position there; its rounding is carried from piece to piece    */
    schuler_course course;
    long double lowest_m, highest_m; /* heights of the course so far */
    schuler_collocation collocation;
} schuler_path_builder;

/** Start at a course and a height. path must be zero-initialised, or NULL. */
void schuler_path_begin(schuler_path_builder *b, schuler_path *path, schuler_course course,
                        long double h_m);

/** Start anywhere, for flows that do not look at the course. */
void schuler_path_begin_at(schuler_path_builder *b, schuler_path *path, xvec r_e);

/** Follow a flow over t in (from, to], one analytic function of t there.
 *  Errors   SCHULER_ERR_NUMERIC  no piece is short enough (a singular flow), or too many pieces
 *           SCHULER_ERR_MEMORY;  the path is then still valid, and shorter */
SCHULER_NODISCARD schuler_status schuler_path_extend(schuler_path_builder *b,
                                                     schuler_flow_function *flow, const void *user,
                                                     double from_s, double to_s);

#endif

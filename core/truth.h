/* SPDX-License-Identifier: MIT */
/* The truth as the lanes need it: exact increments of angle and velocity, block by block. */
#ifndef SCHULER_CORE_TRUTH_H
#define SCHULER_CORE_TRUTH_H

#include "core/gravity.h"
#include "core/isa.h"
#include "core/path.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum {
    SCHULER_BLOCK = 32,
    SCHULER_NODES = 3
}; /* steps in a block; Gauss-Legendre nodes in a step */

/* Steps first+1 .. first+n: step k is the interval ((k-1) dt, k dt]. */
typedef struct {
    int64_t first;
    int n; /* 1..SCHULER_BLOCK                                       */
    double dt_s;
    double dtheta_ib_b[3][SCHULER_BLOCK]; /* integral of omega_ib_b over the step, rad            */
    double dv_ib_b[3][SCHULER_BLOCK];     /* integral of f_ib_b over the step, m/s                */
    /* Gravity on the true path at mid-step beyond the navigator's table, ECEF, m/s^2: what the
     * navigator's own model adds (dg_nav), and what only the real world has (dg_truth). */
    int has_dg; /* 0: both are all zero and need not be looked at         */
    double dg_nav_e[3][SCHULER_BLOCK];
    double dg_truth_e[3][SCHULER_BLOCK];
} schuler_truth_block;

typedef struct schuler_truth schuler_truth; /* immutable once created: shared by threads */

/** Set up the truth of a path.
 *  Given      path             borrowed, must outlive the truth
 *             dt_s             sample interval
 *             truth_gravity, nav_gravity   names for schuler_field_open
 *  Errors     SCHULER_ERR_GRAVITY_DATA, SCHULER_ERR_NUMERIC (path leaves the box of the gravity
 * table), SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_truth_create(schuler_truth **out, const schuler_path *path, double dt_s,
                     const char *truth_gravity, const char *nav_gravity, schuler_error *err);
SCHULER_API void schuler_truth_free(schuler_truth *truth);

/** Number of whole steps in the path, floor(duration/dt) with a tolerance of 1e-6 of a step. */
SCHULER_API int64_t schuler_truth_steps(const schuler_truth *truth);

/** Increments of steps first+1 .. first+n. first may be negative (priming). Relative error of the
 *  quadrature below 1e-13; a step that holds a joint of two pieces is split there. */
SCHULER_API void schuler_truth_block_compute(const schuler_truth *truth, schuler_isa isa,
                                             int64_t first, int n, schuler_truth_block *out);

/* The reference state at one instant. */
typedef struct {
    double t_s;
    schuler_llh llh;
    schuler_mat3 C_n_e;         /* north-east-down at the true position                         */
    schuler_vec3 r_e, v_e, v_n; /* m, m/s, m/s                                                  */
    schuler_quat q_b_e;
    double roll_rad, pitch_rad, heading_rad;
} schuler_truth_state;

SCHULER_API void schuler_truth_at(const schuler_truth *truth, double t_s, schuler_truth_state *out);

/** What a perfect IMU senses at one instant: inertial angular rate (rad/s) and specific force (m/s^2),
 *  body axes, with all of the real world's gravity. Outside the path as schuler_path_at. */
SCHULER_API void schuler_truth_rates(const schuler_truth *truth, double t_s,
                                     schuler_vec3 *omega_ib_b, schuler_vec3 *f_ib_b);

/** The navigator's gravity table, for mechanizations. */
SCHULER_API const schuler_gravity_table *schuler_truth_nav_gravity(const schuler_truth *truth);
SCHULER_API double schuler_truth_dt(const schuler_truth *truth);

SCHULER_END_C

#endif

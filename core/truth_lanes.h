/* SPDX-License-Identifier: MIT */
/* Between truth.c and its lane code: steps in a row that lie in one piece of the path. Private to
 * core. */
#ifndef SCHULER_CORE_TRUTH_LANES_H
#define SCHULER_CORE_TRUTH_LANES_H

#include "core/truth.h"

/* Three components for each step of a block; a struct, so that it can be const. */
typedef struct {
    double v[3][SCHULER_BLOCK];
} schuler_columns;

enum { SCHULER_RUN_TERMS = SCHULER_PIECE_DEGREE + 1 };

/* A Gauss-Legendre rule on [0, 1]. */
typedef struct {
    int count;
    double node[6], weight[6];
} schuler_quadrature;

/* One piece as the lane code wants it: power series in s, time derivatives multiplied out. */
typedef struct {
    double s0, ds; /* s at the start of step 0, s per step                                */
    double dt_s;   /* length of a step                                                    */
    int parts;     /* each step is integrated in so many equal parts, each with           */
    const schuler_quadrature *rule;
    double r0_e[3];
    const double (*dr_e)[SCHULER_RUN_TERMS];       /* m                                    */
    double free_e[3][SCHULER_PIECE_DEGREE];        /* a_e + 2 omega_ie x v_e, m/s^2        */
    const double (*rho_b)[SCHULER_PIECE_DEGREE];   /* rad                                  */
    double rho_dot_b[3][SCHULER_PIECE_DEGREE - 1]; /* rad/s                                */
    double C_e_b0[3][3];                           /* to the piece's reference attitude b0  */
    double omega_ie_b0[3];                         /* earth rate, rad/s                    */
    const schuler_gravity_table *gravity;
} schuler_truth_run;

typedef struct {
    /** Increments of steps index .. index + n - 1 of the run to columns at .. at + n - 1.
     *  Given   dg_e   gravity beyond the table per column, m/s^2, or NULL */
    void (*increments)(const schuler_truth_run *run, double index, int at, int n,
                       const schuler_columns *dg_e, double (*dtheta)[SCHULER_BLOCK],
                       double (*dv)[SCHULER_BLOCK]);
    /** Specific force and rate at one instant of each of n steps: index + i + fraction steps into the
     *  run; index is a whole number, so that no sum depends on the width. */
    void (*points)(const schuler_truth_run *run, double index, double fraction, int at, int n,
                   schuler_columns *f, schuler_columns *omega);
    /** The gravity table at n points: gravity, height and normal ratio; a check that
     * all instruction sets and the scalar twin agree. n <= SCHULER_BLOCK. */
    void (*gravity)(const schuler_gravity_table *g, int n, const schuler_columns *r_e,
                    schuler_columns *gravity_e, double *height_m, double *normal_z);
} schuler_truth_lanes;

/** The lane code compiled for an instruction set. */
const schuler_truth_lanes *schuler_truth_lanes_for(schuler_isa isa);

#endif

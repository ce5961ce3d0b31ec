/* SPDX-License-Identifier: MIT */
/* What drives the linear error: sensors that run along the truth, and random processes. Private to
 * scenarios. */
#ifndef SCHULER_SCENARIOS_COVARIANCE_PARTS_H
#define SCHULER_SCENARIOS_COVARIANCE_PARTS_H

#include "scenarios/covariance.h"
#include "scenarios/lane_spec.h"
#include "scenarios/linear_error.h"
#include "scenarios/plan.h"
#include "sensors/markov_filter.h"

/* ---- Errors that are vectors: one sigma of a component, or the mean of a source ----------------- */

typedef struct {
    int source;
    bool is_mean;
    double x[LINEAR_STATES];
    /* Integral of its input over the stretch, as linear_stretch_matrices has it; and of that times what is
     * left of the stretch: where in it the input came. */
    double u[LINEAR_STATES], later[LINEAR_STATES];
} error_vector;

/* ---- Sensors ------------------------------------------------------------------------------------ */

/* A lane of a triad that makes the input of a vector. */
typedef struct {
    int vector;
    schuler_instrument instrument;
    schuler_lane_spec spec;
} sensor_lane;

/* Both triads with their lanes. */
typedef struct {
    schuler_chain *chain;
    int count;    /* lanes */
    int *vector;  /* of each */
    char *states; /* of each vector of lanes */
    size_t state_size;
} triad_bench;

typedef struct {
    const simulation_plan *plan;
    int width;
    triad_bench triad[SCHULER_INSTRUMENTS];
    schuler_truth_nodes *nodes; /* NULL when not needed */
    double *measured;           /* [axis][step][lane] */
} sensor_bench;

/** Lanes of both triads for a plan whose truth is set.
 *  Errors   SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC (chain) */
schuler_status sensor_bench_create(sensor_bench **out, const simulation_plan *plan,
                                   const sensor_lane *lanes, int count, schuler_error *err);
void sensor_bench_free(sensor_bench *bench); /* NULL is fine */

/* Samples of a block whose errors are added in body axes and turned at once. */
typedef struct {
    int from, n;
    schuler_mat3 C_b_e; /* in their middle                      */
    double left_s;      /* from there to the end of the stretch */
} turned_samples;

/** Steps of a block, in order: add what the sensors' errors are to u of their vectors.
 *  Given   parts   of the block, count of them */
void sensor_bench_take(sensor_bench *bench, const schuler_truth_block *truth,
                       const turned_samples *parts, int count, error_vector *vectors);

/* ---- Random processes --------------------------------------------------------------------------- */

/* Of one axis of a triad, or of the barometer: db/dt = ..., see sensors/processes.h. */
typedef struct {
    double
        T_s; /* correlation time; 0: white of density sigma^2; INFINITY: a walk of coefficient sigma */
    double sigma;
    double variance;             /* of b now */
    double cross[LINEAR_STATES]; /* covariance of the error with b */
} noise_member;

enum { NOISE_MEMBERS_MAX = 3 * SCHULER_MARKOV_MAX };

typedef struct {
    int source;
    int input; /* LINEAR_DV, LINEAR_PSI: three axes; LINEAR_A: the barometer */
    int members;
    int axis[NOISE_MEMBERS_MAX];
    noise_member member[NOISE_MEMBERS_MAX];
    double P[LINEAR_STATES][LINEAR_STATES];
} noise_source;

/** The processes of a source; NULL when it is one, else why it is not covered. */
const char *noise_source_of(noise_source *out, const simulation_plan *plan, int source);

/** Let the processes go on for a time, in which the integral of an axis adds G[axis] of it to the error. */
void noise_source_inject(noise_source *n, double T_s, double (*G)[LINEAR_STATES]);

/** Over a stretch. C_b_e: mean over it, column = body axis. */
void noise_source_step(noise_source *n, double T_s, const schuler_mat3 *C_b_e,
                       const linear_matrix *transition, const linear_matrix *drive);

/* ---- A run of the covariance -------------------------------------------------------------------- */

typedef struct {
    simulation_plan plan;
    const schuler_truth *truth;
    linear_navigator navigator;
    schuler_covariance *result;
    error_vector *vectors;
    sensor_lane *lanes;
    noise_source *noises;
    int vector_count, lane_count, noise_count;
    sensor_bench *bench;
    double start_h_m;
} covariance_run;

/** Vectors, lanes or processes of a source, added to the run's.
 *  Returned   NULL, or why it is not covered */
const char *covariance_add_source(covariance_run *c, int source);

/** Attitudes that a self-alignment ends with, put into the vectors and processes. Nothing when there is none.
 *  Errors   SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC */
schuler_status covariance_align(covariance_run *c, schuler_error *err);

/** Mean and one sigma of a component of a source over the runs. */
void covariance_moments(const error_source *s, int component, uint64_t seed, double *mean,
                        double *sigma);

#endif

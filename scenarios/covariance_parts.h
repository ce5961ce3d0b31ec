/* SPDX-License-Identifier: MIT */
/* What drives the linear error: sensors that run along the truth, and random processes. Private to
 * scenarios. */
#ifndef SCHULER_SCENARIOS_COVARIANCE_PARTS_H
#define SCHULER_SCENARIOS_COVARIANCE_PARTS_H

#include "scenarios/lane_spec.h"
#include "scenarios/linear_error.h"
#include "scenarios/plan.h"
#include "sensors/markov_filter.h"

/* ---- Errors that are vectors: one sigma of a component, or the mean of a source ----------------- */

typedef struct {
    int source;
    bool is_mean;
    double x[LINEAR_STATES];
    double u
        [LINEAR_STATES]; /* integral of its input over the stretch, as linear_stretch_matrices has it */
} error_vector;

/* ---- Sensors ------------------------------------------------------------------------------------ */

/* A lane of a triad that makes the input of a vector. */
typedef struct {
    int vector;
    schuler_instrument instrument;
    schuler_lane_spec spec;
} sensor_lane;

typedef struct sensor_bench sensor_bench;

/** Lanes of both triads for a plan whose truth is set.
 *  Errors   SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC (chain) */
schuler_status sensor_bench_create(sensor_bench **out, const simulation_plan *plan,
                                   const sensor_lane *lanes, int count, schuler_error *err);
void sensor_bench_free(sensor_bench *bench); /* NULL is fine */

/* Samples whose errors are added in body axes and turned at once: what the body turns in them counts by its
 * square over 24. */
enum { TURNED_TOGETHER = 8, TURNS_MAX = (SCHULER_BLOCK + TURNED_TOGETHER - 1) / TURNED_TOGETHER };

/** Steps of a block, in order: add what the sensors' errors are to u of their vectors.
 *  Given   C_b_e   in the middle of each TURNED_TOGETHER of its steps */
void sensor_bench_take(sensor_bench *bench, const schuler_truth_block *truth,
                       const schuler_mat3 *C_b_e, error_vector *vectors);

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

/** Over a stretch. C_b_e: mean over it, column = body axis. */
void noise_source_step(noise_source *n, double T_s, const schuler_mat3 *C_b_e,
                       const linear_matrix *transition, const linear_matrix *drive);

#endif

/* SPDX-License-Identifier: MIT */
/* The lanes of a batch in vectors, with the state of their sensors and navigators. */
#ifndef SCHULER_SCENARIOS_BATCH_H
#define SCHULER_SCENARIOS_BATCH_H

#include "core/truth.h"
#include "mechanization/mechanization.h"
#include "scenarios/plan.h"
#include "scenarios/vertical.h"
#include "sensors/chain.h"

typedef struct {
    int chunk, row, run; /* chunk: within the batch            */
    int normals;         /* random numbers a step: lanes of a kind go together */
    int result;          /* place in the order of results      */
} batch_lane;

/* A vector of lanes: a model state for each triad and a mechanization state. */
typedef struct {
    void *triad[SCHULER_INSTRUMENTS];
    void *nav;
    vertical_lane *vertical; /* NULL unless there is a barometer */
} lane_group;

typedef struct {
    const simulation_plan *plan;
    schuler_chain *chain[SCHULER_INSTRUMENTS];
    bool needs_nodes; /* some chain looks at instants */
    const schuler_mechanization *frame;
    int width;         /* lanes in a vector */
    batch_lane *lanes; /* by kind, then in the order of results: group g holds width from g*width */
    int count;
    lane_group *groups;
    int group_count;
    vertical_setup vertical;               /* of the barometers' loops */
    vertical_lane *vertical_lanes;         /* of all groups, or NULL   */
    char *memory;                          /* of all states */
    double *measured[SCHULER_INSTRUMENTS]; /* [axis][step][lane], reused by every group */
    schuler_truth_nodes *nodes;            /* NULL unless they are needed */
} lane_batch_state;

/** Set up batch `index` at the true start: values drawn; without self-alignment also the navigators.
 *  Errors  SCHULER_ERR_MEMORY; free with schuler_batch_state_free in any case */
schuler_status schuler_batch_state_make(lane_batch_state *b, const simulation_plan *plan,
                                        size_t index, schuler_error *err);
void schuler_batch_state_free(lane_batch_state *b);

/** Start the navigators: initial errors applied, primed.
 *  Given   q_b_e   what self-alignment has found for each lane; NULL: the truth, with its errors */
void schuler_batch_navigators(lane_batch_state *b, const schuler_quat *q_b_e);
/** Where lane i believes to be, ECEF, and whether it knows the disturbance of gravity. */
schuler_vec3 schuler_batch_place(const lane_batch_state *b, int i, double *knows_dg);

#endif

/* SPDX-License-Identifier: MIT */
/* Strapdown mechanizations: each frame is one file in mechanization/frames/ with lane code behind
 * this table. All work on one vector of lanes at a time, block by block. */
#ifndef SCHULER_MECHANIZATION_MECHANIZATION_H
#define SCHULER_MECHANIZATION_MECHANIZATION_H

#include "core/gravity.h"
#include "core/isa.h"
#include "mechanization/algorithms.h"
#include <stddef.h>
#include <stdint.h>

SCHULER_BEGIN_C

/* Position, velocity and attitude of one lane, whatever the frame it is computed in. */
typedef struct {
    schuler_vec3 r_e;   /* ECEF, m                                                            */
    schuler_vec3 v_e;   /* velocity over ground, ECEF components, m/s                         */
    schuler_quat q_b_e; /* body to ECEF                                                       */
} schuler_nav_state;

enum { SCHULER_PRIME = 3 }; /* samples before the start that the highest order looks back at */

typedef struct {
    double dt_s;            /* sample interval                                    */
    int samples_per_update; /* fast cycles in a navigation cycle: 1, 2, 4 ...     */
    int order; /* of the recursion for coning and sculling: 1 (none), 2 or 4                     */
    const schuler_coning_algorithm *algorithm; /* what groups of samples correct; NULL = nothing.
                                                  Needs samples_per_update 1                     */
    const schuler_gravity_table *gravity; /* borrowed                                           */
    int lanes;
    const schuler_nav_state *start; /* one per lane                                       */
    const double *dg_coefficient;   /* one per lane: 1 = the navigator knows dg_truth, 0 = not */
    double prime_dtheta[SCHULER_PRIME][3]; /* true increments before the start, newest first     */
    double prime_dv[SCHULER_PRIME][3];
} schuler_nav_setup;

/* dtheta and dv are [axis][step][lane], axes stride*lanes doubles apart. dg_* are [axis][step],
 * axes stride doubles apart: both given, or both NULL when there is none. */
typedef struct {
    int n, stride;
    const double *dtheta, *dv;
    const double *dg_nav_e, *dg_truth_e;
} schuler_nav_block;

typedef struct {
    const char *name, *summary, *source;
    const char *equation, *limits; /* as text; lines of the first separated by \n, 76 columns */
    double latitude_max_rad;       /* north and south, where the frame ends; 0: it does not */
    size_t state_size;             /* bytes, aligned to 64, for one vector of lanes */
    size_t group_size;             /* more of them, for an algorithm of several samples */
    void (*init)(void *state, const schuler_nav_setup *setup);
    /** Advance by block->n samples. A block ends on a navigation cycle: n is a multiple of
     *  samples_per_update, except at the end of a run, where the rest is not updated. */
    void (*advance)(void *state, const schuler_nav_block *block);
    /** Hold the vertical channel: put height and up-velocity to the given values, leave the
     * horizontal channels alone. */
    void (*hold_vertical)(void *state, double height_m, double v_up_mps);
    /** Heights of the lanes, and corrections of height and up-velocity along each lane's own
     * vertical. Arrays of one value a lane, aligned to 64. */
    void (*height)(const void *state, double *height_m);
    void (*correct_vertical)(void *state, const double *dh_m, const double *dv_up_mps);
    void (*get)(const void *state, int lane, schuler_nav_state *out);
} schuler_mechanization;

/** Bytes of a state for an algorithm (NULL: the recursion alone), a multiple of 64. */
SCHULER_API size_t schuler_mechanization_size(const schuler_mechanization *m,
                                              const schuler_coning_algorithm *algorithm);

/** 1 when a place is beyond the latitude at which the frame ends. */
SCHULER_API int schuler_mechanization_ends(const schuler_mechanization *m, schuler_vec3 r_e);

/** All frames as compiled for an instruction set, NULL-terminated; and the index of one, or -1. */
SCHULER_API const schuler_mechanization *const *schuler_mechanizations(schuler_isa isa);
SCHULER_API int schuler_mechanization_find(const char *name);

SCHULER_END_C

#endif

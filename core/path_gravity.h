/* SPDX-License-Identifier: MIT */
/* What gravity has beyond the tables, along a path: polynomials in time between samples of the full
 * models. Private to core. */
#ifndef SCHULER_CORE_PATH_GRAVITY_H
#define SCHULER_CORE_PATH_GRAVITY_H

#include "core/gravity.h"
#include "core/path.h"
#include "core/truth_lanes.h"

enum { SCHULER_PATH_GRAVITY_TERMS = 17 };

/* The three things that are told apart. */
enum {
    SCHULER_PATH_REAL, /* the real world's field less its table: for the specific force        */
    SCHULER_PATH_NAV,  /* the navigator's field less its table: what it adds by itself         */
    SCHULER_PATH_ONLY_REAL, /* the real world's field less the navigator's: what it does not know */
    SCHULER_PATH_PARTS,
};

typedef struct {
    double t0_s, duration_s;
    int terms;
    double dg_e[SCHULER_PATH_PARTS][3]
               [SCHULER_PATH_GRAVITY_TERMS]; /* powers of s in [-1, 1], m/s^2 */
} schuler_path_gravity_interval;

typedef struct {
    size_t count;                             /* contiguous in time; 0 = zero everywhere */
    int has[SCHULER_PATH_PARTS];              /* 0: that part is zero everywhere         */
    schuler_path_gravity_interval *intervals; /* owned */
} schuler_path_gravity;

/* The field of one side and its table. */
typedef struct {
    const schuler_field_model *field;
    const schuler_gravity_table *table;
} schuler_path_field;

/** Sample both sides along the path; nav NULL: the same as real. Nothing is done where all is zero.
 *  Errors     SCHULER_ERR_MEMORY */
SCHULER_NODISCARD schuler_status schuler_path_gravity_sample(schuler_path_gravity *out,
                                                             const schuler_path *path,
                                                             const schuler_path_field *real,
                                                             const schuler_path_field *nav);
void schuler_path_gravity_free(schuler_path_gravity *g);

/** In the middle of the steps first+1 .. first+n of length dt, m/s^2; outside the path the value at
 *  its end. n <= SCHULER_BLOCK. Each step's value depends on nothing but its number. */
void schuler_path_gravity_fill(const schuler_path_gravity *g, double dt_s, int64_t first, int n,
                               schuler_columns out[SCHULER_PATH_PARTS]);

/** One part at one instant, m/s^2; outside the path the value at its end. */
schuler_vec3 schuler_path_gravity_at(const schuler_path_gravity *g, int part, double t_s);

#endif

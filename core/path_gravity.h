/* SPDX-License-Identifier: MIT */
/* What a gravity model has beyond a table, along a path: polynomials in time between samples of the
 * full model. Private to core. */
#ifndef SCHULER_CORE_PATH_GRAVITY_H
#define SCHULER_CORE_PATH_GRAVITY_H

#include "core/gravity.h"
#include "core/path.h"

enum { SCHULER_PATH_GRAVITY_TERMS = 5 };

typedef struct {
    double t0_s, duration_s;
    double dg_e[3][SCHULER_PATH_GRAVITY_TERMS]; /* powers of s in [-1, 1], m/s^2 */
} schuler_path_gravity_interval;

typedef struct {
    size_t count;                             /* contiguous in time; 0 = zero everywhere */
    schuler_path_gravity_interval *intervals; /* owned */
} schuler_path_gravity;

/** Sample field minus table along the path, gaps of at most 5 km of arc and 1 km of height. Nothing
 *  is done for a field without a disturbance.
 *  Errors   SCHULER_ERR_MEMORY */
SCHULER_NODISCARD schuler_status schuler_path_gravity_sample(schuler_path_gravity *out,
                                                             const schuler_path *path,
                                                             const schuler_field_model *field,
                                                             const schuler_gravity_table *table);
void schuler_path_gravity_free(schuler_path_gravity *g);
/** At t, m/s^2; outside the path the value at its end. */
schuler_vec3 schuler_path_gravity_at(const schuler_path_gravity *g, double t_s);

#endif

/* SPDX-License-Identifier: MIT */
/* Gravity disturbance of a full model along a path that is only known as it is navigated: straight
 * lines between the model's values at places ahead. */
#ifndef SCHULER_SCENARIOS_DISTURBANCE_H
#define SCHULER_SCENARIOS_DISTURBANCE_H

#include "core/gravity.h"
#include <stdint.h>

typedef struct {
    const schuler_field_model *field;
    const schuler_gravity_table *table;
    double dt_s;
    int64_t from, to; /* steps the stretch covers                                       */
    schuler_vec3 dg_from, dg_to; /* at its ends, ECEF, m/s^2 */
} schuler_disturbance;

/** Steps that may be taken from step now before the next look ahead; looks ahead when due.
 *  Given      r_e, v_e   where the navigator is, m and m/s */
int64_t schuler_disturbance_ahead(schuler_disturbance *d, int64_t now, schuler_vec3 r_e,
                                  schuler_vec3 v_e);

/** Its value at mid-step of the n steps after step now: out[axis * stride + step]. */
void schuler_disturbance_fill(const schuler_disturbance *d, int64_t now, int n, int stride,
                              double *out);

#endif

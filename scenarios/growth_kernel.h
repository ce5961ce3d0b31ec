/* SPDX-License-Identifier: MIT */
/* Position north and east at 0, dt, 2 dt, ... after a unit of an error at time 0. Private to growth. */
#ifndef SCHULER_SCENARIOS_GROWTH_KERNEL_H
#define SCHULER_SCENARIOS_GROWTH_KERNEL_H

#include "scenarios/growth.h"

/* How the error begins: an impulse, constant from 0 on, growing as t. */
typedef enum { KERNEL_IMPULSE, KERNEL_STEP, KERNEL_RAMP } kernel_shape;

/* r_N, r_E, v_N, v_E, psi_N, psi_E, psi_D; then the error and its slope. */
enum { KERNEL_STATES = 9 };

typedef struct {
    schuler_growth_entry entry;
    schuler_growth_law law;
    kernel_shape shape;
    const schuler_rest *rest;
    double u_n[3], dt_s;
    int64_t step;
    double x[KERNEL_STATES], transition[KERNEL_STATES][KERNEL_STATES]; /* of the law EARTH */
} growth_kernel;

/** Given   shape   KERNEL_IMPULSE for errors of the start */
void growth_kernel_start(growth_kernel *k, const schuler_growth *growth, int component,
                         const schuler_rest *rest, schuler_growth_law law, kernel_shape shape,
                         double dt_s);
/** Where it is now. */
void growth_kernel_at(const growth_kernel *k, double out_m[2]);
void growth_kernel_step(growth_kernel *k);

#endif

/* SPDX-License-Identifier: MIT */
/* The instantaneous output of a lane within a step, for what is not linear in it: the true input at a
 * node, and the errors of the stages before, taken as constant within the step. */
#ifndef SCHULER_SENSORS_INSTANT_H
#define SCHULER_SENSORS_INSTANT_H

#include "core/truth.h"
#include "sensors/setup.h"

/* Mean error of the output y of a step, m/s^2 or rad/s. */
LANES_INLINE lanes instant_error(const schuler_model_block *b, int axis, int step, lanes y)
{
    return (y - lanes_set(b->own[axis * b->stride + step])) * lanes_set(1.0 / b->dt_s);
}

LANES_INLINE lanes instant_value(const schuler_model_block *b, schuler_instrument instrument,
                                 int axis, int step, int node, lanes error)
{
    const double *const truth =
        instrument == SCHULER_ACCEL ? b->view->f[axis][0] : b->view->omega[axis][0];
    return lanes_set(truth[node * SCHULER_BLOCK + step]) + error;
}

#endif

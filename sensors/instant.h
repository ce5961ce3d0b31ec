/* SPDX-License-Identifier: MIT */
/* The instantaneous output of a lane within a step, for what is not linear in it: the true input at a
 * node, and the errors of the stages before, taken as constant within the step. */
#ifndef SCHULER_SENSORS_INSTANT_H
#define SCHULER_SENSORS_INSTANT_H

#include "core/truth.h"
#include "sensors/setup.h"

LANES_INLINE double instant_truth(const schuler_model_block *b, schuler_instrument instrument,
                                  int axis, int step, int node)
{
    const double *const truth =
        instrument == SCHULER_ACCEL ? b->view->f[axis][0] : b->view->omega[axis][0];
    return truth[node * SCHULER_BLOCK + step];
}

/* What the output y of a step has beside the truth at its nodes, m/s^2 or rad/s: the instantaneous
 * values have the mean y/dt. */
LANES_INLINE lanes instant_error(const schuler_model_block *b, schuler_instrument instrument,
                                 int axis, int step, lanes y)
{
    double mean = 0.0;
    for (int j = 0; j < b->view->nodes; j++)
        mean += b->view->weight[j] * instant_truth(b, instrument, axis, step, j);
    return y * lanes_set(1.0 / b->dt_s) - lanes_set(mean);
}

LANES_INLINE lanes instant_value(const schuler_model_block *b, schuler_instrument instrument,
                                 int axis, int step, int node, lanes error)
{
    return lanes_set(instant_truth(b, instrument, axis, step, node)) + error;
}

#endif

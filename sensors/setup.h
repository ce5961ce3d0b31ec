/* SPDX-License-Identifier: MIT */
/* Getting the values of a parameter from the lanes' specs into vectors. */
#ifndef SCHULER_SENSORS_SETUP_H
#define SCHULER_SENSORS_SETUP_H

#include "core/lanes.h"
#include "sensors/model.h"

LANES_INLINE lanes setup_value(const schuler_model_setup *s, int param, int component)
{
    double x[SCHULER_LANES] __attribute__((aligned(64)));
    for (int l = 0; l < SCHULER_LANES; l++) x[l] = s->specs[l].value[param][component];
    return lanes_load(x);
}

LANES_INLINE lanes_u64 setup_runs(const schuler_model_setup *s)
{
    uint64_t x[SCHULER_LANES];
    lanes_u64 runs;
    for (int l = 0; l < SCHULER_LANES; l++) x[l] = s->specs[l].run;
    memcpy(&runs, x, sizeof(runs));
    return runs;
}

/* Whether any lane has a non-zero component: a process that no lane has is not computed. */
LANES_INLINE int setup_any(const schuler_model_setup *s, int param, int components)
{
    for (int l = 0; l < SCHULER_LANES; l++)
        for (int i = 0; i < components; i++)
            if (s->specs[l].value[param][i] != 0.0) return 1;
    return 0;
}

#endif

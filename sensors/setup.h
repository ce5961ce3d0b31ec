/* SPDX-License-Identifier: MIT */
/* Getting the values of a parameter from the lanes' specs into vectors. */
#ifndef SCHULER_SENSORS_SETUP_H
#define SCHULER_SENSORS_SETUP_H

#include "core/lanes.h"
#include "sensors/model.h"

/* One component in one lane. */
LANES_INLINE double setup_lane(const schuler_model_setup *s, int lane, int param, int component)
{
    return s->specs[lane].value[s->base + param][component];
}

/* A setting: the same in every lane. */
LANES_INLINE double setup_setting(const schuler_model_setup *s, int param, int component)
{
    return setup_lane(s, 0, param, component);
}

LANES_INLINE lanes setup_value(const schuler_model_setup *s, int param, int component)
{
    double x[SCHULER_LANES] __attribute__((aligned(64)));
    for (int l = 0; l < SCHULER_LANES; l++) x[l] = setup_lane(s, l, param, component);
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
            if (setup_lane(s, l, param, i) != 0.0) return 1;
    return 0;
}

#endif

/* SPDX-License-Identifier: MIT */
#include "core/overlay_gimbal.h"
#include <math.h>

/* Rounds that lie wholly before t; a whole number of them is exact in ticks. */
static double round_start(const overlay_gimbal *g, double t_s)
{
    return floor(t_s / g->round_s) * g->round_s;
}

void schuler_gimbal_at(const overlay_gimbal *g, schuler_instant t, long double *angle_rad,
                       long double *rate_radps)
{
    if (g->count == 0) {
        *angle_rad = (long double)g->rate_radps * ((long double)t.joint_s + t.after_s);
        *rate_radps = g->rate_radps;
        return;
    }
    /* By the joint: what follows it is one analytic function, also at the end of a round. */
    const double start_s = round_start(g, t.joint_s);
    const long double rounds = roundl((long double)start_s / g->round_s);
    *angle_rad = rounds * g->round_rad;
    *rate_radps = 0.0L;
    for (size_t i = 0; i < g->count; i++) {
        const schuler_instant since = { t.joint_s - start_s - g->moves[i].start_s, t.after_s };
        *angle_rad += schuler_trapezoid_value(&g->moves[i].trapezoid, since);
        *rate_radps += schuler_trapezoid_rate(&g->moves[i].trapezoid, since);
    }
}

double schuler_gimbal_next_joint(const overlay_gimbal *g, double t_s)
{
    if (g->count == 0) return INFINITY;
    const double start_s = round_start(g, t_s);
    double next_s = start_s + g->round_s;
    for (size_t i = 0; i < g->count; i++) {
        const schuler_trapezoid *const z = &g->moves[i].trapezoid;
        const double at_s = start_s + g->moves[i].start_s;
        const double joints_s[] = { at_s, at_s + z->ramp_s, at_s + z->ramp_s + z->plateau_s,
                                    at_s + schuler_trapezoid_duration(z) };
        for (int j = 0; j < 4; j++)
            if (joints_s[j] > t_s && joints_s[j] < next_s) next_s = joints_s[j];
    }
    return next_s;
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/disturbance.h"
#include <math.h>

static schuler_vec3 at(const schuler_disturbance *d, schuler_vec3 r_e)
{
    return schuler_vec3_sub(schuler_field_gravity(d->field, r_e),
                            schuler_gravity_at(d->table, r_e));
}

int64_t schuler_disturbance_ahead(schuler_disturbance *d, int64_t now, schuler_vec3 r_e,
                                  schuler_vec3 v_e)
{
    if (now >= d->to) {
        /* The shortest wave of a degree-360 model is 110 km; over 500 m a straight line leaves less
         * than (2 pi 500/110000)^2/8 = 1e-4 of its amplitude. Two seconds of a turn move the end by
         * 20 m. */
        const double reach_s = fmin(2.0, 500.0 / fmax(schuler_vec3_norm(v_e), 1.0));
        const double steps = fmax(1.0, floor(reach_s / d->dt_s));
        d->from = now;
        d->to = now + (int64_t)steps;
        d->dg_from = at(d, r_e);
        d->dg_to = at(d, schuler_vec3_add(r_e, schuler_vec3_scale(steps * d->dt_s, v_e)));
    }
    return d->to - now;
}

void schuler_disturbance_fill(const schuler_disturbance *d, int64_t now, int n, int stride,
                              double *out)
{
    const double whole = (double)(d->to - d->from);
    for (int k = 0; k < n; k++) {
        const double part = ((double)(now - d->from + k) + 0.5) / whole;
        for (int i = 0; i < 3; i++)
            out[i * stride + k] = d->dg_from.v[i] + part * (d->dg_to.v[i] - d->dg_from.v[i]);
    }
}

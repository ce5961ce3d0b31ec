/* SPDX-License-Identifier: MIT */
/* The scalar twin of gravity_lanes.h: the same operations in the same order, so the same bits. */
#include "core/gravity.h"

static void variables(const schuler_gravity_table *g, schuler_vec3 r_e, double *T, double *U)
{
    const double x = r_e.v[0], y = r_e.v[1], z = r_e.v[2];
    const double p2 = x * x + y * y, z2 = z * z;
    *T = z2 * g->t_scale + g->t_shift;
    *U = p2 * g->u_xy + (z2 * g->u_z + g->u_shift);
}

static double series(const double c[SCHULER_GRAVITY_TERMS], double T, double U)
{
    const double *row = c + SCHULER_GRAVITY_TERMS - 1;
    double sum = row[0];
    for (int i = SCHULER_GRAVITY_DEGREE - 1; i >= 0; i--) {
        const int last = SCHULER_GRAVITY_DEGREE - i;
        row -= last + 1;
        double in_U = row[last];
        for (int j = last - 1; j >= 0; j--) in_U = in_U * U + row[j];
        sum = sum * T + in_U;
    }
    return sum;
}

schuler_vec3 schuler_gravity_at(const schuler_gravity_table *g, schuler_vec3 r_e)
{
    double T, U;
    variables(g, r_e, &T, &U);
    const double horizontal = g->omega2 - series(g->A, T, U);
    const double vertical = series(g->B, T, U);
    return (schuler_vec3){ { r_e.v[0] * horizontal, r_e.v[1] * horizontal, r_e.v[2] * -vertical } };
}

double schuler_gravity_height(const schuler_gravity_table *g, schuler_vec3 r_e)
{
    double T, U;
    variables(g, r_e, &T, &U);
    return series(g->height, T, U);
}

double schuler_gravity_normal_z(const schuler_gravity_table *g, schuler_vec3 r_e)
{
    double T, U;
    variables(g, r_e, &T, &U);
    return series(g->normal_z, T, U);
}

/* SPDX-License-Identifier: MIT */
/* The gravity table on a vector of lanes: the hot spot of the whole program. No division, no square
 * root; coefficients are broadcast from the table. gravity.c holds the scalar twin, operation for
 * operation the same. */
#ifndef SCHULER_CORE_GRAVITY_LANES_H
#define SCHULER_CORE_GRAVITY_LANES_H

#include "core/gravity.h"
#include "core/lanes.h"

/* The two scaled variables of a position. */
LANES_INLINE void lanes_gravity_variables(const schuler_gravity_table *g, lanes x, lanes y, lanes z,
                                          lanes *T, lanes *U)
{
    const lanes p2 = x * x + y * y, z2 = z * z;
    *T = z2 * g->t_scale + g->t_shift;
    *U = p2 * g->u_xy + (z2 * g->u_z + g->u_shift);
}

/* Sum of c_ij T^i U^j, nested Horner: rows in U, then the rows in T. */
LANES_INLINE lanes lanes_gravity_series(const double c[SCHULER_GRAVITY_TERMS], lanes T, lanes U)
{
    const double *row = c + SCHULER_GRAVITY_TERMS - 1;
    lanes sum = lanes_set(row[0]);
#pragma GCC unroll 8
    for (int i = SCHULER_GRAVITY_DEGREE - 1; i >= 0; i--) {
        const int last = SCHULER_GRAVITY_DEGREE - i;
        row -= last + 1;
        lanes in_U = lanes_set(row[last]);
#pragma GCC unroll 8
        for (int j = last - 1; j >= 0; j--) in_U = in_U * U + row[j];
        sum = sum * T + in_U;
    }
    return sum;
}

/** Gravity with centrifugal term at ECEF positions (m), m/s^2; see schuler_gravity_at. */
LANES_INLINE void lanes_gravity(const schuler_gravity_table *g, lanes x, lanes y, lanes z,
                                lanes out[3])
{
    lanes T, U;
    lanes_gravity_variables(g, x, y, z, &T, &U);
    const lanes horizontal = g->omega2 - lanes_gravity_series(g->A, T, U);
    const lanes vertical = lanes_gravity_series(g->B, T, U);
    out[0] = x * horizontal;
    out[1] = y * horizontal;
    out[2] = z * -vertical;
}

/** Geodetic height, m. */
LANES_INLINE lanes lanes_height(const schuler_gravity_table *g, lanes x, lanes y, lanes z)
{
    lanes T, U;
    lanes_gravity_variables(g, x, y, z, &T, &U);
    return lanes_gravity_series(g->height, T, U);
}

/** k such that the geodetic normal (up) is along (x, y, k z). */
LANES_INLINE lanes lanes_normal_z(const schuler_gravity_table *g, lanes x, lanes y, lanes z)
{
    lanes T, U;
    lanes_gravity_variables(g, x, y, z, &T, &U);
    return lanes_gravity_series(g->normal_z, T, U);
}

#endif

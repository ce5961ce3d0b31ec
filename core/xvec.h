/* SPDX-License-Identifier: MIT */
/* Three-vectors in extended precision, for building paths: what is built there is rounded to double
 * once, at the end. Private to core. */
#ifndef SCHULER_CORE_XVEC_H
#define SCHULER_CORE_XVEC_H

#include "core/vec.h"

typedef struct {
    long double v[3];
} xvec;

static inline xvec xvec_make(long double x, long double y, long double z)
{
    return (xvec){ { x, y, z } };
}

/* a + k b */
static inline xvec xvec_add_scaled(xvec a, long double k, xvec b)
{
    return xvec_make(a.v[0] + k * b.v[0], a.v[1] + k * b.v[1], a.v[2] + k * b.v[2]);
}

static inline xvec xvec_scale(long double k, xvec a)
{
    return xvec_make(k * a.v[0], k * a.v[1], k * a.v[2]);
}

static inline long double xvec_dot(xvec a, xvec b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

static inline xvec xvec_cross(xvec a, xvec b)
{
    return xvec_make(a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2],
                     a.v[0] * b.v[1] - a.v[1] * b.v[0]);
}

static inline xvec xvec_unit(xvec a)
{
    return xvec_scale(1.0L / sqrtl(xvec_dot(a, a)), a);
}

/* Axes, as columns, turned about one of them: the new axes in the frame of the old ones. */
static inline void xvec_turn(xvec axes[3], int axis, long double angle_rad)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const long double c = cosl(angle_rad), s = sinl(angle_rad);
    const xvec first = axes[a], second = axes[b];
    axes[a] = xvec_add_scaled(xvec_scale(c, first), s, second);
    axes[b] = xvec_add_scaled(xvec_scale(c, second), -s, first);
}

/* Components along axes, to the frame in which these are given. */
static inline xvec xvec_along(const xvec axes[3], xvec x)
{
    return xvec_add_scaled(xvec_add_scaled(xvec_scale(x.v[0], axes[0]), x.v[1], axes[1]), x.v[2],
                           axes[2]);
}

static inline schuler_vec3 xvec_round(xvec a)
{
    return (schuler_vec3){ { (double)a.v[0], (double)a.v[1], (double)a.v[2] } };
}

#endif

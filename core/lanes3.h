/* SPDX-License-Identifier: MIT */
/* Three-vectors and quaternions of lanes. */
#ifndef SCHULER_CORE_LANES3_H
#define SCHULER_CORE_LANES3_H

#include "core/lanes.h"

typedef struct {
    lanes x, y, z;
} lanes3;

typedef struct {
    lanes w, x, y, z;
} lanes_quat;

LANES_INLINE lanes3 lanes3_add(lanes3 a, lanes3 b)
{
    return (lanes3){ a.x + b.x, a.y + b.y, a.z + b.z };
}

LANES_INLINE lanes3 lanes3_scale(lanes k, lanes3 a)
{
    return (lanes3){ k * a.x, k * a.y, k * a.z };
}

LANES_INLINE lanes lanes3_dot(lanes3 a, lanes3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LANES_INLINE lanes3 lanes3_cross(lanes3 a, lanes3 b)
{
    return (lanes3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/* a + b x c */
LANES_INLINE lanes3 lanes3_add_cross(lanes3 a, lanes3 b, lanes3 c)
{
    return lanes3_add(a, lanes3_cross(b, c));
}

/* C(q) u for a unit quaternion: u + w t + q x t with t = 2 q x u. */
LANES_INLINE lanes3 lanes_quat_rotate(lanes_quat q, lanes3 u)
{
    const lanes3 v = { q.x, q.y, q.z };
    lanes3 t = lanes3_cross(v, u);
    t = lanes3_add(t, t);
    return lanes3_add_cross(lanes3_add(u, lanes3_scale(q.w, t)), v, t);
}

#endif

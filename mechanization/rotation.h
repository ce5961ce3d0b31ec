/* SPDX-License-Identifier: MIT */
/* Rotation of one navigation cycle: exact formulas as series of |phi|^2. A cycle turns by far less
 * than a radian (at 100 Hz and 10 rad/s: 0.1 rad); the first term left out is below 1e-15 there and
 * below 1e-11 at 0.25 rad. */
#ifndef SCHULER_MECHANIZATION_ROTATION_H
#define SCHULER_MECHANIZATION_ROTATION_H

#include "core/lanes3.h"

/* q(phi) - 1: the increment of a quaternion loses nothing to the 1. */
LANES_INLINE lanes_quat rotation_increment(lanes3 phi)
{
    const lanes p2 = lanes3_dot(phi, phi);
    /* cos(p/2) - 1 and sin(p/2)/p */
    const lanes c = p2 * (lanes_set(-1.0 / 8.0) +
                          p2 * (lanes_set(1.0 / 384.0) + p2 * (lanes_set(-1.0 / 46080.0) +
                                                               p2 * lanes_set(1.0 / 10321920.0))));
    const lanes s =
        lanes_set(0.5) + p2 * (lanes_set(-1.0 / 48.0) +
                               p2 * (lanes_set(1.0 / 3840.0) + p2 * lanes_set(-1.0 / 645120.0)));
    return (lanes_quat){ c, s * phi.x, s * phi.y, s * phi.z };
}

/* Velocity change in the axes of the cycle's start, for constant rate and force: upsilon +
 * (1 - cos a)/a^2 alpha x upsilon + (1 - sin a/a)/a^2 alpha x (alpha x upsilon). */
LANES_INLINE lanes3 rotation_velocity(lanes3 alpha, lanes3 upsilon)
{
    const lanes a2 = lanes3_dot(alpha, alpha);
    const lanes k1 = lanes_set(1.0 / 2.0) +
                     a2 * (lanes_set(-1.0 / 24.0) +
                           a2 * (lanes_set(1.0 / 720.0) + a2 * lanes_set(-1.0 / 40320.0)));
    const lanes k2 = lanes_set(1.0 / 6.0) +
                     a2 * (lanes_set(-1.0 / 120.0) +
                           a2 * (lanes_set(1.0 / 5040.0) + a2 * lanes_set(-1.0 / 362880.0)));
    const lanes3 once = lanes3_cross(alpha, upsilon);
    const lanes3 twice = lanes3_cross(alpha, once);
    return lanes3_add(upsilon, lanes3_add(lanes3_scale(k1, once), lanes3_scale(k2, twice)));
}

/* What rotation_velocity lacks when rate and force change linearly: terms of two angles and one
 * velocity, (T^4/24) [a x (a x f1) - b x (a x f0)],   omega = a + b t,  f = f0 + f1 t, from V3 =
 * integral of A2 f with dA2/dt = [alpha x][omega x], less the constant-rate form's 1/6 alpha x
 * (alpha x upsilon). With a, f0 the means of this cycle and b, f1 the differences to the one before
 * it is 1/24 [alpha_before x (alpha x upsilon) - alpha x (alpha x upsilon_before)]. Without it the
 * velocity is of third order in the length of a cycle. */
LANES_INLINE lanes3 rotation_velocity_change(lanes3 alpha, lanes3 upsilon, lanes3 alpha_before,
                                             lanes3 upsilon_before)
{
    const lanes3 now = lanes3_cross(alpha, upsilon);
    const lanes3 before = lanes3_cross(upsilon_before, alpha);
    const lanes3 sum = lanes3_add_cross(lanes3_cross(alpha_before, now), alpha, before);
    return lanes3_scale(lanes_set(1.0 / 24.0), sum);
}

#endif

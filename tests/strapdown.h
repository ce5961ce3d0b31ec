/* SPDX-License-Identifier: MIT */
/* Motions with closed increments, and the little of a navigator that attitude and velocity need. For
 * tests built with one lane. */
#ifndef SCHULER_TESTS_STRAPDOWN_H
#define SCHULER_TESTS_STRAPDOWN_H

#include "core/earth.h"
#include "mechanization/coning.h"
#include "mechanization/rotation.h"
#include <math.h>

/* Pure coning of half angle a at W rad/s over [t1, t2]: reference section 9.4. */
static inline coning_sample coning_increment(double a, double W, double t1, double t2)
{
    return (coning_sample){ .d = { sin(a) * (cos(W * t2) - cos(W * t1)),
                                   sin(a) * (sin(W * t2) - sin(W * t1)),
                                   -W * (1.0 - cos(a)) * (t2 - t1) } };
}

/* theta_x = A sin Wt, f_y = D sin Wt: section 9.5. */
static inline coning_sample sculling_increment(double A, double D, double W, double t1, double t2)
{
    return (coning_sample){ .d = { A * (sin(W * t2) - sin(W * t1)), 0.0, 0.0 },
                            .u = { 0.0, D / W * (cos(W * t1) - cos(W * t2)), 0.0 } };
}

/* q (1 + d), d the increment of a quaternion of 1. */
static inline lanes_quat multiply_increment(lanes_quat q, lanes_quat d)
{
    return (lanes_quat){ q.w + (q.w * d.w - q.x * d.x - q.y * d.y - q.z * d.z),
                         q.x + (q.w * d.x + q.x * d.w + q.y * d.z - q.z * d.y),
                         q.y + (q.w * d.y + q.y * d.w + q.z * d.x - q.x * d.z),
                         q.z + (q.w * d.z + q.z * d.w + q.x * d.y - q.y * d.x) };
}

/* The small turn from one attitude to another, about z, rad. */
static inline double turned_about_z(lanes_quat from, lanes_quat to)
{
    return 2.0 * (from.w * to.z - to.w * from.z - from.x * to.y + to.x * from.y);
}

#endif

/* SPDX-License-Identifier: MIT */
/* An axis about which the IMU is turned in the vehicle: at a constant rate, or by a list of moves that is
 * repeated. Private to core. */
#ifndef SCHULER_CORE_OVERLAY_GIMBAL_H
#define SCHULER_CORE_OVERLAY_GIMBAL_H

#include "core/profile.h"
#include <stddef.h>

/* At start_s of the round; ticks. */
typedef struct {
    double start_s;
    schuler_trapezoid trapezoid;
} overlay_move;

typedef struct {
    int axis;            /* 0 forward, 1 right, 2 down            */
    double rate_radps;   /* of a carousel                         */
    double round_s;      /* length of the list of moves           */
    double round_rad;    /* angle that a round adds               */
    overlay_move *moves; /* owned */
    size_t count;
} overlay_gimbal;

/** Angle and rate at t >= 0. */
void schuler_gimbal_at(const overlay_gimbal *g, schuler_instant t, long double *angle_rad,
                       long double *rate_radps);
/** The first instant after t where the motion is not analytic; INFINITY without. */
double schuler_gimbal_next_joint(const overlay_gimbal *g, double t_s);

#endif

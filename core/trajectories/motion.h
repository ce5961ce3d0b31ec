/* SPDX-License-Identifier: MIT */
/* What the files of the kind `motion` share. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_MOTION_H
#define SCHULER_CORE_TRAJECTORIES_MOTION_H

#include "core/path_build.h"
#include "core/trajectory_specs.h"

extern const schuler_object schuler_motion_object;

/* A motion in a frame r that stands still on the earth, at the start's place and in its attitude. */
typedef struct {
    const schuler_motion_spec *spec;
    xvec axes_r[3]; /* of r, ECEF */
} motion_frame;

/* The flows, for schuler_path_extend; user is a motion_frame. */
schuler_flow_function schuler_motion_coning, schuler_motion_sculling, schuler_motion_spin_cone,
    schuler_motion_constant_rate, schuler_motion_turntable, schuler_motion_parallel;

#endif

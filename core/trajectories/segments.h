/* SPDX-License-Identifier: MIT */
/* What the files of the kind `segments` share. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_SEGMENTS_H
#define SCHULER_CORE_TRAJECTORIES_SEGMENTS_H

#include "core/course.h"
#include "core/trajectory_specs.h"

extern const schuler_object schuler_segments_object;

/* What the manoeuvres hand on. */
typedef struct {
    schuler_path_builder *builder;
    double speed_mps, h_m, heading_rad;
    double path_angle_rad;               /* -90 .. 90 deg; 0 in level flight */
    double yaw_rad, pitch_rad, roll_rad; /* of the body relative to the flight path */
    schuler_diagnostics *d;
} flight;

/* A manoeuvre: its keys, and how it is flown. */
typedef struct {
    const schuler_object *object;
    schuler_status (*fly)(flight *f, const void *spec);
} segment_kind;

/* All of them, the object NULL at the end. */
extern const segment_kind schuler_segment_kinds[];

/** Go on as it is: all that is handed on is kept. */
schuler_phase segment_steady(const flight *f);

/** Fly a phase and hand on what it ends with.
 *  Errors   as schuler_trajectory_kind.build, into f->d at the place */
SCHULER_NODISCARD schuler_status segment_follow(flight *f, const schuler_phase *phase,
                                                const schuler_place *place);

/** Say why not. Returned: SCHULER_ERR_INPUT. */
schuler_status segment_refuse(const flight *f, const schuler_place *place, const char *message);

/** What several manoeuvres are made of. */
schuler_status segment_hold(flight *f, const void *spec);
schuler_status segment_accelerate(flight *f, const void *spec);
schuler_status segment_climb(flight *f, const void *spec);
schuler_status segment_turn(flight *f, const void *spec);
schuler_status segment_pull(flight *f, const void *spec);
schuler_status segment_loop(flight *f, const void *spec);
schuler_status segment_yaw(flight *f, const void *spec);
schuler_status segment_pitch(flight *f, const void *spec);
schuler_status segment_roll(flight *f, const void *spec);
schuler_status segment_s_turn(flight *f, const void *spec);
schuler_status segment_orbit(flight *f, const void *spec);
schuler_status segment_stop_and_go(flight *f, const void *spec);
schuler_status segment_polynomial(flight *f, const void *spec);

#endif

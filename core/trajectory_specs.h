/* SPDX-License-Identifier: MIT */
/* What each kind of trajectory reads from its keys. Angles rad, lengths m, times s. NAN = not
 * given. */
#ifndef SCHULER_CORE_TRAJECTORY_SPECS_H
#define SCHULER_CORE_TRAJECTORY_SPECS_H

#include "core/trajectory.h"

SCHULER_BEGIN_C

/* kind static */
typedef struct {
    schuler_place place;
    schuler_start start; /* no speed */
    double for_s;
} schuler_static_spec;

/* kind segments: a list of the variants below */
typedef struct {
    schuler_place place;
    schuler_start start; /* no roll, no pitch; path_angle */
    schuler_variant_list segments;
} schuler_segments_spec;

typedef struct {
    schuler_place place;
    double for_s;
} schuler_hold_spec; /* hold, cruise */

typedef struct {
    schuler_place place;
    double to_mps, at_mps2, jerk_mps3;
} schuler_accelerate_spec;

typedef struct {
    schuler_place place;
    double to_m, at_mps, acceleration_mps2;
} schuler_climb_spec;

typedef struct {
    schuler_place place;
    double by_rad, bank_rad, roll_rate_radps;
    double radius_m, jerk_mps3; /* with a radius (> 0) the turn is flat, and bank is not read */
} schuler_turn_spec;

typedef struct {
    schuler_turn_spec turn; /* to one side first */
    int64_t times;
} schuler_s_turn_spec;

typedef struct {
    schuler_place place;
    double turns, radius_m, roll_rate_radps;
} schuler_orbit_spec;

typedef struct {
    schuler_place place;
    double to_rad, at_mps2, jerk_mps3;
} schuler_pull_spec;

typedef struct {
    schuler_place place;
    double by_rad, at_mps2, jerk_mps3;
} schuler_loop_spec;

typedef struct {
    schuler_place place;
    double by_rad, rate_radps, acceleration_radps2;
} schuler_body_turn_spec; /* yaw, pitch, roll */

typedef struct {
    schuler_place place;
    int64_t times;
    double speed_mps, at_mps2, jerk_mps3, drive_s, stop_s;
} schuler_stop_and_go_spec;

/* Control points of what changes, at most 16 each. */
typedef struct {
    schuler_place place;
    double for_s;
    schuler_quantity_list speed, height, path_angle, turn, yaw, pitch, roll;
} schuler_polynomial_spec;

extern const schuler_object schuler_segment_hold, schuler_segment_cruise,
    schuler_segment_accelerate, schuler_segment_climb, schuler_segment_turn, schuler_segment_s_turn,
    schuler_segment_orbit, schuler_segment_pull, schuler_segment_loop, schuler_segment_yaw,
    schuler_segment_pitch, schuler_segment_roll, schuler_segment_stop_and_go,
    schuler_segment_polynomial;

/* kind motion: one of the motions below; a place without file is not given */
typedef struct {
    schuler_place place;
    double half_angle_rad, frequency_Hz;
} schuler_coning_spec;

typedef struct {
    schuler_place place;
    double angle_rad, force_mps2, frequency_Hz;
} schuler_sculling_spec;

typedef struct {
    schuler_place place;
    double spin_radps, precession_radps, cone_rad;
} schuler_spin_cone_spec;

typedef struct {
    schuler_place place;
    double rate_radps[3];
} schuler_constant_rate_spec;

typedef struct {
    schuler_place place;
    double rate_radps;
} schuler_turntable_spec;

typedef struct {
    schuler_place place;
    double speed_mps;
} schuler_steady_spec; /* parallel, geodesic */

typedef struct {
    schuler_place place;
    schuler_start start; /* no speed */
    double for_s;
    schuler_coning_spec coning;
    schuler_sculling_spec sculling;
    schuler_spin_cone_spec spin_cone;
    schuler_constant_rate_spec constant_rate;
    schuler_turntable_spec turntable;
    schuler_steady_spec parallel, geodesic;
} schuler_motion_spec;

/* kind recorded */
typedef struct {
    schuler_place place;
    const char *file;     /* path as written */
    const char *velocity; /* "use" or "ignore" */
    schuler_recorded_samples samples;
} schuler_recorded_spec;

/* kind route */

/* How the vehicle manoeuvres; in a waypoint NAN means "as in defaults". */
typedef struct {
    schuler_place place;
    double bank_rad, roll_rate_radps, radius_m; /* radius: flat turn instead of a banked one */
    double climb_mps, descent_mps, vertical_acceleration_mps2;
    double acceleration_mps2, deceleration_mps2, jerk_mps3;
} schuler_manner;

typedef struct {
    schuler_place place;
    const char *name; /* or NULL */
    double lat_rad, lon_rad, h_m, speed_mps;
    double wait_s;
    schuler_manner manner; /* keys stand in the waypoint itself */
} schuler_waypoint_spec;

typedef struct {
    schuler_place place;
    schuler_manner defaults;
    schuler_list waypoints; /* of schuler_waypoint_spec */
} schuler_route_spec;

SCHULER_END_C

#endif

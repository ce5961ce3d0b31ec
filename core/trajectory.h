/* SPDX-License-Identifier: MIT */
/* Kinds of trajectory. Each is one file in core/trajectories/: a table of its keys and a function
 * that compiles them to a path. */
#ifndef SCHULER_CORE_TRAJECTORY_H
#define SCHULER_CORE_TRAJECTORY_H

#include "core/path.h"
#include "core/schema.h"

SCHULER_BEGIN_C

/* 1000 h: longer than any mission, and times stay exact (core/profile.h). */
#define SCHULER_TRAJECTORY_LONGEST_S 3.6e6

/* Rows of a trajectory file, one line each after the header. */
typedef struct {
    double t_s;
    schuler_vec3 r_e, v_e; /* m; over ground, m/s */
    schuler_quat q_b_e;
} schuler_recorded_sample;

typedef struct {
    const char *file; /* as opened, for messages */
    size_t count;
    schuler_recorded_sample *items;
} schuler_recorded_samples;

typedef struct {
    const char *name; /* trajectory.kind in the scenario                            */
    const char *summary, *source;
    const schuler_object *object; /* its keys, without `kind`                                   */
    /** Compile the read struct to a path.
     *  Errors  SCHULER_ERR_INPUT into d with the place of the offending item (a turn without speed,
     * a leg too short for its turns, a pole); SCHULER_ERR_NUMERIC; SCHULER_ERR_MEMORY */
    schuler_status (*build)(const void *spec, schuler_path *out, schuler_diagnostics *d);
    /** The samples of a spec that names a file, for whoever reads it before build; else NULL. */
    schuler_recorded_samples *(*samples)(void *spec, const char **file);
} schuler_trajectory_kind;

/** All kinds, NULL-terminated. */
SCHULER_API extern const schuler_trajectory_kind *const schuler_trajectory_kinds[];

/* Where a trajectory starts; shared by the kinds static and segments. */
typedef struct {
    schuler_place place;
    double lat_rad, lon_rad, h_m;
    double roll_rad, pitch_rad, heading_rad;
    double speed_mps, path_angle_rad;
} schuler_start;

SCHULER_END_C

#endif

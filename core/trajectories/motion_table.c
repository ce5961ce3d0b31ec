/* SPDX-License-Identifier: MIT */
/* The keys of the kind `motion`. */
#include "core/trajectories/fields.h"
#include "core/trajectories/motion.h"

#define FASTEST_HZ    1000.0
#define FASTEST_RADPS 100.0

static const schuler_field coning_fields[] = {
    FIELD_NEEDED("half_angle", schuler_coning_spec, half_angle_rad, SCHULER_DIM_ANGLE, 0.0, 1.5,
                 "1 deg", "of the cone"),
    FIELD_NEEDED("frequency", schuler_coning_spec, frequency_Hz, SCHULER_DIM_FREQUENCY, 1e-4,
                 FASTEST_HZ, "5 Hz", "of going round it"),
    { 0 },
};

static const schuler_field sculling_fields[] = {
    FIELD_NEEDED("angle", schuler_sculling_spec, angle_rad, SCHULER_DIM_ANGLE, 0.0, 1.5, "10 mrad",
                 "amplitude A of roll: A sin(2 pi f t)"),
    FIELD_NEEDED("force", schuler_sculling_spec, force_mps2, SCHULER_DIM_ACCEL, 0.0, 1000.0,
                 "10 m/s^2", "amplitude D of the specific force along y: D sin(2 pi f t)"),
    FIELD_NEEDED("frequency", schuler_sculling_spec, frequency_Hz, SCHULER_DIM_FREQUENCY, 1e-4,
                 FASTEST_HZ, "5 Hz", "of both"),
    { 0 },
};

static const schuler_field spin_cone_fields[] = {
    FIELD_NEEDED("spin", schuler_spin_cone_spec, spin_radps, SCHULER_DIM_RATE, -FASTEST_RADPS,
                 FASTEST_RADPS, "1 rad/s", "rate about the body's x axis"),
    FIELD_NEEDED("precession", schuler_spin_cone_spec, precession_radps, SCHULER_DIM_RATE,
                 -FASTEST_RADPS, FASTEST_RADPS, "0.1 rad/s", "rate at which the axis goes round"),
    FIELD_NEEDED("cone", schuler_spin_cone_spec, cone_rad, SCHULER_DIM_ANGLE, 0.0, SCHULER_PI,
                 "45 deg", "angle between the axis and what it goes round"),
    { 0 },
};

static const schuler_field constant_rate_fields[] = {
    FIELD_OPTIONAL("x", schuler_constant_rate_spec, rate_radps[0], SCHULER_DIM_RATE, 0.0,
                   -FASTEST_RADPS, FASTEST_RADPS, "0.3 rad/s",
                   "rate about body x, relative to the earth"),
    FIELD_OPTIONAL("y", schuler_constant_rate_spec, rate_radps[1], SCHULER_DIM_RATE, 0.0,
                   -FASTEST_RADPS, FASTEST_RADPS, "-0.2 rad/s", "about body y"),
    FIELD_OPTIONAL("z", schuler_constant_rate_spec, rate_radps[2], SCHULER_DIM_RATE, 0.0,
                   -FASTEST_RADPS, FASTEST_RADPS, "0.5 rad/s", "about body z"),
    { 0 },
};

static const schuler_field turntable_fields[] = {
    FIELD_NEEDED("rate", schuler_turntable_spec, rate_radps, SCHULER_DIM_RATE, -FASTEST_RADPS,
                 FASTEST_RADPS, "10 deg/s",
                 "of the table about the vertical, relative to the earth"),
    { 0 },
};

static const schuler_field steady_fields[] = {
    FIELD_NEEDED("speed", schuler_steady_spec, speed_mps, SCHULER_DIM_SPEED, 0.0, FIELD_FASTEST_MPS,
                 "250 m/s", "over ground, at its height"),
    { 0 },
};

#define MOTION(NAME, TYPE, FIELDS, DOC)                                                            \
    static const schuler_object NAME##_object = {                                                  \
        .name = #NAME, .doc = DOC, .size = sizeof(TYPE), .fields = FIELDS                          \
    }
MOTION(coning, schuler_coning_spec, coning_fields, "the body's axes go round a cone");
MOTION(sculling, schuler_sculling_spec, sculling_fields, "roll and side force swing together");
MOTION(spin_cone, schuler_spin_cone_spec, spin_cone_fields,
       "a spinning body whose axis goes round a cone: Savage's SPIN-CONE");
MOTION(constant_rate, schuler_constant_rate_spec, constant_rate_fields,
       "a constant rate about any axis of the body");
MOTION(turntable, schuler_turntable_spec, turntable_fields, "a turntable with a vertical axis");
MOTION(parallel, schuler_steady_spec, steady_fields, "level flight to the east along a parallel");
MOTION(geodesic, schuler_steady_spec, steady_fields,
       "level flight along a geodesic, over a pole too");

static const schuler_field start_fields[] = {
    FIELD_LATITUDE(schuler_start, lat_rad),
    FIELD_LONGITUDE(schuler_start, lon_rad),
    FIELD_HEIGHT(schuler_start, h_m),
    FIELD_OPTIONAL("roll", schuler_start, roll_rad, SCHULER_DIM_ANGLE, 0.0, -SCHULER_PI, SCHULER_PI,
                   "0 deg", "roll of the frame in which the motion is given"),
    FIELD_OPTIONAL("pitch", schuler_start, pitch_rad, SCHULER_DIM_ANGLE, 0.0, -0.5 * SCHULER_PI,
                   0.5 * SCHULER_PI, "0 deg", "pitch of it"),
    FIELD_HEADING(schuler_start, heading_rad),
    { 0 },
};

static const schuler_object start_object = {
    .name = "start",
    .doc = "where the motion starts, and the attitude of the frame in which it is given",
    .size = sizeof(schuler_start),
    .fields = start_fields,
};

#define MOTION_KEY(NAME, EXAMPLE)                                                                  \
    {                                                                                              \
        .key = #NAME, .kind = SCHULER_FIELD_OBJECT, .offset = offsetof(schuler_motion_spec, NAME), \
        .example = EXAMPLE, .doc = "one of the motions", .object = &NAME##_object                  \
    }

static const schuler_field fields[] = {
    { .key = "start",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(schuler_motion_spec, start),
      .required = true,
      .example = "{lat: 45 deg, lon: 7 deg}",
      .doc = "place and attitude",
      .object = &start_object },
    FIELD_NEEDED("for", schuler_motion_spec, for_s, SCHULER_DIM_TIME, 0.01,
                 SCHULER_TRAJECTORY_LONGEST_S, "1 h", "how long"),
    MOTION_KEY(coning, "{half_angle: 1 deg, frequency: 5 Hz}"),
    MOTION_KEY(sculling, "{angle: 10 mrad, force: 10 m/s^2, frequency: 5 Hz}"),
    MOTION_KEY(spin_cone, "{spin: 1 rad/s, precession: 0.1 rad/s, cone: 45 deg}"),
    MOTION_KEY(constant_rate, "{x: 0.3 rad/s, y: -0.2 rad/s, z: 0.5 rad/s}"),
    MOTION_KEY(turntable, "{rate: 10 deg/s}"),
    MOTION_KEY(parallel, "{speed: 250 m/s}"),
    MOTION_KEY(geodesic, "{speed: 250 m/s}"),
    { 0 },
};

const schuler_object schuler_motion_object = {
    .name = "motion",
    .doc = "one test motion in closed form",
    .size = sizeof(schuler_motion_spec),
    .fields = fields,
};

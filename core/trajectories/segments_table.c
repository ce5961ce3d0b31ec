/* SPDX-License-Identifier: MIT */
/* The keys of the kind `segments`. */
#include "core/trajectories/fields.h"
#include "core/trajectories/segments.h"

static const schuler_field hold_fields[] = {
    FIELD_NEEDED("for", schuler_hold_spec, for_s, SCHULER_DIM_TIME, 1e-3,
                 SCHULER_TRAJECTORY_LONGEST_S, "10 min", "how long"),
    { 0 },
};

const schuler_object schuler_segment_hold = {
    .name = "hold",
    .doc = "keep speed, heading, attitude, and height or the angle of the flight path; stand still "
           "at rest",
    .size = sizeof(schuler_hold_spec),
    .fields = hold_fields,
};

const schuler_object schuler_segment_cruise = {
    .name = "cruise",
    .doc = "the same as hold, reads better in flight",
    .size = sizeof(schuler_hold_spec),
    .fields = hold_fields,
};

static const schuler_field accelerate_fields[] = {
    FIELD_NEEDED("to", schuler_accelerate_spec, to_mps, SCHULER_DIM_SPEED, 0.0, FIELD_FASTEST_MPS,
                 "100 m/s", "speed to reach, up or down"),
    FIELD_NEEDED("at", schuler_accelerate_spec, at_mps2, SCHULER_DIM_ACCEL, 1e-4, 500.0, "2 m/s^2",
                 "largest acceleration along the path"),
    FIELD_OPTIONAL("jerk", schuler_accelerate_spec, jerk_mps3, SCHULER_DIM_JERK, 1.0, 1e-4, 5000.0,
                   "1 m/s^3", "largest rate of change of it"),
    { 0 },
};

const schuler_object schuler_segment_accelerate = {
    .name = "accelerate",
    .doc = "change speed; heading and height (or the angle of the flight path) are kept",
    .size = sizeof(schuler_accelerate_spec),
    .fields = accelerate_fields,
};

static const schuler_field climb_fields[] = {
    FIELD_NEEDED("to", schuler_climb_spec, to_m, SCHULER_DIM_LENGTH, FIELD_LOWEST_M,
                 FIELD_HIGHEST_M, "10000 m", "height to reach, up or down"),
    FIELD_NEEDED("at", schuler_climb_spec, at_mps, SCHULER_DIM_SPEED, 1e-3, FIELD_FASTEST_MPS,
                 "10 m/s", "largest climb or descent rate, without sign"),
    FIELD_OPTIONAL("acceleration", schuler_climb_spec, acceleration_mps2, SCHULER_DIM_ACCEL, 1.0,
                   1e-4, 500.0, "1 m/s^2", "largest vertical acceleration at start and end"),
    { 0 },
};

const schuler_object schuler_segment_climb = {
    .name = "climb",
    .doc =
        "change height (climb or descend), ground speed and heading kept; pitch follows the path",
    .size = sizeof(schuler_climb_spec),
    .fields = climb_fields,
};

/* Of a turn, and of what is made of turns. */
/* clang-format off */
#define TURN_MANNER(TYPE, IN)                                                                   \
    FIELD_OPTIONAL("bank", TYPE, IN bank_rad, SCHULER_DIM_ANGLE, 25.0 * SCHULER_RAD_PER_DEG,    \
                   0.1 * SCHULER_RAD_PER_DEG, 85.0 * SCHULER_RAD_PER_DEG, "25 deg",             \
                   "bank of the coordinated turn; less when the turn is too small to reach it"),\
    FIELD_OPTIONAL("roll_rate", TYPE, IN roll_rate_radps, SCHULER_DIM_RATE,                     \
                   5.0 * SCHULER_RAD_PER_DEG, 0.01 * SCHULER_RAD_PER_DEG,                       \
                   1000.0 * SCHULER_RAD_PER_DEG, "5 deg/s",                                     \
                   "largest roll rate into and out of it"),                                     \
    FIELD_OPTIONAL("radius", TYPE, IN radius_m, SCHULER_DIM_LENGTH, NAN, 1.0, 1e6, "20 m",      \
                   "a flat turn of this radius instead of a banked one, as cars and ships do"), \
    FIELD_OPTIONAL("jerk", TYPE, IN jerk_mps3, SCHULER_DIM_JERK, 1.0, 1e-4, 5000.0, "1 m/s^3",  \
                   "of a flat turn: largest rate of change of the sideways acceleration")
/* clang-format on */

static const schuler_field turn_fields[] = {
    FIELD_NEEDED("by", schuler_turn_spec, by_rad, SCHULER_DIM_ANGLE, -20.0 * SCHULER_PI,
                 20.0 * SCHULER_PI, "90 deg", "change of heading, negative = left"),
    TURN_MANNER(schuler_turn_spec, ),
    { 0 },
};

const schuler_object schuler_segment_turn = {
    .name = "turn",
    .doc = "coordinated turn at constant speed and height: tan(bank) = speed * turn rate / g0",
    .size = sizeof(schuler_turn_spec),
    .fields = turn_fields,
};

static const schuler_field s_turn_fields[] = {
    FIELD_NEEDED("by", schuler_s_turn_spec, turn.by_rad, SCHULER_DIM_ANGLE, -SCHULER_PI, SCHULER_PI,
                 "30 deg", "to one side and then to the other, negative = left first"),
    TURN_MANNER(schuler_s_turn_spec, turn.),
    { .key = "times",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = offsetof(schuler_s_turn_spec, times),
      .def = 1,
      .min = 1,
      .max = 1000,
      .example = "3",
      .doc = "how many of them" },
    { 0 },
};

const schuler_object schuler_segment_s_turn = {
    .name = "s_turn",
    .doc = "turns to one side, to the other and back to the first heading",
    .size = sizeof(schuler_s_turn_spec),
    .fields = s_turn_fields,
};

static const schuler_field orbit_fields[] = {
    { .key = "turns",
      .kind = SCHULER_FIELD_NUMBER,
      .offset = offsetof(schuler_orbit_spec, turns),
      .required = true,
      .min = -1000,
      .max = 1000,
      .example = "3",
      .doc = "how many rounds, negative = left" },
    FIELD_NEEDED("radius", schuler_orbit_spec, radius_m, SCHULER_DIM_LENGTH, 1.0, 1e6, "3 km",
                 "of the circle; bank follows from it and the speed"),
    FIELD_OPTIONAL("roll_rate", schuler_orbit_spec, roll_rate_radps, SCHULER_DIM_RATE,
                   5.0 * SCHULER_RAD_PER_DEG, 0.01 * SCHULER_RAD_PER_DEG,
                   1000.0 * SCHULER_RAD_PER_DEG, "5 deg/s", "largest roll rate into and out of it"),
    { 0 },
};

const schuler_object schuler_segment_orbit = {
    .name = "orbit",
    .doc = "rounds of a circle, banked, at constant speed and height",
    .size = sizeof(schuler_orbit_spec),
    .fields = orbit_fields,
};

#define BEND_MANNER(TYPE)                                                                          \
    FIELD_NEEDED("at", TYPE, at_mps2, SCHULER_DIM_ACCEL, 1e-4, 500.0, "3 g",                       \
                 "largest acceleration across the flight path, gravity not counted"),              \
        FIELD_OPTIONAL("jerk", TYPE, jerk_mps3, SCHULER_DIM_JERK, 20.0, 1e-4, 5000.0, "20 m/s^3",  \
                       "largest rate of change of it")

static const schuler_field pull_fields[] = {
    FIELD_NEEDED("to", schuler_pull_spec, to_rad, SCHULER_DIM_ANGLE, -0.5 * SCHULER_PI,
                 0.5 * SCHULER_PI, "30 deg", "angle of the flight path above the horizon"),
    BEND_MANNER(schuler_pull_spec),
    { 0 },
};

const schuler_object schuler_segment_pull = {
    .name = "pull",
    .doc = "bend the flight path up or down in its vertical plane, at constant speed; segments "
           "after it keep the angle, until it is 0 again",
    .size = sizeof(schuler_pull_spec),
    .fields = pull_fields,
};

static const schuler_field loop_fields[] = {
    FIELD_OPTIONAL("by", schuler_loop_spec, by_rad, SCHULER_DIM_ANGLE, 2.0 * SCHULER_PI,
                   -20.0 * SCHULER_PI, 20.0 * SCHULER_PI, "360 deg",
                   "how far the flight path is bent, negative = down; 180 deg ends on the back, "
                   "going the other way"),
    BEND_MANNER(schuler_loop_spec),
    { 0 },
};

const schuler_object schuler_segment_loop = {
    .name = "loop",
    .doc = "a loop in the vertical plane, or part of one, at constant speed",
    .size = sizeof(schuler_loop_spec),
    .fields = loop_fields,
};

static const schuler_field body_turn_fields[] = {
    FIELD_NEEDED("by", schuler_body_turn_spec, by_rad, SCHULER_DIM_ANGLE, -200.0 * SCHULER_PI,
                 200.0 * SCHULER_PI, "10 deg", "change of the angle"),
    FIELD_NEEDED("rate", schuler_body_turn_spec, rate_radps, SCHULER_DIM_RATE, 1e-5, 50.0,
                 "3 deg/s", "largest rate"),
    FIELD_OPTIONAL("acceleration", schuler_body_turn_spec, acceleration_radps2,
                   SCHULER_DIM_ANGULAR_ACCEL, 60.0 * SCHULER_RAD_PER_DEG,
                   1e-4 * SCHULER_RAD_PER_DEG, 5e4 * SCHULER_RAD_PER_DEG, "60 deg/s^2",
                   "largest rate of change of the rate"),
    { 0 },
};

#define BODY_TURN(NAME, DOC)                                                                       \
    const schuler_object schuler_segment_##NAME = {                                                \
        .name = #NAME,                                                                             \
        .doc = DOC,                                                                                \
        .size = sizeof(schuler_body_turn_spec),                                                    \
        .fields = body_turn_fields,                                                                \
    }
BODY_TURN(yaw,
          "turn the body to the right relative to its flight path, which goes on; at rest, turn "
          "on the spot");
BODY_TURN(pitch, "nose up relative to the flight path, which goes on; kept by what follows");
BODY_TURN(roll, "right side down relative to the flight path, which goes on; kept by what follows");

static const schuler_field stop_and_go_fields[] = {
    { .key = "times",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = offsetof(schuler_stop_and_go_spec, times),
      .required = true,
      .min = 1,
      .max = 10000,
      .example = "10",
      .doc = "how often" },
    FIELD_NEEDED("speed", schuler_stop_and_go_spec, speed_mps, SCHULER_DIM_SPEED, 1e-3,
                 FIELD_FASTEST_MPS, "50 km/h", "between stops"),
    FIELD_NEEDED("at", schuler_stop_and_go_spec, at_mps2, SCHULER_DIM_ACCEL, 1e-4, 500.0,
                 "1.5 m/s^2", "largest acceleration, and deceleration"),
    FIELD_OPTIONAL("jerk", schuler_stop_and_go_spec, jerk_mps3, SCHULER_DIM_JERK, 1.0, 1e-4, 5000.0,
                   "1 m/s^3", "largest rate of change of it"),
    FIELD_NEEDED("drive", schuler_stop_and_go_spec, drive_s, SCHULER_DIM_TIME, 1e-3,
                 SCHULER_TRAJECTORY_LONGEST_S, "40 s", "time at that speed"),
    FIELD_NEEDED("stop", schuler_stop_and_go_spec, stop_s, SCHULER_DIM_TIME, 1e-3,
                 SCHULER_TRAJECTORY_LONGEST_S, "25 s", "time at rest after it"),
    { 0 },
};

const schuler_object schuler_segment_stop_and_go = {
    .name = "stop_and_go",
    .doc = "accelerate, drive, brake and stand still, several times",
    .size = sizeof(schuler_stop_and_go_spec),
    .fields = stop_and_go_fields,
};

#define CURVE(KEY, DIM, MIN, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        .key = #KEY, .kind = SCHULER_FIELD_QUANTITIES,                                             \
        .offset = offsetof(schuler_polynomial_spec, KEY), .dim = DIM,                              \
        .components = SCHULER_CURVE_POINTS, .min = MIN, .max = MAX, .example = EXAMPLE, .doc = DOC \
    }

static const schuler_field polynomial_fields[] = {
    FIELD_NEEDED("for", schuler_polynomial_spec, for_s, SCHULER_DIM_TIME, 0.01,
                 SCHULER_TRAJECTORY_LONGEST_S, "60 s", "how long"),
    CURVE(speed, SCHULER_DIM_SPEED, 0.0, FIELD_FASTEST_MPS, "180 m/s",
          "over ground, or along the flight path when that has an angle"),
    CURVE(height, SCHULER_DIM_LENGTH, FIELD_LOWEST_M, FIELD_HIGHEST_M, "3000 m",
          "in level flight, without path_angle"),
    CURVE(path_angle, SCHULER_DIM_ANGLE, -0.5 * SCHULER_PI, 0.5 * SCHULER_PI, "20 deg",
          "of the flight path above the horizon"),
    CURVE(turn, SCHULER_DIM_ANGLE, -200.0 * SCHULER_PI, 200.0 * SCHULER_PI, "30 deg",
          "heading relative to that at the beginning; banked as a coordinated turn"),
    CURVE(yaw, SCHULER_DIM_ANGLE, -200.0 * SCHULER_PI, 200.0 * SCHULER_PI, "2 deg",
          "of the body relative to the flight path"),
    CURVE(pitch, SCHULER_DIM_ANGLE, -200.0 * SCHULER_PI, 200.0 * SCHULER_PI, "5 deg",
          "of the body relative to the flight path"),
    CURVE(roll, SCHULER_DIM_ANGLE, -200.0 * SCHULER_PI, 200.0 * SCHULER_PI, "10 deg",
          "of the body relative to the flight path"),
    { 0 },
};

const schuler_object schuler_segment_polynomial = {
    .name = "polynomial",
    .doc = "several things at once along polynomials in Bernstein form: the values are control "
           "points, [last] or [p1, p2, ..., last]; the first, which is where it is, and the last "
           "count three times, so that accelerations join",
    .size = sizeof(schuler_polynomial_spec),
    .fields = polynomial_fields,
};

/* Every manoeuvre and who flies it. */
/* clang-format off */
#define SEGMENTS(X)                                                                             \
    X(hold, hold) X(cruise, hold) X(accelerate, accelerate) X(climb, climb) X(turn, turn)       \
    X(s_turn, s_turn) X(orbit, orbit) X(pull, pull) X(loop, loop) X(yaw, yaw) X(pitch, pitch)   \
    X(roll, roll) X(stop_and_go, stop_and_go) X(polynomial, polynomial)
#define KIND(NAME, FLIER) { &schuler_segment_##NAME, segment_##FLIER },
#define VARIANT(NAME, FLIER) &schuler_segment_##NAME,
/* clang-format on */

const segment_kind schuler_segment_kinds[] = { SEGMENTS(KIND){ NULL, NULL } };

static const schuler_object *const variants[] = { SEGMENTS(VARIANT) NULL };

static const schuler_field start_fields[] = {
    FIELD_LATITUDE(schuler_start, lat_rad),
    FIELD_LONGITUDE(schuler_start, lon_rad),
    FIELD_HEIGHT(schuler_start, h_m),
    FIELD_HEADING(schuler_start, heading_rad),
    FIELD_OPTIONAL("speed", schuler_start, speed_mps, SCHULER_DIM_SPEED, 0.0, 0.0,
                   FIELD_FASTEST_MPS, "0 m/s", "at the start, along the flight path"),
    FIELD_OPTIONAL("path_angle", schuler_start, path_angle_rad, SCHULER_DIM_ANGLE, 0.0,
                   -0.5 * SCHULER_PI, 0.5 * SCHULER_PI, "90 deg",
                   "of the flight path above the horizon; 90 deg for a rocket on its pad"),
    { 0 },
};

static const schuler_object start_object = {
    .name = "start",
    .doc = "where the motion starts",
    .size = sizeof(schuler_start),
    .fields = start_fields,
};

static const schuler_field fields[] = {
    { .key = "start",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(schuler_segments_spec, start),
      .required = true,
      .example = "{lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 0 m/s}",
      .doc = "place, heading and speed",
      .object = &start_object },
    { .key = "segments",
      .kind = SCHULER_FIELD_VARIANTS,
      .offset = offsetof(schuler_segments_spec, segments),
      .required = true,
      .example = "[hold: {for: 10 min}]",
      .doc = "manoeuvres, one after the other",
      .variants = variants },
    { 0 },
};

const schuler_object schuler_segments_object = {
    .name = "segments",
    .doc = "a list of manoeuvres; straight flight keeps its heading (a rhumb line)",
    .size = sizeof(schuler_segments_spec),
    .fields = fields,
};

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
    .doc = "keep speed, height and heading (at rest: stand still)",
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
                 "100 m/s", "ground speed to reach, up or down"),
    FIELD_NEEDED("at", schuler_accelerate_spec, at_mps2, SCHULER_DIM_ACCEL, 1e-4, 500.0, "2 m/s^2",
                 "largest acceleration along the track"),
    FIELD_OPTIONAL("jerk", schuler_accelerate_spec, jerk_mps3, SCHULER_DIM_JERK, 1.0, 1e-4, 5000.0,
                   "1 m/s^3", "largest rate of change of it"),
    { 0 },
};

const schuler_object schuler_segment_accelerate = {
    .name = "accelerate",
    .doc = "change ground speed, heading and height kept",
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

static const schuler_field turn_fields[] = {
    FIELD_NEEDED("by", schuler_turn_spec, by_rad, SCHULER_DIM_ANGLE, -20.0 * SCHULER_PI,
                 20.0 * SCHULER_PI, "90 deg", "change of heading, negative = left"),
    FIELD_OPTIONAL("bank", schuler_turn_spec, bank_rad, SCHULER_DIM_ANGLE,
                   25.0 * SCHULER_RAD_PER_DEG, 0.1 * SCHULER_RAD_PER_DEG,
                   85.0 * SCHULER_RAD_PER_DEG, "25 deg",
                   "bank of the coordinated turn; less when the turn is too small to reach it"),
    FIELD_OPTIONAL("roll_rate", schuler_turn_spec, roll_rate_radps, SCHULER_DIM_RATE,
                   5.0 * SCHULER_RAD_PER_DEG, 0.01 * SCHULER_RAD_PER_DEG,
                   1000.0 * SCHULER_RAD_PER_DEG, "5 deg/s", "largest roll rate into and out of it"),
    { 0 },
};

const schuler_object schuler_segment_turn = {
    .name = "turn",
    .doc = "coordinated turn at constant speed and height: tan(bank) = speed * turn rate / g0",
    .size = sizeof(schuler_turn_spec),
    .fields = turn_fields,
};

static const schuler_object *const variants[] = {
    &schuler_segment_hold,  &schuler_segment_cruise, &schuler_segment_accelerate,
    &schuler_segment_climb, &schuler_segment_turn,   NULL,
};

static const schuler_field start_fields[] = {
    FIELD_LATITUDE(schuler_start, lat_rad),
    FIELD_LONGITUDE(schuler_start, lon_rad),
    FIELD_HEIGHT(schuler_start, h_m),
    FIELD_HEADING(schuler_start, heading_rad),
    FIELD_OPTIONAL("speed", schuler_start, speed_mps, SCHULER_DIM_SPEED, 0.0, 0.0,
                   FIELD_FASTEST_MPS, "0 m/s", "ground speed at the start"),
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

/* SPDX-License-Identifier: MIT */
/* The keys of the kind `route`. */
#include "core/trajectories/fields.h"
#include "core/trajectories/route.h"

#define DEG SCHULER_RAD_PER_DEG

/* The same keys in `defaults`, where they have values, and in a waypoint, where absent means "as
 * there". D gives the default. */
/* clang-format off */
#define MANNER(TYPE, AT, D)                                                                     \
    FIELD_OPTIONAL("bank", TYPE, AT bank_rad, SCHULER_DIM_ANGLE, D(25.0 * DEG), 0.1 * DEG,      \
                   85.0 * DEG, "25 deg", "bank of the turn at the waypoint"),                   \
    FIELD_OPTIONAL("roll_rate", TYPE, AT roll_rate_radps, SCHULER_DIM_RATE, D(5.0 * DEG),       \
                   0.01 * DEG, 1000.0 * DEG, "5 deg/s", "largest roll rate into and out of it"), \
    FIELD_OPTIONAL("radius", TYPE, AT radius_m, SCHULER_DIM_LENGTH, NAN, 1.0, 1e6, "60 m",      \
                   "a flat turn of this radius, as in taxiing, instead of a banked one"),       \
    FIELD_OPTIONAL("climb", TYPE, AT climb_mps, SCHULER_DIM_SPEED, D(10.0), 1e-3,               \
                   FIELD_FASTEST_MPS, "10 m/s", "largest climb rate on the leg to the waypoint"), \
    FIELD_OPTIONAL("descent", TYPE, AT descent_mps, SCHULER_DIM_SPEED, D(8.0), 1e-3,            \
                   FIELD_FASTEST_MPS, "8 m/s", "largest descent rate on that leg, without sign"), \
    FIELD_OPTIONAL("vertical_acceleration", TYPE, AT vertical_acceleration_mps2,                \
                   SCHULER_DIM_ACCEL, D(1.0), 1e-4, 500.0, "1 m/s^2",                           \
                   "largest vertical acceleration into and out of climbs and descents"),        \
    FIELD_OPTIONAL("acceleration", TYPE, AT acceleration_mps2, SCHULER_DIM_ACCEL, D(1.5), 1e-4, \
                   500.0, "1.5 m/s^2", "largest acceleration on the leg to the waypoint"),      \
    FIELD_OPTIONAL("deceleration", TYPE, AT deceleration_mps2, SCHULER_DIM_ACCEL, D(1.5), 1e-4, \
                   500.0, "1.5 m/s^2", "largest deceleration on that leg, without sign"),       \
    FIELD_OPTIONAL("jerk", TYPE, AT jerk_mps3, SCHULER_DIM_JERK, D(1.0), 1e-4, 5000.0,          \
                   "1 m/s^3", "largest rate of change of acceleration")
/* clang-format on */
#define GIVEN(X)     (X)
#define NOT_GIVEN(X) NAN

static const schuler_field defaults_fields[] = {
    MANNER(schuler_manner, , GIVEN),
    { 0 },
};

static const schuler_object defaults_object = {
    .name = "defaults",
    .doc = "how the vehicle manoeuvres where a waypoint does not say otherwise",
    .size = sizeof(schuler_manner),
    .fields = defaults_fields,
};

static const schuler_field waypoint_fields[] = {
    { .key = "name",
      .kind = SCHULER_FIELD_TEXT,
      .offset = offsetof(schuler_waypoint_spec, name),
      .example = "LISBOA",
      .doc = "what it is called in messages" },
    FIELD_LATITUDE(schuler_waypoint_spec, lat_rad),
    FIELD_LONGITUDE(schuler_waypoint_spec, lon_rad),
    FIELD_OPTIONAL("height", schuler_waypoint_spec, h_m, SCHULER_DIM_LENGTH, NAN, FIELD_LOWEST_M,
                   FIELD_HIGHEST_M, "10000 m",
                   "height above the WGS84 ellipsoid; absent: as at the waypoint before"),
    FIELD_OPTIONAL("speed", schuler_waypoint_spec, speed_mps, SCHULER_DIM_SPEED, NAN, 0.0,
                   FIELD_FASTEST_MPS, "230 m/s",
                   "ground speed there; absent: as at the waypoint before"),
    FIELD_OPTIONAL("wait", schuler_waypoint_spec, wait_s, SCHULER_DIM_TIME, 0.0, 0.0,
                   SCHULER_TRAJECTORY_LONGEST_S, "10 min", "how long to stand there, at speed 0"),
    MANNER(schuler_waypoint_spec, manner., NOT_GIVEN),
    { 0 },
};

static const schuler_object waypoint_object = {
    .name = "waypoint",
    .doc = "a point the route flies by: the turn cuts the corner and meets the next leg",
    .size = sizeof(schuler_waypoint_spec),
    .fields = waypoint_fields,
};

static const schuler_field fields[] = {
    { .key = "defaults",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(schuler_route_spec, defaults),
      .example = "{bank: 25 deg, climb: 10 m/s}",
      .doc = "how the vehicle manoeuvres",
      .object = &defaults_object },
    { .key = "waypoints",
      .kind = SCHULER_FIELD_LIST,
      .offset = offsetof(schuler_route_spec, waypoints),
      .required = true,
      .example = "[{lat: 45 deg, lon: 7 deg, height: 300 m, speed: 0 m/s}]",
      .doc = "two or more; height and speed hold at the waypoint and change on the way to it",
      .object = &waypoint_object },
    { 0 },
};

const schuler_object schuler_route_object = {
    .name = "route",
    .doc = "waypoints joined by geodesics of the WGS84 ellipsoid, with fly-by turns",
    .size = sizeof(schuler_route_spec),
    .fields = fields,
};

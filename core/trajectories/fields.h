/* SPDX-License-Identifier: MIT */
/* One row of a trajectory's table in one or two lines. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_FIELDS_H
#define SCHULER_CORE_TRAJECTORIES_FIELDS_H

#include "core/gravity.h"
#include "core/trajectory_specs.h"
#include <stddef.h>

/* clang-format off */
#define FIELD_NEEDED(KEY, TYPE, MEMBER, DIM, MIN, MAX, EXAMPLE, DOC)                            \
    { .key = KEY, .kind = SCHULER_FIELD_QUANTITY, .offset = offsetof(TYPE, MEMBER),             \
      .required = true, .dim = DIM, .min = MIN, .max = MAX, .example = EXAMPLE, .doc = DOC }

#define FIELD_OPTIONAL(KEY, TYPE, MEMBER, DIM, DEFAULT, MIN, MAX, EXAMPLE, DOC)                 \
    { .key = KEY, .kind = SCHULER_FIELD_QUANTITY, .offset = offsetof(TYPE, MEMBER),             \
      .dim = DIM, .def = DEFAULT, .min = MIN, .max = MAX, .example = EXAMPLE, .doc = DOC }

#define FIELD_LATITUDE(TYPE, MEMBER)                                                            \
    FIELD_NEEDED("lat", TYPE, MEMBER, SCHULER_DIM_ANGLE, -0.5 * SCHULER_PI, 0.5 * SCHULER_PI,   \
                 "45 deg", "geodetic latitude (WGS84), north positive")
#define FIELD_LONGITUDE(TYPE, MEMBER)                                                           \
    FIELD_NEEDED("lon", TYPE, MEMBER, SCHULER_DIM_ANGLE, -SCHULER_PI, 2.0 * SCHULER_PI,         \
                 "7 deg", "longitude, east positive")
#define FIELD_HEIGHT(TYPE, MEMBER)                                                              \
    FIELD_OPTIONAL("height", TYPE, MEMBER, SCHULER_DIM_LENGTH, 0.0, FIELD_LOWEST_M,             \
                   FIELD_HIGHEST_M, "1000 m", "height above the WGS84 ellipsoid")
#define FIELD_HEADING(TYPE, MEMBER)                                                             \
    FIELD_OPTIONAL("heading", TYPE, MEMBER, SCHULER_DIM_ANGLE, 0.0, -2.0 * SCHULER_PI,          \
                   2.0 * SCHULER_PI, "45 deg", "direction from north, east positive")
/* clang-format on */

/* Where gravity is known. */
#define FIELD_LOWEST_M    SCHULER_GRAVITY_LOW_M
#define FIELD_HIGHEST_M   120000.0
#define FIELD_FASTEST_MPS 4000.0

#endif

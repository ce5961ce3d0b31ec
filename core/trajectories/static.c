/* SPDX-License-Identifier: MIT */
/* At rest on the earth: one piece with constant position and attitude. */
#include "core/profile.h"
#include "core/trajectories/fields.h"
#include <stdlib.h>

static const schuler_field start_fields[] = {
    FIELD_LATITUDE(schuler_start, lat_rad),
    FIELD_LONGITUDE(schuler_start, lon_rad),
    FIELD_HEIGHT(schuler_start, h_m),
    FIELD_OPTIONAL("roll", schuler_start, roll_rad, SCHULER_DIM_ANGLE, 0.0, -SCHULER_PI, SCHULER_PI,
                   "0 deg", "roll, right side down positive"),
    FIELD_OPTIONAL("pitch", schuler_start, pitch_rad, SCHULER_DIM_ANGLE, 0.0, -0.5 * SCHULER_PI,
                   0.5 * SCHULER_PI, "0 deg", "pitch, nose up positive"),
    FIELD_HEADING(schuler_start, heading_rad),
    { 0 },
};

static const schuler_object start_object = {
    .name = "start",
    .doc = "where the vehicle stands, and how",
    .size = sizeof(schuler_start),
    .fields = start_fields,
};

static const schuler_field fields[] = {
    { .key = "start",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(schuler_static_spec, start),
      .required = true,
      .example = "{lat: 45 deg, lon: 7 deg}",
      .doc = "place and attitude",
      .object = &start_object },
    FIELD_NEEDED("for", schuler_static_spec, for_s, SCHULER_DIM_TIME, 0.01,
                 SCHULER_TRAJECTORY_LONGEST_S, "1 h", "how long"),
    { 0 },
};

static const schuler_object object = {
    .name = "static",
    .doc = "at rest on the earth",
    .size = sizeof(schuler_static_spec),
    .fields = fields,
};

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_static_spec *const s = spec;
    const schuler_start *const at = &s->start;
    schuler_piece *const piece = calloc(1, sizeof(*piece));
    if (piece == NULL) {
        schuler_diagnose(d, SCHULER_ERR_MEMORY, &s->place, "out of memory for the trajectory");
        return SCHULER_ERR_MEMORY;
    }
    piece->duration_s = schuler_tick(s->for_s);
    piece->r0_e = schuler_ecef_from_llh((schuler_llh){ at->lat_rad, at->lon_rad, at->h_m });
    const schuler_mat3 C_n_e = schuler_C_n_e(at->lat_rad, at->lon_rad);
    const schuler_mat3 C_b_n =
        schuler_mat3_from_euler(at->roll_rad, at->pitch_rad, at->heading_rad);
    const schuler_mat3 C_b_e = schuler_mat3_mul(&C_n_e, &C_b_n);
    piece->q0_b_e = schuler_quat_from_mat3(&C_b_e);
    *out = (schuler_path){ .count = 1, .pieces = piece, .duration_s = piece->duration_s };
    return SCHULER_OK;
}

extern const schuler_trajectory_kind schuler_trajectory_static;
const schuler_trajectory_kind schuler_trajectory_static = {
    .name = "static",
    .summary = "at rest on the earth, in any attitude",
    .source = "closed form: position and attitude are constant",
    .object = &object,
    .build = build,
};

/* SPDX-License-Identifier: MIT */
/* The place of the IMU in the vehicle whose motion the trajectory describes. */
#include "core/overlays/keys.h"

typedef struct {
    schuler_place place;
    double x_m, y_m, z_m;
} imu_at_spec;

static const schuler_field fields[] = {
    FIELD_OPTIONAL("x", imu_at_spec, x_m, SCHULER_DIM_LENGTH, 0.0, -1000.0, 1000.0, "5 m",
                   "forward"),
    FIELD_OPTIONAL("y", imu_at_spec, y_m, SCHULER_DIM_LENGTH, 0.0, -1000.0, 1000.0, "-1 m",
                   "right"),
    FIELD_OPTIONAL("z", imu_at_spec, z_m, SCHULER_DIM_LENGTH, 0.0, -1000.0, 1000.0, "0.5 m",
                   "down"),
    { 0 },
};

extern const schuler_object schuler_overlay_imu_at_object;
const schuler_object schuler_overlay_imu_at_object = {
    .name = "imu_at",
    .doc = "from the vehicle's reference point to the IMU, in the vehicle's axes",
    .size = sizeof(imu_at_spec),
    .fields = fields,
};

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    (void)d;
    const imu_at_spec *const s = spec;
    o->lever_m = schuler_vec3_add(o->lever_m, (schuler_vec3){ { s->x_m, s->y_m, s->z_m } });
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_imu_at;
const schuler_overlay_kind schuler_overlay_imu_at = {
    .object = &schuler_overlay_imu_at_object,
    .source = "rigid body: r + C_b_e l",
    .add = add,
};

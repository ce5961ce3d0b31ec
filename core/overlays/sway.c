/* SPDX-License-Identifier: MIT */
/* One sinusoid of the whole vehicle, turning or moving. */
#include "core/overlays/keys.h"
#include <string.h>

typedef struct {
    schuler_place place;
    const char *motion;
    double angle_rad, distance_m, period_s, phase_rad;
    schuler_overlay_times times;
} sway_spec;

/* In the order of the channels. */
static const char *const motions[] = { "surge", "sway", "heave", "roll", "pitch", "yaw", NULL };

static const schuler_field fields[] = {
    { .key = "motion",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(sway_spec, motion),
      .required = true,
      .choices = motions,
      .example = "roll",
      .doc = "roll, pitch, yaw, or surge (forward), sway (right), heave (down)" },
    FIELD_OPTIONAL("angle", sway_spec, angle_rad, SCHULER_DIM_ANGLE, NAN, 0.0, 1.5, "3 deg",
                   "amplitude of roll, pitch or yaw"),
    FIELD_OPTIONAL("distance", sway_spec, distance_m, SCHULER_DIM_LENGTH, NAN, 0.0, 100.0, "1 m",
                   "amplitude of surge, sway or heave"),
    FIELD_NEEDED("period", sway_spec, period_s, SCHULER_DIM_TIME, 1e-3, 1e5, "8 s", "of it"),
    FIELD_OPTIONAL("phase", sway_spec, phase_rad, SCHULER_DIM_ANGLE, 0.0, -2.0 * SCHULER_PI,
                   2.0 * SCHULER_PI, "90 deg", "it is A sin(2 pi t/period + phase)"),
    OVERLAY_TIMES(sway_spec),
    { 0 },
};

extern const schuler_object schuler_overlay_sway_object;
const schuler_object schuler_overlay_sway_object = {
    .name = "sway",
    .doc = "a sinusoid of the vehicle: roll, pitch, yaw, surge, sway or heave",
    .size = sizeof(sway_spec),
    .fields = fields,
};

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const sway_spec *const s = spec;
    int channel = 0;
    while (strcmp(motions[channel], s->motion) != 0) channel++;
    const bool turns = channel >= OVERLAY_ROLL;
    const double size = turns ? s->angle_rad : s->distance_m;
    if (isnan(size) || !isnan(turns ? s->distance_m : s->angle_rad)) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place,
                         "sway: '%s' needs the key '%s', and it alone", s->motion,
                         turns ? "angle" : "distance");
        return SCHULER_ERR_INPUT;
    }
    overlay_group *const group = schuler_overlay_group(o, &s->times, 1, &s->place, d);
    if (!group) return SCHULER_ERR_INPUT;
    group->lines[0].frequency_Hz = 1.0L / s->period_s;
    group->lines[0].in_phase[channel] = size * sin(s->phase_rad);
    group->lines[0].in_quadrature[channel] = size * cos(s->phase_rad);
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_sway;
const schuler_overlay_kind schuler_overlay_sway = {
    .object = &schuler_overlay_sway_object,
    .source = "closed form",
    .add = add,
};

/* SPDX-License-Identifier: MIT */
/* The IMU turned in the vehicle at a constant rate, so that the errors across the axis average out. */
#include "core/overlays/keys.h"
#include <string.h>

typedef struct {
    schuler_place place;
    const char *about;
    double rate_radps;
} carousel_spec;

static const char *const axes[] = { "z", "x", "y", NULL };

static const schuler_field fields[] = {
    { .key = "about",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(carousel_spec, about),
      .choices = axes,
      .example = "z",
      .doc = "axis of the vehicle: forward x, right y, down z" },
    FIELD_NEEDED("rate", carousel_spec, rate_radps, SCHULER_DIM_RATE, -20.0, 20.0, "6 deg/s",
                 "of turning, negative the other way"),
    { 0 },
};

extern const schuler_object schuler_overlay_carousel_object;
const schuler_object schuler_overlay_carousel_object = {
    .name = "carousel",
    .doc = "the IMU turns in the vehicle at a constant rate",
    .size = sizeof(carousel_spec),
    .fields = fields,
};

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const carousel_spec *const s = spec;
    if (o->has_gimbals) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place,
                         "carousel: the IMU is turned by another overlay already");
        return SCHULER_ERR_INPUT;
    }
    o->has_gimbals = 1;
    o->gimbals[1] = (overlay_gimbal){ .axis = s->about[0] - 'x', .rate_radps = s->rate_radps };
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_carousel;
const schuler_overlay_kind schuler_overlay_carousel = {
    .object = &schuler_overlay_carousel_object,
    .source = "E. S. Geller, IEEE Trans. Aerospace and Electronic Systems 4(2), 1968",
    .add = add,
};

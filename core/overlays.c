/* SPDX-License-Identifier: MIT */
#include "core/overlays.h"
#include "core/overlay.h"
#include <stddef.h>

#define X(kind) extern const schuler_overlay_kind schuler_overlay_##kind;
#include "schuler_overlays.def"
#undef X

const schuler_overlay_kind *const schuler_overlay_kinds[] = {
#define X(kind) &schuler_overlay_##kind,
#include "schuler_overlays.def"
#undef X
    NULL,
};

#define X(kind) extern const schuler_object schuler_overlay_##kind##_object;
#include "schuler_overlays.def"
#undef X

static const schuler_object *const variants[] = {
#define X(kind) &schuler_overlay_##kind##_object,
#include "schuler_overlays.def"
#undef X
    NULL,
};

static const schuler_field fields[] = {
    { .key = "overlays",
      .kind = SCHULER_FIELD_VARIANTS,
      .offset = offsetof(schuler_overlays_spec, overlays),
      .example = "[vibration: {axis: z, amplitude: 0.5 g, frequency: 20 Hz}]",
      .doc = "motions that add to the trajectory, all at once",
      .variants = variants },
    { 0 },
};

const schuler_object schuler_overlays_object = {
    .name = "overlays",
    .doc = "motions that add to any trajectory",
    .size = sizeof(schuler_overlays_spec),
    .fields = fields,
};

const schuler_object *schuler_overlay_object(const schuler_overlay_kind *kind)
{
    return kind->object;
}

const char *schuler_overlay_source(const schuler_overlay_kind *kind)
{
    return kind->source;
}

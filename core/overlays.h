/* SPDX-License-Identifier: MIT */
/* Motions that add to any trajectory: `trajectory.overlays`. */
#ifndef SCHULER_CORE_OVERLAYS_H
#define SCHULER_CORE_OVERLAYS_H

#include "core/path.h"
#include "core/schema.h"

SCHULER_BEGIN_C

typedef struct schuler_overlay_kind schuler_overlay_kind;

/** All kinds, NULL-terminated. */
SCHULER_API extern const schuler_overlay_kind *const schuler_overlay_kinds[];
/** Its keys, named as in the scenario; what it is taken from. */
SCHULER_API const schuler_object *schuler_overlay_object(const schuler_overlay_kind *kind);
SCHULER_API const char *schuler_overlay_source(const schuler_overlay_kind *kind);

typedef struct {
    schuler_place place;
    schuler_variant_list overlays;
} schuler_overlays_spec;

/* The one key `overlays`, a list of the kinds. */
SCHULER_API extern const schuler_object schuler_overlays_object;

/** Put a path in place of itself with the overlays added. It is then that of the IMU.
 *  Given     path   what the trajectory built;  place   for messages about all of them
 *  Errors    SCHULER_ERR_INPUT, SCHULER_ERR_NUMERIC, SCHULER_ERR_MEMORY; in d, path as it was */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_overlays_apply(const schuler_variant_list *list, schuler_path *path,
                       const schuler_place *place, schuler_diagnostics *d);

SCHULER_END_C

#endif

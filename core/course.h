/* SPDX-License-Identifier: MIT */
/* How a vehicle moves over the ellipsoid: two flows for a phase of the motion.
 * Private to core. */
#ifndef SCHULER_CORE_COURSE_H
#define SCHULER_CORE_COURSE_H

#include "core/path_build.h"
#include "core/profile.h"

/** Normal and tangent at a place; azimuth east of north. At a pole the longitude says where north
 * is. */
schuler_course schuler_course_at(long double lat_rad, long double lon_rad, long double azimuth_rad);

/* How the track answers to heading. */
typedef enum {
    SCHULER_COURSE_RHUMB, /* heading is that of the horizontal velocity from north: a rhumb line
                             when constant */
    SCHULER_COURSE_TRACK, /* heading only turns the track, which else is a geodesic of the ellipsoid
                           */
} schuler_course_kind;

/** Let the builder follow a phase.
 *  Errors   as schuler_path_extend */
SCHULER_NODISCARD schuler_status schuler_course_follow(schuler_path_builder *b,
                                                       schuler_course_kind kind,
                                                       const schuler_phase *phase);

#endif

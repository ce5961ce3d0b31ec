/* SPDX-License-Identifier: MIT */
/* How much a path moves: what scale factors, misalignments and the like have to act on. */
#ifndef SCHULER_SCENARIOS_MOTION_EXTENT_H
#define SCHULER_SCENARIOS_MOTION_EXTENT_H

#include "core/path.h"

SCHULER_BEGIN_C

typedef struct {
    double speed_mps;     /* largest speed over the ground                                       */
    double accel_mps2;    /* largest acceleration relative to the earth                          */
    double rate_radps;    /* largest rate of the body relative to the earth                      */
    double turned_rad;    /* heading, all turns added whichever way                              */
    double turned_on_rad; /* heading at the end less that at the start, whole circles counted    */
} schuler_motion_extent;

/** Looked at in twenty thousand instants of the path: what is quicker than that may be missed. */
SCHULER_API schuler_motion_extent schuler_motion_extent_of(const schuler_path *path);

SCHULER_END_C

#endif

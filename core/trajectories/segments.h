/* SPDX-License-Identifier: MIT */
/* The table of the kind `segments` for the code that builds it. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_SEGMENTS_H
#define SCHULER_CORE_TRAJECTORIES_SEGMENTS_H

#include "core/trajectory_specs.h"

extern const schuler_object schuler_segments_object;

#endif

/* SPDX-License-Identifier: MIT */
/* The mechanizations as compiled for one instruction set. */
#include "mechanization/mechanization_table.h"
#include "core/lanes.h"

#define X(name) extern const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_##name);
#include "schuler_mechanizations.def"
#undef X

#define X(name) &SCHULER_LANE_NAME(schuler_frame_##name),
const schuler_mechanization *const SCHULER_LANE_NAME(schuler_frame_table)[] = {
#include "schuler_mechanizations.def"
    NULL,
};
#undef X

/* SPDX-License-Identifier: MIT */
#include "core/trajectory.h"

#define X(kind) extern const schuler_trajectory_kind schuler_trajectory_##kind;
#include "schuler_trajectories.def"
#undef X

const schuler_trajectory_kind *const schuler_trajectory_kinds[] = {
#define X(kind) &schuler_trajectory_##kind,
#include "schuler_trajectories.def"
#undef X
    NULL,
};

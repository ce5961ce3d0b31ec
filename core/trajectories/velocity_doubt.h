/* SPDX-License-Identifier: MIT */
/* Do the velocities of a recorded trajectory belong to its positions? */
#ifndef SCHULER_CORE_TRAJECTORIES_VELOCITY_DOUBT_H
#define SCHULER_CORE_TRAJECTORIES_VELOCITY_DOUBT_H

#include "core/trajectory.h"

/** How far two rows' mean velocity by position is from that by their velocities.
 *  Given     a, b   rows that follow each other, h_s > 0 apart
 *  Returned  m/s; 0 when no more than a motion between the rows explains: 0.05 m/s and a quarter of
 *            the change of velocity */
double schuler_velocity_doubt(const schuler_recorded_sample *a, const schuler_recorded_sample *b,
                              double h_s);

#endif

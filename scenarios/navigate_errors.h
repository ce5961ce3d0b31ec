/* SPDX-License-Identifier: MIT */
/* How far a navigator is off a reference, row by row. */
#ifndef SCHULER_SCENARIOS_NAVIGATE_ERRORS_H
#define SCHULER_SCENARIOS_NAVIGATE_ERRORS_H

#include "core/trajectory.h"
#include "scenarios/navigate.h"

/** The state as a row of a trajectory.
 *  Returned   C_b_n   because Euler angles lose it at the poles */
schuler_trajectory_row navigate_row(const schuler_nav_state *s, double t_s, schuler_mat3 *C_b_n);

/** Compare with a row of the reference; rms holds sums of squares until navigate_finish.
 *  Given      s, row, C_b_n   the navigator, as navigate_row gives it
 *             truth           the reference as vectors
 *             elapsed_s       since the start */
void navigate_compare(schuler_navigate_result *result, const schuler_nav_state *s,
                      const schuler_trajectory_row *row, const schuler_mat3 *C_b_n,
                      const schuler_trajectory_row *reference, const schuler_recorded_sample *truth,
                      double elapsed_s);
void navigate_finish(schuler_navigate_result *result);

#endif

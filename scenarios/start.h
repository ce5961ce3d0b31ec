/* SPDX-License-Identifier: MIT */
/* Where a navigator begins: the truth with errors on it. */
#ifndef SCHULER_SCENARIOS_START_H
#define SCHULER_SCENARIOS_START_H

#include "core/truth.h"
#include "mechanization/mechanization.h"

/** The true state with the errors of a start, resolved in NED at the truth: position m, velocity m/s, and
 *  phi rad: computed C_b_n = (I - [phi x]) C_b_n, where n is that of the place where the navigator believes
 *  to be. */
schuler_nav_state schuler_start_with(const schuler_truth_state *truth, schuler_vec3 dr_n,
                                     schuler_vec3 dv_n, schuler_vec3 phi_n);

#endif

/* SPDX-License-Identifier: MIT */
/* A vehicle that stays at its place for a while, still or swaying about it, and ends in the attitude in
 * which it sets off: the motion of an alignment. */
#ifndef SCHULER_CORE_MOORING_H
#define SCHULER_CORE_MOORING_H

#include "core/path.h"

SCHULER_BEGIN_C

/* Roll, pitch and heading swing as sinusoids of different periods about their means; heave does not
 * move the place. All zero: still. */
typedef struct {
    double roll_rad, pitch_rad, heading_rad; /* amplitudes                                       */
    double period_s;                         /* of the roll; pitch and heading have 0.8 and 1.3  */
} schuler_sway;

/** Given     r_e, q_b_e   place and attitude at the end, which is reached at rest: the sway dies away
 *                         smoothly over the last period
 *            duration_s   more than two periods when it sways
 *  Returned  out          zero-initialised before; owned by the caller
 *  Errors    SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC (too fast a sway) */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_path_mooring(schuler_path *out,
                                                                  schuler_vec3 r_e,
                                                                  schuler_quat q_b_e,
                                                                  double duration_s,
                                                                  const schuler_sway *sway);

SCHULER_END_C

#endif

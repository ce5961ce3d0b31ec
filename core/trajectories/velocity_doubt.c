/* SPDX-License-Identifier: MIT */
#include "core/trajectories/velocity_doubt.h"
#include "core/vec.h"

/* They may differ by an acceleration that changes within the interval, h/6 of it at most. */
double schuler_velocity_doubt(const schuler_recorded_sample *a, const schuler_recorded_sample *b,
                              double h_s)
{
    const schuler_vec3 by_place = schuler_vec3_scale(1.0 / h_s, schuler_vec3_sub(b->r_e, a->r_e));
    const schuler_vec3 mean = schuler_vec3_scale(0.5, schuler_vec3_add(a->v_e, b->v_e));
    const double off_mps = schuler_vec3_norm(schuler_vec3_sub(by_place, mean));
    const double allowed_mps = 0.05 + 0.25 * schuler_vec3_norm(schuler_vec3_sub(b->v_e, a->v_e));
    return off_mps > allowed_mps ? off_mps : 0.0;
}

/* SPDX-License-Identifier: MIT */
/* What a perfect IMU senses at one instant. */
#include "core/truth_private.h"
#include "core/vec.h"

void schuler_truth_rates(const schuler_truth *truth, double t_s, schuler_vec3 *omega_ib_b,
                         schuler_vec3 *f_ib_b)
{
    const schuler_motion m = schuler_path_at(truth->path, t_s);
    const schuler_vec3 omega_ie_e = { { 0.0, 0.0, SCHULER_OMEGA_IE_RADPS } };
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
    const schuler_vec3 g_e =
        schuler_vec3_add(schuler_gravity_at(&truth->truth_table, m.r_e),
                         schuler_path_gravity_at(&truth->dg, SCHULER_PATH_REAL, t_s));
    const schuler_vec3 coriolis_e = schuler_vec3_scale(2.0, schuler_vec3_cross(omega_ie_e, m.v_e));
    const schuler_vec3 f_ib_e = schuler_vec3_sub(schuler_vec3_add(m.a_e, coriolis_e), g_e);
    const schuler_vec3 omega_ie_b = schuler_mat3_apply_transposed(&C_b_e, omega_ie_e);
    *omega_ib_b = schuler_vec3_add(m.omega_eb_b, omega_ie_b);
    *f_ib_b = schuler_mat3_apply_transposed(&C_b_e, f_ib_e);
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/start.h"

schuler_nav_state schuler_start_with(const schuler_truth_state *truth, schuler_vec3 dr_n,
                                     schuler_vec3 dv_n, schuler_vec3 phi_n)
{
    /* C_b_n computed = (I - [phi x]) C_b_n: a turn of the whole by -phi... */
    const schuler_vec3 r_e = schuler_vec3_add(truth->r_e, schuler_mat3_apply(&truth->C_n_e, dr_n));
    const schuler_vec3 turn_e = schuler_mat3_apply(&truth->C_n_e, schuler_vec3_scale(-1.0, phi_n));
    schuler_quat q_b_e = schuler_quat_mul(schuler_quat_from_rotvec(turn_e), truth->q_b_e);
    /* ...and n is that of the place where the navigator believes to be: level there, not at the
     * truth. */
    if (schuler_vec3_norm(dr_n) > 0.0) {
        const schuler_llh llh = schuler_llh_from_ecef(r_e);
        const schuler_mat3 C_n_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad);
        const schuler_mat3 C_e_n = schuler_mat3_transpose(&truth->C_n_e);
        const schuler_mat3 move = schuler_mat3_mul(&C_n_e, &C_e_n);
        q_b_e = schuler_quat_mul(schuler_quat_from_mat3(&move), q_b_e);
    }
    return (schuler_nav_state){
        .r_e = r_e,
        .v_e = schuler_vec3_add(truth->v_e, schuler_mat3_apply(&truth->C_n_e, dv_n)),
        .q_b_e = q_b_e,
    };
}

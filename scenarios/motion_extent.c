/* SPDX-License-Identifier: MIT */
#include "scenarios/motion_extent.h"
#include <stdint.h>

static double heading_at(const schuler_motion *m)
{
    const schuler_llh llh = schuler_llh_from_ecef(m->r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad),
                       C_e_n = schuler_mat3_transpose(&C_n_e),
                       C_b_e = schuler_mat3_from_quat(m->q_b_e),
                       C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    double roll_rad, pitch_rad, heading_rad;
    schuler_euler_from_mat3(&C_b_n, &roll_rad, &pitch_rad, &heading_rad);
    return heading_rad;
}

schuler_motion_extent schuler_motion_extent_of(const schuler_path *path)
{
    enum { INSTANTS = 20000 };
    schuler_motion_extent e = { 0 };
    double before_rad = 0.0;
    for (int i = 0; i <= INSTANTS; i++) {
        const schuler_motion m = schuler_path_at(path, path->duration_s * i / INSTANTS);
        const double heading_rad = heading_at(&m);
        const double turn_rad = i ? remainder(heading_rad - before_rad, 2.0 * SCHULER_PI) : 0.0;
        before_rad = heading_rad;
        e.turned_rad += fabs(turn_rad);
        e.turned_on_rad += turn_rad;
        e.speed_mps = fmax(e.speed_mps, schuler_vec3_norm(m.v_e));
        e.accel_mps2 = fmax(e.accel_mps2, schuler_vec3_norm(m.a_e));
        e.rate_radps = fmax(e.rate_radps, schuler_vec3_norm(m.omega_eb_b));
    }
    return e;
}

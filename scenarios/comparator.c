/* SPDX-License-Identifier: MIT */
#include "scenarios/comparator.h"
#include <math.h>

/* Into [-pi, pi]: the short way round. */
static double wrapped(double angle_rad)
{
    return remainder(angle_rad, 2.0 * SCHULER_PI);
}

schuler_error_row schuler_compare(const schuler_nav_state *nav, const schuler_truth_state *truth)
{
    schuler_error_row row = { .time_s = truth->t_s };
    const schuler_vec3 dr_n =
        schuler_mat3_apply_transposed(&truth->C_n_e, schuler_vec3_sub(nav->r_e, truth->r_e));
    const schuler_vec3 dv_n =
        schuler_mat3_apply_transposed(&truth->C_n_e, schuler_vec3_sub(nav->v_e, truth->v_e));
    for (int i = 0; i < 3; i++) {
        row.r_n[i] = dr_n.v[i] + 0.0; /* no negative zeros in tables */
        row.v_n[i] = dv_n.v[i] + 0.0;
    }
    return row;
}

void schuler_compare_attitude(const schuler_nav_state *nav, const schuler_truth_state *truth,
                              schuler_error_row *row)
{
    const schuler_llh llh = schuler_llh_from_ecef(nav->r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&C_n_e);
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(nav->q_b_e);
    const schuler_mat3 C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    double roll_rad, pitch_rad, heading_rad;
    schuler_euler_from_mat3(&C_b_n, &roll_rad, &pitch_rad, &heading_rad);
    row->roll_rad = wrapped(roll_rad - truth->roll_rad);
    row->pitch_rad = pitch_rad - truth->pitch_rad;
    row->heading_rad = wrapped(heading_rad - truth->heading_rad);
}

void schuler_metrics_start(lane_metrics *m, const schuler_error_row *row)
{
    for (int i = 0; i < 2; i++) m->start_m[i] = row->r_n[i];
}

double schuler_metrics_take(lane_metrics *m, const schuler_error_row *row)
{
    const double r2 = row->r_n[0] * row->r_n[0] + row->r_n[1] * row->r_n[1];
    const double r = sqrt(r2), t = row->time_s;
    const double dn = row->r_n[0] - m->start_m[0], de = row->r_n[1] - m->start_m[1];
    m->sum_tr += t * sqrt(dn * dn + de * de);
    m->sum_tt += t * t;
    m->sum_v2 += row->v_n[0] * row->v_n[0] + row->v_n[1] * row->v_n[1];
    m->count += 1.0;
    m->end_m = r;
    if (r > m->max_m) m->max_m = r;
    return r2;
}

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

/* Reference E1: sqrt(g/R) of a sphere. */
static const double schuler_radps = 0.00124067072659453, late_s = 1800.0;

/* Upper triangle and right sides of the least squares of r = v t + A (1 - cos wt) + B sin wt. */
static void take_harmonic(lane_metrics *m, double t_s, double north_m, double east_m)
{
    const double wt = schuler_radps * t_s, base[3] = { t_s, 1.0 - cos(wt), sin(wt) };
    for (int i = 0; i < 3; i++) {
        for (int k = i; k < 3; k++) m->harmonic[i][k] += base[i] * base[k];
        m->harmonic[i][3] += base[i] * north_m;
        m->harmonic[i][4] += base[i] * east_m;
    }
}

/* v of an axis; 0 when there are too few reports to tell it from the oscillation. */
static double harmonic_rate(const lane_metrics *m, int axis)
{
    const double(*h)[5] = m->harmonic;
    const double r[3] = { h[0][3 + axis], h[1][3 + axis], h[2][3 + axis] };
    const double p = h[1][1] * h[2][2] - h[1][2] * h[1][2],
                 q = h[0][1] * h[2][2] - h[0][2] * h[1][2],
                 s = h[0][1] * h[1][2] - h[0][2] * h[1][1];
    const double det = h[0][0] * p - h[0][1] * q + h[0][2] * s;
    if (!(det > 1e-12 * h[0][0] * h[1][1] * h[2][2])) return 0.0;
    return (r[0] * p - r[1] * q + r[2] * s) / det;
}

double schuler_metrics_drift(const lane_metrics *m, schuler_metric metric, int axis)
{
    if (metric == SCHULER_METRIC_SLOPE) return (axis < 0 ? m->sum_tr : m->sum_ta[axis]) / m->sum_tt;
    if (metric == SCHULER_METRIC_TRMS)
        return m->count_late > 0.0 ? sqrt(m->sum_late / m->count_late) : 0.0;
    double a[2];
    for (int i = 0; i < 2; i++)
        a[i] = metric == SCHULER_METRIC_FINAL ? m->end_a[i] / m->end_s : harmonic_rate(m, i);
    return axis < 0 ? hypot(a[0], a[1]) : a[axis];
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
    const double from_start = sqrt(dn * dn + de * de);
    m->sum_tr += t * from_start;
    m->sum_tt += t * t;
    m->sum_ta[0] += t * dn;
    m->sum_ta[1] += t * de;
    if (t >= late_s) {
        m->sum_late += from_start * from_start / (t * t);
        m->count_late += 1.0;
    }
    take_harmonic(m, t, dn, de);
    m->end_s = t;
    m->end_a[0] = dn;
    m->end_a[1] = de;
    m->sum_v2 += row->v_n[0] * row->v_n[0] + row->v_n[1] * row->v_n[1];
    m->count += 1.0;
    m->end_m = r;
    if (r > m->max_m) m->max_m = r;
    return r2;
}

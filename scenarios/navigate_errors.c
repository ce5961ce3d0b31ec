/* SPDX-License-Identifier: MIT */
#include "scenarios/navigate_errors.h"
#include <math.h>

schuler_trajectory_row navigate_row(const schuler_nav_state *s, double t_s, schuler_mat3 *C_b_n)
{
    schuler_trajectory_row row = { .t_s = t_s, .llh = schuler_llh_from_ecef(s->r_e) };
    const schuler_mat3 C_n_e = schuler_C_n_e(row.llh.lat_rad, row.llh.lon_rad);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&C_n_e);
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(s->q_b_e);
    *C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    row.v_n = schuler_mat3_apply(&C_e_n, s->v_e);
    schuler_euler_from_mat3(C_b_n, &row.roll_rad, &row.pitch_rad, &row.heading_rad);
    return row;
}

static schuler_navigate_errors
errors_of(const schuler_nav_state *s, const schuler_trajectory_row *row, const schuler_mat3 *C_b_n,
          const schuler_trajectory_row *reference, const schuler_recorded_sample *truth)
{
    const schuler_mat3 C_n_e = schuler_C_n_e(reference->llh.lat_rad, reference->llh.lon_rad);
    const schuler_vec3 dr_e = schuler_vec3_sub(s->r_e, truth->r_e);
    const schuler_vec3 dr_n = schuler_mat3_apply_transposed(&C_n_e, dr_e);
    const schuler_mat3 C_b_n_true =
        schuler_mat3_from_euler(reference->roll_rad, reference->pitch_rad, reference->heading_rad);
    const schuler_mat3 C_n_b_true = schuler_mat3_transpose(&C_b_n_true);
    const schuler_mat3 rotation = schuler_mat3_mul(C_b_n, &C_n_b_true);
    const schuler_vec3 phi_n = schuler_quat_to_rotvec(schuler_quat_from_mat3(&rotation));
    return (schuler_navigate_errors){
        .horizontal_m = hypot(dr_n.v[0], dr_n.v[1]),
        .height_m = row->llh.h_m - reference->llh.h_m,
        .velocity_mps = schuler_vec3_norm(schuler_vec3_sub(s->v_e, truth->v_e)),
        .attitude_rad = schuler_vec3_norm(phi_n),
    };
}

static void add_figure(schuler_error_figures *f, double error)
{
    f->final = error;
    f->max = fmax(f->max, fabs(error));
    f->rms += error * error;
}

/* Times at which growth is told: the first row at each, or after it. */
static const double told_s[] = { 1,     2,     5,     10,    20,    30,    60,    120,
                                 300,   600,   1200,  1800,  3600,  7200,  18000, 36000,
                                 72000, 86400, 1.8e5, 3.6e5, 7.2e5, 1.8e6, 3.6e6 };
enum { TOLD = sizeof told_s / sizeof told_s[0] };
_Static_assert((int)TOLD < (int)SCHULER_GROWTH_TIMES_MAX, "and the end");

/* How many of the times have come, to the rounding of clocks. */
static int come(double elapsed_s)
{
    int n = 0;
    while (n < TOLD && elapsed_s > told_s[n] - 1e-6) n++;
    return n;
}

void navigate_compare(schuler_navigate_result *result, const schuler_nav_state *s,
                      const schuler_trajectory_row *row, const schuler_mat3 *C_b_n,
                      const schuler_trajectory_row *reference, const schuler_recorded_sample *truth,
                      double elapsed_s)
{
    const schuler_navigate_errors e = errors_of(s, row, C_b_n, reference, truth);
    add_figure(&result->horizontal_m, e.horizontal_m);
    add_figure(&result->height_m, e.height_m);
    add_figure(&result->velocity_mps, e.velocity_mps);
    add_figure(&result->attitude_rad, e.attitude_rad);
    /* The last one is of the row before, and stays when that was one of the times. */
    const schuler_navigate_growth now = { elapsed_s, e };
    int n = result->growth_times;
    if (n > 0 &&
        come(result->growth[n - 1].time_s) == come(n > 1 ? result->growth[n - 2].time_s : 0))
        n--;
    result->growth[n] = now;
    result->growth_times = n + 1;
}

static void finish(schuler_error_figures *f, int64_t rows)
{
    f->rms = rows > 0 ? sqrt(f->rms / (double)rows) : 0.0;
}

void navigate_finish(schuler_navigate_result *result)
{
    finish(&result->horizontal_m, result->rows - 1);
    finish(&result->height_m, result->rows - 1);
    finish(&result->velocity_mps, result->rows - 1);
    finish(&result->attitude_rad, result->rows - 1);
}

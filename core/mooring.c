/* SPDX-License-Identifier: MIT */
#include "core/mooring.h"
#include "core/course.h"
#include "core/path_build.h"
#include <math.h>
#include <stdlib.h>

typedef struct {
    schuler_sway sway;
    double roll_rad, pitch_rad, heading_rad; /* means, and the attitude at the end */
    long double fade_from_s, fade_s;
    int fading;
} mooring;

static long double swing(const mooring *m, double amplitude, double periods, long double t)
{
    return amplitude * sinl(2.0L * (long double)M_PI * t / (periods * m->sway.period_s));
}

static void flow(const void *user, schuler_instant at, const schuler_course *course,
                 schuler_flow *out)
{
    const mooring *const m = user;
    const long double t = (long double)at.joint_s + at.after_s;
    long double left = 1.0L;
    if (m->fading) {
        const long double x = (t - m->fade_from_s) / m->fade_s;
        left = 1.0L - x * x * x * (10.0L - x * (15.0L - 6.0L * x));
    }
    const long double r = m->roll_rad + left * swing(m, m->sway.roll_rad, 1.0, t);
    const long double p = m->pitch_rad + left * swing(m, m->sway.pitch_rad, 0.8, t);
    const long double h = m->heading_rad + left * swing(m, m->sway.heading_rad, 1.3, t);
    const long double cr = cosl(r), sr = sinl(r), cp = cosl(p), sp = sinl(p), ch = cosl(h),
                      sh = sinl(h);
    /* Rows of C_b_n's columns: forward, right, down in north, east, down. */
    const long double axes[3][3] = {
        { cp * ch, cp * sh, -sp },
        { sr * sp * ch - cr * sh, sr * sp * sh + cr * ch, sr * cp },
        { cr * sp * ch + sr * sh, cr * sp * sh - sr * ch, cr * cp },
    };
    const xvec north = course->u_e, up = course->n_e;
    const xvec east = xvec_cross(north, up);
    out->n_rate_e = out->u_rate_e = out->v_e = xvec_make(0.0L, 0.0L, 0.0L);
    for (int i = 0; i < 3; i++)
        out->axes_e[i] = xvec_add_scaled(
            xvec_add_scaled(xvec_scale(axes[i][0], north), axes[i][1], east), -axes[i][2], up);
}

static schuler_status still(schuler_path *out, schuler_vec3 r_e, schuler_quat q_b_e,
                            double duration_s)
{
    schuler_piece *const piece = calloc(1, sizeof *piece);
    if (!piece) return SCHULER_ERR_MEMORY;
    piece->duration_s = schuler_tick(duration_s);
    piece->r0_e = r_e;
    piece->q0_b_e = q_b_e;
    *out = (schuler_path){ .count = 1, .pieces = piece, .duration_s = piece->duration_s };
    return SCHULER_OK;
}

schuler_status schuler_path_mooring(schuler_path *out, schuler_vec3 r_e, schuler_quat q_b_e,
                                    double duration_s, const schuler_sway *sway)
{
    if (sway->roll_rad == 0.0 && sway->pitch_rad == 0.0 && sway->heading_rad == 0.0)
        return still(out, r_e, q_b_e, duration_s);
    const schuler_llh at = schuler_llh_from_ecef(r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(at.lat_rad, at.lon_rad);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&C_n_e);
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(q_b_e);
    const schuler_mat3 C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    const double end_s = schuler_tick(duration_s), fade_s = schuler_tick(sway->period_s);
    mooring m = { .sway = *sway, .fade_from_s = end_s - fade_s, .fade_s = fade_s };
    schuler_euler_from_mat3(&C_b_n, &m.roll_rad, &m.pitch_rad, &m.heading_rad);
    schuler_path_builder b;
    schuler_path_begin(&b, out, schuler_course_at(at.lat_rad, at.lon_rad, 0.0), at.h_m);
    schuler_status status = schuler_path_extend(&b, flow, &m, 0.0, end_s - fade_s);
    m.fading = 1;
    if (status == SCHULER_OK) status = schuler_path_extend(&b, flow, &m, end_s - fade_s, end_s);
    if (status != SCHULER_OK) schuler_path_free(out);
    return status;
}

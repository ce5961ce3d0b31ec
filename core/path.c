/* SPDX-License-Identifier: MIT */
#include "core/path.h"
#include <stdlib.h>

void schuler_path_free(schuler_path *path)
{
    if (path == NULL) return;
    free(path->pieces);
    *path = (schuler_path){ 0 };
}

size_t schuler_path_find(const schuler_path *path, double t_s)
{
    size_t low = 0, high = path->count; /* the piece is in [low, high) */
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (path->pieces[middle].t0_s <= t_s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Value and the first two derivatives of a power series. */
static void series(const double *c, int degree, double s, double out[3])
{
    double p = c[degree], dp = 0.0, half_ddp = 0.0;
    for (int k = degree - 1; k >= 0; k--) {
        half_ddp = half_ddp * s + dp;
        dp = dp * s + p;
        p = p * s + c[k];
    }
    out[0] = p;
    out[1] = dp;
    out[2] = 2.0 * half_ddp;
}

/* Rate in body axes of a rotation vector that changes: omega = J rho', with
 * J = 1 - (1 - cos x)/x^2 [rho x] + (x - sin x)/x^3 [rho x]^2. */
static schuler_vec3 rate_of_rotvec(schuler_vec3 rho, schuler_vec3 rho_dot)
{
    const double x2 = schuler_vec3_dot(rho, rho), x = sqrt(x2);
    /* Below 0.02 the differences lose digits; three terms of the series are exact to rounding. */
    const double k1 = x < 0.02 ? 0.5 - x2 / 24.0 * (1.0 - x2 / 30.0) : (1.0 - cos(x)) / x2;
    const double k2 =
        x < 0.02 ? 1.0 / 6.0 - x2 / 120.0 * (1.0 - x2 / 42.0) : (x - sin(x)) / (x2 * x);
    const schuler_vec3 once = schuler_vec3_cross(rho, rho_dot);
    const schuler_vec3 twice = schuler_vec3_cross(rho, once);
    return schuler_vec3_add(schuler_vec3_sub(rho_dot, schuler_vec3_scale(k1, once)),
                            schuler_vec3_scale(k2, twice));
}

schuler_motion schuler_piece_at(const schuler_piece *piece, double s)
{
    const double ds_dt = 2.0 / piece->duration_s;
    schuler_motion m;
    schuler_vec3 rho, rho_dot;
    for (int i = 0; i < 3; i++) {
        double p[3];
        series(piece->dr_e[i], SCHULER_PIECE_DEGREE, s, p);
        m.r_e.v[i] = piece->r0_e.v[i] + p[0];
        m.v_e.v[i] = p[1] * ds_dt;
        m.a_e.v[i] = p[2] * ds_dt * ds_dt;
        series(piece->rho_b[i], SCHULER_PIECE_DEGREE - 1, s, p);
        rho.v[i] = p[0];
        rho_dot.v[i] = p[1] * ds_dt;
    }
    m.q_b_e = schuler_quat_mul(piece->q0_b_e, schuler_quat_from_rotvec(rho));
    m.omega_eb_b = rate_of_rotvec(rho, rho_dot);
    return m;
}

schuler_motion schuler_path_at(const schuler_path *path, double t_s)
{
    const schuler_piece *const piece = &path->pieces[schuler_path_find(path, t_s)];
    const double s = (t_s - piece->t0_s) * (2.0 / piece->duration_s) - 1.0;
    return schuler_piece_at(piece, fmin(fmax(s, -SCHULER_PIECE_REACH), SCHULER_PIECE_REACH));
}

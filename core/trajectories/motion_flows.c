/* SPDX-License-Identifier: MIT */
/* Test motions in closed form. */
#include "core/earth.h"
#include "core/trajectories/motion.h"

static const long double pi = 3.14159265358979323846264338327950288L;

static long double time_of(schuler_instant t)
{
    return (long double)t.joint_s + t.after_s;
}

/* At rest in r, with axes given there. */
static void in_place(const motion_frame *m, const xvec axes_in_r[3], schuler_flow *out)
{
    out->n_rate_e = out->u_rate_e = out->v_e = xvec_make(0.0L, 0.0L, 0.0L);
    for (int i = 0; i < 3; i++) out->axes_e[i] = xvec_along(m->axes_r, axes_in_r[i]);
}

static void start_axes(xvec axes[3])
{
    for (int i = 0; i < 3; i++) axes[i] = xvec_make(i == 0, i == 1, i == 2);
}

/* q = [cos(a/2), sin(a/2) cos wt, sin(a/2) sin wt, 0]: a turn by the half angle a about an axis that
 * goes round in the plane of x and y. */
void schuler_motion_coning(const void *user, schuler_instant t, const schuler_course *course,
                           schuler_flow *out)
{
    (void)course;
    const motion_frame *const m = user;
    const schuler_coning_spec *const s = &m->spec->coning;
    const long double turns = (long double)s->frequency_Hz * time_of(t);
    const long double phase = 2.0L * pi * (turns - rintl(turns));
    xvec axes[3];
    start_axes(axes);
    xvec_turn(axes, 2, phase);
    xvec_turn(axes, 0, s->half_angle_rad);
    xvec_turn(axes, 2, -phase);
    in_place(m, axes, out);
}

/* Roll A sin wt and a specific force along y of D sin wt, both exactly, so the vehicle gains D J1(A) of
 * velocity a second along z. With x = wt (Jacobi and Anger)
 *     sin x cos(A sin x) = sum (J_2k - J_2k+2) sin (2k+1) x,
 *     sin x sin(A sin x) = J_1 + sum (J_2k+1 - J_2k-1) cos 2kx. */
void schuler_motion_sculling(const void *user, schuler_instant t, const schuler_course *course,
                             schuler_flow *out)
{
    enum { TERMS = 12 };
    (void)course;
    const motion_frame *const m = user;
    const schuler_sculling_spec *const s = &m->spec->sculling;
    const long double A = s->angle_rad, omega = 2.0L * pi * (long double)s->frequency_Hz;
    const long double turns = (long double)s->frequency_Hz * time_of(t);
    const long double x = 2.0L * pi * (turns - rintl(turns));
    xvec axes[3];
    start_axes(axes);
    xvec_turn(axes, 0, A * sinl(x));
    in_place(m, axes, out);
    long double J[2 * TERMS + 3];
    for (int k = 0; k < 2 * TERMS + 3; k++) J[k] = jnl(k, A);
    long double v_y = 0.0L, v_z = J[1] * time_of(t);
    for (int k = TERMS; k >= 0; k--) {
        v_y -= (J[2 * k] - J[2 * k + 2]) / (2 * k + 1) * cosl((2 * k + 1) * x) / omega;
        if (k > 0) v_z += (J[2 * k + 1] - J[2 * k - 1]) / (2 * k) * sinl(2 * k * x) / omega;
    }
    out->v_e = xvec_along(m->axes_r, xvec_make(0.0L, s->force_mps2 * v_y, s->force_mps2 * v_z));
}

/* Roll (w_s - w_c cos b) t, pitch pi/2 - b, yaw -w_c t. */
void schuler_motion_spin_cone(const void *user, schuler_instant t, const schuler_course *course,
                              schuler_flow *out)
{
    (void)course;
    const motion_frame *const m = user;
    const schuler_spin_cone_spec *const s = &m->spec->spin_cone;
    const long double cone = s->cone_rad;
    const long double roll_rate = s->spin_radps - s->precession_radps * cosl(cone);
    xvec axes[3];
    start_axes(axes);
    xvec_turn(axes, 2, -(long double)s->precession_radps * time_of(t));
    xvec_turn(axes, 1, 0.5L * pi - cone);
    xvec_turn(axes, 0, roll_rate * time_of(t));
    in_place(m, axes, out);
}

void schuler_motion_constant_rate(const void *user, schuler_instant t, const schuler_course *course,
                                  schuler_flow *out)
{
    (void)course;
    const motion_frame *const m = user;
    const double *const w = m->spec->constant_rate.rate_radps;
    const xvec rate = xvec_make(w[0], w[1], w[2]);
    const long double size = sqrtl(xvec_dot(rate, rate)), angle = size * time_of(t);
    xvec axes[3];
    start_axes(axes);
    const xvec u = xvec_scale(size > 0.0L ? 1.0L / size : 0.0L, rate);
    for (int i = 0; i < 3; i++) { /* Rodrigues: x + sin u x x + (1 - cos) u x (u x x) */
        const xvec once = xvec_cross(u, axes[i]), twice = xvec_cross(u, once);
        axes[i] =
            xvec_add_scaled(xvec_add_scaled(axes[i], sinl(angle), once), 1.0L - cosl(angle), twice);
    }
    in_place(m, axes, out);
}

void schuler_motion_turntable(const void *user, schuler_instant t, const schuler_course *course,
                              schuler_flow *out)
{
    (void)course;
    const motion_frame *const m = user;
    /* About the vertical, whatever the attitude on the table: r is turned, not b. */
    const schuler_start *const at = &m->spec->start;
    xvec axes[3];
    start_axes(axes);
    xvec_turn(axes, 2, m->spec->turntable.rate_radps * time_of(t));
    xvec_turn(axes, 1, at->pitch_rad);
    xvec_turn(axes, 0, at->roll_rad);
    in_place(m, axes, out);
}

/* Level, heading east, at constant speed: all rates are constant in the local frame. */
void schuler_motion_parallel(const void *user, schuler_instant t, const schuler_course *course,
                             schuler_flow *out)
{
    (void)course;
    const motion_frame *const m = user;
    const schuler_start *const at = &m->spec->start;
    const long double e2 = SCHULER_WGS84_E2, sl = sinl(at->lat_rad), cl = cosl(at->lat_rad);
    const long double R_P = SCHULER_WGS84_A_M / sqrtl(1.0L - e2 * sl * sl);
    const long double speed = m->spec->parallel.speed_mps;
    const long double lon = at->lon_rad + speed / ((R_P + at->h_m) * cl) * time_of(t);
    const long double so = sinl(lon), co = cosl(lon);
    const xvec east_e = xvec_make(-so, co, 0.0L);
    out->n_rate_e = out->u_rate_e = xvec_make(0.0L, 0.0L, 0.0L);
    out->v_e = xvec_scale(speed, east_e);
    out->axes_e[0] = east_e;
    out->axes_e[1] = xvec_make(sl * co, sl * so, -cl); /* south */
    out->axes_e[2] = xvec_make(-cl * co, -cl * so, -sl);
}

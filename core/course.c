/* SPDX-License-Identifier: MIT */
/* Along a horizontal unit vector t, the unit normal n of the ellipsoid turns per metre of its
 * surface by K(t) = (1/R_P) [t + e'^2 t_z (z - n_z n)],  z = (0, 0, 1), because 1/R_M - 1/R_P =
 * e'^2 cos^2(lat)/R_P, cos(lat) N = z - n_z n and t_z = cos(lat) t.N: east it is t/R_P, north
 * t/R_M, and no place is singular. At height h the velocity is s' (t + h K(t)) + h' n for a surface
 * speed s'. */
#include "core/course.h"
#include "core/earth.h"

static const long double e2 = SCHULER_WGS84_E2;

schuler_course schuler_course_at(long double lat_rad, long double lon_rad, long double azimuth_rad)
{
    const long double sl = sinl(lat_rad), cl = cosl(lat_rad);
    const long double so = sinl(lon_rad), co = cosl(lon_rad);
    const xvec north_e = xvec_make(-sl * co, -sl * so, cl), east_e = xvec_make(-so, co, 0.0L);
    return (schuler_course){
        .n_e = xvec_make(cl * co, cl * so, sl),
        .u_e = xvec_add_scaled(xvec_scale(cosl(azimuth_rad), north_e), sinl(azimuth_rad), east_e),
    };
}

/* K(t) at n. */
static xvec normal_turn(xvec n_e, xvec t_e)
{
    const long double R_P = SCHULER_WGS84_A_M / sqrtl(1.0L - e2 * n_e.v[2] * n_e.v[2]);
    const long double k = e2 / (1.0L - e2) * t_e.v[2];
    const xvec z_cross_part = xvec_add_scaled(xvec_make(0.0L, 0.0L, 1.0L), -n_e.v[2], n_e);
    return xvec_scale(1.0L / R_P, xvec_add_scaled(t_e, k, z_cross_part));
}

/* What the channels of speed, height and path angle say at an instant. */
typedef struct {
    long double ground_mps; /* over ground, at the height; negative when the path leads backwards */
    long double climb_mps, h_m;
    long double cp, sp; /* cosine and sine of the path angle */
} steering;

static steering steer(const schuler_phase *phase, schuler_instant t, long double h_m)
{
    const long double speed = schuler_channel_value(&phase->speed, t);
    if (phase->along_path) {
        const long double angle = schuler_channel_value(&phase->path_angle, t);
        const long double cp = cosl(angle), sp = sinl(angle);
        return (steering){ speed * cp, speed * sp, h_m, cp, sp };
    }
    const long double climb = schuler_channel_rate(&phase->height, t);
    const long double along = hypotl(speed, climb);
    return (steering){
        .ground_mps = speed,
        .climb_mps = climb,
        .h_m = schuler_channel_value(&phase->height, t),
        .cp = along > 0.0L ? speed / along : 1.0L,
        .sp = along > 0.0L ? climb / along : 0.0L,
    };
}

/* Forward along the flight path, bank by coordination: tan(bank) = speed * turn rate / g0. Written
 * with vectors and ratios, so that no angle is ever singular. Then the body's own turns. */
static void attitude(const schuler_phase *phase, schuler_instant t, xvec n_e, xvec forward_e,
                     steering at, long double turn_rate, xvec axes_e[3])
{
    const long double cp = at.cp, sp = at.sp;
    const long double tan_bank = phase->banked ? at.ground_mps * turn_rate / SCHULER_G0_MPS2 : 0.0L;
    const long double cr = 1.0L / sqrtl(1.0L + tan_bank * tan_bank), sr = tan_bank * cr;
    axes_e[0] = xvec_add_scaled(xvec_scale(cp, forward_e), sp, n_e);
    const xvec right_e = xvec_cross(forward_e, n_e);
    const xvec under_e = xvec_cross(axes_e[0], right_e);
    axes_e[1] = xvec_add_scaled(xvec_scale(cr, right_e), sr, under_e);
    axes_e[2] = xvec_add_scaled(xvec_scale(cr, under_e), -sr, right_e);
    const schuler_channel *const turns[3] = { &phase->yaw, &phase->pitch, &phase->roll };
    for (int i = 0; i < 3; i++) {
        const long double angle = schuler_channel_value(turns[i], t);
        if (angle != 0.0L) xvec_turn(axes_e, 2 - i, angle);
    }
}

static void flow_rhumb(const void *user, schuler_instant t, const schuler_course *course,
                       schuler_flow *out)
{
    const schuler_phase *const phase = user;
    const xvec n = course->n_e;
    const steering at = steer(phase, t, course->h_m);
    const long double speed = at.ground_mps, h = at.h_m;
    const long double heading = schuler_channel_value(&phase->heading, t);
    const xvec east_e = xvec_unit(xvec_make(-n.v[1], n.v[0], 0.0L));
    const xvec north_e = xvec_cross(n, east_e);
    const long double w2 = 1.0L - e2 * n.v[2] * n.v[2];
    const long double R_P = SCHULER_WGS84_A_M / sqrtl(w2), R_M = R_P * (1.0L - e2) / w2;
    const long double ch = cosl(heading), sh = sinl(heading);
    const xvec forward_e = xvec_add_scaled(xvec_scale(ch, north_e), sh, east_e);
    out->n_rate_e = xvec_add_scaled(xvec_scale(speed * ch / (R_M + h), north_e),
                                    speed * sh / (R_P + h), east_e);
    out->u_rate_e = xvec_make(0.0L, 0.0L, 0.0L); /* not used by this flow */
    out->h_rate_mps = at.climb_mps;
    out->v_e = xvec_add_scaled(xvec_scale(speed, forward_e), at.climb_mps, n);
    attitude(phase, t, n, forward_e, at, schuler_channel_rate(&phase->heading, t), out->axes_e);
}

static void flow_track(const void *user, schuler_instant t, const schuler_course *course,
                       schuler_flow *out)
{
    const schuler_phase *const phase = user;
    const xvec n = course->n_e, u = course->u_e;
    const steering at = steer(phase, t, course->h_m);
    const long double speed = at.ground_mps, h = at.h_m;
    const long double turn_rate = schuler_channel_rate(&phase->heading, t);
    const xvec K = normal_turn(n, u);
    const xvec per_surface = xvec_add_scaled(u, h, K);
    const long double stretch = sqrtl(xvec_dot(per_surface, per_surface));
    const xvec forward_e = xvec_scale(1.0L / stretch, per_surface);
    out->n_rate_e = xvec_scale(speed / stretch, K);
    /* The tangent stays tangent; beyond that only the turn moves it: a geodesic when there is none.
     */
    out->u_rate_e =
        xvec_add_scaled(xvec_scale(-xvec_dot(u, out->n_rate_e), n), turn_rate, xvec_cross(u, n));
    out->h_rate_mps = at.climb_mps;
    out->v_e = xvec_add_scaled(xvec_scale(speed, forward_e), at.climb_mps, n);
    attitude(phase, t, n, forward_e, at, turn_rate, out->axes_e);
}

schuler_status schuler_course_follow(schuler_path_builder *b, schuler_course_kind kind,
                                     const schuler_phase *phase)
{
    double joints_s[SCHULER_PHASE_JOINTS];
    const int count = schuler_phase_joints(phase, joints_s);
    schuler_flow_function *const flow = kind == SCHULER_COURSE_RHUMB ? flow_rhumb : flow_track;
    for (int i = 0; i + 1 < count; i++) {
        const schuler_status status =
            schuler_path_extend(b, flow, phase, joints_s[i], joints_s[i + 1]);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

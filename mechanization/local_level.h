/* SPDX-License-Identifier: MIT */
/* Local-level mechanizations: axes L with z along the ellipsoid's normal, down. Position is the attitude
 * of these axes in the earth, a quaternion, and the height; no latitude, no longitude, no trigonometry.
 * Frames differ in how they turn about the vertical: frame_vertical_rate, which the file defines before
 * it includes this.
 *
 * With z the earth's axis in L (z_z = -sin(latitude)) the down vector turns with
 *
 *     omega_eL = (n_y, -n_x, omega_z),   n = v A + z B (v_x z_x + v_y z_y)   of the horizontal parts
 *     A = 1/(R_P + h),   B = e^2 R_P/(1 - e^2 z_z^2) / ((R_M + h)(R_P + h)),
 *
 * A east and A + B cos^2(latitude) = 1/(R_M + h) north; nothing in it is singular. One cycle of length T:
 *
 *     mid   position half a cycle on, with the rate of the cycle before: z, height, gravity there
 *     f     = C_b_L [alpha, upsilon rotated + scul],   u = f - zeta/2 x (f + (dv - dv_before)/6)
 *     dv    = u + g T - T (2 omega_ie + omega_eL) x v_mean + T/12 d_omega x (f - dv),   d_omega the change of omega_eL
 *             v_mean = v + dv_before/12 + 5/12 dv
 *     q_L_e = q_L_e q(T omega_eL),   height -= T v_mean_z
 *     q_b_L = q(-zeta) q_b_L q(phi),   zeta = T (omega_ie + omega_eL)
 *
 * dv is found in two rounds, which leaves 1e-12 of it. The twelfths are what force, velocity and the frame's
 * rate have in common in their change, each linear over the cycle: half of (dv - dv_before)/6 is the force
 * that changes while the frame turns; d_omega x f the frame's rate that does under a steady force; and
 * d_omega x dv the spread of v in omega_eL x v, which is of second order in v. In ECEF the first sums
 * to nothing and there are no others; here a turn would be of second order in T without them: 13 micrometres
 * on the manoeuvres at 100 Hz. */
#ifndef SCHULER_MECHANIZATION_LOCAL_LEVEL_H
#define SCHULER_MECHANIZATION_LOCAL_LEVEL_H

#include "core/earth.h"
#include "mechanization/cycle.h"

typedef struct {
    lanes3 v;        /* in L, m/s          */
    lanes_quat q, p; /* body to L; L to ECEF */
    lanes h;         /* m                  */
    lanes3 v_rest;   /* what their sums have rounded away */
    lanes_quat q_rest, p_rest;
    lanes h_rest;
    lanes3 omega_eL; /* of the cycle before, rad/s */
    cycle_state cycle;
} frame_nav;

typedef struct {
    lanes3 v;
    lanes_quat q, p;
    lanes h;
} frame_sums;

/* The earth's axis in L. */
LANES_INLINE lanes3 earth_axis(lanes_quat p)
{
    const lanes two = lanes_set(2.0);
    return (lanes3){ two * (p.x * p.z - p.w * p.y), two * (p.y * p.z + p.w * p.x),
                     lanes_set(1.0) - two * (p.x * p.x + p.y * p.y) };
}

/* Up in ECEF. */
LANES_INLINE lanes3 up_of(lanes_quat p)
{
    const lanes two = lanes_set(2.0);
    return (lanes3){ -two * (p.x * p.z + p.w * p.y), two * (p.w * p.x - p.y * p.z),
                     two * (p.x * p.x + p.y * p.y) - lanes_set(1.0) };
}

/* C(q)^T u */
LANES_INLINE lanes3 rotate_back(lanes_quat q, lanes3 u)
{
    return lanes_quat_rotate((lanes_quat){ q.w, -q.x, -q.y, -q.z }, u);
}

/* The ellipsoid at a place: curvatures with the height, and metres in ECEF. */
typedef struct {
    lanes3 z, r;
    lanes A, B;
} local_place;

LANES_INLINE local_place place_at(lanes_quat p, lanes h)
{
    const double a = SCHULER_WGS84_A_M, e2 = SCHULER_WGS84_E2;
    local_place at = { .z = earth_axis(p) };
    const lanes one = lanes_set(1.0);
    const lanes w2 = one - lanes_set(e2) * at.z.z * at.z.z, w = lanes_sqrt(w2);
    const lanes east = lanes_set(a) + h * w, north = lanes_set(a * (1.0 - e2)) + h * w * w2;
    const lanes inverse = one / (east * north);
    at.A = w * north * inverse;
    at.B = lanes_set(a * e2) * w * inverse;
    const lanes R_P = lanes_set(a) / w;
    const lanes3 n = up_of(p);
    const lanes out = R_P + h;
    at.r = (lanes3){ out * n.x, out * n.y, (R_P * lanes_set(1.0 - e2) + h) * n.z };
    return at;
}

LANES_INLINE lanes3 transport_rate(const local_place *at, lanes3 v)
{
    const lanes along = at->B * (v.x * at->z.x + v.y * at->z.y);
    const lanes n_x = v.x * at->A + along * at->z.x, n_y = v.y * at->A + along * at->z.y;
    return (lanes3){ n_y, -n_x, frame_vertical_rate(n_y, at->z) };
}

/* T (2 omega_ie + omega_eL) x v */
LANES_INLINE lanes3 coriolis(lanes T, lanes3 z, lanes3 omega_eL, lanes3 v)
{
    const lanes twice = lanes_set(2.0 * SCHULER_OMEGA_IE_RADPS);
    return lanes3_cross(lanes3_scale(T, lanes3_add(lanes3_scale(twice, z), omega_eL)), v);
}

LANES_INLINE lanes3 lanes3_sub(lanes3 a, lanes3 b)
{
    return (lanes3){ a.x - b.x, a.y - b.y, a.z - b.z };
}

/* -T/2 (omega_ie + omega_eL) */
LANES_INLINE lanes3 half_turn(lanes T, lanes3 omega_ie, lanes3 omega_eL)
{
    return lanes3_scale(lanes_set(-0.5) * T, lanes3_add(omega_ie, omega_eL));
}

static void frame_init(frame_nav *n, const schuler_nav_setup *s)
{
    double v[3][SCHULER_LANES], q[4][SCHULER_LANES], p[4][SCHULER_LANES], h[SCHULER_LANES];
    for (int l = 0; l < SCHULER_LANES; l++) {
        const schuler_nav_state *const at = &s->start[l];
        const schuler_llh llh = schuler_llh_from_ecef(at->r_e);
        const schuler_mat3 C_L_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad);
        const schuler_vec3 v_L = schuler_mat3_apply_transposed(&C_L_e, at->v_e);
        const schuler_quat q_L_e = schuler_quat_from_mat3(&C_L_e);
        const schuler_quat q_e_L = { q_L_e.w, -q_L_e.x, -q_L_e.y, -q_L_e.z };
        const schuler_quat q_b_L = schuler_quat_mul(q_e_L, at->q_b_e);
        for (int i = 0; i < 3; i++) v[i][l] = v_L.v[i];
        q[0][l] = q_b_L.w, q[1][l] = q_b_L.x, q[2][l] = q_b_L.y, q[3][l] = q_b_L.z;
        p[0][l] = q_L_e.w, p[1][l] = q_L_e.x, p[2][l] = q_L_e.y, p[3][l] = q_L_e.z;
        h[l] = llh.h_m;
    }
#define LANE_OF(x) lane_values(x, sizeof(double))
    n->v = (lanes3){ LANE_OF(v[0]), LANE_OF(v[1]), LANE_OF(v[2]) };
    n->q = (lanes_quat){ LANE_OF(q[0]), LANE_OF(q[1]), LANE_OF(q[2]), LANE_OF(q[3]) };
    n->p = (lanes_quat){ LANE_OF(p[0]), LANE_OF(p[1]), LANE_OF(p[2]), LANE_OF(p[3]) };
    n->h = LANE_OF(h);
#undef LANE_OF
    n->v_rest = lanes3_zero;
    n->q_rest = n->p_rest = quat_zero;
    n->h_rest = lanes_set(0.0);
    const lanes T = lanes_set(n->cycle.T_s);
    const local_place at = place_at(n->p, n->h);
    n->omega_eL = transport_rate(&at, n->v);
    const lanes3 g = rotate_back(n->p, cycle_gravity(&n->cycle, at.r));
    const lanes3 u =
        lanes3_add(lanes_quat_rotate(n->q, cycle_velocity_before(&n->cycle)), lanes3_scale(T, g));
    n->cycle.dv_before = lanes3_sub(u, coriolis(T, at.z, n->omega_eL, n->v));
}

LANES_INLINE frame_sums frame_no_sums(void)
{
    return (frame_sums){ lanes3_zero, quat_zero, quat_zero, lanes_set(0.0) };
}

LANES_INLINE void frame_join(frame_nav *n, const frame_sums *sums)
{
    n->v = add3_with_rest(n->v, sums->v, &n->v_rest);
    n->h = add_with_rest(n->h, sums->h, &n->h_rest);
    n->q = join_unit(n->q, sums->q, &n->q_rest);
    n->p = join_unit(n->p, sums->p, &n->p_rest);
}

/* The slow cycle. dg_e: what gravity has beyond the table, m/s^2. */
LANES_INLINE void frame_update(frame_nav *n, frame_sums *sums, coning_sums s, lanes3 dg_e)
{
    const double T_s = n->cycle.T_s;
    const lanes T = lanes_set(T_s);
    const lanes3 dv_before = n->cycle.dv_before;
    const lanes3 v = lanes3_add(n->v, sums->v);
    const lanes_quat q = quat_add(n->q, sums->q), p = quat_add(n->p, sums->p);

    const lanes_quat p_mid =
        quat_add(p, quat_turn(p, lanes3_scale(lanes_set(0.25 * T_s), n->omega_eL)));
    const lanes h_mid =
        n->h + (sums->h - (lanes_set(0.5 * T_s) * v.z + lanes_set(T_s / 6.0) * dv_before.z));
    const local_place at = place_at(p_mid, h_mid);
    const lanes3 g = rotate_back(p_mid, lanes3_add(cycle_gravity(&n->cycle, at.r), dg_e));
    const lanes3 earth = lanes3_scale(lanes_set(SCHULER_OMEGA_IE_RADPS), at.z);

    const lanes3 v_first = lanes3_add(v, lanes3_scale(lanes_set(0.5), dv_before));
    const lanes3 omega_first = transport_rate(&at, v_first);
    const lanes3 f = lanes_quat_rotate(q, cycle_velocity(&n->cycle, s));
    const lanes3 g_T = lanes3_scale(T, g);
    const lanes3 turned = lanes3_add_cross(f, half_turn(T, earth, omega_first), f);
    const lanes3 dv_first =
        lanes3_sub(lanes3_add(turned, g_T), coriolis(T, at.z, omega_first, v_first));
    const lanes3 bend = lanes3_sub(dv_first, dv_before);
    const lanes3 v_mean = lanes3_add(v_first, lanes3_scale(lanes_set(5.0 / 12.0), bend));
    const lanes3 omega_eL = transport_rate(&at, v_mean);
    const lanes3 f_turning = lanes3_add(f, lanes3_scale(lanes_set(1.0 / 6.0), bend));
    lanes3 dv = lanes3_add_cross(f, half_turn(T, earth, omega_eL), f_turning);
    dv = lanes3_sub(lanes3_add(dv, g_T), coriolis(T, at.z, omega_eL, v_mean));
    dv =
        lanes3_add_cross(dv, lanes3_scale(lanes_set(T_s / 12.0), lanes3_sub(omega_eL, n->omega_eL)),
                         lanes3_sub(f, dv_first));

    sums->v = lanes3_add(sums->v, dv);
    sums->h -= T * v_mean.z;
    sums->p = quat_add(sums->p, quat_mul(p, rotation_increment(lanes3_scale(T, omega_eL))));
    n->omega_eL = omega_eL;
    n->cycle.dv_before = dv;

    /* The turn of the body, q (q(phi) - 1), and that of the frame. */
    const lanes_quat body = quat_mul(q, rotation_increment(lanes3_add(s.alpha, s.beta)));
    const lanes_quat frame = rotation_increment(lanes3_scale(-T, lanes3_add(earth, omega_eL)));
    sums->q = quat_add(sums->q, quat_add(body, quat_mul(frame, quat_add(q, body))));
}

/* What a group of samples lacks: a turn of the body and a velocity in its axes. */
LANES_INLINE void frame_correct(const frame_nav *n, frame_sums *sums, coning_correction c)
{
    const lanes_quat q = quat_add(n->q, sums->q);
    sums->v = lanes3_add(sums->v, lanes_quat_rotate(q, c.scul));
    sums->q = quat_add(sums->q, quat_turn(q, lanes3_scale(lanes_set(0.5), c.beta)));
}

#include "mechanization/frame_loop.h"

static void hold_vertical(void *state, double height_m, double v_up_mps)
{
    frame_nav *const n = &((frame_state *)state)->nav;
    n->h = lanes_set(height_m);
    n->v.z = lanes_set(-v_up_mps);
    n->h_rest = n->v_rest.z = lanes_set(0.0);
}

static void height(const void *state, double *height_m)
{
    lanes_store(height_m, ((const frame_state *)state)->nav.h);
}

static void correct_vertical(void *state, const double *dh_m, const double *dv_up_mps)
{
    frame_nav *const n = &((frame_state *)state)->nav;
    n->h = add_with_rest(n->h, lanes_load(dh_m), &n->h_rest);
    n->v.z = add_with_rest(n->v.z, -lanes_load(dv_up_mps), &n->v_rest.z);
}

static void get(const void *state, int lane, schuler_nav_state *out)
{
    const frame_nav *const n = &((const frame_state *)state)->nav;
    double x[12][SCHULER_LANES] __attribute__((aligned(64)));
    const local_place at = place_at(n->p, n->h);
    const lanes3 v_e = lanes_quat_rotate(n->p, n->v);
    const lanes_quat q = quat_mul(n->p, n->q);
    const lanes all[] = { at.r.x, at.r.y, at.r.z, v_e.x, v_e.y, v_e.z, q.w, q.x, q.y, q.z };
    for (int i = 0; i < 10; i++) lanes_store(x[i], all[i]);
    for (int i = 0; i < 3; i++) {
        out->r_e.v[i] = x[i][lane];
        out->v_e.v[i] = x[3 + i][lane];
    }
    out->q_b_e = (schuler_quat){ x[6][lane], x[7][lane], x[8][lane], x[9][lane] };
}

/* For the table of a frame. */
#define LOCAL_LEVEL_FUNCTIONS                                                                      \
    .state_size = offsetof(frame_state, group),                                                    \
    .group_size = sizeof(frame_state) - offsetof(frame_state, group), .init = frame_start,         \
    .advance = frame_advance, .hold_vertical = hold_vertical, .height = height,                    \
    .correct_vertical = correct_vertical, .get = get

#endif

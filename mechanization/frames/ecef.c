/* SPDX-License-Identifier: MIT */
/* Earth-fixed mechanization: position in ECEF metres, quaternion body to ECEF. No trigonometry and
 * no division in the cycle, nothing singular anywhere on earth.
 *
 * One navigation cycle of length T, w = Omega T z the earth's turn in it:
 *
 *     phi  = alpha + beta                                 rotation vector of the body
 *     u_e  = (1 - w/2 x) C_b_e [alpha, upsilon rotated + scul]
 *     g    = gravity at the mean position of the cycle
 *     dv   = u_e + g T - 2 w x (v + dv_before/12 + 5/12 dv)     solved for dv
 *     r   += T (v + dv/2 - (dv - dv_before)/12)
 *     q    = q(-w) q q(phi)
 *
 * Means take the acceleration as linear over this cycle and the one before. Left out: the change of
 * force during the earth's turn, w/12 x (u_e - u_before), which sums to w/12 x (the change of u_e).
 */
#include "mechanization/cycle.h"

typedef struct {
    lanes3 r, v;           /* m, m/s */
    lanes_quat q;          /* body to ECEF */
    lanes3 r_rest, v_rest; /* what their sums have rounded away */
    lanes_quat q_rest;
    cycle_state cycle;
    double turn_rad; /* of the earth in a cycle */
    double implicit_rad, implicit_inverse;
} frame_nav;

typedef struct {
    lanes3 r, v;
    lanes_quat q;
} frame_sums;

LANES_INLINE lanes3 minus_turn(double angle_rad, lanes3 a)
{
    const lanes h = lanes_set(angle_rad);
    return (lanes3){ a.x + h * a.y, a.y - h * a.x, a.z };
}

static void frame_init(frame_nav *n, const schuler_nav_setup *s)
{
    const size_t stride = sizeof(schuler_nav_state);
    const schuler_nav_state *first = s->start;
    n->r = (lanes3){ lane_values(&first->r_e.v[0], stride), lane_values(&first->r_e.v[1], stride),
                     lane_values(&first->r_e.v[2], stride) };
    n->v = (lanes3){ lane_values(&first->v_e.v[0], stride), lane_values(&first->v_e.v[1], stride),
                     lane_values(&first->v_e.v[2], stride) };
    n->q =
        (lanes_quat){ lane_values(&first->q_b_e.w, stride), lane_values(&first->q_b_e.x, stride),
                      lane_values(&first->q_b_e.y, stride), lane_values(&first->q_b_e.z, stride) };
    n->r_rest = n->v_rest = lanes3_zero;
    n->q_rest = quat_zero;
    n->turn_rad = SCHULER_OMEGA_IE_RADPS * n->cycle.T_s;
    n->implicit_rad = 5.0 / 6.0 * n->turn_rad;
    n->implicit_inverse = 1.0 / (1.0 + n->implicit_rad * n->implicit_rad);
    const lanes3 u =
        lanes3_add(lanes_quat_rotate(n->q, cycle_velocity_before(&n->cycle)),
                   lanes3_scale(lanes_set(n->cycle.T_s), cycle_gravity(&n->cycle, n->r)));
    const lanes3 turned = minus_turn(2.0 * n->turn_rad, n->v);
    n->cycle.dv_before = (lanes3){ turned.x - n->v.x + u.x, turned.y - n->v.y + u.y, u.z };
}

LANES_INLINE frame_sums frame_no_sums(void)
{
    return (frame_sums){ lanes3_zero, lanes3_zero, quat_zero };
}

LANES_INLINE void frame_join(frame_nav *n, const frame_sums *sums)
{
    n->r = add3_with_rest(n->r, sums->r, &n->r_rest);
    n->v = add3_with_rest(n->v, sums->v, &n->v_rest);
    n->q = join_unit(n->q, sums->q, &n->q_rest);
}

/* The slow cycle. dg: what gravity has beyond the table, m/s^2. */
LANES_INLINE void frame_update(frame_nav *n, frame_sums *sums, coning_sums s, lanes3 dg)
{
    const double T_s = n->cycle.T_s;
    const lanes T = lanes_set(T_s);
    const lanes3 dv_before = n->cycle.dv_before;
    const lanes3 v = lanes3_add(n->v, sums->v);
    const lanes_quat q = quat_add(n->q, sums->q);
    const lanes3 dv_b = cycle_velocity(&n->cycle, s);
    const lanes3 u_e = minus_turn(0.5 * n->turn_rad, lanes_quat_rotate(q, dv_b));

    /* Means over the cycle, acceleration linear over two: r + T (v/2 + dv_before/6), and of the
     * velocity v + dv_before/12 + 5/12 dv, the last part implicit. */
    const lanes3 r_mean = lanes3_add(
        n->r, lanes3_add(sums->r, lanes3_add(lanes3_scale(lanes_set(0.5 * T_s), v),
                                             lanes3_scale(lanes_set(T_s / 6.0), dv_before))));
    const lanes3 g = lanes3_add(cycle_gravity(&n->cycle, r_mean), dg);
    const lanes twelfth = lanes_set(1.0 / 12.0);
    const lanes w = lanes_set(2.0 * n->turn_rad), implicit = lanes_set(n->implicit_rad);
    const lanes a = u_e.x + g.x * T + w * (v.y + twelfth * dv_before.y);
    const lanes b = u_e.y + g.y * T - w * (v.x + twelfth * dv_before.x);
    const lanes inverse = lanes_set(n->implicit_inverse);
    const lanes3 dv = { (a + implicit * b) * inverse, (b - implicit * a) * inverse,
                        u_e.z + g.z * T };

    const lanes3 bend = lanes3_add(lanes3_scale(lanes_set(5.0), dv), dv_before);
    const lanes3 dr = lanes3_add(lanes3_scale(T, v), lanes3_scale(lanes_set(T_s / 12.0), bend));
    sums->r = lanes3_add(sums->r, dr);
    sums->v = lanes3_add(sums->v, dv);
    n->cycle.dv_before = dv;

    /* The turn of the body, q (q(phi) - 1), and that of the earth. */
    const lanes_quat body = quat_mul(q, rotation_increment(lanes3_add(s.alpha, s.beta)));
    const lanes_quat p = quat_add(q, body);
    const lanes ez = lanes_set(-0.5 * n->turn_rad);
    const lanes ew = lanes_set(-0.125 * n->turn_rad * n->turn_rad);
    sums->q = (lanes_quat){ sums->q.w + (body.w + (ew * p.w - ez * p.z)),
                            sums->q.x + (body.x + (ew * p.x - ez * p.y)),
                            sums->q.y + (body.y + (ew * p.y + ez * p.x)),
                            sums->q.z + (body.z + (ew * p.z + ez * p.w)) };
}

/* What a group of samples lacks: a turn of the body and a velocity in its axes. */
LANES_INLINE void frame_correct(const frame_nav *n, frame_sums *sums, coning_correction c)
{
    const lanes_quat q = quat_add(n->q, sums->q);
    sums->v = lanes3_add(sums->v, lanes_quat_rotate(q, c.scul));
    sums->q = quat_add(sums->q, quat_turn(q, lanes3_scale(lanes_set(0.5), c.beta)));
}

#include "mechanization/frame_loop.h"

LANES_INLINE lanes3 up_at(const frame_nav *n)
{
    const lanes k = lanes_normal_z(&n->cycle.gravity, n->r.x, n->r.y, n->r.z);
    const lanes3 along = { n->r.x, n->r.y, k * n->r.z };
    return lanes3_scale(lanes_set(1.0) / lanes_sqrt(lanes3_dot(along, along)), along);
}

LANES_INLINE void move_along(frame_nav *n, lanes3 up, lanes dh, lanes dv)
{
    n->r = add3_with_rest(n->r, lanes3_scale(dh, up), &n->r_rest);
    n->v = add3_with_rest(n->v, lanes3_scale(dv, up), &n->v_rest);
}

static void hold_vertical(void *state, double height_m, double v_up_mps)
{
    frame_nav *n = &((frame_state *)state)->nav;
    const lanes3 up = up_at(n);
    const lanes dh = lanes_set(height_m) - lanes_height(&n->cycle.gravity, n->r.x, n->r.y, n->r.z);
    move_along(n, up, dh, lanes_set(v_up_mps) - lanes3_dot(n->v, up));
}

static void height(const void *state, double *height_m)
{
    const frame_nav *n = &((const frame_state *)state)->nav;
    lanes_store(height_m, lanes_height(&n->cycle.gravity, n->r.x, n->r.y, n->r.z));
}

static void correct_vertical(void *state, const double *dh_m, const double *dv_up_mps)
{
    frame_nav *n = &((frame_state *)state)->nav;
    move_along(n, up_at(n), lanes_load(dh_m), lanes_load(dv_up_mps));
}

static void get(const void *state, int lane, schuler_nav_state *out)
{
    const frame_nav *n = &((const frame_state *)state)->nav;
    const lanes *from[10] = { &n->r.x, &n->r.y, &n->r.z, &n->v.x, &n->v.y,
                              &n->v.z, &n->q.w, &n->q.x, &n->q.y, &n->q.z };
    double x[10];
    for (int i = 0; i < 10; i++)
        memcpy(&x[i], (const char *)from[i] + (size_t)lane * sizeof(double), sizeof(double));
    out->r_e = (schuler_vec3){ { x[0], x[1], x[2] } };
    out->v_e = (schuler_vec3){ { x[3], x[4], x[5] } };
    out->q_b_e = (schuler_quat){ x[6], x[7], x[8], x[9] };
}

extern const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_ecef);
const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_ecef) = {
    .name = "ecef",
    .summary = "earth-centred earth-fixed, metres and quaternion",
    .source =
        "P. G. Savage, Strapdown inertial navigation integration algorithm design, J. Guidance, "
        "Control, and Dynamics 21(1) and 21(2), 1998; P. D. Groves, 2nd ed., ch. 5",
    .equation = "r' = v\n"
                "v' = C_b_e f_ib_b - 2 omega_ie x v + g(r)\n"
                "C_b_e' = C_b_e [omega_ib_b x] - [omega_ie x] C_b_e",
    .limits = "none: nothing is singular anywhere on earth",
    .state_size = offsetof(frame_state, group),
    .group_size = sizeof(frame_state) - offsetof(frame_state, group),
    .init = frame_start,
    .advance = frame_advance,
    .hold_vertical = hold_vertical,
    .height = height,
    .correct_vertical = correct_vertical,
    .get = get,
};

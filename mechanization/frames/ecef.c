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
#include "core/gravity_lanes.h"
#include "mechanization/coning_group.h"
#include "mechanization/rotation.h"

typedef struct {
    lanes3 r, v;           /* m, m/s */
    lanes_quat q;          /* body to ECEF */
    lanes3 r_rest, v_rest; /* what their sums have rounded away */
    lanes_quat q_rest;
    lanes3 alpha_before, upsilon_before; /* sums of the cycle before */
    lanes3 dv_before; /* velocity change of the cycle before, m/s                   */
    lanes3 past_d[SCHULER_PRIME], past_u[SCHULER_PRIME]; /* newest first */
    lanes knows_dg;                                      /* 1 where the navigator knows dg_truth */
    schuler_gravity_table gravity;
    double T_s, turn_rad; /* of a cycle; turn of the earth in it */
    double implicit_rad, implicit_inverse;
    int order, samples;
} ecef;

/* What only some algorithms need lies behind, and is there only for them. */
typedef struct {
    ecef nav;
    const schuler_coning_algorithm *algorithm; /* NULL: the recursion alone */
    coning_group group;
} ecef_state;

LANES_INLINE lanes3 minus_turn(double angle_rad, lanes3 a)
{
    const lanes h = lanes_set(angle_rad);
    return (lanes3){ a.x + h * a.y, a.y - h * a.x, a.z };
}

static lanes lane_values(const double *first, size_t stride)
{
    double x[SCHULER_LANES] __attribute__((aligned(64)));
    for (int l = 0; l < SCHULER_LANES; l++)
        x[l] = *(const double *)((const char *)first + (size_t)l * stride);
    return lanes_load(x);
}

LANES_INLINE lanes3 gravity_at(const ecef *n, lanes3 r)
{
    lanes g[3];
    lanes_gravity(&n->gravity, r.x, r.y, r.z, g);
    return (lanes3){ g[0], g[1], g[2] };
}

static void init(void *state, const schuler_nav_setup *s)
{
    ecef_state *const whole = state;
    ecef *n = &whole->nav;
    const size_t stride = sizeof(schuler_nav_state);
    const schuler_nav_state *first = s->start;
    n->r = (lanes3){ lane_values(&first->r_e.v[0], stride), lane_values(&first->r_e.v[1], stride),
                     lane_values(&first->r_e.v[2], stride) };
    n->v = (lanes3){ lane_values(&first->v_e.v[0], stride), lane_values(&first->v_e.v[1], stride),
                     lane_values(&first->v_e.v[2], stride) };
    n->q =
        (lanes_quat){ lane_values(&first->q_b_e.w, stride), lane_values(&first->q_b_e.x, stride),
                      lane_values(&first->q_b_e.y, stride), lane_values(&first->q_b_e.z, stride) };
    n->r_rest = n->v_rest = (lanes3){ lanes_set(0.0), lanes_set(0.0), lanes_set(0.0) };
    n->q_rest = (lanes_quat){ lanes_set(0.0), lanes_set(0.0), lanes_set(0.0), lanes_set(0.0) };
    n->knows_dg = lane_values(s->dg_coefficient, sizeof(double));
    n->gravity = *s->gravity;
    n->samples = s->samples_per_update;
    n->order = s->order;
    whole->algorithm = s->algorithm && s->algorithm->samples > 1 ? s->algorithm : NULL;
    if (whole->algorithm) whole->group.count = 0;
    n->T_s = s->samples_per_update * s->dt_s;
    n->turn_rad = SCHULER_OMEGA_IE_RADPS * n->T_s;
    n->implicit_rad = 5.0 / 6.0 * n->turn_rad;
    n->implicit_inverse = 1.0 / (1.0 + n->implicit_rad * n->implicit_rad);
    for (int p = 0; p < SCHULER_PRIME; p++) {
        const double *d = s->prime_dtheta[p], *u = s->prime_dv[p];
        n->past_d[p] = (lanes3){ lanes_set(d[0]), lanes_set(d[1]), lanes_set(d[2]) };
        n->past_u[p] = (lanes3){ lanes_set(u[0]), lanes_set(u[1]), lanes_set(u[2]) };
    }
    /* The cycle before the start, seen from the start: the sample just before it, turned back by
     * half its angle, as if it had lasted the whole cycle. */
    const lanes cycle = lanes_set(n->T_s), scale = lanes_set((double)s->samples_per_update);
    n->alpha_before = lanes3_scale(scale, n->past_d[0]);
    n->upsilon_before = lanes3_scale(scale, n->past_u[0]);
    lanes3 u =
        lanes3_add_cross(n->past_u[0], lanes3_scale(lanes_set(0.5), n->past_u[0]), n->past_d[0]);
    u = lanes3_add(lanes_quat_rotate(n->q, lanes3_scale(scale, u)),
                   lanes3_scale(cycle, gravity_at(n, n->r)));
    n->dv_before = minus_turn(2.0 * n->turn_rad, n->v);
    n->dv_before = (lanes3){ n->dv_before.x - n->v.x + u.x, n->dv_before.y - n->v.y + u.y, u.z };
}

/* Position, velocity and attitude are r + sums.r and so on: what a block has added so far is summed
 * up by itself, in numbers small enough to lose nothing, and joins the state once a block with the
 * rest of the rounding carried. Else equal steps on a straight leg round alike a hundred thousand
 * times: in the attitude 1e-12 rad in a quarter of an hour, which is several micrometres. */
typedef struct {
    lanes3 r, v;
    lanes_quat q;
} block_sums;

LANES_INLINE lanes add_with_rest(lanes sum, lanes step, lanes *rest)
{
    const lanes whole = step + *rest, next = sum + whole;
    *rest = whole - (next - sum);
    return next;
}

LANES_INLINE lanes3 add3_with_rest(lanes3 sum, lanes3 step, lanes3 *rest)
{
    return (lanes3){ add_with_rest(sum.x, step.x, &rest->x), add_with_rest(sum.y, step.y, &rest->y),
                     add_with_rest(sum.z, step.z, &rest->z) };
}

LANES_INLINE lanes_quat add4_with_rest(lanes_quat sum, lanes_quat step, lanes_quat *rest)
{
    return (lanes_quat){ add_with_rest(sum.w, step.w, &rest->w),
                         add_with_rest(sum.x, step.x, &rest->x),
                         add_with_rest(sum.y, step.y, &rest->y),
                         add_with_rest(sum.z, step.z, &rest->z) };
}

LANES_INLINE void join(ecef *n, const block_sums *sums)
{
    n->r = add3_with_rest(n->r, sums->r, &n->r_rest);
    n->v = add3_with_rest(n->v, sums->v, &n->v_rest);
    n->q = add4_with_rest(n->q, sums->q, &n->q_rest);
    /* One Newton step to unit norm, which has moved by rounding only. */
    const lanes_quat q = n->q;
    const lanes k =
        lanes_set(0.5) - lanes_set(0.5) * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    n->q = add4_with_rest(q, (lanes_quat){ k * q.w, k * q.x, k * q.y, k * q.z }, &n->q_rest);
}

/* The slow cycle. dg: what gravity has beyond the table, m/s^2. */
LANES_INLINE void update(ecef *n, block_sums *sums, coning_sums s, lanes3 dg)
{
    const lanes T = lanes_set(n->T_s);
    const lanes3 v = lanes3_add(n->v, sums->v);
    const lanes_quat q = { n->q.w + sums->q.w, n->q.x + sums->q.x, n->q.y + sums->q.y,
                           n->q.z + sums->q.z };
    const lanes3 dv_b = lanes3_add(
        lanes3_add(rotation_velocity(s.alpha, s.upsilon), s.scul),
        rotation_velocity_change(s.alpha, s.upsilon, n->alpha_before, n->upsilon_before));
    n->alpha_before = s.alpha;
    n->upsilon_before = s.upsilon;
    const lanes3 u_e = minus_turn(0.5 * n->turn_rad, lanes_quat_rotate(q, dv_b));

    /* Means over the cycle, acceleration linear over two: r + T (v/2 + dv_before/6), and of the
     * velocity v + dv_before/12 + 5/12 dv, the last part implicit. */
    const lanes3 r_mean = lanes3_add(
        n->r, lanes3_add(sums->r, lanes3_add(lanes3_scale(lanes_set(0.5 * n->T_s), v),
                                             lanes3_scale(lanes_set(n->T_s / 6.0), n->dv_before))));
    const lanes3 g = lanes3_add(gravity_at(n, r_mean), dg);
    const lanes twelfth = lanes_set(1.0 / 12.0);
    const lanes w = lanes_set(2.0 * n->turn_rad), implicit = lanes_set(n->implicit_rad);
    const lanes a = u_e.x + g.x * T + w * (v.y + twelfth * n->dv_before.y);
    const lanes b = u_e.y + g.y * T - w * (v.x + twelfth * n->dv_before.x);
    const lanes inverse = lanes_set(n->implicit_inverse);
    const lanes3 dv = { (a + implicit * b) * inverse, (b - implicit * a) * inverse,
                        u_e.z + g.z * T };

    const lanes3 bend = lanes3_add(lanes3_scale(lanes_set(5.0), dv), n->dv_before);
    const lanes3 dr = lanes3_add(lanes3_scale(T, v), lanes3_scale(lanes_set(n->T_s / 12.0), bend));
    sums->r = lanes3_add(sums->r, dr);
    sums->v = lanes3_add(sums->v, dv);
    n->dv_before = dv;

    /* The turn of the body, q (q(phi) - 1), and that of the earth. */
    const lanes_quat d = rotation_increment(lanes3_add(s.alpha, s.beta));
    const lanes_quat body = {
        q.w * d.w - q.x * d.x - q.y * d.y - q.z * d.z,
        q.w * d.x + q.x * d.w + q.y * d.z - q.z * d.y,
        q.w * d.y - q.x * d.z + q.y * d.w + q.z * d.x,
        q.w * d.z + q.x * d.y - q.y * d.x + q.z * d.w,
    };
    const lanes_quat p = { q.w + body.w, q.x + body.x, q.y + body.y, q.z + body.z };
    const lanes ez = lanes_set(-0.5 * n->turn_rad);
    const lanes ew = lanes_set(-0.125 * n->turn_rad * n->turn_rad);
    sums->q = (lanes_quat){ sums->q.w + (body.w + (ew * p.w - ez * p.z)),
                            sums->q.x + (body.x + (ew * p.x - ez * p.y)),
                            sums->q.y + (body.y + (ew * p.y + ez * p.x)),
                            sums->q.z + (body.z + (ew * p.z + ez * p.w)) };
}

/* What a group of samples lacks: a turn of the body and a velocity in its axes. */
LANES_INLINE void correct(const ecef *n, block_sums *sums, coning_correction c)
{
    const lanes_quat q = { n->q.w + sums->q.w, n->q.x + sums->q.x, n->q.y + sums->q.y,
                           n->q.z + sums->q.z };
    const lanes3 h = lanes3_scale(lanes_set(0.5), c.beta);
    sums->v = lanes3_add(sums->v, lanes_quat_rotate(q, c.scul));
    sums->q.w -= q.x * h.x + q.y * h.y + q.z * h.z;
    sums->q.x += q.w * h.x + q.y * h.z - q.z * h.y;
    sums->q.y += q.w * h.y - q.x * h.z + q.z * h.x;
    sums->q.z += q.w * h.z + q.x * h.y - q.y * h.x;
}

LANES_INLINE lanes3 block_sample(const double *data, int stride, int k)
{
    const double *p = data + (ptrdiff_t)k * SCHULER_LANES;
    const ptrdiff_t axis = (ptrdiff_t)stride * SCHULER_LANES;
    return (lanes3){ lanes_load(p), lanes_load(p + axis), lanes_load(p + 2 * axis) };
}

LANES_INLINE lanes3 block_dg(const ecef *n, const schuler_nav_block *b, int k)
{
    lanes dg[3];
    for (int i = 0; i < 3; i++)
        dg[i] = lanes_set(b->dg_nav_e[i * b->stride + k]) +
                n->knows_dg * lanes_set(b->dg_truth_e[i * b->stride + k]);
    return (lanes3){ dg[0], dg[1], dg[2] };
}

LANES_INLINE void remember(lanes3 past[SCHULER_PRIME], lanes3 newest, int order)
{
    if (order != 2) past[2] = past[1], past[1] = past[0];
    past[0] = newest;
}

/* Specialised by the caller's constants: order, whether a cycle is one sample, whether there is a
 * dg. */
LANES_INLINE void advance_as(ecef_state *state, const schuler_nav_block *b, int order, int samples,
                             int has_dg, int grouped)
{
    ecef n = state->nav;
    const lanes zero = lanes_set(0.0);
    const lanes3 none = { zero, zero, zero };
    block_sums block = { none, none, { zero, zero, zero, zero } };
    for (int k = 0; k + samples <= b->n; k += samples) {
        coning_sums sums;
        for (int l = 0; l < samples; l++) {
            const coning_sample s = { block_sample(b->dtheta, b->stride, k + l),
                                      block_sample(b->dv, b->stride, k + l) };
            const coning_before d = coning_look_back(n.past_d, order);
            const coning_before u = coning_look_back(n.past_u, order);
            sums = l == 0 ? coning_first(s, d, u, order) : coning_next(sums, s, d, u, order);
            remember(n.past_d, s.d, order);
            remember(n.past_u, s.u, order);
        }
        /* Mid-cycle: the middle sample's value (of the two, the later). */
        update(&n, &block, sums, has_dg ? block_dg(&n, b, k + samples / 2) : none);
        coning_correction c;
        const coning_sample newest = { n.past_d[0], n.past_u[0] };
        if (grouped && coning_group_take(&state->group, state->algorithm, newest, sums, &c))
            correct(&n, &block, c);
    }
    join(&n, &block);
    state->nav = n;
}

/* Functions of their own: together they would take each other's registers. */
__attribute__((noinline)) static void advance_any(ecef_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, state->nav.order, state->nav.samples, b->dg_nav_e != NULL,
               state->algorithm != NULL);
}

__attribute__((noinline)) static void advance_two(ecef_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, 2, 1, 0, 0);
}

__attribute__((noinline)) static void advance_four(ecef_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, 4, 1, 0, 0);
}

static void advance(void *state, const schuler_nav_block *b)
{
    ecef_state *const s = state;
    if (b->dg_nav_e != NULL || s->algorithm != NULL || s->nav.samples != 1 || s->nav.order == 1)
        advance_any(s, b);
    else if (s->nav.order == 2)
        advance_two(s, b);
    else
        advance_four(s, b);
}

LANES_INLINE lanes3 up_at(const ecef *n)
{
    const lanes k = lanes_normal_z(&n->gravity, n->r.x, n->r.y, n->r.z);
    const lanes3 along = { n->r.x, n->r.y, k * n->r.z };
    return lanes3_scale(lanes_set(1.0) / lanes_sqrt(lanes3_dot(along, along)), along);
}

LANES_INLINE void move_along(ecef *n, lanes3 up, lanes dh, lanes dv)
{
    n->r = add3_with_rest(n->r, lanes3_scale(dh, up), &n->r_rest);
    n->v = add3_with_rest(n->v, lanes3_scale(dv, up), &n->v_rest);
}

static void hold_vertical(void *state, double height_m, double v_up_mps)
{
    ecef *n = &((ecef_state *)state)->nav;
    const lanes3 up = up_at(n);
    const lanes dh = lanes_set(height_m) - lanes_height(&n->gravity, n->r.x, n->r.y, n->r.z);
    move_along(n, up, dh, lanes_set(v_up_mps) - lanes3_dot(n->v, up));
}

static void height(const void *state, double *height_m)
{
    const ecef *n = &((const ecef_state *)state)->nav;
    lanes_store(height_m, lanes_height(&n->gravity, n->r.x, n->r.y, n->r.z));
}

static void correct_vertical(void *state, const double *dh_m, const double *dv_up_mps)
{
    ecef *n = &((ecef_state *)state)->nav;
    move_along(n, up_at(n), lanes_load(dh_m), lanes_load(dv_up_mps));
}

static void get(const void *state, int lane, schuler_nav_state *out)
{
    const ecef *n = &((const ecef_state *)state)->nav;
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
    .state_size = offsetof(ecef_state, group),
    .group_size = sizeof(ecef_state) - offsetof(ecef_state, group),
    .init = init,
    .advance = advance,
    .hold_vertical = hold_vertical,
    .height = height,
    .correct_vertical = correct_vertical,
    .get = get,
};

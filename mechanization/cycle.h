/* SPDX-License-Identifier: MIT */
/* What a navigation cycle is made of in every frame: the samples, sums that keep their rounding, the
 * velocity of a cycle in the body's axes. Each frame file defines on it
 *
 *     frame_nav           its state, with a member `cycle`
 *     frame_sums          what a block adds to it, zero to begin with
 *     frame_init          from the setup, `cycle` being set up already
 *     frame_update        the slow cycle
 *     frame_correct       what a group of samples lacks
 *     frame_join          a block's sums into the state
 *
 * and includes frame_loop.h last. */
#ifndef SCHULER_MECHANIZATION_CYCLE_H
#define SCHULER_MECHANIZATION_CYCLE_H

#include "core/gravity_lanes.h"
#include "mechanization/coning_group.h"
#include "mechanization/rotation.h"

typedef struct {
    lanes3 alpha_before, upsilon_before; /* sums of the cycle before */
    lanes3 dv_before; /* velocity change of the cycle before, in the frame, m/s     */
    lanes3 past_d[SCHULER_PRIME], past_u[SCHULER_PRIME]; /* newest first */
    lanes knows_dg;                                      /* 1 where the navigator knows dg_truth */
    schuler_gravity_table gravity;
    double T_s; /* length of a cycle */
    int order, samples;
} cycle_state;

/* A member of each lane's struct, `stride` bytes apart. */
static lanes lane_values(const double *first, size_t stride)
{
    double x[SCHULER_LANES] __attribute__((aligned(64)));
    for (int l = 0; l < SCHULER_LANES; l++)
        x[l] = *(const double *)((const char *)first + (size_t)l * stride);
    return lanes_load(x);
}

LANES_INLINE lanes3 cycle_gravity(const cycle_state *c, lanes3 r_e)
{
    lanes g[3];
    lanes_gravity(&c->gravity, r_e.x, r_e.y, r_e.z, g);
    return (lanes3){ g[0], g[1], g[2] };
}

static void cycle_init(cycle_state *c, const schuler_nav_setup *s)
{
    c->knows_dg = lane_values(s->dg_coefficient, sizeof(double));
    c->gravity = *s->gravity;
    c->samples = s->samples_per_update;
    c->order = s->order;
    c->T_s = s->samples_per_update * s->dt_s;
    for (int p = 0; p < SCHULER_PRIME; p++) {
        const double *d = s->prime_dtheta[p], *u = s->prime_dv[p];
        c->past_d[p] = (lanes3){ lanes_set(d[0]), lanes_set(d[1]), lanes_set(d[2]) };
        c->past_u[p] = (lanes3){ lanes_set(u[0]), lanes_set(u[1]), lanes_set(u[2]) };
    }
    /* The cycle before the start, seen from the start: the sample just before it, as if it had lasted
     * the whole cycle. */
    const lanes scale = lanes_set((double)s->samples_per_update);
    c->alpha_before = lanes3_scale(scale, c->past_d[0]);
    c->upsilon_before = lanes3_scale(scale, c->past_u[0]);
}

/* The velocity that the cycle before the start gained by specific force, in the body's axes of the start:
 * turned back by half its angle. */
LANES_INLINE lanes3 cycle_velocity_before(const cycle_state *c)
{
    const lanes scale = lanes_set((double)c->samples);
    const lanes3 half = lanes3_scale(lanes_set(0.5), c->past_u[0]);
    return lanes3_scale(scale, lanes3_add_cross(c->past_u[0], half, c->past_d[0]));
}

/* The velocity that this cycle gains by specific force, in the body's axes of its start. */
LANES_INLINE lanes3 cycle_velocity(cycle_state *c, coning_sums s)
{
    const lanes3 dv_b = lanes3_add(
        lanes3_add(rotation_velocity(s.alpha, s.upsilon), s.scul),
        rotation_velocity_change(s.alpha, s.upsilon, c->alpha_before, c->upsilon_before));
    c->alpha_before = s.alpha;
    c->upsilon_before = s.upsilon;
    return dv_b;
}

/* A state is x + sums.x: what a block has added so far is summed up by itself, in numbers small enough to
 * lose nothing, and joins the state once a block with the rest of the rounding carried. Else equal steps
 * on a straight leg round alike a hundred thousand times: in the attitude 1e-12 rad in a quarter of an
 * hour, which is several micrometres. */
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

/* The same for a unit quaternion, with one Newton step to the norm, which has moved by rounding only. */
LANES_INLINE lanes_quat join_unit(lanes_quat sum, lanes_quat step, lanes_quat *rest)
{
    const lanes_quat q = add4_with_rest(sum, step, rest);
    const lanes k =
        lanes_set(0.5) - lanes_set(0.5) * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return add4_with_rest(q, (lanes_quat){ k * q.w, k * q.x, k * q.y, k * q.z }, rest);
}

LANES_INLINE lanes_quat quat_add(lanes_quat a, lanes_quat b)
{
    return (lanes_quat){ a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z };
}

LANES_INLINE lanes_quat quat_mul(lanes_quat q, lanes_quat d)
{
    return (lanes_quat){
        q.w * d.w - q.x * d.x - q.y * d.y - q.z * d.z,
        q.w * d.x + q.x * d.w + q.y * d.z - q.z * d.y,
        q.w * d.y - q.x * d.z + q.y * d.w + q.z * d.x,
        q.w * d.z + q.x * d.y - q.y * d.x + q.z * d.w,
    };
}

/* q (0, h): what a small turn by 2 h adds, to first order. */
LANES_INLINE lanes_quat quat_turn(lanes_quat q, lanes3 h)
{
    return (lanes_quat){
        -(q.x * h.x + q.y * h.y + q.z * h.z),
        q.w * h.x + q.y * h.z - q.z * h.y,
        q.w * h.y - q.x * h.z + q.z * h.x,
        q.w * h.z + q.x * h.y - q.y * h.x,
    };
}

static const lanes_quat quat_zero = { 0 };
static const lanes3 lanes3_zero = { 0 };

#endif

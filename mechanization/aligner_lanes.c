/* SPDX-License-Identifier: MIT */
#include "mechanization/aligner.h"
#include "mechanization/coning.h"
#include "mechanization/rotation.h"

typedef struct {
    lanes_quat q; /* body to b0 */
    lanes3 v;     /* m/s in b0  */
    lanes3 past_d[SCHULER_PRIME], past_u[SCHULER_PRIME];
    int started;
} aligner;

static void init(void *state)
{
    aligner *a = state;
    const lanes zero = lanes_set(0.0);
    a->q = (lanes_quat){ lanes_set(1.0), zero, zero, zero };
    a->v = (lanes3){ zero, zero, zero };
    a->started = 0;
}

LANES_INLINE lanes3 sample(const double *data, int stride, int k)
{
    const double *p = data + (ptrdiff_t)k * SCHULER_LANES;
    const ptrdiff_t axis = (ptrdiff_t)stride * SCHULER_LANES;
    return (lanes3){ lanes_load(p), lanes_load(p + axis), lanes_load(p + 2 * axis) };
}

LANES_INLINE void remember(lanes3 past[SCHULER_PRIME], lanes3 newest)
{
    past[2] = past[1];
    past[1] = past[0];
    past[0] = newest;
}

/* As the frames do it, without gravity, earth and place. */
static void advance(void *state, const schuler_nav_block *b)
{
    aligner a = *(aligner *)state;
    for (int k = 0; k < b->n; k++) {
        const coning_sample s = { sample(b->dtheta, b->stride, k), sample(b->dv, b->stride, k) };
        for (int p = 0; p < SCHULER_PRIME && !a.started; p++) a.past_d[p] = s.d, a.past_u[p] = s.u;
        a.started = 1;
        const coning_sums c =
            coning_first(s, coning_look_back(a.past_d, 4), coning_look_back(a.past_u, 4), 4);
        remember(a.past_d, s.d);
        remember(a.past_u, s.u);
        const lanes3 dv = lanes3_add(rotation_velocity(c.alpha, c.upsilon), c.scul);
        a.v = lanes3_add(a.v, lanes_quat_rotate(a.q, dv));
        const lanes_quat d = rotation_increment(lanes3_add(c.alpha, c.beta)), q = a.q;
        a.q = (lanes_quat){ q.w + (q.w * d.w - q.x * d.x - q.y * d.y - q.z * d.z),
                            q.x + (q.w * d.x + q.x * d.w + q.y * d.z - q.z * d.y),
                            q.y + (q.w * d.y - q.x * d.z + q.y * d.w + q.z * d.x),
                            q.z + (q.w * d.z + q.x * d.y - q.y * d.x + q.z * d.w) };
    }
    /* One Newton step to unit norm, which has moved by rounding only. */
    const lanes_quat q = a.q;
    const lanes f =
        lanes_set(1.5) - lanes_set(0.5) * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    a.q = (lanes_quat){ f * q.w, f * q.x, f * q.y, f * q.z };
    *(aligner *)state = a;
}

static void get(const void *state, int lane, schuler_quat *q_b_b0, schuler_vec3 *v_b0)
{
    const aligner *const a = state;
    const lanes *from[7] = { &a->q.w, &a->q.x, &a->q.y, &a->q.z, &a->v.x, &a->v.y, &a->v.z };
    double x[7];
    for (int i = 0; i < 7; i++)
        memcpy(&x[i], (const char *)from[i] + (size_t)lane * sizeof(double), sizeof(double));
    *q_b_b0 = (schuler_quat){ x[0], x[1], x[2], x[3] };
    *v_b0 = (schuler_vec3){ { x[4], x[5], x[6] } };
}

extern const schuler_aligner SCHULER_LANE_NAME(schuler_aligner);
const schuler_aligner SCHULER_LANE_NAME(schuler_aligner) = {
    .state_size = sizeof(aligner),
    .init = init,
    .advance = advance,
    .get = get,
};

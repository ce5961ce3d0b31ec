/* SPDX-License-Identifier: MIT */
/* The loop over a block, the same for every frame; included last by its file (see cycle.h). It leaves
 * frame_state, frame_start and frame_advance. */

#include "mechanization/cycle.h"

/* What only some algorithms need lies behind, and is there only for them. */
typedef struct {
    frame_nav nav;
    const schuler_coning_algorithm *algorithm; /* NULL: the recursion alone */
    coning_group group;
} frame_state;

static void frame_start(void *state, const schuler_nav_setup *s)
{
    frame_state *const whole = state;
    whole->algorithm = s->algorithm && s->algorithm->samples > 1 ? s->algorithm : NULL;
    if (whole->algorithm) whole->group.count = 0;
    cycle_init(&whole->nav.cycle, s);
    frame_init(&whole->nav, s);
}

LANES_INLINE lanes3 block_sample(const double *data, int stride, int k)
{
    const double *p = data + (ptrdiff_t)k * SCHULER_LANES;
    const ptrdiff_t axis = (ptrdiff_t)stride * SCHULER_LANES;
    return (lanes3){ lanes_load(p), lanes_load(p + axis), lanes_load(p + 2 * axis) };
}

LANES_INLINE lanes3 block_dg(const cycle_state *c, const schuler_nav_block *b, int k)
{
    lanes dg[3];
    for (int i = 0; i < 3; i++)
        dg[i] = lanes_set(b->dg_nav_e[i * b->stride + k]) +
                c->knows_dg * lanes_set(b->dg_truth_e[i * b->stride + k]);
    return (lanes3){ dg[0], dg[1], dg[2] };
}

LANES_INLINE void remember(lanes3 past[SCHULER_PRIME], lanes3 newest, int order)
{
    if (order != 2) past[2] = past[1], past[1] = past[0];
    past[0] = newest;
}

/* Specialised by the caller's constants: order, whether a cycle is one sample, whether there is a
 * dg. */
LANES_INLINE void advance_as(frame_state *state, const schuler_nav_block *b, int order, int samples,
                             int has_dg, int grouped)
{
    frame_nav n = state->nav;
    frame_sums block = frame_no_sums();
    for (int k = 0; k + samples <= b->n; k += samples) {
        coning_sums sums;
        for (int l = 0; l < samples; l++) {
            const coning_sample s = { block_sample(b->dtheta, b->stride, k + l),
                                      block_sample(b->dv, b->stride, k + l) };
            const coning_before d = coning_look_back(n.cycle.past_d, order);
            const coning_before u = coning_look_back(n.cycle.past_u, order);
            sums = l == 0 ? coning_first(s, d, u, order) : coning_next(sums, s, d, u, order);
            remember(n.cycle.past_d, s.d, order);
            remember(n.cycle.past_u, s.u, order);
        }
        /* Mid-cycle: the middle sample's value (of the two, the later). */
        frame_update(&n, &block, sums,
                     has_dg ? block_dg(&n.cycle, b, k + samples / 2) : lanes3_zero);
        coning_correction c;
        const coning_sample newest = { n.cycle.past_d[0], n.cycle.past_u[0] };
        if (grouped && coning_group_take(&state->group, state->algorithm, newest, sums, &c))
            frame_correct(&n, &block, c);
    }
    frame_join(&n, &block);
    state->nav = n;
}

/* Functions of their own: together they would take each other's registers. */
__attribute__((noinline)) static void advance_any(frame_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, state->nav.cycle.order, state->nav.cycle.samples, b->dg_nav_e != NULL,
               state->algorithm != NULL);
}

__attribute__((noinline)) static void advance_two(frame_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, 2, 1, 0, 0);
}

__attribute__((noinline)) static void advance_four(frame_state *state, const schuler_nav_block *b)
{
    advance_as(state, b, 4, 1, 0, 0);
}

static void frame_advance(void *state, const schuler_nav_block *b)
{
    frame_state *const s = state;
    const cycle_state *const c = &s->nav.cycle;
    if (b->dg_nav_e != NULL || s->algorithm != NULL || c->samples != 1 || c->order == 1)
        advance_any(s, b);
    else if (c->order == 2)
        advance_two(s, b);
    else
        advance_four(s, b);
}

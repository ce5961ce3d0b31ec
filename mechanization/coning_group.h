/* SPDX-License-Identifier: MIT */
/* High-order coning and sculling over groups of samples, apart from the navigation cycle. Attitude and
 * velocity are kept at every sample by the recursion of coning.h; when N samples are complete, what an
 * algorithm of N samples says of the whole group replaces what the recursion has made of it:
 *
 *     made      beta += 1/2 alpha x d + kappa,   scul += 1/2 (alpha x u + upsilon x d) + kappa
 *     optimal   sum over s of C_s d_(N-s) x d_N, with u for d in one of the two for sculling
 *     Taylor    sum over i < j of K_ij d_i x d_j, alike
 *
 * so position is integrated at the rate of the samples, whatever N is. The optimal coefficients
 * (R. B. Miller, J. Guidance 6(4), 1983; M. B. Ignagni, 13(2), 1990; J. G. Lee et al., 13(6), 1990)
 * assume pure coning, where d_i x d_j depends on j - i alone; those of the Taylor series hold for any
 * rate that is a polynomial. Sculling is their dual (K. M. Roscoe, 24(2), 2001). Third-order terms are
 * those of the samples' own rotations. */
#ifndef SCHULER_MECHANIZATION_CONING_GROUP_H
#define SCHULER_MECHANIZATION_CONING_GROUP_H

#include "mechanization/algorithms.h"
#include "mechanization/coning.h"

typedef struct {
    int count; /* samples so far                       */
    lanes3 d[SCHULER_GROUP_MAX], u[SCHULER_GROUP_MAX];
    lanes3 alpha, upsilon, beta, scul; /* as the recursion has made them       */
} coning_group;

/* What is to be added: a rotation of the body and a velocity in its axes. */
typedef struct {
    lanes3 beta, scul;
} coning_correction;

LANES_INLINE lanes3 coning_weighted(const double *weight, const lanes3 *x, int count)
{
    lanes3 sum = lanes3_scale(lanes_set(weight[0]), x[0]);
    for (int i = 1; i < count; i++) sum = lanes3_add(sum, lanes3_scale(lanes_set(weight[i]), x[i]));
    return sum;
}

/* One more sample and the kappas that the recursion has for it. Returned: 1 when the group is complete
 * and *out is what it lacks; the next sample begins another. */
LANES_INLINE int coning_group_take(coning_group *g, const schuler_coning_algorithm *a,
                                   coning_sample s, coning_sums kappa, coning_correction *out)
{
    const lanes half = lanes_set(0.5), zero = lanes_set(0.0);
    const lanes3 none = { zero, zero, zero };
    if (g->count == 0) g->alpha = g->upsilon = g->beta = g->scul = none;
    const lanes3 alpha = lanes3_scale(half, g->alpha), upsilon = lanes3_scale(half, g->upsilon);
    g->beta = lanes3_add(g->beta, lanes3_add_cross(kappa.beta, alpha, s.d));
    g->scul = lanes3_add(g->scul,
                         lanes3_add_cross(lanes3_add_cross(kappa.scul, alpha, s.u), upsilon, s.d));
    g->alpha = lanes3_add(g->alpha, s.d);
    g->upsilon = lanes3_add(g->upsilon, s.u);
    g->d[g->count] = s.d;
    g->u[g->count] = s.u;
    if (++g->count < a->samples) return 0;
    g->count = 0;
    /* Each later sample with the weighted sum of those before it. */
    lanes3 beta = none, scul = none;
    for (int j = 1; j < a->samples; j++) {
        const lanes3 d = coning_weighted(a->pair[j], g->d, j);
        const lanes3 u = coning_weighted(a->pair[j], g->u, j);
        beta = lanes3_add_cross(beta, d, g->d[j]);
        scul = lanes3_add_cross(lanes3_add_cross(scul, d, g->u[j]), u, g->d[j]);
    }
    /* Both are in the axes of the group's start, now in those of its end: what is added to a rotation
     * vector acts half way through the turn. */
    const lanes minus = lanes_set(-1.0);
    const lanes3 d_beta = lanes3_add(beta, lanes3_scale(minus, g->beta));
    const lanes3 d_scul = lanes3_add(scul, lanes3_scale(minus, g->scul));
    out->beta = lanes3_add_cross(d_beta, lanes3_scale(lanes_set(-0.5), g->alpha), d_beta);
    out->scul = lanes3_add_cross(d_scul, lanes3_scale(minus, g->alpha), d_scul);
    return 1;
}

#endif

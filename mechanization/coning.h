/* SPDX-License-Identifier: MIT */
/* The fast cycle of the two-speed algorithm: sums over the samples of one navigation cycle.
 *
 *     beta  += 1/2 alpha x d + kappa(d, d)                          coning
 *     scul  += 1/2 (alpha x u + upsilon x d) + kappa(d, u) + kappa(u, d)   sculling
 *     alpha += d,  upsilon += u
 *
 * d, u are the sample's angle and velocity increments. kappa integrates alpha x omega / 2 over the
 * sample, with the rate that fits this sample and the ones before it, d_1 the newest of them:
 *
 *     two samples    kappa = d_1 x d_0 / 12                      rate linear in time
 *     four samples   kappa = (473/1890 d_1 - 1919/15120 d_2 + 53/1890 d_3) x d_0
 *                          + 2/315 d_2 x d_1 - 29/15120 d_3 x d_1 + 1/3780 d_3 x d_2   cubic
 *
 * The first is P. G. Savage's recursion (J. Guidance 21(1), 1998; 21(2) for sculling). The second
 * is derived the same way: solve the cubic from the four integrals, integrate over the last
 * interval. Its last three products are one, (d_2 - 29/96 d_3) x (2/315 d_1 - 1/3780 d_3): any skew
 * form in three vectors is. Both are exact for general rotation, not for coning alone. */
#ifndef SCHULER_MECHANIZATION_CONING_H
#define SCHULER_MECHANIZATION_CONING_H

#include "core/lanes3.h"
#include "mechanization/mechanization.h"

typedef struct {
    lanes3 d, u; /* angle rad, velocity m/s */
} coning_sample;

typedef struct {
    lanes3 alpha, upsilon, beta, scul;
} coning_sums;

/* What the samples before this one contribute: kappa(a, b) = p_a x b_0 + e_a x f_b. */
typedef struct {
    lanes3 p, e, f;
} coning_before;

/* `order` is a constant where this is inlined: 1 is no correction at all. */
LANES_INLINE coning_before coning_look_back(const lanes3 past[SCHULER_PRIME], int order)
{
    const lanes zero = lanes_set(0.0);
    if (order == 1) return (coning_before){ .p = { zero, zero, zero } };
    if (order == 2) return (coning_before){ .p = lanes3_scale(lanes_set(1.0 / 12.0), past[0]) };
    return (coning_before){
        .p = lanes3_add(lanes3_add(lanes3_scale(lanes_set(473.0 / 1890.0), past[0]),
                                   lanes3_scale(lanes_set(-1919.0 / 15120.0), past[1])),
                        lanes3_scale(lanes_set(53.0 / 1890.0), past[2])),
        .e = lanes3_add(past[1], lanes3_scale(lanes_set(-29.0 / 96.0), past[2])),
        .f = lanes3_add(lanes3_scale(lanes_set(2.0 / 315.0), past[0]),
                        lanes3_scale(lanes_set(-1.0 / 3780.0), past[2])),
    };
}

/* Coning and sculling of the first sample of a cycle: the sums start from nothing. */
LANES_INLINE coning_sums coning_first(coning_sample s, coning_before d, coning_before u, int order)
{
    lanes3 beta = lanes3_cross(d.p, s.d);
    lanes3 scul = lanes3_add_cross(lanes3_cross(d.p, s.u), u.p, s.d);
    if (order == 4) {
        beta = lanes3_add_cross(beta, d.e, d.f);
        scul = lanes3_add_cross(lanes3_add_cross(scul, d.e, u.f), u.e, d.f);
    }
    return (coning_sums){ .alpha = s.d, .upsilon = s.u, .beta = beta, .scul = scul };
}

/* The next one: its own terms, and those with the sums so far. */
LANES_INLINE coning_sums coning_next(coning_sums sums, coning_sample s, coning_before d,
                                     coning_before u, int order)
{
    const coning_sums own = coning_first(s, d, u, order);
    const lanes half = lanes_set(0.5);
    const lanes3 a = lanes3_scale(half, sums.alpha), v = lanes3_scale(half, sums.upsilon);
    return (coning_sums){
        .alpha = lanes3_add(sums.alpha, s.d),
        .upsilon = lanes3_add(sums.upsilon, s.u),
        .beta = lanes3_add(sums.beta, lanes3_add_cross(own.beta, a, s.d)),
        .scul = lanes3_add(sums.scul, lanes3_add_cross(lanes3_add_cross(own.scul, a, s.u), v, s.d)),
    };
}

#endif

/* SPDX-License-Identifier: MIT */
/* Noise of a sensor in plain C, apart from the simulator's own code: for tests of its analysis. */
#ifndef SCHULER_TESTS_SIMULATED_NOISE_H
#define SCHULER_TESTS_SIMULATED_NOISE_H

#include "sensors/processes.h"
#include <math.h>
#include <stdint.h>

typedef struct {
    uint64_t state;
    int spare_is_there;
    double spare;
} noise_source;

/* Uniform in (0, 1): a Weyl sequence, its bits mixed (splitmix64). */
static inline double noise_uniform(noise_source *s)
{
    uint64_t z = s->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return ((double)((z ^ z >> 31) >> 11) + 0.5) * 0x1p-53;
}

static inline double noise_normal(noise_source *s)
{
    if (s->spare_is_there) {
        s->spare_is_there = 0;
        return s->spare;
    }
    const double r = sqrt(-2.0 * log(noise_uniform(s))), a = 2.0 * M_PI * noise_uniform(s);
    s->spare_is_there = 1;
    s->spare = r * sin(a);
    return r * cos(a);
}

typedef struct {
    double Q, N, B, K, R; /* of IEEE Std 952 */
    double dt_s;
} noise_coefficients;

/* n increments of the integral of the rate: each process by its exact recursion. */
static inline void noise_simulate(const noise_coefficients *c, uint64_t seed, int64_t n,
                                  double *out)
{
    noise_source s = { .state = seed * 7919 + 13 };
    const double dt_s = c->dt_s;
    const schuler_flicker_bank bank =
        schuler_flicker_bank_of(SCHULER_FLICKER_SHORTEST_S, SCHULER_FLICKER_LONGEST_S, dt_s);
    const schuler_process_step walk = schuler_random_walk_step(c->K, dt_s);
    schuler_process_step step[SCHULER_MARKOV_MAX];
    double member[SCHULER_MARKOV_MAX], walked = 0.0, before = noise_normal(&s);
    for (int i = 0; i < bank.members; i++) {
        const schuler_markov_process p = schuler_flicker_bank_member(&bank, c->B, i);
        step[i] = schuler_gauss_markov_step(p.sigma, p.T_s, dt_s);
        member[i] = p.sigma * noise_normal(&s);
    }
    for (int64_t k = 0; k < n; k++) {
        double sum = c->R * ((double)k + 0.5) * dt_s * dt_s;
        if (c->Q != 0.0) {
            const double now = noise_normal(&s);
            sum += c->Q * (now - before);
            before = now;
        }
        if (c->N != 0.0) sum += c->N * sqrt(dt_s) * noise_normal(&s);
        for (int i = 0; i < bank.members && c->B != 0.0; i++) {
            const double w1 = noise_normal(&s), w2 = noise_normal(&s);
            sum += step[i].gain * member[i] + step[i].l21 * w1 + step[i].l22 * w2;
            member[i] = step[i].phi * member[i] + step[i].l11 * w1;
        }
        if (c->K != 0.0) {
            const double w1 = noise_normal(&s), w2 = noise_normal(&s);
            sum += walk.gain * walked + walk.l21 * w1 + walk.l22 * w2;
            walked += walk.l11 * w1;
        }
        out[k] = sum;
    }
}

#endif

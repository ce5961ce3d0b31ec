/* SPDX-License-Identifier: MIT */
/* Second-order Gauss-Markov process, critically damped: b'' + 2 beta b' + beta^2 b = white, beta = 1/T,
 * correlation sigma^2 exp(-beta |t|) (1 + beta |t|). Bias, its rate and its integral over a sample
 * dt follow exactly
 *
 *     (b, b')_2 = Phi (b, b')_1 + ...,   I = gain . (b, b')_1 + ...,   drives = L w, three numbers
 *
 * L the Cholesky factor of the covariance q_ij = 4 beta^3 sigma^2 integral over dt of h_i h_j, with the
 * impulse responses h_b = s e^-u, h_b' = (1 - u) e^-u, h_I = (1 - e^-u (1 + u))/beta^2, u = beta s.
 * Source: A. Gelb (ed.), Applied Optimal Estimation, ch. 2 (second-order Markov process). */
#ifndef SCHULER_SENSORS_GAUSS_MARKOV_2_H
#define SCHULER_SENSORS_GAUSS_MARKOV_2_H

#include "core/normal.h"
#include "core/truth.h"
#include "sensors/setup.h"
#include <math.h>

/* In units of sigma and T: time in T, rate in sigma/T. */
typedef struct {
    double phi[2][2], gain[2], l[3][3];
} gauss_markov_2_step;

typedef struct {
    lanes sigma[3]; /* times T: the integral is in units of sigma T */
    lanes b[3], b_dot[3];
    gauss_markov_2_step step[3];
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int active;
} gauss_markov_2;

/* 1 - e^-u (1 + u), all digits for small u: u^2/2 - u^3/3 + u^4/8 - ... */
LANES_INLINE double markov_2_integral(double u)
{
    if (u > 0.2) return 1.0 - exp(-u) * (1.0 + u);
    /* sum over n >= 2 of (-1)^n u^n (n - 1)/n! */
    double sum = 0.0, power = 1.0;
    for (int n = 1; n <= 12; n++) {
        power *= -u / n;
        sum += power * (n - 1);
    }
    return sum;
}

/* Covariance of the drives over a step of x = dt/T, by Gauss-Legendre on pieces no longer than T; after
 * 50 T nothing but the integral's limit is left. */
LANES_INLINE void markov_2_covariance(double x, double q[3][3])
{
    static const double node[4] = { 0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                    0.96028985649753623 };
    static const double weight[4] = { 0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                      0.10122853629037626 };
    const double end = fmin(x, 50.0);
    const int pieces = (int)ceil(end);
    for (int i = 0; i < 9; i++) q[i / 3][i % 3] = 0.0;
    for (int p = 0; p < pieces; p++)
        for (int j = 0; j < 8; j++) {
            const double half = 0.5 * end / pieces;
            const double u = half * (2 * p + 1 + (j < 4 ? node[j] : -node[j - 4]));
            const double h[3] = { u * exp(-u), (1.0 - u) * exp(-u), markov_2_integral(u) };
            for (int i = 0; i < 9; i++)
                q[i / 3][i % 3] += 4.0 * half * weight[j % 4] * h[i / 3] * h[i % 3];
        }
    q[2][2] += 4.0 * (x - end);
}

LANES_INLINE gauss_markov_2_step gauss_markov_2_step_of(double x)
{
    gauss_markov_2_step s = { 0 };
    double q[3][3];
    const double e = exp(-x);
    s.phi[0][0] = e * (1.0 + x);
    s.phi[0][1] = e * x;
    s.phi[1][0] = -e * x;
    s.phi[1][1] = e * (1.0 - x);
    s.gain[0] = 2.0 - e * (2.0 + x); /* integral of (1 + u) e^-u */
    if (x < 0.2) s.gain[0] = markov_2_integral(x) - expm1(-x);
    s.gain[1] = markov_2_integral(x);
    markov_2_covariance(x, q);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            double sum = q[i][j];
            for (int k = 0; k < j; k++) sum -= s.l[i][k] * s.l[j][k];
            s.l[i][j] = i == j ? sqrt(fmax(sum, 0.0)) : s.l[j][j] > 0.0 ? sum / s.l[j][j] : 0.0;
        }
    return s;
}

LANES_INLINE void gauss_markov_2_setup(gauss_markov_2 *m, const schuler_model_setup *s, int param,
                                       int time_param, unsigned number)
{
    m->run = setup_runs(s);
    m->seed = s->seed;
    m->number = number;
    m->active = setup_any(s, param, 3);
    for (int i = 0; i < 3; i++) {
        const double T = setup_setting(s, time_param, i);
        m->step[i] = gauss_markov_2_step_of(s->dt_s / T);
        m->sigma[i] = setup_value(s, param, i) * lanes_set(T);
        lanes start[4];
        lanes_normals(m->seed, m->run, stream_counter(number, (unsigned)i, SCHULER_USE_START), 0, 1,
                      start);
        m->b[i] = start[0];
        m->b_dot[i] = start[1]; /* variance of b' is sigma^2/T^2, not correlated with b */
    }
}

/* Numbers 4k .. 4k+3 of the stream of an axis belong to step k; the last one is not used. */
LANES_INLINE void gauss_markov_2_add(gauss_markov_2 *m, const schuler_model_block *b)
{
    for (int i = 0; i < 3; i++) {
        double *const out = b->out + i * b->stride * SCHULER_LANES;
        const gauss_markov_2_step *const p = &m->step[i];
        lanes x = m->b[i], v = m->b_dot[i];
        for (int k = 0; k < b->n; k++) {
            lanes w[4];
            lanes_normals(m->seed, m->run, stream_counter(m->number, (unsigned)i, SCHULER_USE_SLOW),
                          (uint64_t)(b->first + k), 1, w);
            const lanes I = p->gain[0] * x + p->gain[1] * v +
                            (p->l[2][0] * w[0] + p->l[2][1] * w[1] + p->l[2][2] * w[2]);
            const lanes next = p->phi[0][0] * x + p->phi[0][1] * v + p->l[0][0] * w[0];
            v = p->phi[1][0] * x + p->phi[1][1] * v + (p->l[1][0] * w[0] + p->l[1][1] * w[1]);
            x = next;
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + m->sigma[i] * I);
        }
        m->b[i] = x;
        m->b_dot[i] = v;
    }
}

#endif

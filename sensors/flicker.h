/* SPDX-License-Identifier: MIT */
/* Flicker noise, S(f) = B^2/(2 pi f), as a bank of first-order Gauss-Markov processes:
 *
 *     T_i = T_0 r^i,   sigma_i^2 = B^2 ln(r)/pi,   r = 4
 *
 * (the sum over T of 2 sigma^2 T/(1 + (2 pi f T)^2) is, for T in geometric progression, the integral
 * over dT/T: sigma^2/(2 f ln r)). The floor of the Allan deviation is sqrt(2 ln 2/pi) B with a ripple
 * of 0.024 %; within a decade of the ends of the bank it falls off (2 % a factor of ten inside).
 *
 * The increments of one member over equal steps D are a process of their own, ARMA(1, 1): with
 * I = integral of b, v_k = I_k - phi I_(k-1) has covariances c0, c1 and no others, so
 *
 *     I = x + s e,   x' = phi x + s (phi + t) e,   s^2 t = c1,  s^2 (1 + t^2) = c0,  |t| < 1
 *
 * is exact in distribution with one random number e a step, and stationary from the start when x
 * begins with variance s^2 (phi + t)^2/(1 - phi^2). With x = D/T, in units of sigma^2 T^2:
 *   c1 = gain q12 - phi q22,  c0 = q22 + gain^2 q11 - 2 gain phi q12 + phi^2 q22,
 *   gain = 1 - phi, q11 = 1 - phi^2, q12 = (1 - phi)^2, q22 as in drift.h. No cancellation: both are
 *   of third order in x, 4/3 and 1/3.
 *
 * A member is updated every D, the largest power of two of samples that is no longer than T/20, and
 * within D its increment is spread evenly. */
#ifndef SCHULER_SENSORS_FLICKER_H
#define SCHULER_SENSORS_FLICKER_H

#include "sensors/drift.h"

enum { FLICKER_MEMBERS_MAX = 24 };

typedef struct {
    int64_t pace;                    /* samples in D */
    double phi, feed, direct, start; /* x' = phi x + feed e; I per sample = (x + s e)/pace: all are
                                        in units of B dt, direct = s/pace                          */
} flicker_member;

typedef struct {
    lanes B[3]; /* coefficient times dt */
    lanes x[3][FLICKER_MEMBERS_MAX], each[3][FLICKER_MEMBERS_MAX];
    flicker_member member[FLICKER_MEMBERS_MAX];
    lanes_u64 run;
    uint64_t seed;
    unsigned number;
    int members, active;
} flicker;

/* The member's numbers in units of B dt a sample. */
LANES_INLINE flicker_member flicker_member_of(double T, double dt_s)
{
    int64_t pace = 1;
    while (pace < (int64_t)1 << 40 && 2.0 * (double)pace * dt_s <= T / 20.0) pace *= 2;
    const double x = (double)pace * dt_s / T;
    const double phi = exp(-x), gain = -expm1(-x), q11 = -expm1(-2.0 * x), q12 = gain * gain,
                 q22 = drift_q22(x);
    const double c0 = q22 + gain * gain * q11 - 2.0 * gain * phi * q12 + phi * phi * q22;
    const double c1 = gain * q12 - phi * q22;
    const double t = 2.0 * c1 / (c0 + sqrt((c0 - 2.0 * c1) * (c0 + 2.0 * c1)));
    /* sigma T, per sample of the step and in units of dt: sigma T/(pace dt) = sigma/x. */
    const double s = sqrt(c1 / t) * sqrt(log(4.0) / M_PI) / x;
    return (flicker_member){ .pace = pace,
                             .phi = phi,
                             .feed = s * (phi + t),
                             .direct = s,
                             .start = s * (phi + t) / sqrt(q11) };
}

LANES_INLINE void flicker_setup(flicker *f, const schuler_model_setup *s, int param, int shortest,
                                int longest, unsigned number)
{
    f->run = setup_runs(s);
    f->seed = s->seed;
    f->number = number;
    f->active = setup_any(s, param, 3);
    f->members = 0;
    const double first = fmax(setup_setting(s, shortest, 0), 10.0 * s->dt_s);
    const double last = fmax(setup_setting(s, longest, 0), first);
    for (double T = first; T <= last * 1.0000001 && f->members < FLICKER_MEMBERS_MAX; T *= 4.0)
        f->member[f->members++] = flicker_member_of(T, s->dt_s);
    for (int i = 0; i < 3; i++) {
        f->B[i] = setup_value(s, param, i) * lanes_set(s->dt_s);
        for (int j = 0; j < f->members && f->active; j += 4) {
            lanes start[4];
            lanes_normals(f->seed, f->run, stream_counter(number, (unsigned)i, SCHULER_USE_START),
                          (uint64_t)j / 4, 1, start);
            for (int k = 0; k < 4 && j + k < f->members; k++) {
                f->x[i][j + k] = lanes_set(f->member[j + k].start) * start[k];
                f->each[i][j + k] = lanes_set(0.0);
            }
        }
    }
}

/* Number j of the stream of an axis and member belongs to its step j; members are 2^48 apart. */
LANES_INLINE void flicker_member_add(flicker *f, int axis, int i, const schuler_model_block *b,
                                     lanes *sum)
{
    const flicker_member *const m = &f->member[i];
    const uint64_t counter = stream_counter(f->number, (unsigned)axis, SCHULER_USE_SLOW);
    const uint64_t stream = (uint64_t)(i + 1) << 48;
    const int64_t past = b->first + b->n;
    int64_t at = (b->first + m->pace - 1) / m->pace * m->pace; /* of the next update */
    const int64_t group = at / m->pace / 4;
    lanes x = f->x[axis][i], each = f->each[axis][i], normal[SCHULER_BLOCK + 4];
    if (at < past)
        lanes_normals(f->seed, f->run, counter, stream + (uint64_t)group,
                      (int)((past - 1) / m->pace / 4 - group + 1), normal);
    for (int64_t k = b->first; k < past;) {
        if (k == at) {
            const lanes e = normal[at / m->pace - 4 * group];
            each = x + lanes_set(m->direct) * e;
            x = lanes_set(m->phi) * x + lanes_set(m->feed) * e;
            at += m->pace;
        }
        for (; k < at && k < past; k++) sum[k - b->first] += each;
    }
    f->x[axis][i] = x;
    f->each[axis][i] = each;
}

LANES_INLINE void flicker_add(flicker *f, const schuler_model_block *b)
{
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        lanes sum[SCHULER_BLOCK];
        for (int k = 0; k < b->n; k++) sum[k] = lanes_set(0.0);
        for (int i = 0; i < f->members; i++) flicker_member_add(f, axis, i, b, sum);
        for (int k = 0; k < b->n; k++)
            lanes_store(out + k * SCHULER_LANES,
                        lanes_load(out + k * SCHULER_LANES) + f->B[axis] * sum[k]);
    }
}

#endif

/* SPDX-License-Identifier: MIT */
/* Models that are a sum of coefficients times functions of the true input:
 *
 *     y = x + sum over k of c_k B_k(a_i, a_p, a_o, omega, ...)
 *
 * B_k is the same for all lanes, so its integral over each step is taken once a block, on the
 * instantaneous input at the nodes of the quadrature (mean(a^2) is not mean(a)^2: vibration
 * rectifies by itself). A lane then costs one multiplication for each of its terms. With all
 * coefficients zero the output is the input, bit for bit. */
#ifndef SCHULER_SENSORS_TERMS_H
#define SCHULER_SENSORS_TERMS_H

#include "core/truth.h"
#include "sensors/setup.h"

enum { TERMS_MAX = 40 };

/* One instrument at one instant, on its own axes i, p, o. */
typedef struct {
    double a[3];     /* specific force, m/s^2                                        */
    double omega[3]; /* angular rate, rad/s                                          */
    double alpha[3]; /* angular acceleration, mean over the step: its integral is exact, rad/s^2 */
    double temperature, temperature_rate; /* above the reference, K; K/s             */
} term_input;

typedef void (*term_bases)(const schuler_model_setup *settings, const term_input *x, double *B);
/* Coefficients of one lane and axis; v[param] are the values of the model's parameters. */
typedef const double (*term_values)[SCHULER_COMPONENTS_MAX];
typedef void (*term_coefficients)(const schuler_model_setup *setup, term_values v, int axis,
                                  double *c);

typedef struct {
    int count[3], which[3][TERMS_MAX]; /* the terms that some lane has */
    lanes c[3][TERMS_MAX];
} terms;

LANES_INLINE void terms_observe(const schuler_model_setup *settings, const schuler_view *v,
                                int count, term_bases bases, double *signals)
{
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < v->n; k++) {
            double sum[TERMS_MAX] = { 0 }, B[TERMS_MAX] = { 0 };
            term_input x;
            for (int c = 0; c < 3; c++) {
                const double *const rate = v->omega_end[axis][c];
                x.alpha[c] = (rate[k + 1] - rate[k]) / v->dt_s;
            }
            for (int j = 0; j < v->nodes; j++) {
                const int at = j * SCHULER_BLOCK + k;
                for (int c = 0; c < 3; c++) {
                    x.a[c] = v->f[axis][c][at];
                    x.omega[c] = v->omega[axis][c][at];
                }
                x.temperature = v->temperature[at];
                x.temperature_rate = v->temperature_rate[at];
                bases(settings, &x, B);
                for (int q = 0; q < count; q++) sum[q] += v->weight[j] * B[q];
            }
            for (int q = 0; q < count; q++)
                signals[(axis * count + q) * SCHULER_BLOCK + k] = v->dt_s * sum[q];
        }
}

/* coefficients NULL: coefficient k is parameter k. Returned: whether any is not zero. */
LANES_INLINE int terms_setup(terms *t, const schuler_model_setup *s, int count,
                             term_coefficients coefficients)
{
    int any = 0;
    for (int axis = 0; axis < 3; axis++) {
        double c[SCHULER_LANES][TERMS_MAX] = { { 0 } };
        for (int l = 0; l < SCHULER_LANES; l++) {
            const term_values v = &s->specs[l].value[s->base];
            if (coefficients)
                coefficients(s, v, axis, c[l]);
            else
                for (int q = 0; q < count; q++) c[l][q] = v[q][axis];
        }
        t->count[axis] = 0;
        for (int q = 0; q < count; q++) {
            double x[SCHULER_LANES] __attribute__((aligned(64)));
            int used = 0;
            for (int l = 0; l < SCHULER_LANES; l++) used |= (x[l] = c[l][q]) != 0.0;
            if (!used) continue;
            t->which[axis][t->count[axis]] = q;
            t->c[axis][t->count[axis]++] = lanes_load(x);
            any = 1;
        }
    }
    return any;
}

/* Adds the terms to what is in out (a stage), or to the true increments (a model: from_own). */
LANES_INLINE void terms_apply(const terms *t, const schuler_model_block *b, int signals,
                              int from_own)
{
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        const double *const own = b->own + axis * b->stride;
        const double *s[TERMS_MAX];
        const int count = t->count[axis];
        for (int q = 0; q < count; q++)
            s[q] = b->signals + (axis * signals + t->which[axis][q]) * SCHULER_BLOCK;
        for (int k = 0; k < b->n; k++) {
            lanes y = from_own ? lanes_set(own[k]) : lanes_load(out + k * SCHULER_LANES);
            for (int q = 0; q < count; q++) y += t->c[axis][q] * lanes_set(s[q][k]);
            lanes_store(out + k * SCHULER_LANES, y);
        }
    }
}

/* The functions observe, setup and apply of a model that is nothing but its terms. */
#define TERMS_MODEL(COUNT, BASES, COEFFICIENTS)                                                    \
    static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)      \
    {                                                                                              \
        terms_observe(s, v, COUNT, BASES, signals);                                                \
    }                                                                                              \
                                                                                                   \
    static int setup(void *state, const schuler_model_setup *s)                                    \
    {                                                                                              \
        (void)terms_setup(state, s, COUNT, COEFFICIENTS);                                          \
        return 1;                                                                                  \
    }                                                                                              \
                                                                                                   \
    static void apply(void *state, const schuler_model_block *b)                                   \
    {                                                                                              \
        terms_apply(state, b, COUNT, 1);                                                           \
    }

/* The functions setup and apply of a stage that adds its terms to what comes in. */
#define TERMS_STAGE(COUNT, COEFFICIENTS)                                                           \
    static int setup(void *state, const schuler_model_setup *s)                                    \
    {                                                                                              \
        return terms_setup(state, s, COUNT, COEFFICIENTS);                                         \
    }                                                                                              \
                                                                                                   \
    static void apply(void *state, const schuler_model_block *b)                                   \
    {                                                                                              \
        terms_apply(state, b, COUNT, 0);                                                           \
    }

#endif

/* SPDX-License-Identifier: MIT */
#include "sensors/markov_filter.h"
#include "sensors/markov_integral.h"
#include <math.h>

/* One process; everything that becomes small with x is kept as itself, not as a difference from 1. */
typedef struct {
    double x, phi, one_minus_phi; /* dt/T and the pole of the filter                       */
    double y;                     /* pole of S in y = c - 1: (1 - phi)^2/(2 phi)               */
    double c0, c1;                /* covariances, with sigma^2 T^2: of third order in x        */
} pole;

enum {
    X_MAX = 100, /* e^-100 is nothing beside 1, and its square is still a number */
    BISECTIONS = 64
};

static pole pole_of(schuler_markov_process p, double dt_s)
{
    const double x = fmin(dt_s / p.T_s, X_MAX);
    /* A shorter correlation is white: the same product sigma^2 T is all that is left of it. */
    const double T_s = dt_s / x, variance = p.sigma * p.sigma * p.T_s * T_s;
    const double phi = exp(-x), gain = -expm1(-x);
    const double q11 = -expm1(-2.0 * x), q12 = gain * gain, q22 = markov_q22(x);
    return (pole){
        .x = x,
        .phi = phi,
        .one_minus_phi = gain,
        .y = gain * gain / (2.0 * phi),
        .c0 = variance * (q22 + gain * gain * q11 - 2.0 * gain * phi * q12 + phi * phi * q22),
        .c1 = variance * (gain * q12 - phi * q22),
    };
}

/* S at c = 1 + y. */
static double spectrum(const pole *p, int members, double y)
{
    double sum = 0.0;
    for (int i = 0; i < members; i++)
        sum += (p[i].c0 + 2.0 * p[i].c1 * (1.0 + y)) / (2.0 * p[i].phi * (p[i].y - y));
    return sum;
}

/* 1 - zeta of the zero between two poles. S goes from minus to plus infinity there. */
static double zero_between(const pole *p, int members, double low, double high)
{
    double from = log(low), to = log(high);
    for (int n = 0; n < BISECTIONS; n++) {
        const double middle = 0.5 * (from + to);
        if (spectrum(p, members, exp(middle)) > 0.0)
            to = middle;
        else
            from = middle;
    }
    const double y = exp(0.5 * (from + to));
    return 2.0 / (sqrt(1.0 + 2.0 / y) + 1.0);
}

/* The zero below c = -1, as -zeta in (0, 1): c = -(1 + t^2)/(2 t). */
static double zero_below(const pole *p, int members)
{
    double from = 0.0, to = 1.0;
    for (int n = 0; n < BISECTIONS; n++) {
        const double t = 0.5 * (from + to);
        if (spectrum(p, members, -(1.0 + t) * (1.0 + t) / (2.0 * t)) > 0.0)
            to = t;
        else
            from = t;
    }
    return 0.5 * (from + to);
}

schuler_markov_filter schuler_markov_filter_of(const schuler_markov_process *process, int members,
                                               double dt_s)
{
    schuler_markov_filter f = { .members = members };
    pole p[SCHULER_MARKOV_MAX];
    double one_minus_zeta[SCHULER_MARKOV_MAX]; /* the first one is the zero below c = -1 */
    for (int i = 0; i < members; i++) p[i] = pole_of(process[i], dt_s);
    one_minus_zeta[0] = 1.0 + zero_below(p, members);
    for (int i = 1; i < members; i++)
        one_minus_zeta[i] = zero_between(p, members, p[i].y, p[i - 1].y);

    double s2 = spectrum(p, members, -2.0);
    for (int i = 0; i < members; i++) {
        const double ratio = (1.0 + p[i].phi) / (2.0 - one_minus_zeta[i]);
        s2 *= ratio * ratio;
    }
    f.direct = sqrt(s2);
    for (int i = 0; i < members; i++) {
        f.x[i] = p[i].x;
        f.phi[i] = p[i].phi;
        f.feed[i] = f.direct * (one_minus_zeta[i] - p[i].one_minus_phi);
        for (int j = 0; j < members; j++)
            if (j != i)
                f.feed[i] *= (one_minus_zeta[j] - p[i].one_minus_phi) /
                             (p[j].one_minus_phi - p[i].one_minus_phi);
    }
    return f;
}

void schuler_markov_filter_start(const schuler_markov_filter *f,
                                 double l[SCHULER_MARKOV_MAX][SCHULER_MARKOV_MAX])
{
    for (int i = 0; i < f->members; i++)
        for (int j = 0; j <= i; j++) {
            const double between = -expm1(-(f->x[i] + f->x[j]));
            double sum = f->feed[i] * f->feed[j] / between;
            for (int k = 0; k < j; k++) sum -= l[i][k] * l[j][k];
            l[i][j] = i == j ? sqrt(fmax(sum, 0.0)) : l[j][j] > 0.0 ? sum / l[j][j] : 0.0;
        }
}

/* SPDX-License-Identifier: MIT */
#include "sensors/allan_covariance.h"
#include "core/earth.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The generalised covariance G(t) of the phase: -1/2 of the variance of what it gains over t, or for
 * processes of which only second differences have a variance, any function with the right second
 * differences. Per unit of the squared coefficient:
 *   white -|t|/2;  random walk |t|^3/12;  flicker t^2 ln|t|/(2 pi);
 *   Gauss-Markov -sigma^2 T^2 (x - 1 + e^-x), x = |t|/T. Quantization is a lone 1 at t = 0.
 * Second differences over tau have the variance 6 G(0) - 8 G(tau) + 2 G(2 tau) = 2 tau^2 AVAR. */

/* x - 1 + e^-x, all digits for small x. */
static double ramp_up(double x)
{
    if (x > 0.1) return x + expm1(-x);
    return x * x *
           (1.0 / 2.0 -
            x * (1.0 / 6.0 -
                 x * (1.0 / 24.0 -
                      x * (1.0 / 120.0 - x * (1.0 / 720.0 - x * (1.0 / 5040.0 - x / 40320.0))))));
}

static double flicker(const schuler_flicker_bank *bank, double t)
{
    if (bank->members == 0) return t > 0.0 ? t * t * log(t) / (2.0 * SCHULER_PI) : 0.0;
    double sum = 0.0;
    for (int i = 0; i < bank->members; i++) {
        const schuler_markov_process p = schuler_flicker_bank_member(bank, 1.0, i);
        sum -= p.sigma * p.sigma * p.T_s * p.T_s * ramp_up(t / p.T_s);
    }
    return sum;
}

/* Second and fourth derivative. */
static void flicker_derivatives(const schuler_flicker_bank *bank, double t, double d[2])
{
    if (bank->members == 0) {
        d[0] = (2.0 * log(t) + 3.0) / (2.0 * SCHULER_PI);
        d[1] = -1.0 / (SCHULER_PI * t * t);
        return;
    }
    d[0] = d[1] = 0.0;
    for (int i = 0; i < bank->members; i++) {
        const schuler_markov_process p = schuler_flicker_bank_member(bank, 1.0, i);
        const double x = t / p.T_s, e = x < 40.0 ? p.sigma * p.sigma * exp(-x) : 0.0;
        d[0] -= e;
        d[1] -= e / (p.T_s * p.T_s);
    }
}

/* G(t + h) - 2 G(t) + G(t - h) of white noise, flicker, random walk. Far from 0 the difference of
 * nearly equal numbers is replaced by its Taylor series: at t = 30 h the term left out, of order
 * (h/t)^4/100, is below 1e-8 of the whole. */
static void differenced(const schuler_flicker_bank *bank, double t, double h, double out[3])
{
    t = fabs(t);
    if (t > 30.0 * h) {
        double d[2];
        flicker_derivatives(bank, t, d);
        out[0] = 0.0;
        out[1] = h * h * (d[0] + h * h / 12.0 * d[1]);
        out[2] = 0.5 * t * h * h;
        return;
    }
    const double above = t + h, below = fabs(t - h);
    out[0] = -0.5 * (above - 2.0 * t + below);
    out[1] = flicker(bank, above) - 2.0 * flicker(bank, t) + flicker(bank, below);
    out[2] = (above * above * above - 2.0 * t * t * t + below * below * below) / 12.0;
}

/* Two series of second differences, over m_i <= m_j, of the same record. */
typedef struct {
    const schuler_flicker_bank *bank;
    int64_t n, mi, mj;
    double dt_s;
    double square[ALLAN_RANDOM][ALLAN_RANDOM], single[ALLAN_RANDOM];
} lag_sum;

/* Pairs whose centres are d apart, to one side. */
static double pairs_apart(const lag_sum *s, double d)
{
    const double ahead = d - (double)(s->mj - s->mi);
    const double all = (double)(s->n - 2 * s->mj + 1);
    return ahead <= 0.0 ? all : fmax(0.0, all - ahead);
}

static const double choice[3] = { 1.0, -2.0, 1.0 };

/* Quantization has covariance at single lags only. */
static double quantization_at(const lag_sum *s, int64_t d)
{
    double sum = 0.0;
    for (int a = -1; a <= 1; a++)
        for (int b = -1; b <= 1; b++)
            if (d + a * s->mi + b * s->mj == 0) sum += choice[a + 1] * choice[b + 1];
    return sum;
}

static void covariances(const lag_sum *s, double d, double R[ALLAN_RANDOM])
{
    R[0] = R[1] = R[2] = R[3] = 0.0;
    for (int b = -1; b <= 1; b++) {
        double part[3];
        differenced(s->bank, (d + (double)(b * s->mj)) * s->dt_s, (double)s->mi * s->dt_s, part);
        for (int a = 0; a < 3; a++) R[1 + a] += choice[b + 1] * part[a];
    }
}

static void add(lag_sum *s, double weight, const double R[ALLAN_RANDOM])
{
    for (int a = 0; a < ALLAN_RANDOM; a++) {
        s->single[a] += weight * R[a];
        for (int b = 0; b < ALLAN_RANDOM; b++) s->square[a][b] += weight * R[a] * R[b];
    }
}

/* Lags from first to last, both sides, the two ends counted half; R is smooth between. A short piece
 * is summed lag by lag, a long one as an integral: their difference is the change of slope over 12. */
static void add_piece(lag_sum *s, int64_t first, int64_t last)
{
    enum { SHORT = 12, NODES = 3 };
    static const double node[NODES] = { 0.23861918608319691, 0.66120938646626451,
                                        0.93246951420315203 };
    static const double share[NODES] = { 0.46791393457269105, 0.36076157304813861,
                                         0.17132449237917035 };
    double R[ALLAN_RANDOM];
    if (last - first <= SHORT) {
        for (int64_t d = first; d <= last && last > first; d++) {
            covariances(s, (double)d, R);
            add(s, (d == first || d == last ? 1.0 : 2.0) * pairs_apart(s, (double)d), R);
        }
        return;
    }
    const double half = 0.5 * (double)(last - first), middle = 0.5 * (double)(last + first);
    for (int i = 0; i < 2 * NODES; i++) {
        const double d = middle + half * (i < NODES ? node[i] : -node[i - NODES]);
        covariances(s, d, R);
        add(s, 2.0 * half * share[i % NODES] * pairs_apart(s, d), R);
    }
}

/* Pieces that grow by a factor of four away from both ends, where R may have a kink or a logarithm;
 * near an end it changes over m_i. */
static void add_graded(lag_sum *s, int64_t first, int64_t last)
{
    const int64_t smallest = s->mi;
    if (last - first <= 4 * smallest) {
        add_piece(s, first, last);
        return;
    }
    const int64_t middle = first + (last - first) / 2;
    for (int side = 0; side < 2; side++) {
        int64_t from = 0;
        const int64_t end = side ? last - middle : middle - first;
        for (int64_t length = smallest; from < end; length *= 4) {
            const int64_t to = from + length < end ? from + length : end;
            if (side)
                add_piece(s, last - to, last - from);
            else
                add_piece(s, first + from, first + to);
            from = to;
        }
    }
}

/* What quantization adds at the lags where it is not zero; the smooth terms are there already. */
static void add_quantization(lag_sum *s, int64_t lag)
{
    double R[ALLAN_RANDOM];
    const double q = quantization_at(s, lag);
    const double weight = (lag > 0 ? 2.0 : 1.0) * pairs_apart(s, (double)lag);
    covariances(s, (double)lag, R);
    s->single[0] += weight * q;
    s->square[0][0] += weight * q * q;
    for (int a = 1; a < ALLAN_RANDOM; a++) {
        s->square[0][a] += weight * q * R[a];
        s->square[a][0] = s->square[0][a];
    }
}

static allan_pair pair_of(lag_sum *s)
{
    /* Where a kink of R is, or of the number of pairs; and the largest lag. */
    const int64_t last = s->n - s->mi - s->mj + 1;
    const int64_t kink[5] = { 0, s->mi, s->mj - s->mi, s->mj, s->mj + s->mi };
    int64_t edge[7], edges = 0;
    for (int64_t from = -1;;) { /* sorted, each once */
        int64_t next = last;
        for (int i = 0; i < 5; i++)
            if (kink[i] > from && kink[i] < next) next = kink[i];
        edge[edges++] = next;
        if (next == last) break;
        if (quantization_at(s, next) != 0.0) add_quantization(s, next);
        from = next;
    }
    for (int i = 0; i + 1 < edges; i++) add_graded(s, edge[i], edge[i + 1]);

    allan_pair p;
    const double ti = (double)s->mi * s->dt_s, tj = (double)s->mj * s->dt_s;
    const double scale = 1.0 / (4.0 * ti * ti * tj * tj * (double)(s->n - 2 * s->mi + 1) *
                                (double)(s->n - 2 * s->mj + 1));
    for (int a = 0; a < ALLAN_RANDOM; a++) {
        for (int b = 0; b < ALLAN_RANDOM; b++) p.square[a][b] = 2.0 * scale * s->square[a][b];
        p.ramp[a] = 4.0 * scale * ti * ti * tj * tj * s->single[a];
    }
    return p;
}

schuler_status allan_covariance_create(allan_covariance *out, int64_t n, double dt_s,
                                       const int64_t *m, int count,
                                       const schuler_flicker_bank *bank)
{
    out->count = count;
    out->pairs = malloc(sizeof(allan_pair) * (size_t)(count * (count + 1) / 2 + 1));
    if (!out->pairs) return SCHULER_ERR_MEMORY;
    for (int i = 0; i < count; i++)
        for (int j = 0; j <= i; j++) {
            lag_sum s = { .bank = bank, .n = n, .mi = m[j], .mj = m[i], .dt_s = dt_s };
            out->pairs[i * (i + 1) / 2 + j] = pair_of(&s);
        }
    return SCHULER_OK;
}

void allan_covariance_free(allan_covariance *c)
{
    free(c->pairs);
    c->pairs = NULL;
}

double allan_covariance_at(const allan_covariance *v, int i, int j,
                           const double c[SCHULER_ALLAN_TERMS])
{
    const allan_pair *const p = &v->pairs[i > j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i];
    double sum = 0.0;
    for (int a = 0; a < ALLAN_RANDOM; a++) {
        sum += c[a] * c[SCHULER_ALLAN_RAMP] * p->ramp[a];
        for (int b = 0; b < ALLAN_RANDOM; b++) sum += c[a] * c[b] * p->square[a][b];
    }
    return sum;
}

/* SPDX-License-Identifier: MIT */
#include "sensors/allan_fit.h"
#include "sensors/allan_covariance.h"
#include "sensors/allan_solve.h"
#include "sensors/chi_square.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TERMS = SCHULER_ALLAN_TERMS, POINTS = SCHULER_ALLAN_POINTS_MAX };

/* Value times this is still told: beyond it only the order of magnitude is known. */
static const double UNSURE_RATIO = 10.0;

struct schuler_allan_design {
    int count;
    int64_t n;
    double tau_s[POINTS], x[POINTS][TERMS]; /* sigma^2 per unit of the squared coefficients */
    int64_t m[POINTS];
    allan_covariance covariance;
};

schuler_status schuler_allan_design_create(schuler_allan_design **out, int64_t n, double dt_s,
                                           const int64_t *m, int count,
                                           const schuler_flicker_bank *bank)
{
    *out = NULL;
    if (count < 0 || count > POINTS) return SCHULER_ERR_INPUT;
    for (int i = 0; i < count; i++)
        if (m[i] < 1 || m[i] > n / 3) return SCHULER_ERR_INPUT;
    schuler_allan_design *d = calloc(1, sizeof(*d));
    if (!d) return SCHULER_ERR_MEMORY;
    d->count = count;
    d->n = n;
    for (int i = 0; i < count; i++) {
        const double tau_s = (double)m[i] * dt_s;
        d->m[i] = m[i];
        d->tau_s[i] = tau_s;
        d->x[i][SCHULER_ALLAN_QUANTIZATION] = schuler_process_quantization(1.0, tau_s);
        d->x[i][SCHULER_ALLAN_WHITE] = schuler_process_white(1.0, tau_s);
        d->x[i][SCHULER_ALLAN_FLICKER] = bank->members > 0
                                             ? schuler_process_flicker_bank(bank, 1.0, tau_s)
                                             : schuler_process_flicker(1.0, tau_s);
        d->x[i][SCHULER_ALLAN_RANDOM_WALK] = schuler_process_random_walk(1.0, tau_s);
        d->x[i][SCHULER_ALLAN_RAMP] = schuler_process_ramp(1.0, tau_s);
    }
    const schuler_status status = allan_covariance_create(&d->covariance, n, dt_s, m, count, bank);
    if (status != SCHULER_OK) {
        schuler_allan_design_free(d);
        return status;
    }
    *out = d;
    return SCHULER_OK;
}

void schuler_allan_design_free(schuler_allan_design *d)
{
    if (!d) return;
    allan_covariance_free(&d->covariance);
    free(d);
}

/* Weights under squared coefficients c. A sigma^2 of zero (a record of whole counts that did not
 * move) says nothing about its variance. */
static void weigh(const schuler_allan_design *d, const double *sigma2, const double c[TERMS],
                  double *w)
{
    for (int i = 0; i < d->count; i++) {
        const double variance = allan_covariance_at(&d->covariance, i, i, c);
        const double least = 1e-12 * sigma2[i] * sigma2[i]; /* a pure ramp has no variance */
        w[i] = sigma2[i] > 0.0 ? 1.0 / fmax(variance, least) : 0.0;
    }
}

/* A fitted term as a linear function of the sigma^2, and the variance of that function as a quadratic
 * form in the squared coefficients. */
typedef struct {
    double value; /* before any clipping: may be negative */
    double square[ALLAN_RANDOM][ALLAN_RANDOM], ramp[ALLAN_RANDOM];
} estimate;

static int estimate_of(const schuler_allan_design *d, const allan_normal *e, const double *sigma2,
                       const double *w, unsigned set, int term, estimate *out)
{
    double row[TERMS], unit[TERMS] = { 0 }, a[POINTS];
    memset(out, 0, sizeof(*out));
    unit[term] = 1.0;
    if (!allan_solve(e, unit, set, row)) return 0;
    for (int i = 0; i < d->count; i++) {
        a[i] = 0.0;
        for (int k = 0; k < TERMS; k++) a[i] += row[k] * d->x[i][k];
        a[i] *= w[i] * e->scale[term];
        out->value += a[i] * sigma2[i];
    }
    for (int i = 0; i < d->count; i++)
        for (int j = 0; j <= i; j++) {
            const allan_pair *const p = &d->covariance.pairs[i * (i + 1) / 2 + j];
            const double weight = a[i] * a[j] * (i == j ? 1.0 : 2.0);
            for (int k = 0; k < ALLAN_RANDOM; k++) {
                out->ramp[k] += weight * p->ramp[k];
                for (int l = 0; l < ALLAN_RANDOM; l++)
                    out->square[k][l] += weight * p->square[k][l];
            }
        }
    return 1;
}

/* Quantile p of a chi-square distribution that is shifted and scaled to mean 0, variance 1 and this
 * skewness. Close to normal, by the expansion of Cornish and Fisher; the term left out is of the order
 * of its cube. */
static double skewed_quantile(double skewness, double p)
{
    if (skewness > 0.05) {
        const double dof = 8.0 / (skewness * skewness);
        return (schuler_chi_square_quantile(dof, p) - dof) / sqrt(2.0 * dof);
    }
    const double size = sqrt(schuler_chi_square_quantile(1.0, fabs(2.0 * p - 1.0)));
    const double z = p < 0.5 ? -size : size, z2 = z * z;
    return z + skewness * (z2 - 1.0) / 6.0 + skewness * skewness * z * (z2 - 7.0) / 144.0;
}

/* Quantile of the estimate of a squared coefficient if its true value is h and the others are c. Its
 * variance is a + b h + g h^2. The last part alone is a chi-square of 2/g degrees of freedom, with
 * third cumulant 2 g^2 h^3; the others are sums of many tau and taken as normal. A shifted chi-square
 * has these three moments; without skewness it is the normal distribution. */
static double quantile(const estimate *e, const double c[TERMS], int term, double h, double p)
{
    double at[TERMS], variance = 0.0;
    memcpy(at, c, sizeof(at));
    at[term] = h;
    for (int k = 0; k < ALLAN_RANDOM; k++) {
        variance += at[k] * at[SCHULER_ALLAN_RAMP] * e->ramp[k];
        for (int l = 0; l < ALLAN_RANDOM; l++) variance += at[k] * at[l] * e->square[k][l];
    }
    if (!(variance > 0.0)) return h;
    const double own = term < ALLAN_RANDOM ? fmax(0.0, e->square[term][term]) : 0.0;
    const double sd = sqrt(variance);
    return h + sd * skewed_quantile(2.0 * own * own * h * h * h / (variance * sd), p);
}

/* The true value for which the estimate would be the p-quantile. */
static double invert(const estimate *e, const double c[TERMS], int term, double p, double start)
{
    double low = 0.0, high = fmax(start, 1e-300);
    if (p > 0.5 && quantile(e, c, term, 0.0, p) >= e->value) return 0.0;
    for (int k = 0; k < 2000 && quantile(e, c, term, high, p) < e->value; k++) high *= 2.0;
    for (int k = 0; k < 100 && high - low > 1e-9 * high; k++) {
        const double middle = 0.5 * (low + high);
        if (quantile(e, c, term, middle, p) < e->value)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

static void judge(const estimate *e, const double c[TERMS], int term, double level,
                  schuler_allan_coefficient *out)
{
    const double tail = 0.5 * (1.0 - level);
    double zero[TERMS];
    memcpy(zero, c, sizeof(zero));
    zero[term] = 0.0;
    /* A scale to start the search from: where the normal distribution would put the limit. */
    const double reach = fabs(e->value) + fabs(quantile(e, zero, term, 0.0, tail));
    const double lower = invert(e, c, term, 1.0 - tail, reach);
    const double upper = invert(e, c, term, tail, reach);
    *out = (schuler_allan_coefficient){ .value = sqrt(fmax(0.0, e->value)),
                                        .lower = sqrt(lower),
                                        .upper = sqrt(upper) };
    if (lower <= 0.0 || e->value <= 0.0)
        out->state = SCHULER_ALLAN_NOT_SEEN;
    else if (out->upper > UNSURE_RATIO * out->lower)
        out->state = SCHULER_ALLAN_UNSURE;
    else
        out->state = SCHULER_ALLAN_FITTED;
}

static void find_worst(const schuler_allan_design *d, const double *sigma2, const double c[TERMS],
                       const double *w, schuler_allan_fit *out)
{
    for (int i = 0; i < d->count; i++) {
        double model = 0.0;
        for (int k = 0; k < TERMS; k++) model += c[k] * d->x[i][k];
        const double off = fabs(sigma2[i] - model) * sqrt(w[i]);
        if (!(off > out->worst)) continue;
        out->worst = off;
        out->worst_tau_s = d->tau_s[i];
    }
}

schuler_status schuler_allan_fit_terms(const schuler_allan_design *d, const double *sigma2,
                                       unsigned terms, double level, schuler_allan_fit *out)
{
    double w[POINTS], c[TERMS] = { 0 };
    allan_normal e;
    unsigned set = 0;
    for (int i = 0; i < d->count; i++)
        if (!(sigma2[i] >= 0.0) || !isfinite(sigma2[i])) return SCHULER_ERR_NUMERIC;
    *out = (schuler_allan_fit){ 0 };
    terms &= (1u << TERMS) - 1;

    /* The weights need the fit: begin with the degrees of freedom n/m, then iterate. */
    for (int i = 0; i < d->count; i++)
        w[i] = sigma2[i] > 0.0 ? (double)d->n / ((double)d->m[i] * sigma2[i] * sigma2[i]) : 0.0;
    for (int k = 0; k < 30; k++) {
        double before[TERMS], change = 0.0;
        memcpy(before, c, sizeof(before));
        allan_normal_equations(&e, d->x, sigma2, w, d->count);
        set = allan_solve_positive(&e, terms, c);
        if (!set) break;
        weigh(d, sigma2, c, w);
        for (int a = 0; a < TERMS; a++)
            change = fmax(change, fabs(c[a] - before[a]) / fmax(c[a], before[a] + 1e-300));
        if (change < 1e-9) break;
    }
    if (set) allan_normal_equations(&e, d->x, sigma2, w, d->count);
    for (int term = 0; term < TERMS; term++) {
        estimate own;
        schuler_allan_coefficient *const result = &out->term[term];
        if (!(terms >> term & 1)) continue;
        result->state = set ? SCHULER_ALLAN_NO_DATA : SCHULER_ALLAN_NOT_SEEN;
        if (set && estimate_of(d, &e, sigma2, w, set | 1u << term, term, &own))
            judge(&own, c, term, level, result);
    }
    find_worst(d, sigma2, c, w, out);
    return SCHULER_OK;
}

double schuler_allan_fit_at(const schuler_allan_design *d, const schuler_allan_fit *fit, int i)
{
    double sum = 0.0;
    for (int k = 0; k < TERMS; k++) sum += fit->term[k].value * fit->term[k].value * d->x[i][k];
    return sum;
}

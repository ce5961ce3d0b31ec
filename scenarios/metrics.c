/* SPDX-License-Identifier: MIT */
#include "scenarios/metrics.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int ascending(const void *a, const void *b)
{
    double x, y;
    memcpy(&x, a, sizeof(x));
    memcpy(&y, b, sizeof(y));
    return (x > y) - (x < y);
}

double schuler_percentile(const double *values, int n, double p, double *scratch)
{
    if (n < 1) return 0.0;
    memcpy(scratch, values, (size_t)n * sizeof(*scratch));
    qsort(scratch, (size_t)n, sizeof(*scratch), ascending);
    const double place = (n - 1) * fmin(fmax(p, 0.0), 1.0); /* counted from 0 */
    const int below = (int)place;
    const int above = below + 1 < n ? below + 1 : below;
    const double x = scratch[below], y = scratch[above];
    /* Equal neighbours first: exact, and no inf - inf. */
    return x == y ? x : x + (place - below) * (y - x);
}

/* A binomial distribution as weights relative to its mode: the ratio of neighbours is all it takes,
 * so nothing overflows, and what underflows far out is really nothing. */
struct binomial {
    int n, mode;
    double odds, total; /* p / (1 - p); sum of all weights, mode = 1 */
};

static double weight_above(const struct binomial *b, int k, double weight_k)
{
    return weight_k * b->odds * (double)(b->n - k) / (double)(k + 1);
}

static double weight_below(const struct binomial *b, int k, double weight_k)
{
    return weight_k * (double)k / (b->odds * (double)(b->n - k + 1));
}

/* Sum of the weights of first..last. */
static double weight_between(const struct binomial *b, int first, int last)
{
    double sum = 0.0, weight = 1.0;
    for (int k = b->mode; k <= last && weight > 0.0; weight = weight_above(b, k++, weight))
        if (k >= first) sum += weight;
    weight = b->mode > 0 ? weight_below(b, b->mode, 1.0) : 0.0;
    for (int k = b->mode - 1; k >= first && weight > 0.0; weight = weight_below(b, k--, weight))
        if (k <= last) sum += weight;
    return sum;
}

/* Largest rank with P(B < rank) <= tail; 0 when even P(B = 0) is more. */
static int rank_with_tail_below(const struct binomial *b, double tail)
{
    double left = weight_between(b, 0, b->mode), weight = 1.0; /* left: weight of 0..k */
    int k = b->mode;
    while (k >= 0 && left > tail * b->total) {
        left -= weight;
        weight = weight_below(b, k, weight);
        k--;
    }
    return k + 1; /* 0..k is within the tail, so B < k + 1 is */
}

/* Smallest rank with P(B >= rank) <= tail; n + 1 when even P(B = n) is more. */
static int rank_with_tail_above(const struct binomial *b, double tail)
{
    double left = weight_between(b, b->mode, b->n), weight = 1.0; /* left: weight of k..n */
    int k = b->mode;
    while (k <= b->n && left > tail * b->total) {
        left -= weight;
        weight = weight_above(b, k, weight);
        k++;
    }
    return k;
}

void schuler_order_interval(int n, double p, double confidence, int *lower, int *upper,
                            double *coverage)
{
    *lower = 0;
    *upper = (n > 0 ? n : 0) + 1;
    *coverage = 1.0;
    if (n < 1 || !(p > 0.0 && p < 1.0)) return;

    struct binomial b = { .n = n, .odds = p / (1.0 - p) };
    b.mode = (int)fmin((n + 1) * p, n);
    b.total = weight_between(&b, 0, n);

    const double tail = 0.5 * (1.0 - confidence);
    *lower = rank_with_tail_below(&b, tail);
    *upper = rank_with_tail_above(&b, tail);
    /* Half of the doubt is not enough for the near end of a lopsided percentile (the 95th of 59
     * runs), but all of it may be: then the other end takes what is left, and the coverage still
     * holds. */
    if (p > 0.5 && *upper == n + 1 && pow(p, n) <= 2.0 * tail) {
        *upper = n;
        *lower = rank_with_tail_below(&b, 2.0 * tail - pow(p, n));
    } else if (p < 0.5 && *lower == 0 && pow(1.0 - p, n) <= 2.0 * tail) {
        *lower = 1;
        *upper = rank_with_tail_above(&b, 2.0 * tail - pow(1.0 - p, n));
    }
    *coverage = weight_between(&b, *lower, *upper - 1) / b.total;
}

double schuler_slope_through_origin(const double *t_s, const double *r_m, size_t n)
{
    double tr = 0.0, tt = 0.0;
    for (size_t i = 0; i < n; i++) {
        tr += t_s[i] * r_m[i];
        tt += t_s[i] * t_s[i];
    }
    return tt > 0.0 ? tr / tt : 0.0;
}

double schuler_rms(const double *values, int n)
{
    /* Scaled by the largest: a diverged vertical channel reaches 1e200 m before it overflows. */
    double largest = 0.0, sum = 0.0;
    for (int i = 0; i < n; i++) largest = fmax(largest, fabs(values[i]));
    if (largest == 0.0 || isinf(largest)) return largest;
    for (int i = 0; i < n; i++) sum += (values[i] / largest) * (values[i] / largest);
    return largest * sqrt(sum / n);
}

schuler_status schuler_row_summarise(schuler_budget_row *row)
{
    if (row->runs < 1) {
        row->rms_end_m = row->rms_max_m = row->cep_mps = row->r95_mps = row->rms_slope_mps = 0.0;
        return SCHULER_OK;
    }
    double *scratch = malloc((size_t)row->runs * sizeof(*scratch));
    if (!scratch) return SCHULER_ERR_MEMORY;
    row->rms_end_m = schuler_rms(row->end_m, row->runs);
    row->rms_max_m = schuler_rms(row->max_m, row->runs);
    row->rms_slope_mps = schuler_rms(row->slope_mps, row->runs);
    row->cep_mps = schuler_percentile(row->slope_mps, row->runs, 0.50, scratch);
    row->r95_mps = schuler_percentile(row->slope_mps, row->runs, 0.95, scratch);
    free(scratch);
    return SCHULER_OK;
}

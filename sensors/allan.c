/* SPDX-License-Identifier: MIT */
#include "sensors/allan.h"
#include "sensors/chi_square.h"
#include <math.h>
#include <string.h>

/* Two of these hold eight sums side by side. The order of summation is part of the result, so it is
 * written down here and not left to the compiler. */
typedef double four __attribute__((vector_size(32)));

static four load(const double *x)
{
    four v;
    memcpy(&v, x, sizeof(v));
    return v;
}

static double total(const four sum[2])
{
    const four s = sum[0] + sum[1];
    return (s[0] + s[2]) + (s[1] + s[3]);
}

int schuler_allan_factors(int64_t n, int per_decade, int64_t *m, int max)
{
    int count = 0;
    for (int i = 0; count < max; i++) {
        const int64_t next = llround(pow(10.0, (double)i / per_decade));
        if (next > n / 3) break;
        if (count == 0 || next > m[count - 1]) m[count++] = next;
    }
    return count;
}

static double mean_of(const double *y, int64_t n)
{
    four sum[2] = { { 0 } };
    int64_t k = 0;
    for (; k + 8 <= n; k += 8) {
        sum[0] += load(y + k);
        sum[1] += load(y + k + 4);
    }
    double rest = 0.0;
    for (; k < n; k++) rest += y[k];
    return n > 0 ? (total(sum) + rest) / (double)n : 0.0;
}

double schuler_allan_phase(const double *y, int64_t n, double scale, double *phase)
{
    const double mean = mean_of(y, n);
    double sum = 0.0;
    for (int64_t k = 0; k < n; k++) {
        const double step = scale * (y[k] - mean);
        phase[k] = sum;
        sum += step;
    }
    phase[n] = sum;
    return scale * mean;
}

/* Sum of squared second differences for k in [first, past). */
static double add_differences(const double *x, int64_t m, int64_t first, int64_t past, four sum[2])
{
    int64_t k = first;
    for (; k + 8 <= past; k += 8)
        for (int j = 0; j < 2; j++) {
            const double *const at = x + k + 4 * j;
            const four middle = load(at + m);
            const four d = (load(at + 2 * m) - middle) - (middle - load(at));
            sum[j] += d * d;
        }
    double rest = 0.0;
    for (; k < past; k++) {
        const double d = (x[k + 2 * m] - x[k + m]) - (x[k + m] - x[k]);
        rest += d * d;
    }
    return rest;
}

/* Block by block, all factors on each, so that most of the phase comes from the cache. */
schuler_status schuler_allan_overlapping(const double *phase, int64_t n, double dt_s,
                                         const int64_t *m, int count, double *sigma2,
                                         const volatile int *stop)
{
    enum { BLOCK = 8192 };
    four sum[SCHULER_ALLAN_POINTS_MAX][2];
    double rest[SCHULER_ALLAN_POINTS_MAX] = { 0 };
    if (count < 0 || count > SCHULER_ALLAN_POINTS_MAX) return SCHULER_ERR_INPUT;
    for (int i = 0; i < count; i++)
        if (m[i] < 1 || m[i] > n / 2) return SCHULER_ERR_INPUT;
    memset(sum, 0, sizeof(sum));
    for (int64_t first = 0; first < n; first += BLOCK) {
        if (stop && *stop) return SCHULER_ERR_INTERRUPTED;
        for (int i = 0; i < count; i++) {
            const int64_t end = n - 2 * m[i] + 1;
            const int64_t past = first + BLOCK < end ? first + BLOCK : end;
            if (past > first) rest[i] += add_differences(phase, m[i], first, past, sum[i]);
        }
    }
    for (int i = 0; i < count; i++) {
        const double tau_s = (double)m[i] * dt_s, terms = (double)(n - 2 * m[i] + 1);
        sigma2[i] = (total(sum[i]) + rest[i]) / (2.0 * tau_s * tau_s * terms);
    }
    return SCHULER_OK;
}

double schuler_allan_plain(const double *phase, int64_t n, double dt_s, int64_t m)
{
    if (m < 1 || m > n / 2) return NAN;
    const double tau_s = (double)m * dt_s;
    double sum = 0.0;
    int64_t terms = 0;
    for (int64_t k = 0; k + 2 * m <= n; k += m, terms++) {
        const double d = phase[k + 2 * m] - 2.0 * phase[k + m] + phase[k];
        sum += d * d;
    }
    return sum / (2.0 * tau_s * tau_s * (double)terms);
}

schuler_noise_kind schuler_noise_of_slope(double slope)
{
    const double kind = nearbyint(slope) + 2.0;
    if (!(kind > 0.0)) return SCHULER_NOISE_QUANTIZATION;
    return kind < 3.0 ? (schuler_noise_kind)kind : SCHULER_NOISE_RANDOM_WALK;
}

double schuler_allan_dof(schuler_noise_kind kind, int64_t points, int64_t factor)
{
    const double N = (double)points, m = (double)factor;
    switch (kind) {
    case SCHULER_NOISE_QUANTIZATION:
        return (N + 1.0) * (N - 2.0 * m) / (2.0 * (N - m));
    case SCHULER_NOISE_WHITE:
        return (1.5 * (N - 1.0) / m - 2.0 * (N - 2.0) / N) * 4.0 * m * m / (4.0 * m * m + 5.0);
    case SCHULER_NOISE_FLICKER:
        return factor == 1 ? 2.0 * (N - 2.0) * (N - 2.0) / (2.3 * N - 4.9)
                           : 5.0 * N * N / (4.0 * m * (N + 3.0 * m));
    case SCHULER_NOISE_RANDOM_WALK:
    case SCHULER_NOISE_KINDS:
        break;
    }
    return (N - 2.0) / m * ((N - 1.0) * (N - 1.0) - 3.0 * m * (N - 1.0) + 4.0 * m * m) /
           ((N - 3.0) * (N - 3.0));
}

void schuler_allan_limits(double sigma2, double dof, double level, double limits[2])
{
    const double tail = 0.5 * (1.0 - level);
    limits[0] = sigma2 * dof / schuler_chi_square_quantile(dof, 1.0 - tail);
    limits[1] = sigma2 * dof / schuler_chi_square_quantile(dof, tail);
}

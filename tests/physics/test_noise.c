/* SPDX-License-Identifier: MIT */
/* Noise processes against closed forms, by the scalar build of the lane headers. */
#define SCHULER_LANES      1
#define SCHULER_ISA_SUFFIX test
#include "check.h"
#include "core/earth.h"
#include "sensors/markov.h"
#include "sensors/markov_integral.h"
#include "sensors/processes.h"
#include "sensors/quantizer.h"
#include "sensors/walk.h"
#include "sensors/white.h"
#include <stdlib.h>

enum { P = 0, TIME = 1, STEPS = 320, STRIDE = STEPS };

static schuler_lane_spec spec_of(uint64_t run, double value, double time_s)
{
    schuler_lane_spec spec = { .run = run };
    for (int i = 0; i < 3; i++) spec.value[P][i] = value, spec.value[TIME][i] = time_s;
    return spec;
}

static schuler_model_setup setup_of(schuler_instrument instrument, uint64_t seed, double dt_s,
                                    const schuler_lane_spec *spec)
{
    return (schuler_model_setup){
        .instrument = instrument, .seed = seed, .dt_s = dt_s, .lanes = 1, .specs = spec
    };
}

static schuler_model_block block_of(int first, double *out)
{
    return (schuler_model_block){
        .first = first, .n = SCHULER_BLOCK, .stride = STRIDE, .dt_s = 0.01, .out = out
    };
}

static void gauss_markov_series_meets_the_closed_form(void **state)
{
    (void)state;
    /* Just above the switch the closed form is used, just below the series; the function itself
     * changes by 3 dx/x = 3e-9 between the two points, taken off here. */
    const double x = 2e-2, above = markov_q22(x * (1.0 + 1e-12)),
                 below = markov_q22(x * (1.0 - 1e-12));
    CHECK_REL(above, below * (1.0 + 6e-12), 3e-12);
    /* q22 for sigma = 1, T = 100 s, 0.01 s from 2x - 3 + 4 e^-x - e^-2x in 60 decimal digits. A
     * table in circulation prints 6.66616666999917e-9: two digits short of the 7x^5/30 term, which
     * its own l22 has. */
    CHECK_REL(1e4 * markov_q22(1e-4), 6.6661666899991667e-9, 1e-13);
}

/* Sum of the increments of a process over STEPS steps of 0.01 s, axis 0. */
typedef double (*one_run)(uint64_t run, double value, double time_s);

static double summed(schuler_model_block *block, double out[3][STRIDE])
{
    double sum = 0.0;
    for (int k = 0; k < STEPS; k++) sum += out[0][k];
    (void)block;
    return sum;
}

static double white_run(uint64_t run, double N, double unused)
{
    const schuler_lane_spec spec = spec_of(run, N, unused);
    const schuler_model_setup s = setup_of(SCHULER_GYRO, 3, 0.01, &spec);
    static double out[3][STRIDE] __attribute__((aligned(64)));
    white_noise w;
    white_setup(&w, &s, P, 203);
    memset(out, 0, sizeof(out));
    for (int first = 0; first < STEPS; first += SCHULER_BLOCK) {
        const schuler_model_block b = block_of(first, &out[0][first]);
        white_add(&w, &b);
    }
    return summed(NULL, out);
}

static double gauss_markov_run(uint64_t run, double sigma, double time_s)
{
    const schuler_lane_spec spec = spec_of(run, sigma, time_s);
    const schuler_model_setup s = setup_of(SCHULER_GYRO, 3, 0.01, &spec);
    const schuler_markov_process p = { time_s, 1.0 };
    const schuler_markov_filter f = schuler_markov_filter_of(&p, 1, 0.01);
    static double out[3][STRIDE] __attribute__((aligned(64)));
    markov_noise m;
    markov_setup(&m, &s, P, 204);
    for (int i = 0; i < 3; i++) markov_setup_axis(&m, i, &f);
    memset(out, 0, sizeof(out));
    for (int first = 0; first < STEPS; first += SCHULER_BLOCK) {
        const schuler_model_block b = block_of(first, &out[0][first]);
        markov_add(&m, &b);
    }
    return summed(NULL, out);
}

static double walk_run(uint64_t run, double K, double unused)
{
    const schuler_lane_spec spec = spec_of(run, K, unused);
    const schuler_model_setup s = setup_of(SCHULER_GYRO, 3, 0.01, &spec);
    static double out[3][STRIDE] __attribute__((aligned(64)));
    random_walk w;
    walk_setup(&w, &s, P, 205);
    memset(out, 0, sizeof(out));
    for (int first = 0; first < STEPS; first += SCHULER_BLOCK) {
        const schuler_model_block b = block_of(first, &out[0][first]);
        walk_add(&w, &b);
    }
    return summed(NULL, out);
}

/* The walk's increments as the weights of its random numbers, against the covariance of the integrals of
 * a Wiener process over [i, i+1] and [j, j+1]: j >= i has i + 1/3 for i = j, else i + 1/2. */
static void the_walk_starts_at_zero_and_is_exact_from_there(void **state)
{
    enum { N = 40 };
    const schuler_lane_spec spec = spec_of(0, 1.0, 0.0);
    const schuler_model_setup s = setup_of(SCHULER_GYRO, 3, 1.0, &spec);
    random_walk w;
    (void)state;
    walk_setup(&w, &s, P, 205);
    for (int i = 0; i < N; i++)
        for (int j = i; j < N; j++) {
            double sum = 0.0;
            for (int e = 0; e <= i; e++) {
                const int at = e < WALK_SETTLING ? e : WALK_SETTLING - 1;
                sum += (e == i ? w.s[at] : w.g[at]) * (e == j ? w.s[at] : w.g[at]);
            }
            CHECK_REL(sum, i == j ? i + 1.0 / 3.0 : i + 0.5, 1e-14);
        }
}

/* The variance of a sum of normals, estimated from R runs, has relative sigma sqrt(2/R). */
static void check_variance(one_run process, double value, double time_s, double expected)
{
    enum { R = 8000 };
    double sum2 = 0.0;
    for (uint64_t run = 0; run < R; run++) {
        const double x = process(run, value, time_s);
        sum2 += x * x;
    }
    CHECK_REL(sum2 / R, expected, 5.0 * sqrt(2.0 / R));
}

static void sums_of_noise_have_the_variance_of_the_integral(void **state)
{
    (void)state;
    const double t = STEPS * 0.01;
    check_variance(white_run, 0.02, 0.0, 0.02 * 0.02 * t);
    /* Stationary Gauss-Markov: var = 2 sigma^2 T^2 (t/T - 1 + e^(-t/T)). Short, middling, long T.
     */
    for (double T = 0.05; T < 300.0; T *= 8.0)
        check_variance(gauss_markov_run, 0.5, T, 2.0 * 0.25 * T * T * (t / T + expm1(-t / T)));
    check_variance(walk_run, 0.3, 0.0, 0.09 * t * t * t / 3.0);
}

static void quantizer_loses_nothing(void **state)
{
    (void)state;
    const double lsb = 0.037;
    double in_sum = 0.0, out_sum = 0.0;
    static double out[3][STRIDE] __attribute__((aligned(64)));
    const schuler_lane_spec spec = spec_of(9, lsb, 0.0);
    const schuler_model_setup s = setup_of(SCHULER_ACCEL, 3, 0.01, &spec);
    quantizer q;
    quantizer_setup(&q, &s, P, 106);
    const double rest_at_start = q.rest[0];
    for (int first = 0; first < STEPS; first += SCHULER_BLOCK) {
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < SCHULER_BLOCK; k++)
                out[i][first + k] = 0.05 * sin(0.1 * (first + k));
        for (int k = 0; k < SCHULER_BLOCK; k++) in_sum += out[0][first + k];
        const schuler_model_block b = block_of(first, &out[0][first]);
        quantizer_apply(&q, &b);
        for (int k = 0; k < SCHULER_BLOCK; k++) {
            const double counts = out[0][first + k] / lsb;
            CHECK_NEAR(counts, round(counts), 1e-12);
            out_sum += out[0][first + k];
        }
        assert_true(fabs(q.rest[0]) <= 0.5 * lsb * (1.0 + 1e-12));
        CHECK_NEAR(out_sum, in_sum + rest_at_start - q.rest[0], 1e-13);
    }
}

/* When increments exceed a count at random, the remainder is uniform: sigma lsb/sqrt(12) (B14). */
static void remainder_is_uniform_over_runs(void **state)
{
    (void)state;
    enum { R = 20000 };
    double sum2 = 0.0;
    for (uint64_t run = 0; run < R; run++) {
        const schuler_lane_spec spec = spec_of(run, 1.0, 0.0);
        const schuler_model_setup s = setup_of(SCHULER_GYRO, 3, 0.01, &spec);
        quantizer q;
        quantizer_setup(&q, &s, P, 206);
        sum2 += q.rest[0] * q.rest[0];
    }
    /* variance of x^2 for a uniform in (-1/2, 1/2): 1/80 - 1/144 */
    CHECK_NEAR(sum2 / R, 1.0 / 12.0, 5.0 * sqrt((1.0 / 80.0 - 1.0 / 144.0) / R));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gauss_markov_series_meets_the_closed_form),
        cmocka_unit_test(the_walk_starts_at_zero_and_is_exact_from_there),
        cmocka_unit_test(sums_of_noise_have_the_variance_of_the_integral),
        cmocka_unit_test(quantizer_loses_nothing),
        cmocka_unit_test(remainder_is_uniform_over_runs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

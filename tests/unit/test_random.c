/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/random.h"
#include <Random123/threefry.h>

/* Published: Random123 1.14, tests/kat_vectors, lines "threefry2x64 20": counter, key, result. */
static void threefry_gives_random123s_known_answers(void **state)
{
    (void)state;
    static const uint64_t kat[][6] = {
        { 0, 0, 0, 0, 0xc2b6e3a8c2c69865ULL, 0x6f81ed42f350084dULL },
        { ~0ULL, ~0ULL, ~0ULL, ~0ULL, 0xe02cb7c4d95d277aULL, 0xd06633d0893b8b68ULL },
        { 0x243f6a8885a308d3ULL, 0x13198a2e03707344ULL, 0xa4093822299f31d0ULL,
          0x082efa98ec4e6c89ULL, 0x263c7d30bb0f0af1ULL, 0x56be8361d3311526ULL },
    };
    for (size_t i = 0; i < sizeof(kat) / sizeof(kat[0]); i++) {
        uint64_t out[2];
        schuler_threefry2x64(kat[i], kat[i] + 2, out);
        assert_int_equal(out[0], kat[i][4]);
        assert_int_equal(out[1], kat[i][5]);
    }
}

/* Independent: Random123's own implementation, 20 000 counters and keys. */
static void threefry_equals_random123(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 20000; i++) {
        const threefry2x64_ctr_t c = { { i * 0x9E3779B97F4A7C15ULL, ~i } };
        const threefry2x64_key_t k = { { i << 40, i * i } };
        const threefry2x64_ctr_t r = threefry2x64_R(20, c, k);
        uint64_t out[2];
        schuler_threefry2x64(c.v, k.v, out);
        assert_int_equal(out[0], r.v[0]);
        assert_int_equal(out[1], r.v[1]);
    }
}

/* Moments of N numbers: the k-th sample moment of a standard normal has variance (mu_2k -
 * mu_k^2)/N. Five standard errors: a sound generator fails one check in two million. */
static void normals_have_normal_moments(void **state)
{
    (void)state;
    enum { N = 1 << 21 };
    double sum[9] = { 0 }, pair = 0.0, next = 0.0, previous = 0.0;
    for (uint64_t i = 0; i < N; i++) {
        const double x =
            schuler_stream_normal((schuler_stream){ 7, 3, 203, 1, SCHULER_USE_WHITE }, i);
        double p = 1.0;
        for (int k = 1; k <= 8; k++) sum[k] += p *= x;
        if (i % 2)
            pair += x * previous;
        else if (i)
            next += x * previous;
        previous = x;
    }
    const double mu[17] = { 1, 0, 1, 0, 3, 0, 15, 0, 105, 0, 945, 0, 10395, 0, 135135, 0, 2027025 };
    for (int k = 1; k <= 8; k++)
        CHECK_NEAR(sum[k] / N, mu[k], 5.0 * sqrt((mu[2 * k] - mu[k] * mu[k]) / N));
    CHECK_NEAR(pair / (N / 2), 0.0, 5.0 / sqrt(N / 2)); /* the two numbers of one word */
    CHECK_NEAR(next / (N / 2), 0.0, 5.0 / sqrt(N / 2)); /* neighbouring words          */
}

/* Equal-probability cells of the normal distribution: chi-squared of 15 degrees of freedom has mean
 * 15 and sigma sqrt(30); five of those above is 42.4. */
static void normals_fill_equal_cells_equally(void **state)
{
    (void)state;
    enum { N = 1 << 20, CELLS = 16 };
    long count[CELLS] = { 0 };
    for (uint64_t i = 0; i < N; i++) {
        const double x =
            schuler_stream_normal((schuler_stream){ 1, 0, 103, 2, SCHULER_USE_SLOW }, i);
        int cell = (int)(0.5 * erfc(-x / sqrt(2.0)) * CELLS);
        if (cell >= CELLS) cell = CELLS - 1;
        count[cell]++;
    }
    double chi2 = 0.0;
    for (int i = 0; i < CELLS; i++) {
        const double expected = (double)N / CELLS, d = (double)count[i] - expected;
        chi2 += d * d / expected;
    }
    CHECK_NEAR(chi2, 15.0, 5.0 * sqrt(30.0));
}

/* Streams that differ in one argument only must be independent: correlations of N pairs have sigma
 * 1/sqrt(N). */
static void neighbouring_streams_are_independent(void **state)
{
    (void)state;
    enum { N = 1 << 17 };
    const schuler_stream base = { 42, 5, 200, 0, SCHULER_USE_WHITE };
    const schuler_stream others[] = {
        { 43, 5, 200, 0, SCHULER_USE_WHITE }, { 42, 6, 200, 0, SCHULER_USE_WHITE },
        { 42, 5, 201, 0, SCHULER_USE_WHITE }, { 42, 5, 200, 1, SCHULER_USE_WHITE },
        { 42, 5, 200, 0, SCHULER_USE_SLOW },
    };
    for (size_t k = 0; k < sizeof(others) / sizeof(others[0]); k++) {
        double sum = 0.0;
        for (uint64_t i = 0; i < N; i++)
            sum += schuler_stream_normal(base, i) * schuler_stream_normal(others[k], i);
        CHECK_NEAR(sum / N, 0.0, 5.0 / sqrt(N));
    }
}

static void uniforms_are_uniform(void **state)
{
    (void)state;
    enum { N = 1 << 20 };
    double sum = 0.0, sum2 = 0.0;
    for (uint64_t i = 0; i < N; i++) {
        const double x =
            schuler_stream_uniform((schuler_stream){ 9, 1, 2, 0, SCHULER_USE_DRAW }, i);
        assert_true(x > -1.0 && x < 1.0);
        sum += x;
        sum2 += x * x;
    }
    CHECK_NEAR(sum / N, 0.0, 5.0 * sqrt(1.0 / 3.0 / N));
    CHECK_NEAR(sum2 / N, 1.0 / 3.0, 5.0 * sqrt((1.0 / 5.0 - 1.0 / 9.0) / N));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threefry_gives_random123s_known_answers),
        cmocka_unit_test(threefry_equals_random123),
        cmocka_unit_test(normals_have_normal_moments),
        cmocka_unit_test(normals_fill_equal_cells_equally),
        cmocka_unit_test(neighbouring_streams_are_independent),
        cmocka_unit_test(uniforms_are_uniform),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The estimators against published data. Numbers marked C are of W. J. Riley, NIST SP 1065 (the NBS
 * set of 9 and the set of 1000 numbers), recomputed with 40 digits. */
#include "check.h"
#include "sensors/allan.h"
#include <stdlib.h>
#include <string.h>

static double overlapping(const double *phase, int64_t n, int64_t m)
{
    double sigma2 = -1.0;
    assert_int_equal(schuler_allan_overlapping(phase, n, 1.0, &m, 1, &sigma2, NULL), SCHULER_OK);
    return sqrt(sigma2);
}

static void the_nbs_set_of_nine_is_reproduced(void **state) /* C9 */
{
    static const double y[9] = { 892, 809, 823, 798, 671, 644, 883, 903, 677 };
    double phase[10];
    (void)state;
    schuler_allan_phase(y, 9, 1.0, phase);
    CHECK_REL(overlapping(phase, 9, 1), 91.2294497407498, 1e-12);
    CHECK_REL(sqrt(schuler_allan_plain(phase, 9, 1.0, 1)), 91.2294497407498, 1e-12);
    CHECK_REL(sqrt(schuler_allan_plain(phase, 9, 1.0, 2)), 115.808210704883, 1e-12);
    CHECK_REL(overlapping(phase, 9, 2), 85.952869837681, 1e-12);
}

static void the_set_of_thousand_is_reproduced(void **state) /* C10, C10b */
{
    static const int64_t m[3] = { 1, 10, 100 };
    static const double plain[3] = { 0.292231878106759, 0.0996573606317479, 0.0389780433080265 };
    static const double all[3] = { 0.292231878106759, 0.0915995342011865, 0.0324134302605698 };
    double y[1001], sigma2[3];
    int64_t number = 1234567890;
    (void)state;
    for (int i = 0; i < 1000; i++) {
        y[i] = (double)number / 2147483647.0;
        number = 16807 * number % 2147483647;
    }
    CHECK_REL(schuler_allan_phase(y, 1000, 1.0, y), 0.489774462859507, 1e-13); /* in place */
    assert_int_equal(schuler_allan_overlapping(y, 1000, 1.0, m, 3, sigma2, NULL), SCHULER_OK);
    for (int i = 0; i < 3; i++) {
        CHECK_REL(sqrt(schuler_allan_plain(y, 1000, 1.0, m[i])), plain[i], 1e-12);
        CHECK_REL(sqrt(sigma2[i]), all[i], 1e-12);
    }
}

static void degrees_of_freedom_are_those_of_the_tables(void **state) /* C11 */
{
    (void)state;
    CHECK_REL(schuler_allan_dof(SCHULER_NOISE_WHITE, 1001, 10), 146.176786176786, 1e-13);
    CHECK_REL(schuler_allan_dof(SCHULER_NOISE_FLICKER, 1001, 10), 121.484117361785, 1e-13);
    CHECK_REL(schuler_allan_dof(SCHULER_NOISE_RANDOM_WALK, 1001, 10), 97.3318982654688, 1e-13);
    /* (N + 1)(N - 2m)/(2 (N - m)) and 2 (N - 2)^2/(2.3 N - 4.9) */
    CHECK_REL(schuler_allan_dof(SCHULER_NOISE_QUANTIZATION, 1001, 10), 1002.0 * 981.0 / 1982.0,
              1e-14);
    CHECK_REL(schuler_allan_dof(SCHULER_NOISE_FLICKER, 1001, 1), 2.0 * 999.0 * 999.0 / 2297.4,
              1e-14);
    for (int kind = 0; kind < SCHULER_NOISE_KINDS;
         kind++) /* at the longest tau there is one still */
        assert_true(schuler_allan_dof((schuler_noise_kind)kind, 3001, 1000) >= 1.0);
}

/* A value and its mean do not enter; a ramp R t gives R^2 tau^2/2 whatever tau; the constant rate of
 * 1e6 would cost nine digits if it were left in. */
static void a_ramp_has_its_closed_form_and_a_constant_is_nothing(void **state)
{
    enum { N = 20000 };
    double *const phase = malloc((N + 1) * sizeof(double));
    (void)state;
    assert_non_null(phase);
    for (int k = 0; k < N; k++) phase[k] = 1e6 + 2e-3 * (k + 0.5);
    CHECK_REL(schuler_allan_phase(phase, N, 0.5, phase), 0.5 * (1e6 + 2e-3 * 0.5 * N), 1e-14);
    for (int64_t m = 1; m <= N / 2; m = 3 * m + 1)
        CHECK_REL(overlapping(phase, N, m), 1e-3 * (double)m / sqrt(2.0), 1e-6);
    for (int k = 0; k < N; k++) phase[k] = 123.456;
    schuler_allan_phase(phase, N, 1.0, phase);
    CHECK_NEAR(overlapping(phase, N, 100), 0.0, 1e-9);
    free(phase);
}

/* Blocks and groups of eight end anywhere: against the sum as it is defined. Both sums have fewer than
 * n terms, all positive: n epsilon at most, in practice its root. */
static void every_term_is_counted_once(void **state)
{
    static const int64_t lengths[] = { 3, 8, 9, 17, 8191, 8192, 8193, 16385, 24577 };
    (void)state;
    for (size_t l = 0; l < sizeof lengths / sizeof lengths[0]; l++) {
        const int64_t n = lengths[l];
        double *const phase = malloc((size_t)(n + 1) * sizeof(double));
        uint64_t x = 1;
        assert_non_null(phase);
        for (int64_t k = 0; k <= n; k++) {
            x = x * 6364136223846793005u + 1442695040888963407u;
            phase[k] = (double)(x >> 40);
        }
        for (int64_t m = 1; m <= n / 2; m = 2 * m + 1) {
            double sum = 0.0;
            for (int64_t k = 0; k + 2 * m <= n; k++) {
                const double d = phase[k + 2 * m] - 2.0 * phase[k + m] + phase[k];
                sum += d * d;
            }
            sum /= 2.0 * (double)(m * m) * (double)(n - 2 * m + 1);
            CHECK_REL(overlapping(phase, n, m), sqrt(sum), 1e-12);
        }
        free(phase);
    }
}

static void the_grid_has_ten_to_a_decade_and_ends_at_a_third(void **state)
{
    int64_t m[SCHULER_ALLAN_POINTS_MAX];
    (void)state;
    assert_int_equal(schuler_allan_factors(2, 10, m, SCHULER_ALLAN_POINTS_MAX), 0);
    assert_int_equal(schuler_allan_factors(3, 10, m, SCHULER_ALLAN_POINTS_MAX), 1);
    const int count = schuler_allan_factors(8640000, 10, m, SCHULER_ALLAN_POINTS_MAX);
    assert_int_equal(m[0], 1);
    assert_true(m[count - 1] <= 2880000 && (double)m[count - 1] > 2880000 / 1.26);
    for (int i = 1; i < count; i++) assert_true(m[i] > m[i - 1]);
    for (int i = 20; i < count; i++) CHECK_REL((double)m[i], (double)m[i - 10] * 10.0, 0.03);
    assert_int_equal(schuler_allan_factors(8640000, 10, m, 5), 5);
    /* The longest that fits in memory at all still has room. */
    assert_true(schuler_allan_factors((int64_t)1 << 40, 10, m, SCHULER_ALLAN_POINTS_MAX) <
                SCHULER_ALLAN_POINTS_MAX);
}

static void limits_hold_the_variance_between_them(void **state)
{
    double limits[2];
    (void)state;
    schuler_allan_limits(4.0, 2.0, 0.95, limits); /* two degrees of freedom: exponential */
    CHECK_REL(limits[0], 4.0 * 2.0 / (-2.0 * log(0.025)), 1e-9);
    CHECK_REL(limits[1], 4.0 * 2.0 / (-2.0 * log(0.975)), 1e-9);
    assert_int_equal(schuler_noise_of_slope(-1.9), SCHULER_NOISE_QUANTIZATION);
    assert_int_equal(schuler_noise_of_slope(-9.0), SCHULER_NOISE_QUANTIZATION);
    assert_int_equal(schuler_noise_of_slope(-1.2), SCHULER_NOISE_WHITE);
    assert_int_equal(schuler_noise_of_slope(0.3), SCHULER_NOISE_FLICKER);
    assert_int_equal(schuler_noise_of_slope(0.8), SCHULER_NOISE_RANDOM_WALK);
    assert_int_equal(schuler_noise_of_slope(2.0), SCHULER_NOISE_RANDOM_WALK);
}

static void what_cannot_be_is_refused(void **state)
{
    static const double phase[5] = { 0, 1, 0, 1, 0 };
    const volatile int stop = 1;
    double sigma2 = 7.0;
    int64_t m = 0;
    (void)state;
    assert_int_equal(schuler_allan_overlapping(phase, 4, 1.0, &m, 1, &sigma2, NULL),
                     SCHULER_ERR_INPUT);
    m = 3;
    assert_int_equal(schuler_allan_overlapping(phase, 4, 1.0, &m, 1, &sigma2, NULL),
                     SCHULER_ERR_INPUT);
    m = 1;
    assert_int_equal(schuler_allan_overlapping(phase, 4, 1.0, &m, 1, &sigma2, &stop),
                     SCHULER_ERR_INTERRUPTED);
    CHECK_NEAR(sigma2, 7.0, 0.0);
    assert_true(isnan(schuler_allan_plain(phase, 4, 1.0, 0)));
    assert_true(isnan(schuler_allan_plain(phase, 4, 1.0, 3)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nbs_set_of_nine_is_reproduced),
        cmocka_unit_test(the_set_of_thousand_is_reproduced),
        cmocka_unit_test(degrees_of_freedom_are_those_of_the_tables),
        cmocka_unit_test(a_ramp_has_its_closed_form_and_a_constant_is_nothing),
        cmocka_unit_test(every_term_is_counted_once),
        cmocka_unit_test(the_grid_has_ten_to_a_decade_and_ends_at_a_third),
        cmocka_unit_test(limits_hold_the_variance_between_them),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

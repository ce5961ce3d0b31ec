/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/random.h"
#include "scenarios/metrics.h"
#include <stdlib.h>

static schuler_judgement judge(schuler_statistic statistic, double limit, schuler_budget_row *row)
{
    const schuler_requirement r = { .given = true, .drift_mps = limit, .statistic = statistic };
    schuler_judgement out = { 0 };
    assert_int_equal(schuler_row_summarise(row), SCHULER_OK);
    assert_int_equal(schuler_row_required(row, &r), SCHULER_OK);
    assert_int_equal(schuler_judge(&r, row, &out), SCHULER_OK);
    return out;
}

/* A row whose slopes are given. Ends and maxima are not looked at by the judge. */
static schuler_budget_row row_of(double *slopes, int runs)
{
    return (schuler_budget_row){ .drawn = true,
                                 .runs = runs,
                                 .slope_mps = slopes,
                                 .drift_mps = slopes,
                                 .end_m = slopes,
                                 .max_m = slopes };
}

static void cep_of_ten_runs_lies_between_the_second_and_the_ninth(void **state)
{
    (void)state;
    double slopes[] = { 0.42, 0.77, 0.31, 1.10, 0.58, 0.93, 0.66, 0.49, 0.85, 1.35 };
    schuler_budget_row row = row_of(slopes, 10);
    const schuler_judgement pass = judge(SCHULER_STAT_CEP, 1.10, &row);
    CHECK_NEAR(pass.lower_mps, 0.42, 0.0); /* F10b */
    CHECK_NEAR(pass.upper_mps, 1.10, 0.0);
    CHECK_REL(pass.value_mps, 0.715, 1e-15);
    CHECK_NEAR(pass.confidence, 0.95, 0.0);
    assert_int_equal(pass.verdict, SCHULER_VERDICT_PASS); /* upper bound = limit still passes */
    assert_int_equal(judge(SCHULER_STAT_CEP, 1.09, &row).verdict, SCHULER_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(SCHULER_STAT_CEP, 0.42, &row).verdict, SCHULER_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(SCHULER_STAT_CEP, 0.41, &row).verdict, SCHULER_VERDICT_FAIL);
}

static void nine_runs_give_no_verdict(void **state)
{
    (void)state;
    double slopes[9] = { 1, 1, 1, 1, 1, 1, 1, 1, 1 };
    for (int statistic = SCHULER_STAT_CEP; statistic <= SCHULER_STAT_RMS; statistic++) {
        schuler_budget_row row = row_of(slopes, 9);
        const schuler_judgement out = judge((schuler_statistic)statistic, 100.0, &row);
        assert_int_equal(out.verdict, SCHULER_VERDICT_INCONCLUSIVE);
        CHECK_NEAR(out.value_mps, 1.0, 0.0);
        CHECK_NEAR(out.lower_mps, 0.0, 0.0);
        assert_true(out.upper_mps == HUGE_VAL);
    }
}

static void r95_needs_fifty_nine_runs(void **state)
{
    (void)state;
    double slopes[59];
    for (int i = 0; i < 59; i++) slopes[i] = 59 - i; /* 59 ... 1 */
    schuler_budget_row few = row_of(slopes + 1, 58);
    assert_true(judge(SCHULER_STAT_R95, 1000.0, &few).upper_mps == HUGE_VAL);
    schuler_budget_row enough = row_of(slopes, 59);
    const schuler_judgement out = judge(SCHULER_STAT_R95, 59.0, &enough);
    CHECK_NEAR(out.upper_mps, 59.0, 0.0);
    CHECK_NEAR(out.value_mps, 56.1, 1e-13); /* 1 + 0.95 * 58 */
    assert_int_equal(out.verdict, SCHULER_VERDICT_PASS);
}

/* n = 400 slopes at the quantiles of the circular normal: the rms is sqrt(2) and its relative
 * standard error 1/sqrt(4n) = 2.5 % (F9), so the bounds should be near 1 -+ 1.96 * 0.025. A 2.5 %
 * point of 2000 resamples has a standard error of sqrt(0.025 * 0.975/2000)/phi(1.96) = 0.06 of that
 * sigma, and the far tail missing from the sample (its last quantile is 1 - 1/800) lowers sigma by
 * up to 4 %: 0.3 sigma is four standard errors and the 4 % of 1.96. */
static void bootstrap_of_the_rms_agrees_with_its_standard_error(void **state)
{
    (void)state;
    enum { N = 400 };
    double slopes[N];
    for (int i = 0; i < N; i++) slopes[i] = sqrt(-2.0 * log1p(-(i + 0.5) / N));
    schuler_budget_row row = row_of(slopes, N);
    const schuler_judgement out = judge(SCHULER_STAT_RMS, 2.0, &row);
    const double sigma = out.value_mps / sqrt(4.0 * N);
    CHECK_NEAR(out.value_mps, sqrt(2.0), 0.01);
    CHECK_NEAR(out.lower_mps, out.value_mps - 1.96 * sigma, 0.3 * sigma);
    CHECK_NEAR(out.upper_mps, out.value_mps + 1.96 * sigma, 0.3 * sigma);
    assert_int_equal(out.verdict, SCHULER_VERDICT_PASS);
    const schuler_judgement again = judge(SCHULER_STAT_RMS, 2.0, &row);
    assert_memory_equal(&again.lower_mps, &out.lower_mps, sizeof(double));
    assert_memory_equal(&again.upper_mps, &out.upper_mps, sizeof(double));
}

static void without_draws_the_value_is_its_own_bound(void **state)
{
    (void)state;
    double slopes[] = { 0.7 };
    schuler_budget_row row = row_of(slopes, 1);
    row.drawn = false;
    const schuler_judgement pass = judge(SCHULER_STAT_CEP, 0.7, &row);
    CHECK_NEAR(pass.lower_mps, 0.7, 0.0);
    CHECK_NEAR(pass.upper_mps, 0.7, 0.0);
    assert_int_equal(pass.verdict, SCHULER_VERDICT_PASS);
    assert_int_equal(judge(SCHULER_STAT_RMS, 0.69, &row).verdict, SCHULER_VERDICT_FAIL);
}

static void no_requirement_is_no_verdict(void **state)
{
    (void)state;
    double slopes[] = { 0.7 };
    const schuler_requirement none = { .given = false };
    const schuler_budget_row row = row_of(slopes, 1);
    schuler_judgement out;
    assert_int_equal(schuler_judge(&none, &row, &out), SCHULER_OK);
    assert_int_equal(out.verdict, SCHULER_VERDICT_NONE);
    CHECK_NEAR(out.value_mps, 0.0, 0.0);
}

/* 400 experiments of 100 runs with circular normal drifts: how often the 95 % limits hold the true statistic.
 * Order statistics of 100 runs cover 96.5 % for the median by construction (reference, F7b), and no less than
 * they promise for the 95th percentile; the sampling error of a share is 1.1 %, two of them either way. */
static void limits_hold_the_truth_as_often_as_they_say(void **state)
{
    (void)state;
    enum { EXPERIMENTS = 400, RUNS = 100 };
    const struct {
        schuler_statistic statistic;
        double truth;
    } rows[] = { { SCHULER_STAT_CEP, 1.17741002251547 },
                 { SCHULER_STAT_R95, 2.44774683068082 },
                 { SCHULER_STAT_RMS, 1.4142135623731 } };
    for (size_t s = 0; s < sizeof rows / sizeof rows[0]; s++) {
        int covered = 0;
        for (int e = 0; e < EXPERIMENTS; e++) {
            double slopes[RUNS];
            for (int i = 0; i < RUNS; i++) {
                const uint64_t run = (uint64_t)(e * RUNS + i);
                const schuler_stream north = { 17, run, 1, 0, SCHULER_USE_DRAW };
                const schuler_stream east = { 17, run, 2, 0, SCHULER_USE_DRAW };
                slopes[i] = hypot(schuler_stream_normal(north, 0), schuler_stream_normal(east, 0));
            }
            schuler_budget_row row = row_of(slopes, RUNS);
            const schuler_judgement j = judge(rows[s].statistic, 1.0, &row);
            covered += j.lower_mps <= rows[s].truth && rows[s].truth <= j.upper_mps;
        }
        print_message("statistic %d: %.2f %%\n", (int)rows[s].statistic,
                      100.0 * covered / EXPERIMENTS);
        assert_in_range(covered, 0.93 * EXPERIMENTS, 0.987 * EXPERIMENTS);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cep_of_ten_runs_lies_between_the_second_and_the_ninth),
        cmocka_unit_test(nine_runs_give_no_verdict),
        cmocka_unit_test(r95_needs_fifty_nine_runs),
        cmocka_unit_test(bootstrap_of_the_rms_agrees_with_its_standard_error),
        cmocka_unit_test(without_draws_the_value_is_its_own_bound),
        cmocka_unit_test(no_requirement_is_no_verdict),
        cmocka_unit_test(limits_hold_the_truth_as_often_as_they_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

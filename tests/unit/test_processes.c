/* SPDX-License-Identifier: MIT */
/* Closed forms of the noise processes. Numbers marked C are independent: computed with 40 digits
 * from the definitions; tolerance 1e-12 relative, or half of the last digit that is given. */
#include "check.h"
#include "core/earth.h"
#include "sensors/chi_square.h"
#include "sensors/processes.h"

static const double DEG = SCHULER_RAD_PER_DEG;

static void the_flicker_floor_is_the_root_of_two_ln_two_over_pi(void **state)
{
    (void)state;
    CHECK_NEAR(SCHULER_FLICKER_FLOOR, 0.66428247026796, 1e-14);
    CHECK_REL(sqrt(schuler_process_flicker(2.0, 7.0)), 2.0 * 0.66428247026796, 1e-13);
}

static void terms_add_in_variance(void **state) /* C2 */
{
    static const double tau_s[] = { 1.0, 100.0, 3600.0 };
    static const double degph[] = { 0.549919114189002, 0.0190281161139809, 0.00467824183580747 };
    (void)state;
    for (int i = 0; i < 3; i++) {
        const double t = tau_s[i];
        const double sum = schuler_process_white(0.003 * DEG / 60.0, t) +
                           schuler_process_flicker(0.005 * DEG / 3600.0, t) +
                           schuler_process_random_walk(0.002 * DEG / 3600.0 / 60.0, t) +
                           schuler_process_quantization(0.3 * DEG / 3600.0, t) +
                           schuler_process_ramp(0.001 * DEG / 3600.0 / 3600.0, t);
        CHECK_REL(sqrt(sum) / (DEG / 3600.0), degph[i], 1e-12);
    }
}

static void a_gauss_markov_process_peaks_at_its_time(void **state) /* C3, C3b */
{
    (void)state;
    const double peak_s = 1.89261783292502;
    CHECK_REL(sqrt(schuler_process_gauss_markov(1.0, 1.0, peak_s)), 0.617364283144441, 1e-12);
    CHECK_REL(sqrt(schuler_process_gauss_markov(1.0 / sqrt(2.0), 1.0, peak_s)), 0.436542471073806,
              1e-12); /* q_c = sigma sqrt(2/T) = 1 */
    assert_true(schuler_process_gauss_markov(1, 1, peak_s) >
                schuler_process_gauss_markov(1, 1, peak_s * 1.001));
    assert_true(schuler_process_gauss_markov(1, 1, peak_s) >
                schuler_process_gauss_markov(1, 1, peak_s / 1.001));
    CHECK_REL(sqrt(schuler_process_gauss_markov(1, 100, 1)), 0.0813443247505365, 1e-12);
    CHECK_REL(sqrt(schuler_process_gauss_markov(1, 100, 100)), 0.579812453685807, 1e-12);
    CHECK_REL(sqrt(schuler_process_gauss_markov(1, 100, 1000)), 0.412312764750958, 1e-12);
}

/* For tau far below T the process is a random walk of K^2 = 2 sigma^2/T, less by 3/4 tau/T. */
static void a_slow_gauss_markov_process_keeps_its_digits(void **state)
{
    (void)state;
    for (double tau_s = 1e-8; tau_s < 1e-4; tau_s *= 10.0)
        CHECK_REL(schuler_process_gauss_markov(3.0, 1.0, tau_s),
                  18.0 * tau_s / 3.0 * (1.0 - 0.75 * tau_s), 2.0 * tau_s * tau_s + 1e-13);
}

/* Variance of the integral over t, 2 times the integral of (t - s) R(s), by Simpson's rule: with 4000
 * pieces up to t = 6 T its error is below (t/4000)^4/180 t, 3e-13. */
static double integral_variance(double t_s)
{
    enum { PIECES = 4000 };
    double sum = 0.0;
    for (int i = 0; i <= PIECES; i++) {
        const double s = t_s * i / PIECES, R = exp(-s) * (1.0 + s);
        sum += (t_s - s) * R * (i == 0 || i == PIECES ? 1.0 : i % 2 ? 4.0 : 2.0);
    }
    return 2.0 * sum * t_s / PIECES / 3.0;
}

static void a_second_order_gauss_markov_process_has_its_correlation(void **state)
{
    (void)state;
    for (double tau_s = 0.05; tau_s < 3.0; tau_s *= 1.3) {
        const double variance = (4.0 * integral_variance(tau_s) - integral_variance(2.0 * tau_s)) /
                                (2.0 * tau_s * tau_s);
        CHECK_NEAR(schuler_process_gauss_markov_2(1.0, 1.0, tau_s), variance,
                   5e-12 / (tau_s * tau_s));
        CHECK_REL(schuler_process_gauss_markov_2(2.0, 5.0, 5.0 * tau_s), 4.0 * variance,
                  1e-11 / (tau_s * tau_s) / variance);
    }
    /* Short times see a ramp of rate sigma/T; the two forms meet at tau = T. */
    CHECK_REL(schuler_process_gauss_markov_2(1.0, 1.0, 1e-4), 0.5e-8, 2e-4);
    CHECK_REL(schuler_process_gauss_markov_2(1.0, 1.0, 1.0 + 1e-9),
              schuler_process_gauss_markov_2(1.0, 1.0, 1.0 - 1e-9), 5e-9);
}

static void recursions_have_their_covariances(void **state) /* C4, C4b, C5 */
{
    (void)state;
    const schuler_process_step g = schuler_gauss_markov_step(1.0, 100.0, 0.01);
    CHECK_REL(g.phi, 0.999900004999833, 1e-14);
    CHECK_REL(sqrt(g.q11), 0.0141414285464117, 1e-12);
    CHECK_REL(g.q12, 9.99900005833083e-7, 1e-12);
    CHECK_REL(g.q22, 6.66616668999917e-9, 1e-12);
    CHECK_REL(g.l11, 0.0141414285464117, 1e-12);
    CHECK_REL(g.l21, 7.07071426731357e-5, 1e-12);
    CHECK_REL(g.l22, 4.08248290259739e-5,
              1e-11); /* a difference, four times smaller than its parts */
    CHECK_REL(g.gain, 0.00999950001666625, 1e-12);
    const schuler_process_step k = schuler_random_walk_step(1.0, 0.01);
    CHECK_REL(k.l11, 0.1, 1e-14);
    CHECK_REL(k.l21, 0.0005, 1e-14);
    CHECK_REL(k.l22, 0.000288675134594813, 1e-13);
    CHECK_REL(k.q22, k.l21 * k.l21 + k.l22 * k.l22, 1e-14);
    CHECK_REL(k.q12, k.l11 * k.l21, 1e-14);
}

static void the_flicker_bank_keeps_to_the_floor(void **state) /* C6, C6b, C6c */
{
    static const double decade[] = { 0.9776363627, 0.9942247112, 0.9958358293, 0.9954469662,
                                     0.9899280023 };
    static const double half[] = { 0.96228269, 0.9961718105, 0.9995068098, 0.9987016697,
                                   0.9873601287 };
    (void)state;
    CHECK_REL(schuler_flicker_bank_sigma(10.0), 0.856116580191873, 1e-13);
    CHECK_REL(schuler_flicker_bank_sigma(sqrt(10.0)), 0.60536583933991, 1e-13);
    CHECK_REL(schuler_flicker_bank_sigma(4.0), 0.66428247026796, 1e-13);
    CHECK_REL(schuler_flicker_bank_sigma(2.0), 0.469718639349826, 1e-13);
    const schuler_flicker_bank seven = { 0.1, 10.0, 7, 0 }, thirteen = { 0.1, sqrt(10.0), 13, 0 };
    double tau_s = 1.0;
    for (int i = 0; i < 5; i++, tau_s *= 10.0) {
        CHECK_NEAR(sqrt(schuler_process_flicker_bank(&seven, 1, tau_s)) / SCHULER_FLICKER_FLOOR,
                   decade[i], 5e-10);
        CHECK_NEAR(sqrt(schuler_process_flicker_bank(&thirteen, 1, tau_s)) / SCHULER_FLICKER_FLOOR,
                   half[i], i == 0 ? 5e-9 : 5e-10);
    }
}

static void the_bank_of_the_simulator_ends_where_it_is_told(void **state)
{
    (void)state;
    const schuler_flicker_bank told = schuler_flicker_bank_of(0.1, 1e5, 0.001);
    CHECK_NEAR(told.shortest_s, 0.1, 0.0);
    assert_int_equal(told.members, 10); /* 0.1 s 4^9 = 26214 s */
    assert_false(told.endless);
    const schuler_flicker_bank free = schuler_flicker_bank_of(0.0, 1e5, 0.016);
    CHECK_NEAR(free.shortest_s, 0.001, 1e-18);
    assert_int_equal(free.members, 14); /* 0.001 s 4^13 = 67109 s */
    assert_true(free.endless);
    assert_int_equal(schuler_flicker_bank_of(0.1, 0.01, 0.001).members, 1);
    assert_int_equal(schuler_flicker_bank_of(1e-9, 1e300, 1e-30).members, SCHULER_MARKOV_MAX);
}

/* One member for an endless tail: the tail itself, summed term by term. At ten times the member's time
 * e^-x is below 1e-8 of it. */
static void one_member_stands_for_all_shorter_ones(void **state)
{
    (void)state;
    const schuler_flicker_bank bank = schuler_flicker_bank_of(0.0, 1e5, 16.0);
    const schuler_markov_process first = schuler_flicker_bank_member(&bank, 1.0, 0);
    const double sigma = schuler_flicker_bank_sigma(bank.ratio);
    for (double tau_s = 16.0; tau_s < 1e5; tau_s *= 3.0) {
        double tail = 0.0;
        for (double T_s = bank.shortest_s; T_s > 1e-14; T_s /= bank.ratio)
            tail += schuler_process_gauss_markov(sigma, T_s, tau_s);
        CHECK_REL(schuler_process_gauss_markov(first.sigma, first.T_s, tau_s), tail, 1e-7);
    }
}

/* An endless bank has the floor at every time from the sample to a hundredth of its longest member, but
 * for its ripple of 0.024 % and 0.2 % of what is missing beyond the end. */
static void an_endless_bank_is_flat_down_to_the_sample(void **state)
{
    (void)state;
    const schuler_flicker_bank bank = schuler_flicker_bank_of(0.0, 1e5, 0.01);
    for (double tau_s = 0.01; tau_s < 100.0; tau_s *= 1.5)
        CHECK_NEAR(sqrt(schuler_process_flicker_bank(&bank, 1.0, tau_s)) / SCHULER_FLICKER_FLOOR,
                   1.0, 2.4e-4 + 2e-3 * tau_s / 100.0);
}

static void fractional_weights_are_known(void **state) /* C7 */
{
    (void)state;
    double h[1001];
    schuler_fractional_weights(h, 1001);
    CHECK_NEAR(h[0], 1.0, 0.0);
    CHECK_NEAR(h[1], 0.5, 0.0);
    CHECK_NEAR(h[2], 0.375, 0.0);
    CHECK_NEAR(h[3], 0.3125, 0.0);
    CHECK_REL(h[10], 0.176197052001953, 1e-13);
    CHECK_REL(h[100], 0.0563484790092564, 1e-13);
    CHECK_REL(h[1000], 0.0178390111458543, 1e-13);
    schuler_fractional_weights(h, 0); /* writes nothing */
    CHECK_NEAR(h[0], 1.0, 0.0);
}

static void a_sinusoid_peaks_at_a_third_of_its_period(void **state) /* C8 */
{
    (void)state;
    const double peak = 0.371009648203552;
    CHECK_REL(sqrt(schuler_process_sinusoid(2.0, 10.0, peak / 10.0)), 2.0 * 0.724611353776708,
              1e-12);
    assert_true(schuler_process_sinusoid(1, 1, peak) > schuler_process_sinusoid(1, 1, peak * 1.01));
    assert_true(schuler_process_sinusoid(1, 1, peak) > schuler_process_sinusoid(1, 1, peak / 1.01));
    CHECK_NEAR(schuler_process_sinusoid(1.0, 1.0, 3.0), 0.0, 1e-30); /* whole periods */
    CHECK_NEAR(schuler_process_sinusoid(1.0, 0.0, 3.0), 0.0, 0.0);
}

/* Independent: 40 digits, by bisection of the regularised incomplete gamma function. */
static void chi_square_quantiles_are_right(void **state)
{
    static const struct {
        double dof, p, x;
    } known[] = {
        { 0.5, 0.5, 0.08734760470574682 },    { 1.33, 0.025, 0.006695357837271432 },
        { 1.33, 0.975, 5.872003448886601 },   { 2.5, 0.9999, 19.81039931720148 },
        { 10.0, 0.025, 3.246972780236841 },   { 44.2, 0.975, 64.44339100366899 },
        { 120.7, 0.0001, 71.26100936672217 }, { 1e4, 0.975, 10279.07017988759 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        CHECK_REL(schuler_chi_square_quantile(known[i].dof, known[i].p), known[i].x, 1e-10);
    for (double p = 1e-6; p < 1.0; p += 0.0137) { /* two degrees of freedom: exponential */
        CHECK_REL(schuler_chi_square_quantile(2.0, p), -2.0 * log1p(-p), 1e-10);
        CHECK_REL(schuler_chi_square_probability(2.0, 3.0 * p, 1), exp(-1.5 * p), 1e-13);
        CHECK_REL(schuler_chi_square_probability(1.0, 9.0 * p, 0), erf(sqrt(4.5 * p)), 1e-12);
    }
}

static void chi_square_quantiles_come_back(void **state)
{
    (void)state;
    for (double dof = 0.1; dof < 3e7; dof *= 3.7)
        for (double p = 0.001; p < 1.0; p += 0.0499) {
            const double x = schuler_chi_square_quantile(dof, p);
            CHECK_NEAR(schuler_chi_square_probability(dof, x, 0), p, 1e-9);
            CHECK_NEAR(schuler_chi_square_probability(dof, x, 1), 1.0 - p, 1e-9);
        }
    assert_true(isnan(schuler_chi_square_quantile(0.0, 0.5)));
    assert_true(isnan(schuler_chi_square_quantile(1.0, 0.0)));
    assert_true(isnan(schuler_chi_square_quantile(1.0, 1.0)));
    assert_true(isnan(schuler_chi_square_quantile(nan(""), 0.5)));
    CHECK_NEAR(schuler_chi_square_quantile(1e-3, 1e-4), 0.0, 1e-300);
    CHECK_NEAR(schuler_chi_square_probability(3.0, -1.0, 0), 0.0, 0.0);
    CHECK_NEAR(schuler_chi_square_probability(3.0, HUGE_VAL, 0), 1.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_flicker_floor_is_the_root_of_two_ln_two_over_pi),
        cmocka_unit_test(terms_add_in_variance),
        cmocka_unit_test(a_gauss_markov_process_peaks_at_its_time),
        cmocka_unit_test(a_slow_gauss_markov_process_keeps_its_digits),
        cmocka_unit_test(a_second_order_gauss_markov_process_has_its_correlation),
        cmocka_unit_test(recursions_have_their_covariances),
        cmocka_unit_test(the_flicker_bank_keeps_to_the_floor),
        cmocka_unit_test(the_bank_of_the_simulator_ends_where_it_is_told),
        cmocka_unit_test(one_member_stands_for_all_shorter_ones),
        cmocka_unit_test(an_endless_bank_is_flat_down_to_the_sample),
        cmocka_unit_test(fractional_weights_are_known),
        cmocka_unit_test(a_sinusoid_peaks_at_a_third_of_its_period),
        cmocka_unit_test(chi_square_quantiles_are_right),
        cmocka_unit_test(chi_square_quantiles_come_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Drift metrics against reference/requirements.md, "Numbers to check against" (F1 ... F10b). */
#include "check.h"
#include "core/earth.h"
#include "scenarios/metrics.h"
#include <stdlib.h>

/* Reference values are printed with 15 digits. */
#define PRINTED 1e-13

/* A sample that stands at the quantiles i/100 of the circular normal: its percentiles (type 7) are
 * the distribution's own, F1. */
static void percentiles_of_a_circular_normal(void **state)
{
    (void)state;
    double r[101], scratch[101];
    for (int i = 0; i < 100; i++) r[i] = sqrt(-2.0 * log1p(-i / 100.0));
    r[100] = 10.0;
    /* (n - 1) p is rounded once: relative 1e-16 of a place, and places are up to 0.3 apart. */
    CHECK_NEAR(schuler_percentile(r, 101, 0.50, scratch), 1.17741002251547, 1e-13);
    CHECK_NEAR(schuler_percentile(r, 101, 0.95, scratch), 2.44774683068082, 1e-13);
    CHECK_NEAR(schuler_percentile(r, 101, 0.99, scratch), 3.03485425877029, 1e-12);
}

static void percentile_sorts_a_copy_and_interpolates(void **state)
{
    (void)state;
    const double values[] = { 4.0, 1.0, 3.0, 2.0 };
    double scratch[4];
    CHECK_NEAR(schuler_percentile(values, 4, 0.5, scratch), 2.5, 0.0);
    CHECK_NEAR(schuler_percentile(values, 4, 0.95, scratch), 3.85, 1e-15);
    CHECK_NEAR(schuler_percentile(values, 4, 0.0, scratch), 1.0, 0.0);
    CHECK_NEAR(schuler_percentile(values, 4, 1.0, scratch), 4.0, 0.0);
    CHECK_NEAR(schuler_percentile(values, 1, 0.95, scratch), 4.0, 0.0);
    CHECK_NEAR(values[0], 4.0, 0.0);
    const double diverged[] = { HUGE_VAL, HUGE_VAL };
    assert_true(schuler_percentile(diverged, 2, 0.5, scratch) == HUGE_VAL);
}

static void interval(int n, double p, int lower, int upper, double coverage, double tolerance)
{
    int l, u;
    double c;
    schuler_order_interval(n, p, 0.95, &l, &u, &c);
    assert_int_equal(l, lower);
    assert_int_equal(u, upper);
    CHECK_NEAR(c, coverage, tolerance);
}

static void order_intervals_of_the_median(void **state)
{
    (void)state;
    interval(10, 0.5, 2, 9, 0.978515625, 1e-15);            /* F10b, exact in binary */
    interval(20, 0.5, 6, 15, 0.958610534667969, PRINTED);   /* F7 */
    interval(100, 0.5, 40, 61, 0.964799799782295, PRINTED); /* F7b */
    interval(6, 0.5, 1, 6, 0.96875, 1e-15);                 /* 1 - 2/2^6 */
    interval(5, 0.5, 0, 6, 1.0, 1e-15);                     /* 2/2^5 is too much doubt */
    interval(1, 0.5, 0, 2, 1.0, 1e-15);
    interval(0, 0.5, 0, 1, 1.0, 0.0);
}

static void order_intervals_of_the_95th_percentile(void **state)
{
    (void)state;
    int l, u;
    double c;
    schuler_order_interval(58, 0.95, 0.95, &l, &u, &c);
    assert_int_equal(u, 59); /* 1 - 0.95^58 = 0.949: no bound */
    /* F7b: the largest of 59 bounds it with 0.95150547; what is left, 0.0015, goes to the other
     * end. */
    schuler_order_interval(59, 0.95, 0.95, &l, &u, &c);
    assert_int_equal(u, 59);
    assert_in_range(l, 1, 56);
    assert_true(c >= 0.95 && c < 0.951505474750577);
    schuler_order_interval(72, 0.95, 0.95, &l, &u,
                           &c); /* 0.95^72 = 0.0249: half the doubt is enough */
    assert_int_equal(u, 72);
    assert_true(c >= 0.95);
    /* Mirrored: the 5th percentile of n is the 95th seen from the other end. */
    int l5, u5;
    double c5;
    schuler_order_interval(200, 0.95, 0.95, &l, &u, &c);
    schuler_order_interval(200, 0.05, 0.95, &l5, &u5, &c5);
    assert_int_equal(l5, 201 - u);
    assert_int_equal(u5, 201 - l);
    CHECK_NEAR(c5, c, 1e-13);
    schuler_order_interval(59, 0.05, 0.95, &l5, &u5, &c5);
    assert_int_equal(l5, 1);
}

/* At n = 100000 the normal limit holds: ranks n/2 -+ 1.959964 sqrt(n)/2 to within one rank (the
 * continuity step), and one rank is worth 2 phi(1.96)/(sqrt(n)/2) = 7.4e-4 of coverage. */
static void order_interval_of_very_many_runs(void **state)
{
    (void)state;
    int l, u;
    double c;
    schuler_order_interval(100000, 0.5, 0.95, &l, &u, &c);
    const double half = 1.959964 * sqrt(100000.0) / 2.0;
    CHECK_NEAR(l, 50000.0 - half, 1.5);
    assert_int_equal(u, 100001 - l);
    assert_true(c >= 0.95 && c < 0.95 + 1.5e-3);
    schuler_order_interval(100000, 0.95, 0.95, &l, &u, &c);
    CHECK_NEAR(u - l, 2.0 * 1.959964 * sqrt(100000.0 * 0.05 * 0.95), 3.0);
    assert_true(c >= 0.95 && c < 0.9535);
}

/* Radial error of a pure level gyro bias, in units of eps R, and of a pure tilt: section 3. */
static double drift(double t_s, double w)
{
    return t_s - sin(w * t_s) / w;
}

static double tilt(double t_s, double w)
{
    return 1.0 - cos(w * t_s);
}

enum { SAMPLES = 100000 };

static double slope_of(double (*radial)(double, double), double w, double window_s)
{
    double *t_s = malloc(2 * SAMPLES * sizeof(*t_s)), *r = t_s + SAMPLES;
    assert_non_null(t_s);
    for (int i = 0; i < SAMPLES; i++) {
        t_s[i] = (i + 0.5) * window_s / SAMPLES;
        r[i] = radial(t_s[i], w);
    }
    const double slope = schuler_slope_through_origin(t_s, r, SAMPLES);
    free(t_s);
    return slope;
}

/* The sums are midpoint rules for the integrals of the closed forms: each is off by
 * h^2 T/24 max|(t r)''| with h = T/1e5, which is at most (h/T)^2/8 (4 + wT) relative for the drift
 * (6e-10 at 10 h) and, from |(t r)''| <= 2w + w^2 t, below (h/T)^2 wT (2 + wT)/24 against the
 * integral of t, with a slope as small as 0.05 of 1 nmi/h at 10 h: 1e-8 covers all rows. */
static void least_squares_slopes_of_drift_and_tilt(void **state)
{
    (void)state;
    static const struct {
        double window_s, drift, tilt_nmiph;
    } expected[] = {
        { 1800.0, 0.417648152490705, 0.971640348195511 }, /* F4, F5 */
        { 3600.0, 0.996037771340958, 0.804447415400483 },
        { 5064.0, 1.07600643911221, 0.366881622274569 },
        { 7200.0, 0.964874254346808, 0.24288608745358 },
        { 36000.0, 1.00114637881519, 0.0501563166583204 },
    };
    const double R_m = 6371000.0, w = sqrt(SCHULER_G0_MPS2 / R_m);
    const double nmiph = SCHULER_NMI_M / 3600.0;
    for (size_t i = 0; i < sizeof(expected) / sizeof(*expected); i++) {
        CHECK_REL(slope_of(drift, w, expected[i].window_s), expected[i].drift, 1e-8);
        CHECK_REL(1e-4 * R_m * slope_of(tilt, w, expected[i].window_s) / nmiph,
                  expected[i].tilt_nmiph, 1e-8);
    }
    CHECK_NEAR(schuler_slope_through_origin(NULL, NULL, 0), 0.0, 0.0);
}

static void rms_neither_overflows_nor_divides_by_zero(void **state)
{
    (void)state;
    const double huge[] = { 3e200, -4e200 }, none[] = { 0.0, 0.0 }, one[] = { 1.0, HUGE_VAL };
    CHECK_REL(schuler_rms(huge, 2), 1e200 * sqrt(12.5), 1e-15);
    CHECK_NEAR(schuler_rms(none, 2), 0.0, 0.0);
    CHECK_NEAR(schuler_rms(NULL, 0), 0.0, 0.0);
    assert_true(schuler_rms(one, 2) == HUGE_VAL);
}

static void a_row_is_summarised(void **state)
{
    (void)state;
    double slopes[] = { 0.42, 0.77, 0.31, 1.10, 0.58, 0.93, 0.66, 0.49, 0.85, 1.35 }; /* F10 */
    double ends[] = { 3.0, 4.0, 0, 0, 0, 0, 0, 0, 0, 0 };
    double largest[] = { 6.0, 8.0, 0, 0, 0, 0, 0, 0, 0, 0 };
    schuler_budget_row row = { .runs = 10, .slope_mps = slopes, .end_m = ends, .max_m = largest };
    assert_int_equal(schuler_row_summarise(&row), SCHULER_OK);
    CHECK_REL(row.cep_mps, 0.715, 1e-15);
    CHECK_REL(row.rms_slope_mps, 0.806064513547148, 1e-14);
    CHECK_REL(sqrt(log(2.0)) * row.rms_slope_mps, 0.671092727644264, 1e-14);
    CHECK_REL(row.r95_mps, 1.10 + 0.55 * 0.25, 1e-15); /* place 0.95 * 9 = 8.55 */
    CHECK_REL(row.rms_end_m, sqrt(2.5), 1e-15);
    CHECK_REL(row.rms_max_m, sqrt(10.0), 1e-15);
    schuler_budget_row nothing = { .cep_mps = 1.0 };
    assert_int_equal(schuler_row_summarise(&nothing), SCHULER_OK);
    CHECK_NEAR(nothing.cep_mps, 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(percentiles_of_a_circular_normal),
        cmocka_unit_test(percentile_sorts_a_copy_and_interpolates),
        cmocka_unit_test(order_intervals_of_the_median),
        cmocka_unit_test(order_intervals_of_the_95th_percentile),
        cmocka_unit_test(order_interval_of_very_many_runs),
        cmocka_unit_test(least_squares_slopes_of_drift_and_tilt),
        cmocka_unit_test(rms_neither_overflows_nor_divides_by_zero),
        cmocka_unit_test(a_row_is_summarised),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* What the drift of one run is, against closed forms of the reference's F block. */
#include "check.h"
#include "core/random.h"
#include "scenarios/comparator.h"
#include "scenarios/metrics.h"

static const double w = 0.00124067072659453, R_m = 6371000.0; /* E1 */

typedef double shape(double t_s);

static double level_drift(double t_s) /* of a gyro, over eps R */
{
    return t_s - sin(w * t_s) / w;
}

static double tilt(double t_s) /* 0.1 mrad, m */
{
    return R_m * 1e-4 * (1.0 - cos(w * t_s));
}

/* Errors at every 10 s, the shape along a direction. */
static lane_metrics fly(shape *f, double T_s, double north, double east)
{
    lane_metrics m = { 0 };
    schuler_error_row row = { 0 };
    schuler_metrics_start(&m, &row);
    for (double t_s = 10.0; t_s <= T_s; t_s += 10.0) {
        row.time_s = t_s;
        row.r_n[0] = north * f(t_s);
        row.r_n[1] = east * f(t_s);
        (void)schuler_metrics_take(&m, &row);
    }
    return m;
}

static double nmi_h(double mps)
{
    return mps * 3600.0 / SCHULER_NMI_M;
}

/* Rows F4 and F5: the sums at 10 s against the integrals of the reference, whose difference is of first order
 * in 10 s/T: t^2 weighs the last sample half too much. */
static void final_and_slope_are_those_of_the_reference(void **state)
{
    (void)state;
    static const struct {
        double T_s, drift[2], tilted[2];
    } rows[] = {
        { 1800.0,
          { 0.646915124726869, 0.417648152490705 },
          { 1.11115449942139, 0.971640348195511 } },
        { 3600.0,
          { 1.21715416270743, 0.996037771340958 },
          { 0.427772565336024, 0.804447415400483 } },
        { 7200.0,
          { 0.947122640642129, 0.964874254346808 },
          { 0.323609313852852, 0.24288608745358 } },
        { 36000.0,
          { 0.985889583926566, 1.00114637881519 },
          { 0.00769168396410186, 0.0501563166583204 } },
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const double T_s = rows[i].T_s, coarse = 30.0 / T_s;
        const lane_metrics drift = fly(level_drift, T_s, 0.6, -0.8),
                           tilted = fly(tilt, T_s, 1.0, 0.0);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_FINAL, -1), rows[i].drift[0], 1e-12);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_SLOPE, -1), rows[i].drift[1],
                  coarse);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_FINAL, 0), 0.6 * rows[i].drift[0],
                  1e-12);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_FINAL, 1), -0.8 * rows[i].drift[0],
                  1e-12);
        CHECK_REL(nmi_h(schuler_metrics_drift(&tilted, SCHULER_METRIC_FINAL, -1)),
                  rows[i].tilted[0], 1e-8);
        CHECK_REL(nmi_h(schuler_metrics_drift(&tilted, SCHULER_METRIC_SLOPE, 0)), rows[i].tilted[1],
                  2.0 * coarse);
    }
}

/* Its base holds both shapes exactly: the mean rate of a drift is the drift, that of a tilt nothing. */
static void the_mean_rate_does_not_see_the_pendulum(void **state)
{
    (void)state;
    for (double T_s = 1800.0; T_s <= 36000.0; T_s *= 2.0) {
        const lane_metrics drift = fly(level_drift, T_s, 0.6, -0.8),
                           tilted = fly(tilt, T_s, 1.0, 1.0);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_HARMONIC, -1), 1.0, 1e-9);
        CHECK_REL(schuler_metrics_drift(&drift, SCHULER_METRIC_HARMONIC, 1), -0.8, 1e-9);
        CHECK_NEAR(schuler_metrics_drift(&tilted, SCHULER_METRIC_HARMONIC, -1), 0.0, 1e-8);
    }
    const lane_metrics two = fly(tilt, 20.0, 1.0, 1.0); /* two reports do not tell three unknowns */
    CHECK_NEAR(schuler_metrics_drift(&two, SCHULER_METRIC_HARMONIC, -1), 0.0, 0.0);
}

static double steady(double t_s)
{
    return 0.5 * t_s;
}

static void trms_looks_from_half_an_hour_on(void **state)
{
    (void)state;
    const lane_metrics m = fly(steady, 7200.0, 0.6, 0.8), early = fly(steady, 1700.0, 0.6, 0.8);
    CHECK_REL(schuler_metrics_drift(&m, SCHULER_METRIC_TRMS, -1), 0.5, 1e-13);
    CHECK_NEAR(schuler_metrics_drift(&early, SCHULER_METRIC_TRMS, -1), 0.0, 0.0);
}

/* F1 and F3: circular normal drifts, 20000 runs. The sampling error of a percentile p of the Rayleigh
 * distribution is sqrt(p/(1 - p)/n)/x^2 of it: 1.0 % at 99 %, 0.5 % at 95 %; four of them. */
static void statistics_of_circular_drifts_have_their_ratios(void **state)
{
    (void)state;
    enum { RUNS = 20000 };
    static double north[RUNS], east[RUNS], radial[RUNS];
    for (int i = 0; i < RUNS; i++) {
        const schuler_stream stream = { 5, (uint64_t)i, 1, 0, SCHULER_USE_DRAW };
        const schuler_stream other = { 5, (uint64_t)i, 2, 0, SCHULER_USE_DRAW };
        north[i] = schuler_stream_normal(stream, 0);
        east[i] = schuler_stream_normal(other, 0);
        radial[i] = hypot(north[i], east[i]);
    }
    schuler_budget_row row = {
        .drawn = true, .runs = RUNS, .drift_mps = radial, .axis_mps = { north, east }
    };
    const struct {
        schuler_statistic statistic;
        double expected, relative;
    } rows[] = {
        { SCHULER_STAT_CEP, 1.17741002251547, 0.025 },
        { SCHULER_STAT_R95, 2.44774683068082, 0.021 },
        { SCHULER_STAT_R99, 3.03485425877029, 0.031 },
        { SCHULER_STAT_RMS, 1.4142135623731, 0.015 },
        { SCHULER_STAT_ONE_AXIS, 1.959964, 0.021 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const schuler_requirement r = { .given = true,
                                        .drift_mps = 1e9,
                                        .statistic = rows[i].statistic };
        schuler_judgement j;
        assert_int_equal(schuler_row_required(&row, &r), SCHULER_OK);
        CHECK_REL(row.required_mps, rows[i].expected, rows[i].relative);
        assert_int_equal(schuler_judge(&r, &row, &j), SCHULER_OK);
        assert_true(j.lower_mps < rows[i].expected && rows[i].expected < j.upper_mps);
        assert_true(j.lower_mps > 0.95 * rows[i].expected && j.upper_mps < 1.05 * rows[i].expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(final_and_slope_are_those_of_the_reference),
        cmocka_unit_test(the_mean_rate_does_not_see_the_pendulum),
        cmocka_unit_test(trms_looks_from_half_an_hour_on),
        cmocka_unit_test(statistics_of_circular_drifts_have_their_ratios),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

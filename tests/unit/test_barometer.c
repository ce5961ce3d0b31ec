/* SPDX-License-Identifier: MIT */
/* The barometer and the loop that follows it, each against its closed form. */
#include "check.h"
#include "core/gravity.h"
#include "mechanization/vertical.h"
#include "sensors/barometer.h"

static barometer barometer_with(barometer_errors errors, double interval_s, uint64_t run)
{
    const barometer_setup setup = {
        .seed = 3, .run = run, .interval_s = interval_s, .gauss_markov_time_s = 10.0
    };
    barometer b;
    schuler_barometer_start(&b, &setup, &errors, 100.0);
    return b;
}

static void without_errors_it_reads_the_height_bit_for_bit(void **state)
{
    (void)state;
    barometer b = barometer_with((barometer_errors){ 0 }, 0.3, 1);
    for (uint64_t k = 0; k < 1000; k++) {
        const double height_m = 100.0 + 1e3 * sin(0.01 * (double)k);
        assert_true(schuler_barometer_read(&b, k, height_m) == height_m);
    }
}

/* Rounding of heights of 1 km. */
static void bias_and_scale_act_on_what_they_should(void **state)
{
    (void)state;
    barometer b = barometer_with((barometer_errors){ .bias_m = 7.0, .scale_factor = 0.01 }, 1.0, 1);
    CHECK_NEAR(schuler_barometer_read(&b, 0, 100.0), 107.0, 1e-12);
    CHECK_NEAR(schuler_barometer_read(&b, 1, 1100.0), 1117.0, 1e-12);
}

/* A climb of r from the start on: the reading is h - r T (1 - exp(-t/T)), whatever the interval. */
static void the_lag_is_that_of_a_first_order_response(void **state)
{
    (void)state;
    const double intervals_s[] = { 0.1, 1.0, 4.0 }, rate_mps = 10.0, lag_s = 2.0;
    for (int i = 0; i < 3; i++) {
        barometer b = barometer_with((barometer_errors){ .lag_s = lag_s }, intervals_s[i], 1);
        double read_m = schuler_barometer_read(&b, 0, 100.0);
        assert_true(read_m == 100.0);
        for (uint64_t k = 1; (double)k * intervals_s[i] < 12.05; k++) {
            const double t_s = (double)k * intervals_s[i], height_m = 100.0 + rate_mps * t_s;
            read_m = schuler_barometer_read(&b, k, height_m);
            CHECK_NEAR(read_m - height_m, rate_mps * lag_s * expm1(-t_s / lag_s), 1e-11);
        }
    }
}

/* Over N readings: white noise has variance N^2/dt. Its estimate has a relative sigma of sqrt(2/N),
 * of which five; successive ones are not correlated: 5/sqrt(N). */
static void white_noise_has_its_density(void **state)
{
    (void)state;
    enum { N = 40000 };
    const double dt_s = 0.25, density = 2.0;
    barometer b = barometer_with((barometer_errors){ .noise_m_rts = density }, dt_s, 5);
    double sum2 = 0.0, product = 0.0, before = 0.0;
    for (uint64_t k = 0; k < N; k++) {
        const double e = schuler_barometer_read(&b, k, 50.0) - 50.0;
        sum2 += e * e;
        product += e * before;
        before = e;
    }
    CHECK_REL(sum2 / N, density * density / dt_s, 5.0 * sqrt(2.0 / N));
    CHECK_NEAR(product / sum2, 0.0, 5.0 / sqrt(N));
}

/* N runs of a Gauss-Markov process, at the start and a correlation time later: sigma^2, sigma^2, and
 * sigma^2/e between them, each with five of its standard deviations sqrt(2/N), sqrt((1 + 1/e^2)/N). */
static void the_weather_is_stationary_and_correlated_as_it_should(void **state)
{
    (void)state;
    enum { N = 20000, STEPS = 5 };
    const double sigma_m = 3.0, dt_s = 10.0 / STEPS;
    double first2 = 0.0, last2 = 0.0, product = 0.0;
    for (uint64_t run = 0; run < N; run++) {
        barometer b = barometer_with((barometer_errors){ .gauss_markov_m = sigma_m }, dt_s, run);
        const double first = schuler_barometer_read(&b, 0, 0.0);
        double last = first;
        for (uint64_t k = 1; k <= STEPS; k++) last = schuler_barometer_read(&b, k, 0.0);
        first2 += first * first / N;
        last2 += last * last / N;
        product += first * last / N;
    }
    const double s2 = sigma_m * sigma_m;
    CHECK_REL(first2, s2, 5.0 * sqrt(2.0 / N));
    CHECK_REL(last2, s2, 5.0 * sqrt(2.0 / N));
    CHECK_NEAR(product, s2 * exp(-1.0), 5.0 * s2 * sqrt((1.0 + exp(-2.0)) / N));
}

/* D11b, with the normal gravity of D2. */
static void the_gains_are_those_of_a_triple_pole(void **state)
{
    (void)state;
    const schuler_baro_gains k = schuler_baro_gains_of(100.0, 9.80619776937738, SCHULER_PI / 4.0);
    CHECK_REL(k.k1_ps, 0.03, 1e-14);
    CHECK_REL(k.k2_ps2, 0.00030307495843134, 1e-13);
    CHECK_REL(k.k3_ps3, 1e-6, 1e-14);
    /* D11: the pole that the loop has to hold. */
    CHECK_REL(1.0 / sqrt(k.gradient_ps2), 570.269803053938, 1e-13);
}

/* The loop on a vertical channel that is exactly h'' = 2g/R h + b, advanced exactly. */
typedef struct {
    double h_m, v_mps, kappa2, b_mps2;
} channel;

static void fall(channel *c, double T_s)
{
    const double w = sqrt(c->kappa2), a = c->b_mps2 / c->kappa2, h = c->h_m + a, v = c->v_mps;
    c->h_m = h * cosh(w * T_s) + v * sinh(w * T_s) / w - a;
    c->v_mps = h * w * sinh(w * T_s) + v * cosh(w * T_s);
}

static double largest_off(double T_s)
{
    const schuler_baro_gains gains =
        schuler_baro_gains_of(100.0, 9.80619776937738, SCHULER_PI / 4.0);
    channel c = { .kappa2 = gains.gradient_ps2, .b_mps2 = 9.80665e-3 };
    schuler_baro_loop loop = { 0 };
    double off_m = 0.0;
    for (int k = 1; k * T_s <= 1000.0; k++) {
        double dh_m, dv_mps;
        fall(&c, T_s);
        schuler_baro_update(&loop, &gains, T_s, c.h_m, &dh_m, &dv_mps);
        c.h_m += dh_m;
        c.v_mps += dv_mps;
        const double t_s = k * T_s;
        off_m = fmax(off_m, fabs(c.h_m - 0.5 * c.b_mps2 * t_s * t_s * exp(-t_s / 100.0)));
    }
    return off_m;
}

/* D11c: b t^2/2 exp(-t/tau), for 1 mg 26.54 m at 200 s; the update is of second order in T/tau. */
static void the_loop_follows_the_continuous_one_to_second_order(void **state)
{
    (void)state;
    const double off_m = largest_off(1.0);
    assert_true(off_m < 26.5437151070466 * 1e-4); /* (T/tau)^2 */
    assert_true(largest_off(0.1) < 26.5437151070466 * 1e-6);
    CHECK_REL(largest_off(2.0) / off_m, 4.0, 0.02); /* the next order: T/tau */
}

/* Four updates in a tau are still a loop that settles, on an error of 1 m to begin with. */
static void few_updates_are_enough(void **state)
{
    (void)state;
    const schuler_baro_gains gains = schuler_baro_gains_of(100.0, 9.8, 0.0);
    channel c = { .h_m = 1.0, .kappa2 = gains.gradient_ps2 };
    schuler_baro_loop loop = { .e_m = 1.0 };
    const double T_s = 100.0 / SCHULER_BARO_UPDATES_MIN;
    for (int k = 0; k < 80; k++) {
        double dh_m, dv_mps;
        fall(&c, T_s);
        schuler_baro_update(&loop, &gains, T_s, c.h_m, &dh_m, &dv_mps);
        c.h_m += dh_m;
        c.v_mps += dv_mps;
    }
    CHECK_NEAR(c.h_m, 0.0, 1e-3); /* exp(-20) (20^2/2) = 4e-7, were it the continuous one */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_errors_it_reads_the_height_bit_for_bit),
        cmocka_unit_test(bias_and_scale_act_on_what_they_should),
        cmocka_unit_test(the_lag_is_that_of_a_first_order_response),
        cmocka_unit_test(white_noise_has_its_density),
        cmocka_unit_test(the_weather_is_stationary_and_correlated_as_it_should),
        cmocka_unit_test(the_gains_are_those_of_a_triple_pole),
        cmocka_unit_test(the_loop_follows_the_continuous_one_to_second_order),
        cmocka_unit_test(few_updates_are_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

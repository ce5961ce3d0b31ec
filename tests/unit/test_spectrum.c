/* SPDX-License-Identifier: MIT */
/* Spectral densities against closed forms. */
#include "check.h"
#include "core/earth.h"
#include "sensors/spectrum.h"
#include "simulated_noise.h"
#include <stdlib.h>

enum { N = 1 << 18, SEGMENT = 1024, BINS = SEGMENT / 2 + 1 };
static const double DT_S = 0.01;
static const double STEP_HZ = 1.0 / (SEGMENT * 0.01);

static double *samples(void)
{
    double *const y = malloc(N * sizeof(double));
    assert_non_null(y);
    return y;
}

static void welch(const double *y, double scale, double *density)
{
    assert_int_equal(schuler_spectrum_welch(y, N, DT_S, scale, SEGMENT, density, NULL), SCHULER_OK);
}

/* Two-sided, S = N^2. Over 511 segments of which neighbours share half (their spectra are correlated by
 * 1/6) a bin has a relative sigma of sqrt((1 + 2/36)/511), and the mean over 509 bins is closer by the
 * square root of their number over 1.94, by which the window joins them: 2.9e-3 in all. */
static void white_noise_has_the_square_of_its_random_walk(void **state)
{
    double *const y = samples(), density[BINS], mean = 0.0;
    const noise_coefficients noise = { .N = 3e-7, .dt_s = DT_S };
    (void)state;
    noise_simulate(&noise, 1, N, y); /* increments: divided by dt they are rates */
    welch(y, 1.0 / DT_S, density);
    for (int k = 2; k < BINS - 2; k++) {
        CHECK_REL(density[k], 9e-14, 6.0 * 0.0455);
        mean += density[k] / (BINS - 4);
    }
    CHECK_REL(mean, 9e-14, 5.0 * 2.9e-3);
    free(y);
}

/* The sum over all frequencies of both signs is the variance: for one segment exactly that of the
 * windowed data, sum w^2 y^2/sum w^2. */
static void the_integral_is_the_variance(void **state)
{
    double y[SEGMENT], density[BINS], mean = 0.0, windowed = 0.0, integral = 0.0;
    noise_source s = { .state = 5 };
    (void)state;
    for (int k = 0; k < SEGMENT; k++) mean += (y[k] = 1e3 + noise_normal(&s)) / SEGMENT;
    for (int k = 0; k < SEGMENT; k++) {
        const double w = 0.5 - 0.5 * cos(2.0 * SCHULER_PI * k / SEGMENT);
        windowed += w * w * (y[k] - mean) * (y[k] - mean) / (0.375 * SEGMENT);
    }
    assert_int_equal(schuler_spectrum_welch(y, SEGMENT, DT_S, 1.0, SEGMENT, density, NULL),
                     SCHULER_OK);
    for (int k = 0; k < BINS; k++)
        integral += density[k] * STEP_HZ * (k == 0 || k == BINS - 1 ? 1.0 : 2.0);
    CHECK_REL(integral, windowed, 1e-5); /* single precision */
}

/* A^2/4 at the frequency and at its negative; the Hann window spreads it over three bins, all of it when
 * the frequency is a bin's. */
static void a_sinusoid_has_its_power(void **state)
{
    enum { AT = 100 };
    double *const y = samples(), density[BINS];
    (void)state;
    for (int k = 0; k < N; k++) y[k] = 2e-5 * sin(2.0 * SCHULER_PI * AT * k / SEGMENT + 0.3);
    welch(y, 1.0, density);
    double power = 0.0, rest = 0.0;
    for (int k = 1; k < BINS; k++) *(abs(k - AT) <= 1 ? &power : &rest) += density[k] * STEP_HZ;
    CHECK_REL(power, 4e-10 / 4.0, 1e-5);
    CHECK_NEAR(rest, 0.0, 1e-10 * 1e-10); /* -100 dB: what single precision leaves */
    free(y);
}

/* The mean of 1024 numbers of 9.8 is off by 1.1e-12 at most; as a constant that gives 1e-24 times
 * 10 s times 2/3 in the first bins. */
static void the_mean_and_silence_have_no_density(void **state)
{
    double *const y = samples(), density[BINS];
    (void)state;
    for (int k = 0; k < N; k++) y[k] = 9.8;
    welch(y, 1.0, density);
    for (int k = 0; k < BINS; k++) CHECK_NEAR(density[k], 0.0, 1e-23);
    for (int k = 0; k < N; k++) y[k] = 1e-300 * (k % 2);
    welch(y, 1.0, density);
    for (int k = 0; k < BINS; k++) assert_true(isfinite(density[k]));
    free(y);
}

static void bins_are_averaged_on_a_logarithmic_grid(void **state)
{
    enum { COUNT = 1001 };
    double density[COUNT];
    schuler_spectrum_point point[64];
    (void)state;
    for (int k = 0; k < COUNT; k++) density[k] = k;
    const int count = schuler_spectrum_log_bins(density, COUNT, 0.5, 5, point, 64);
    int bins = 0;
    assert_true(count > 10 && count <= 16);
    for (int i = 0; i < count; i++) {
        CHECK_REL(point[i].density * 0.5, point[i].f_hz, 1e-13); /* linear: the mean bin's */
        bins += point[i].bins;
        if (i > 0) assert_true(point[i].f_hz > point[i - 1].f_hz);
    }
    assert_int_equal(bins, COUNT - 1); /* all but 0 Hz, each once */
    assert_int_equal(schuler_spectrum_log_bins(density, COUNT, 0.5, 5, point, 2), 2);
    assert_int_equal(schuler_spectrum_log_bins(density, 1, 0.5, 5, point, 64), 0);
}

static void lengths_that_cannot_be_are_refused(void **state)
{
    static const int wrong[] = { -2, 0, 6, 9, 32, SCHULER_SEGMENT_MAX + 2 };
    double y[16] = { 0 }, density[BINS];
    const volatile int stop = 1;
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        assert_int_equal(schuler_spectrum_welch(y, 16, DT_S, 1.0, wrong[i], density, NULL),
                         SCHULER_ERR_INPUT);
    assert_int_equal(schuler_spectrum_welch(y, 16, DT_S, 1.0, 16, density, &stop),
                     SCHULER_ERR_INTERRUPTED);
    assert_int_equal(schuler_spectrum_welch(y, 16, DT_S, 1.0, 14, density, NULL), SCHULER_OK);
    assert_int_equal(schuler_spectrum_segment(7), 0);
    assert_int_equal(schuler_spectrum_segment(16), 8);
    assert_int_equal(schuler_spectrum_segment(8192), 1024);
    assert_int_equal(schuler_spectrum_segment((int64_t)1 << 40), 1 << 18);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_noise_has_the_square_of_its_random_walk),
        cmocka_unit_test(the_integral_is_the_variance),
        cmocka_unit_test(a_sinusoid_has_its_power),
        cmocka_unit_test(the_mean_and_silence_have_no_density),
        cmocka_unit_test(bins_are_averaged_on_a_logarithmic_grid),
        cmocka_unit_test(lengths_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

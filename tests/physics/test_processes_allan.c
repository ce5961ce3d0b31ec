/* SPDX-License-Identifier: MIT */
/* Each stochastic process as its stage makes it: the Allan variance of simulated increments against
 * theory, over four decades of averaging time from one sample on, at three rates.
 *
 * SERIES independent series give each a variance at every tau; their mean M and standard deviation S
 * make Student's t = (M - theory) sqrt(SERIES)/S with SERIES - 1 degrees of freedom. The longest tau
 * still has 40 windows in a series, so that S is that of a nearly normal number. 99.99 % of t lie within
 * 4.74 for 23 degrees of freedom. */
#include "one_triad.h"
#include "sensors/allan.h"
#include "sensors/processes.h"
#include <math.h>

enum { SPECIMENS = 8, SERIES = 3 * SPECIMENS, WINDOWS = 40, DECADES = 4, POINTS = 3 * DECADES + 1 };
static const double STUDENT = 4.74;
static const double RATES_S[3] = { 0.0025, 0.01, 0.1 };

static void at_rest(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    (void)user;
    (void)t_s;
    for (int i = 0; i < 3; i++) f_ib_b[i] = omega_ib_b[i] = 0.0;
}

/* SERIES series of n increments, one after the other, of the gyro triad `linear` with these keys. */
static double *simulate(const triad_key *keys, int count, double dt_s, int64_t n)
{
    const triad_job job = { .model = "linear",
                            .instrument = SCHULER_GYRO,
                            .keys = keys,
                            .count = count,
                            .specimens = SPECIMENS,
                            .dt_s = dt_s,
                            .n = n,
                            .input = at_rest };
    return triad_measure(&job);
}

static int64_t samples(void)
{
    return (int64_t)(WINDOWS * pow(10.0, DECADES));
}

/* Averaging factors 1, 2, 5, 10 .. 10^4. */
static int factors(int64_t m[POINTS])
{
    int64_t decade = 1;
    for (int i = 0; i < POINTS; i++) {
        static const int step[3] = { 1, 2, 5 };
        m[i] = decade * step[i % 3];
        if (i % 3 == 2) decade *= 10;
    }
    return POINTS;
}

/* slack is what the theory itself is not: relative. */
static void compare(double *y, double dt_s, double (*theory)(double tau_s), double slack)
{
    const int64_t n = samples();
    int64_t m[POINTS];
    double mean[POINTS] = { 0 }, square[POINTS] = { 0 };
    factors(m);
    double *const phase = malloc((size_t)(n + 1) * sizeof(double));
    assert_non_null(phase);
    for (int s = 0; s < SERIES; s++) {
        double sigma2[POINTS];
        schuler_allan_phase(&y[s * n], n, 1.0, phase);
        assert_int_equal(schuler_allan_overlapping(phase, n, dt_s, m, POINTS, sigma2, NULL),
                         SCHULER_OK);
        for (int i = 0; i < POINTS; i++) {
            const double ratio = sigma2[i] / theory((double)m[i] * dt_s);
            mean[i] += ratio / SERIES;
            square[i] += ratio * ratio / SERIES;
        }
    }
    for (int i = 0; i < POINTS; i++) {
        const double deviation = sqrt((square[i] - mean[i] * mean[i]) / (SERIES - 1));
        if (fabs(mean[i] - 1.0) > STUDENT * deviation + slack)
            fail_msg("dt %g s, tau %g s: variance is %.5f of theory, band %.5f", dt_s,
                     (double)m[i] * dt_s, mean[i], STUDENT * deviation + slack);
    }
    free(phase);
    free(y);
}

static double white_theory(double tau_s)
{
    return schuler_process_white(2e-5, tau_s);
}

static void white(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        const triad_key keys[] = { { "angle_random_walk", 2e-5, NULL } };
        compare(simulate(keys, 1, RATES_S[r], samples()), RATES_S[r], white_theory, 0.0);
    }
}

static double flicker_theory(double tau_s)
{
    return schuler_process_flicker(3e-6, tau_s);
}

/* The ripple of the bank is 0.024 % of the deviation; the longest member, 1e6 s and more, is over 1000
 * times tau, where less than 0.1 % of the variance is missing. */
static void flicker(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        const triad_key keys[] = { { "bias_instability", 3e-6, NULL },
                                   { "bias_instability_longest", 4e6, NULL } };
        compare(simulate(keys, 2, RATES_S[r], samples()), RATES_S[r], flicker_theory, 1.5e-3);
    }
}

static double walk_theory(double tau_s)
{
    return schuler_process_random_walk(1e-7, tau_s);
}

static void random_walk(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        const triad_key keys[] = { { "bias_random_walk", 1e-7, NULL } };
        compare(simulate(keys, 1, RATES_S[r], samples()), RATES_S[r], walk_theory, 0.0);
    }
}

static double time_s;

static double markov_theory(double tau_s)
{
    return schuler_process_gauss_markov(1e-4, time_s, tau_s);
}

static double markov_2_theory(double tau_s)
{
    return schuler_process_gauss_markov_2(1e-4, time_s, tau_s);
}

/* Correlation times of less than a sample, of twenty and of a thousand samples. */
static void gauss_markov(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        static const double in_samples[3] = { 0.5, 20.0, 1000.0 };
        time_s = in_samples[r] * RATES_S[r];
        const triad_key keys[] = { { "gauss_markov", 1e-4, NULL },
                                   { "gauss_markov_time", time_s, NULL } };
        compare(simulate(keys, 2, RATES_S[r], samples()), RATES_S[r], markov_theory, 0.0);
    }
}

static void gauss_markov_2(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        static const double in_samples[3] = { 0.5, 20.0, 1000.0 };
        time_s = in_samples[r] * RATES_S[r];
        const triad_key keys[] = { { "gauss_markov_2", 1e-4, NULL },
                                   { "gauss_markov_2_time", time_s, NULL } };
        compare(simulate(keys, 2, RATES_S[r], samples()), RATES_S[r], markov_2_theory, 0.0);
    }
}

static double quantization_theory(double tau_s)
{
    return schuler_process_quantization(1e-6 / sqrt(12.0), tau_s);
}

/* What quantization adds to white noise of many counts a sample: the same noise, counted and not. With
 * s counts of noise a sample successive remainders correlate by exp(-2 pi^2 s^2), nothing for s = 20. */
static void quantization(void **state)
{
    (void)state;
    for (int r = 0; r < 3; r++) {
        const int64_t n = samples();
        const triad_key keys[] = { { "angle_random_walk", 2e-5 / sqrt(RATES_S[r]), NULL },
                                   { "quantization", 1e-6, NULL } };
        double *const counted = simulate(keys, 2, RATES_S[r], n);
        double *const smooth = simulate(keys, 1, RATES_S[r], n);
        for (int64_t k = 0; k < SERIES * n; k++) counted[k] -= smooth[k];
        free(smooth);
        compare(counted, RATES_S[r], quantization_theory, 0.0);
    }
}

/* What is not random has increments that are the integrals themselves. */
static double ramp_integral(double t_s)
{
    return 0.5 * 1e-7 * t_s * t_s;
}

static double transient_integral(double t_s)
{
    return 1e-4 * 30.0 * -expm1(-t_s / 30.0);
}

static void check_integral(const triad_key *keys, int count, double (*integral)(double t_s))
{
    enum { N = 40000 };
    for (int r = 0; r < 3; r++) {
        const double dt_s = RATES_S[r];
        double *const y = simulate(keys, count, dt_s, N);
        const double largest = fabs(integral(N * dt_s));
        for (int s = 0; s < SERIES; s++) {
            double sum = 0.0;
            for (int k = 0; k < N; k++) {
                sum += y[s * N + k];
                /* each of the sums and the time itself lose no more than a rounding a step */
                CHECK_NEAR(sum, integral((k + 1) * dt_s), N * 2e-16 * largest);
            }
        }
        free(y);
    }
}

static void ramp_and_transient(void **state)
{
    (void)state;
    const triad_key ramp[] = { { "bias_ramp", 1e-7, NULL } };
    const triad_key transient[] = { { "thermal_transient", 1e-4, NULL },
                                    { "thermal_transient_time", 30, NULL } };
    check_integral(ramp, 1, ramp_integral);
    check_integral(transient, 2, transient_integral);
}

static double sinusoid_theory(double tau_s)
{
    return schuler_process_sinusoid(1e-4, 0.125, tau_s);
}

/* Phases differ from series to series. The mean over a record is that over whole periods, but for one
 * period of the rest, 8 s of 40 windows: of at most 1/(windows' time) each, and the variance has the
 * zeros of whole periods, near which nothing is compared. */
static void sinusoid(void **state)
{
    (void)state;
    const double dt_s = 0.01;
    const int64_t n = samples();
    const triad_key keys[] = { { "sinusoid", 1e-4, NULL }, { "sinusoid_frequency", 0.125, NULL } };
    double *const y = simulate(keys, 2, dt_s, n), *const phase = malloc((size_t)(n + 1) * 8);
    assert_non_null(phase);
    for (int s = 0; s < SERIES; s++) {
        schuler_allan_phase(&y[s * n], n, 1.0, phase);
        for (int64_t m = 1; m < 3000; m = m * 2 + 1) {
            const double tau_s = (double)m * dt_s;
            double sigma2;
            if (fabs(sin(M_PI * 0.125 * tau_s)) < 0.1) continue;
            assert_int_equal(schuler_allan_overlapping(phase, n, dt_s, &m, 1, &sigma2, NULL),
                             SCHULER_OK);
            CHECK_REL(sigma2, sinusoid_theory(tau_s), 8.0 / ((double)(n - 2 * m) * dt_s));
        }
    }
    free(phase);
    free(y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white),
        cmocka_unit_test(flicker),
        cmocka_unit_test(random_walk),
        cmocka_unit_test(gauss_markov),
        cmocka_unit_test(gauss_markov_2),
        cmocka_unit_test(quantization),
        cmocka_unit_test(ramp_and_transient),
        cmocka_unit_test(sinusoid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

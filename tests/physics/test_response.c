/* SPDX-License-Identifier: MIT */
/* How an instrument answers its input: low-pass response, delay, range, threshold, steps, temperature,
 * lever arm, each against the closed form of an input for which there is one. */
#include "one_triad.h"
#include "sensors/response.h"
#include <complex.h>
#include <math.h>

static const double _Complex J = (double _Complex)I;

/* The x gyro feels offset + amplitude sin(2 pi f t). */
typedef struct {
    double amplitude, f_hz, offset;
} sine;

static void swing(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    const sine *const s = user;
    for (int i = 0; i < 3; i++) f_ib_b[i] = omega_ib_b[i] = 0.0;
    omega_ib_b[0] = s->offset + s->amplitude * sin(2.0 * M_PI * s->f_hz * t_s);
}

static double *gyro(const triad_key *keys, int count, double dt_s, int64_t n,
                    schuler_stand_input input, void *user)
{
    const triad_job job = { .model = "linear",
                            .instrument = SCHULER_GYRO,
                            .keys = keys,
                            .count = count,
                            .specimens = 1,
                            .dt_s = dt_s,
                            .n = n,
                            .input = input,
                            .user = user };
    return triad_measure(&job);
}

/* 2/n sum of y e^(-j w t) over whole periods, t the middle of each step: a of y = Im(a e^(j w t)). */
static double _Complex component(const double *y, int64_t first, int64_t n, double w, double dt_s)
{
    double _Complex sum = 0.0;
    for (int64_t k = first; k < first + n; k++)
        sum += y[k] * cexp(-J * w * ((double)k + 0.5) * dt_s);
    return 2.0 * J * sum / (double)n;
}

/* The increments of the filtered sinusoid are dt sinc(w dt/2) H(jw) of the input's. Within a step the
 * input is taken as the parabola through three nodes: off by (w dt)^3/6 times the product of the
 * distances to them, below 0.05, whose integral over the step vanishes to the order of (w dt)^4. */
static void check_response(const triad_key *keys, int count, double f_n_hz,
                           double _Complex (*H)(double r))
{
    static const int periods[] = { 400, 100, 40, 20, 10, 8 }; /* samples */
    const double dt_s = 2.5e-3, amplitude = 0.1;
    for (size_t i = 0; i < sizeof periods / sizeof periods[0]; i++) {
        const int64_t settled = 1200, period = periods[i];
        sine s = { .amplitude = amplitude, .f_hz = 1.0 / ((double)period * dt_s) };
        const double w = 2.0 * M_PI * s.f_hz;
        double *const y = gyro(keys, count, dt_s, settled + 10 * period, swing, &s);
        const double _Complex found =
            component(y, settled, 10 * period, w, dt_s) / (amplitude * dt_s);
        const double half = 0.5 * w * dt_s;
        const double _Complex expected = sin(half) / half * H(s.f_hz / f_n_hz);
        const double off = 0.05 / 6.0 * pow(w * dt_s, 4.0);
        CHECK_NEAR(cabs(found - expected) / cabs(expected), 0.0, off + 1e-12);
        free(y);
    }
}

static double damping;

static double _Complex second(double r)
{
    return 1.0 / (1.0 - r * r + 2.0 * J * damping * r);
}

static double _Complex first(double r)
{
    return 1.0 / (1.0 + J * r);
}

static void bandwidth_has_gain_and_phase(void **state)
{
    (void)state;
    const double f_n_hz = 20.0;
    static const double dampings[] = { 0.3, 0.70710678118654752, 1.0, 2.0 };
    for (int i = 0; i < 4; i++) {
        damping = dampings[i];
        const triad_key keys[] = { { "bandwidth", f_n_hz, NULL }, { "damping", damping, NULL } };
        check_response(keys, 2, f_n_hz, second);
        CHECK_REL(schuler_second_order_gain(f_n_hz, damping, 30.0), cabs(second(1.5)), 1e-14);
    }
    const triad_key one[] = { { "bandwidth", f_n_hz, NULL }, { "bandwidth_order", 1.0, NULL } };
    check_response(one, 2, f_n_hz, first);
}

/* Driven by t^2 from its particular solution on, the response stays on it:
 * y = t^2 - 4 zeta/w t + (8 zeta^2 - 2)/w^2; of first order t^2 - 2 t/w + 2/w^2. From steps that are
 * short against the response to very long ones; rounding only, of t^2 and of the last term. */
static void a_parabola_is_answered_exactly(void **state)
{
    static const double node[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    static const double zetas[] = { -1.0, 0.05, 0.7, 1.0, 3.0, 20.0 };
    (void)state;
    for (int i = 0; i < 6; i++)
        for (double wdt = 1e-3; wdt < 2e3; wdt *= 3.7) {
            const double w = 50.0, dt_s = wdt / w, zeta = zetas[i], z = zeta < 0.0 ? 0.5 : zeta;
            const schuler_response r = zeta < 0.0
                                           ? schuler_first_order(w / (2.0 * M_PI), dt_s)
                                           : schuler_second_order(w / (2.0 * M_PI), zeta, dt_s);
            const double a = -4.0 * z / w, b = (zeta < 0.0 ? 2.0 : 8.0 * z * z - 2.0) / (w * w);
            double y = b, y_dot = zeta < 0.0 ? 0.0 : a;
            for (int q = 0; q < 2; q++)
                CHECK_NEAR(r.node[0][q] + r.node[1][q] + r.node[2][q], r.gamma[q],
                           1e-14 * fmax(1.0, fabs(r.gamma[q])));
            for (int k = 0; k < 50; k++) {
                double next = r.phi[0][0] * y + r.phi[0][1] * y_dot;
                double next_dot = r.phi[1][0] * y + r.phi[1][1] * y_dot;
                for (int j = 0; j < 3; j++) {
                    const double t_s = (k + node[j]) * dt_s;
                    next += r.node[j][0] * t_s * t_s;
                    next_dot += r.node[j][1] * t_s * t_s;
                }
                y = next, y_dot = next_dot;
                const double t_s = (k + 1) * dt_s;
                CHECK_NEAR(y, t_s * t_s + a * t_s + b, 1e-12 * (t_s * t_s + fabs(b)));
            }
        }
}

/* At rest in a constant input nothing settles; and once a pulse is over, its whole angle has come out:
 * 0.5 s are 44 time constants of 1/(zeta w). */
static void bandwidth_loses_nothing(void **state)
{
    (void)state;
    const triad_key keys[] = { { "bandwidth", 20.0, NULL } };
    sine constant = { .offset = 0.3 };
    double *y = gyro(keys, 1, 0.01, 500, swing, &constant);
    for (int k = 0; k < 500; k++) CHECK_REL(y[k], 0.3 * 0.01, 1e-14);
    free(y);
}

static void pulse(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    (void)user;
    for (int i = 0; i < 3; i++) f_ib_b[i] = omega_ib_b[i] = 0.0;
    omega_ib_b[0] = t_s > 0.1 && t_s < 0.2 ? 1.0 : 0.0;
}

static void a_pulse_comes_out_whole(void **state)
{
    (void)state;
    const triad_key keys[3][2] = { { { "bandwidth", 20.0, NULL } },
                                   { { "bandwidth", 20.0, NULL },
                                     { "bandwidth_order", 1.0, NULL } },
                                   { { "delay", 0.0173, NULL } } };
    const int count[3] = { 1, 2, 1 };
    for (int i = 0; i < 3; i++) {
        double *const y = gyro(keys[i], count[i], 0.01, 100, pulse, NULL);
        double sum = 0.0;
        for (int k = 0; k < 100; k++) sum += y[k];
        CHECK_NEAR(sum, 0.1, 1e-14);
        free(y);
    }
}

/* Angles that are polynomials of the time. */
static void polynomial(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    const double *const c = user; /* theta = c0 t + c1 t^2 + c2 t^3 + c3 t^4 */
    for (int i = 0; i < 3; i++) f_ib_b[i] = omega_ib_b[i] = 0.0;
    omega_ib_b[0] = c[0] + t_s * (2.0 * c[1] + t_s * (3.0 * c[2] + t_s * 4.0 * c[3]));
}

static double angle(const double *c, double t_s)
{
    return t_s * (c[0] + t_s * (c[1] + t_s * (c[2] + t_s * c[3])));
}

/* Exact for angles of third degree, whatever the part of a sample: rounding of sums of a few numbers of
 * the size of the increments. Of fourth degree the cubic through four points misses
 * c (x + 1) x (x - 1) (x - 2) dt^4 (below c dt^4 of the angle), which cancels in increments but for its
 * change, none for a constant fourth derivative. */
static void a_delay_is_exact_for_cubics(void **state)
{
    (void)state;
    static const double samples[] = { 0.3, 1.0, 2.7, 17.999, 63.5, 64.0 };
    double cubic[2][4] = { { 0.2, -0.03, 0.07, 0.0 }, { 0.2, -0.03, 0.07, 0.11 } };
    const double dt_s = 0.01;
    for (int p = 0; p < 2; p++)
        for (int i = 0; i < 6; i++) {
            const double late_s = samples[i] * dt_s;
            const triad_key keys[] = { { "delay", late_s, NULL } };
            double *const y = gyro(keys, 1, dt_s, 300, polynomial, cubic[p]);
            for (int k = 70; k < 300; k++) {
                const double end_s = (k + 1) * dt_s - late_s;
                const double expected = angle(cubic[p], end_s) - angle(cubic[p], end_s - dt_s);
                CHECK_NEAR(y[k], expected, 20.0 * 2e-16 * angle(cubic[p], 3.0));
            }
            free(y);
        }
}

/* Mean of what a sinusoid of amplitude A has above c. */
static double excess(double A, double c)
{
    if (c >= A) return 0.0;
    return (sqrt(A * A - c * c) - c * acos(c / A)) / M_PI;
}

/* Samples with a corner of the clipped wave are integrated by three nodes: that is off by less than a
 * tenth of A w dt of the sample's length; four corners in a period of N samples, whose errors have
 * different signs: 4 (2 pi/N)/N/10 bounds their sum over a period. */
enum { N = 397 };
static const double CORNERS = 4.0 * 2.0 * M_PI / N / N / 10.0;

static void the_range_rectifies(void **state)
{
    (void)state;
    const double dt_s = 1e-3, A = 2.0;
    static const double offset[] = { 0.0, 0.3, 0.9 }, range[] = { 0.5, 1.5, 1.9 };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            sine s = { A, 1.0 / (N * dt_s), offset[i] };
            const double R = range[k], b = offset[i];
            const triad_key keys[] = { { "saturation", R, NULL } };
            double *const y = gyro(keys, 1, dt_s, 4 * N, swing, &s);
            double sum = 0.0;
            for (int q = 0; q < 4 * N; q++) {
                sum += y[q];
                assert_true(fabs(y[q]) <= R * dt_s * (1.0 + 1e-12));
            }
            CHECK_NEAR(sum / (4 * N * dt_s), b - excess(A, R - b) + excess(A, R + b), A * CORNERS);
            /* describing function of the limiter */
            if (b == 0.0) {
                const double r = R / A, half = M_PI / N;
                const double gain = 2.0 / M_PI * (asin(r) + r * sqrt(1.0 - r * r));
                const double _Complex a = component(y, 0, 4 * N, 2.0 * M_PI * s.f_hz, dt_s);
                CHECK_NEAR(cabs(a) / dt_s, A * gain * sin(half) / half, 2.0 * A * CORNERS);
            }
            free(y);
        }
}

/* The errors of other stages count: a bias moves what is clipped. */
static void the_range_sees_the_bias(void **state)
{
    (void)state;
    sine s = { 2.0, 1.0 / (N * 1e-3), 0.0 };
    const triad_key keys[] = { { "saturation", 1.5, NULL }, { "bias", 0.3, NULL } };
    double *const y = gyro(keys, 2, 1e-3, 4 * N, swing, &s);
    double sum = 0.0;
    for (int k = 0; k < 4 * N; k++) sum += y[k];
    CHECK_NEAR(sum / (4 * N * 1e-3), 0.3 - excess(2.0, 1.2) + excess(2.0, 1.8), 2.0 * CORNERS);
    free(y);
}

static void a_dead_band_has_its_describing_function(void **state)
{
    (void)state;
    const double A = 2.0, dt_s = 1e-3;
    for (double d = 0.1; d < 2.0; d += 0.4) {
        sine s = { A, 1.0 / (N * dt_s), 0.0 };
        const triad_key keys[] = { { "dead_band", d, NULL } };
        double *const y = gyro(keys, 1, dt_s, 4 * N, swing, &s);
        const double r = d / A, half = M_PI / N;
        const double gain = 1.0 - 2.0 / M_PI * (asin(r) - r * sqrt(1.0 - r * r));
        const double _Complex a = component(y, 0, 4 * N, 2.0 * M_PI * s.f_hz, dt_s);
        /* At a corner the output jumps by d: three nodes place it to half of their largest weight, 2/9
         * of a sample; four jumps in a period, twice that in the first harmonic. */
        CHECK_NEAR(cabs(a) / dt_s, A * gain * sin(half) / half, 8.0 * d * (2.0 / 9.0) / N);
        free(y);
    }
}

/* What is rounded off is lost, sample by sample. */
static void a_resolution_carries_nothing(void **state)
{
    (void)state;
    const double step = 0.01;
    const triad_key keys[] = { { "resolution", step, NULL } };
    for (double x = -0.0249; x < 0.025; x += 0.0031) {
        sine constant = { .offset = x };
        double *const y = gyro(keys, 1, 0.02, 50, swing, &constant);
        for (int k = 0; k < 50; k++) CHECK_NEAR(y[k] / 0.02, round(x / step) * step, 1e-16);
        free(y);
    }
}

static void temperature_is_a_polynomial(void **state)
{
    (void)state;
    static const schuler_temperature warm = {
        .reference_K = 298.0, .start_K = 310.0, .end_K = 310.0, .time_s = 1.0
    };
    const triad_key keys[] = {
        { "bias_temperature", 1e-6, NULL },     { "bias_temperature_2", 2e-8, NULL },
        { "bias_temperature_3", -3e-10, NULL }, { "scale_temperature", 1e-5, NULL },
        { "scale_temperature_2", -2e-7, NULL }, { "scale_temperature_3", 5e-9, NULL }
    };
    sine constant = { .offset = 0.4 };
    const triad_job job = { .model = "linear",
                            .instrument = SCHULER_GYRO,
                            .keys = keys,
                            .count = 6,
                            .specimens = 1,
                            .dt_s = 0.01,
                            .n = 40,
                            .input = swing,
                            .user = &constant,
                            .temperature = &warm };
    double *const y = triad_measure(&job);
    const double d = 12.0, bias = d * (1e-6 + d * (2e-8 - d * 3e-10));
    const double scale = d * (1e-5 + d * (-2e-7 + d * 5e-9));
    for (int k = 0; k < 40; k++) CHECK_REL(y[k] / 0.01, 0.4 * (1.0 + scale) + bias, 1e-14);
    free(y);
}

/* A turn that grows and coasts, about a skew axis. */
static void turning(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    const double *const axis = user;
    for (int i = 0; i < 3; i++) {
        f_ib_b[i] = 0.0;
        omega_ib_b[i] = axis[i] * (0.5 + 2.0 * t_s);
    }
}

/* f = alpha x r + omega x (omega x r); quadratic in time, so exact in increments. */
static void a_lever_arm_feels_the_turn(void **state)
{
    (void)state;
    double axis[3] = { 0.3, -0.7, 1.1 };
    static const double arm[3] = { 0.4, -0.2, 0.9 };
    static const double sizes[9] = { 0.01, 0, 0, 0, 0.02, 0.005, -0.01, 0, 0.03 };
    const triad_key keys[] = { { "lever_arm", 0.0, arm }, { "size_effect", 0.0, sizes } };
    const double dt_s = 0.01;
    const triad_job job = { .model = "linear",
                            .instrument = SCHULER_ACCEL,
                            .keys = keys,
                            .count = 2,
                            .specimens = 1,
                            .dt_s = dt_s,
                            .n = 100,
                            .input = turning,
                            .user = axis };
    double *const y = triad_measure(&job);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 100; k++) {
            const double a = k * dt_s, b = a + dt_s;
            /* integral of (0.5 + 2 t)^2, and of its derivative's 2 */
            const double square =
                0.25 * dt_s + (b * b - a * a) + 4.0 / 3.0 * (b * b * b - a * a * a);
            double r[3], u = 0.0, uu = 0.0;
            for (int c = 0; c < 3; c++) {
                r[c] = arm[c] + sizes[3 * i + c];
                u += axis[c] * r[c];
                uu += axis[c] * axis[c];
            }
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            const double turn = 2.0 * dt_s * (axis[p] * r[q] - axis[q] * r[p]);
            CHECK_NEAR(y[i * 100 + k], turn + square * (axis[i] * u - uu * r[i]), 1e-15);
        }
    free(y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bandwidth_has_gain_and_phase),
        cmocka_unit_test(a_parabola_is_answered_exactly),
        cmocka_unit_test(bandwidth_loses_nothing),
        cmocka_unit_test(a_pulse_comes_out_whole),
        cmocka_unit_test(a_delay_is_exact_for_cubics),
        cmocka_unit_test(the_range_rectifies),
        cmocka_unit_test(the_range_sees_the_bias),
        cmocka_unit_test(a_dead_band_has_its_describing_function),
        cmocka_unit_test(a_resolution_carries_nothing),
        cmocka_unit_test(temperature_is_a_polynomial),
        cmocka_unit_test(a_lever_arm_feels_the_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Gyros that move: rectified vibration (B3), rings and coils of light (B5 to B8), lock-in against the
 * equation of its phase, drift with the temperature (B11). */
#include "core/earth.h"
#include "indicate.h"
#include "sensors/optics.h"

static const double g = 9.80665, deg = M_PI / 180.0, deg_h = M_PI / 180.0 / 3600.0;

#define EXACT(actual, expected) CHECK_REL(actual, expected, 1e-14)

static double sensed(indication *x, double i, double o, double s)
{
    x->omega[0] = i, x->omega[1] = o, x->omega[2] = s;
    return indicated(x, x->f[0], x->f[1], x->f[2]);
}

/* ---- On the stand ----------------------------------------------------------------------------- */

/* f = force sin and omega = steady + swing sin, of 20 Hz. */
typedef struct {
    double force[3], steady, swing[3];
} shaking;

static void shake(void *user, double t_s, double f[3], double omega[3])
{
    const shaking *const s = user;
    const double now = sin(2.0 * M_PI * 20.0 * t_s);
    for (int a = 0; a < 3; a++) {
        f[a] = s->force[a] * now;
        omega[a] = (a == 0 ? s->steady : 0.0) + s->swing[a] * now;
    }
}

/* Of the x gyro over 800 samples at 100 Hz, which are 160 whole periods. A step is a fifth of one, so
 * of the harmonics of what is integrated the quadrature lets those of order 5, 10, ... through. */
static double mean_shaken(const indication *x, shaking s)
{
    return indicated_mean(x, shake, &s);
}

/* 5 g rms along the diagonal of i and s: D_IS g^2/2. A sine squared has no harmonic of order 5, so only
 * rounding is left. The argument of the sine reaches 1000 and is rounded to 1e-13: so is the drift, and
 * where the gyros swing it is their rate of 0.2 rad/s, 1e-9 of the 2e-5 rad/s that are rectified. */
static void b3_vibration_is_rectified_by_itself(void **state)
{
    (void)state;
    const double A = 5.0 * g; /* rms of 5 g/sqrt(2) on either axis */
    indication x = indication_of("spinning_mass", SCHULER_GYRO);
    give(&x, "D_IS", 0.04 * deg_h / (g * g));
    const double mean = mean_shaken(&x, (shaking){ .force = { A, 0.0, A } });
    CHECK_REL(mean / deg_h, 0.5, 1e-12);
    indication y = indication_of("vibratory", SCHULER_GYRO);
    give(&y, "g2_oo", 0.1 * deg_h / (g * g));
    const double square = mean_shaken(&y, (shaking){ .force = { 0.0, A, A } });
    CHECK_REL(square / deg_h, 0.1 * 12.5, 1e-12);
    /* The same of the case's rates: (I_SS - I_II)/H times 0.2^2/2. */
    indication z = indication_of("spinning_mass", SCHULER_GYRO);
    give(&z, "aniso_inertia", 1e-3);
    const double inertia = mean_shaken(&z, (shaking){ .swing = { 0.2, 0.0, 0.2 } });
    CHECK_REL(inertia, 1e-3 * 0.02, 1e-9);
}

/* ---- Light ------------------------------------------------------------------------------------ */

static void b5_to_b8_optics(void **state)
{
    (void)state;
    const double arcsec = deg / 3600.0;
    const double pulse = schuler_ring_pulse(632.8e-9, 0.3, schuler_ring_triangle_area(0.3));
    EXACT(pulse / arcsec, 2.26074839414846);
    EXACT(SCHULER_OMEGA_IE_RADPS / pulse, 6.65313615393759);
    const double walk = schuler_lock_in_random_walk(0.05 * deg, 2.0 * arcsec, 100.0 * deg);
    EXACT(walk, 8.20580486530331e-7);
    EXACT(walk * 60.0 / deg, 0.00282094791773878);
    EXACT(schuler_lock_in_rate(1.0 * deg, 0.1 * deg) / deg, 0.99498743710662);
    EXACT(schuler_lock_in_rate(-10.0 * deg, 0.1 * deg) / deg, -9.99949998749937);
    assert_true(schuler_lock_in_rate(0.05, 0.1) == 0.0 && schuler_lock_in_rate(0.0, 0.0) == 0.0);
    const double gain = schuler_fibre_gain(1000.0, 0.1, 1550e-9);
    EXACT(gain, 1.3521580786785);
    EXACT(1e6 * gain * deg_h, 6.55544735566123);
    EXACT(M_PI / gain / deg, 133.120529942711);
}

/* B7 in the model, which acts on I + D and stands before the scale factor. */
static void without_dither_a_ring_locks(void **state)
{
    (void)state;
    indication x = indication_of("ring_laser", SCHULER_GYRO);
    give(&x, "lock_in_undithered", 0.1 * deg);
    EXACT(sensed(&x, 1.0 * deg, 0.0, 0.0) / deg, 0.99498743710662);
    EXACT(sensed(&x, -1.0 * deg, 0.0, 0.0) / deg, -0.99498743710662);
    EXACT(sensed(&x, 10.0 * deg, 0.0, 0.0) / deg, 9.99949998749937);
    /* What is left within is the rounding of a weighted mean. */
    CHECK_NEAR(sensed(&x, 0.09 * deg, -0.03 * deg, 0.0), 0.0, 3e-16 * deg);
    CHECK_NEAR(x.out[1], 0.0, 3e-16 * deg);
    give(&x, "D_F", -0.2 * deg);
    give(&x, "epsilon_K", 0.25);
    EXACT(sensed(&x, 0.0, 0.0, 0.0), 0.8 * schuler_lock_in_rate(-0.2 * deg, 0.1 * deg));
}

/* The law is for the instantaneous rate. Its mean over a swing, exactly: by the trapezoidal rule over a
 * period, which converges faster than any power. What the three nodes add are the harmonics of order 5
 * and 10 of the law, twice their size at most (the weights sum to 1); later ones are far smaller. */
static void lock_in_sees_the_instantaneous_rate(void **state)
{
    (void)state;
    const double L = 0.3, steady = 1.0, swing = 0.4;
    enum { N = 1000 };
    double mean = 0.0, harmonic[2][2] = { { 0 } };
    for (int k = 0; k < N; k++) {
        const double p = 2.0 * M_PI * k / N;
        const double y = schuler_lock_in_rate(steady + swing * sin(p), L) / N;
        mean += y;
        for (int h = 0; h < 2; h++) {
            harmonic[h][0] += y * cos(5.0 * (h + 1) * p);
            harmonic[h][1] += y * sin(5.0 * (h + 1) * p);
        }
    }
    const double let_through =
        2.0 * (hypot(harmonic[0][0], harmonic[0][1]) + hypot(harmonic[1][0], harmonic[1][1]));
    assert_true(let_through < 0.05 * (schuler_lock_in_rate(steady, L) - mean)); /* it tells */
    indication x = indication_of("ring_laser", SCHULER_GYRO);
    give(&x, "lock_in_undithered", L);
    const double got = mean_shaken(&x, (shaking){ .steady = steady, .swing = { swing } });
    CHECK_NEAR(got, mean, let_through);
}

/* The phase of the beat through one turnaround of a dither of 500 Hz, by the classical Runge-Kutta rule
 * with 40 steps in the fastest beat. It begins and ends where psi + (Omega_L/Omega) cos psi is smooth.
 * Returned: the angle that lock-in adds. */
static double turnaround(double psi, double S, double L, double dither, double f_hz)
{
    const double w = 2.0 * M_PI * f_hz;
    const int steps = 2 * (int)(S * dither / f_hz);
    const double dt = 0.5 / f_hz / steps, before = psi - L / dither * cos(psi);
    for (int k = 0; k < steps; k++) {
        const double t = -0.25 / f_hz + k * dt;
        const double start = dither * sin(w * t), middle = dither * sin(w * (t + 0.5 * dt)),
                     end = dither * sin(w * (t + dt));
        const double a = S * (start + L * sin(psi));
        const double b = S * (middle + L * sin(psi + 0.5 * dt * a));
        const double c = S * (middle + L * sin(psi + 0.5 * dt * b));
        const double d = S * (end + L * sin(psi + dt * c));
        psi += dt / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return (psi + L / dither * cos(psi) - before) / S;
}

/* Two turnarounds a cycle, each with a phase of its own. Left out of N is the square of the kick that the
 * phase gets, Omega_L sqrt(2 pi S/alpha) = 0.024 rad: 6e-4. That the angular acceleration changes during
 * a turnaround turns the phase at which it kicks, and alters the size by the square of 500/180000 only,
 * the dither frequency over the fastest beat. */
static void lock_in_random_walk_is_that_of_the_phase_equation(void **state)
{
    (void)state;
    const double K = 2.0 * deg / 3600.0, S = 2.0 * M_PI / K, L = 0.05 * deg, dither = 100.0 * deg;
    enum { PHASES = 8 }; /* a sine of the phase: any three give its mean square */
    double sum = 0.0, square = 0.0;
    for (int k = 0; k < PHASES; k++) {
        const double x = turnaround(2.0 * M_PI * k / PHASES, S, L, dither, 500.0);
        sum += x;
        square += x * x;
    }
    const double variance = square / PHASES - sum / PHASES * (sum / PHASES);
    CHECK_REL(sqrt(2.0 * 500.0 * variance), schuler_lock_in_random_walk(L, K, dither), 6e-4);
}

/* ---- Noise of the model ----------------------------------------------------------------------- */

enum { SPECIMENS = 64, STEPS = 320 };
typedef double noise[3 * STEPS * SPECIMENS];

static void still(void *user, double t_s, double f[3], double omega[3])
{
    (void)user, (void)t_s;
    for (int a = 0; a < 3; a++) f[a] = omega[a] = 0.0;
}

/* Increments at rest of runs 0 to 63, at 50 Hz, with the stages' keys too; NULL-terminated. */
static void record(const char *model, const char *const *keys, const double *values, noise out)
{
    static schuler_lane_spec specs[SPECIMENS];
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    bool given[SCHULER_PARAMS_MAX] = { false };
    const indication x = indication_of(model, SCHULER_GYRO);
    assert_true(schuler_chain_params(x.model, SCHULER_GYRO, params) > 0);
    for (int i = 0; i < SPECIMENS; i++) {
        specs[i] = x.values;
        specs[i].run = (uint64_t)i;
        for (int k = 0; keys[k]; k++)
            for (int p = 0; params[p].key; p++)
                if (strcmp(params[p].key, keys[k]) == 0) {
                    given[p] = true;
                    for (int c = 0; c < params[p].components; c++) specs[i].value[p][c] = values[k];
                }
    }
    const schuler_stand_setup setup = { .chain = { .model = x.model,
                                                   .isa = SCHULER_ISA_SCALAR,
                                                   .dt_s = 0.02,
                                                   .seed = 7,
                                                   .settings = &specs[0],
                                                   .given = given,
                                                   .instrument = SCHULER_GYRO },
                                        .specs = specs,
                                        .specimens = SPECIMENS,
                                        .input = still };
    schuler_stand *stand = NULL;
    assert_int_equal(schuler_stand_create(&stand, &setup, NULL), SCHULER_OK);
    for (int b = 0; b < STEPS / SCHULER_BLOCK; b++)
        schuler_stand_next(stand, SCHULER_BLOCK, out + b * SPECIMENS * 3 * SCHULER_BLOCK);
    schuler_stand_free(stand);
}

static double rms(const double *x, int n)
{
    double sum = 0.0;
    for (int k = 0; k < n; k++) sum += x[k] * x[k];
    return sqrt(sum / n);
}

/* 61440 numbers: their deviation is known to 1/sqrt(2 61440) = 0.285 %, here four times that. */
static void a_dithered_ring_has_the_random_walk(void **state)
{
    (void)state;
    static noise a, b, both;
    const char *const lock_in[] = { "lock_in", "pulse_angle", "dither_rate", NULL };
    const double settings[] = { 0.05 * deg, 3.0 * deg / 3600.0, 50.0 * deg };
    record("ring_laser", lock_in, settings, a);
    const double expected = schuler_lock_in_random_walk(settings[0], settings[1], settings[2]);
    CHECK_REL(rms(a, 3 * STEPS * SPECIMENS) / sqrt(0.02), expected, 4.0 * 0.00285);
    const char *const quantum[] = { "quantum_limit", NULL };
    const double N[] = { 1e-6 };
    record("ring_laser", quantum, N, b);
    CHECK_REL(rms(b, 3 * STEPS * SPECIMENS) / sqrt(0.02), 1e-6, 4.0 * 0.00285);
    /* Two noises, not one: they add sample by sample, and are not alike. */
    const char *const two[] = { "lock_in", "pulse_angle", "dither_rate", "quantum_limit", NULL };
    const double with[] = { settings[0], settings[1], settings[2], N[0] };
    record("ring_laser", two, with, both);
    double product = 0.0;
    for (int k = 0; k < 3 * STEPS * SPECIMENS; k++) {
        CHECK_NEAR(both[k], a[k] + b[k], 1e-20);
        product += a[k] * b[k] / (3 * STEPS * SPECIMENS);
    }
    CHECK_NEAR(product / (rms(a, 3 * STEPS * SPECIMENS) * rms(b, 3 * STEPS * SPECIMENS)), 0.0,
               4.0 / sqrt(3.0 * STEPS * SPECIMENS));
}

/* [I + E + D] [1 + epsilon_K]^-1, D with its noise, that of the chain too. */
static void the_bracket_holds_the_noise(void **state)
{
    (void)state;
    static noise plain, scaled;
    const char *const keys[] = { "lock_in", "quantum_limit", "angle_random_walk", "epsilon_K",
                                 NULL };
    double values[] = { 1e-3, 1e-6, 1e-6, 0.0 };
    record("ring_laser", keys, values, plain);
    values[3] = 0.25;
    record("ring_laser", keys, values, scaled);
    for (int k = 0; k < 3 * STEPS * SPECIMENS; k++) CHECK_NEAR(1.25 * scaled[k], plain[k], 1e-20);
    const char *const fibre[] = { "angle_random_walk", "epsilon_K", NULL };
    const double fibre_values[] = { 1e-6, 0.25 }, without[] = { 1e-6, 0.0 };
    record("fibre_optic", fibre, without, plain);
    record("fibre_optic", fibre, fibre_values, scaled);
    for (int k = 0; k < 3 * STEPS * SPECIMENS; k++) CHECK_NEAR(1.25 * scaled[k], plain[k], 1e-20);
}

/* ---- Temperature ------------------------------------------------------------------------------ */

/* B11: 35 K above the reference and rising by 2 K/min; within a step of 1 us that is 3e-8 K, 1e-9 of
 * the drift. */
static void b11_temperature(void **state)
{
    (void)state;
    const indication x = indication_of("conventional", SCHULER_GYRO);
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    static schuler_lane_spec spec;
    bool given[SCHULER_PARAMS_MAX] = { false };
    static const struct {
        const char *key;
        double value;
    } drift[] = {
        { "bias", 0.1 },
        { "bias_temperature", 0.02 },
        { "bias_temperature_2", -1e-4 },
        { "bias_temperature_3", 1e-6 },
        { "bias_temperature_rate", 0.5 * 60.0 },
    };
    spec = x.values;
    assert_true(schuler_chain_params(x.model, SCHULER_GYRO, params) > 0);
    for (int p = 0; params[p].key; p++)
        for (size_t k = 0; k < sizeof drift / sizeof drift[0]; k++)
            if (strcmp(params[p].key, drift[k].key) == 0) {
                given[p] = true;
                for (int c = 0; c < 3; c++) spec.value[p][c] = drift[k].value * deg_h;
            }
    static const double at_s[2] = { 0.0, 60.0 }, is_K[2] = { 335.0, 337.0 };
    const schuler_temperature rising = {
        .reference_K = 300.0, .count = 2, .at_s = at_s, .is_K = is_K
    };
    const schuler_stand_setup setup = { .chain = { .model = x.model,
                                                   .isa = SCHULER_ISA_SCALAR,
                                                   .dt_s = 1e-6,
                                                   .settings = &spec,
                                                   .given = given,
                                                   .temperature = &rising,
                                                   .instrument = SCHULER_GYRO },
                                        .specs = &spec,
                                        .specimens = 1,
                                        .input = still };
    schuler_stand *stand = NULL;
    assert_int_equal(schuler_stand_create(&stand, &setup, NULL), SCHULER_OK);
    double out[3][SCHULER_BLOCK];
    schuler_stand_next(stand, 1, out[0]);
    schuler_stand_free(stand);
    for (int a = 0; a < 3; a++) CHECK_REL(out[a][0] / 1e-6 / deg_h, 1.720375, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(b3_vibration_is_rectified_by_itself),
        cmocka_unit_test(b5_to_b8_optics),
        cmocka_unit_test(without_dither_a_ring_locks),
        cmocka_unit_test(lock_in_sees_the_instantaneous_rate),
        cmocka_unit_test(lock_in_random_walk_is_that_of_the_phase_equation),
        cmocka_unit_test(a_dithered_ring_has_the_random_walk),
        cmocka_unit_test(the_bracket_holds_the_noise),
        cmocka_unit_test(b11_temperature),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

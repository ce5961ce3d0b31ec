/* SPDX-License-Identifier: MIT */
/* The baro-inertial vertical channel in whole missions. */
#include "mission.h"

#define HEAD                                                                                       \
    "scenario: baro\n"                                                                             \
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m}, for: %s}\n"         \
    "report: {every: %s}\nruns: %d\n"                                                              \
    "imu: {rate: %d Hz, accel: {model: linear%s}, gyro: {model: linear}}\n"

static schuler_scenario *at_rest(const char *duration, const char *every, int runs, int rate_hz,
                                 const char *accel, const char *rest)
{
    char text[2048], head[1024];
    snprintf(head, sizeof head, HEAD, duration, every, runs, rate_hz, accel);
    snprintf(text, sizeof text, "%s%s", head, rest);
    return mission_text(text);
}

/* D11c: a step of 1 mg on the down-axis, up as height error b t^2/2 exp(-t/tau): -26.54 m at 200 s.
 * The loop is of second order in T/tau (1e-5), the gradient of gravity is 2g/R to 0.3 % (3e-5 of k2). More
 * comes from Coriolis, twice: k1 e is an up-velocity that the navigator has and the vehicle has not; it
 * grows an east velocity and that an up-acceleration, at (2 W cos L)^2 k1 e, of which the loop leaves
 * tau^3 = 3 (2 W cos L)^2 tau^2 = 3.2e-4 of e. */
static void a_step_of_the_accelerometer_is_driven_out(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest("2000 s", "40 s", 1, 100, ", bias: [0 mg, 0 mg, 1 mg]",
                                  "navigation: {vertical: baro}\n");
    mission_trace t = mission_errors(s, "accel.bias");
    const double b_mps2 = 9.80665e-3, peak_m = 26.5437151070466;
    assert_int_equal(t.count, 51);
    for (size_t i = 0; i < t.count; i++) {
        const double t_s = 40.0 * (double)i;
        CHECK_NEAR(t.rows[i].r_n[2], 0.5 * b_mps2 * t_s * t_s * exp(-t_s / 100.0), 4e-4 * peak_m);
    }
    CHECK_REL(t.rows[5].r_n[2], peak_m, 4e-4);
    free(t.rows);
    schuler_scenario_free(s);
}

/* A bias of the barometer is the height's once the transient, of (t/tau)^2/2 exp(-t/tau) = 4e-7, is over.
 * Coriolis of the velocity that settles it, 2 W cos(L) h = 1e-4 x 50 = 5 mm/s east, swings by 5 mm/s x 806
 * s = 4 m; the up-acceleration of that swing changes by 1e-4 x 5 mm/s x 2 pi/84.4 min = 6.4e-10 m/s^3, of
 * which the loop leaves tau^3: 0.64 mm, and k1 times that in the navigator's velocity. */
static void a_bias_of_the_barometer_is_that_of_the_height(void **state)
{
    (void)state;
    schuler_scenario *s =
        at_rest("2000 s", "40 s", 1, 100, "", "navigation: {vertical: baro}\nbaro: {bias: 50 m}\n");
    mission_trace t = mission_errors(s, "baro.bias");
    const schuler_error_row *const end = &t.rows[t.count - 1];
    CHECK_NEAR(-end->r_n[2], 50.0, 1e-3);
    CHECK_NEAR(end->v_n[2], 0.0, 3e-5);
    for (size_t i = 0; i < t.count; i++)
        CHECK_NEAR(hypot(t.rows[i].r_n[0], t.rows[i].r_n[1]), 0.0, 5.0);
    free(t.rows);
    schuler_scenario_free(s);
}

typedef struct {
    double sum2;
    int count;
} spread;

static schuler_status add_height(void *user, const char *id, int run, const schuler_error_row *rows,
                                 size_t count)
{
    spread *s = user;
    (void)run;
    if (strcmp(id, "all") != 0) return SCHULER_OK;
    s->sum2 += rows[count - 1].r_n[2] * rows[count - 1].r_n[2];
    s->count++;
    return SCHULER_OK;
}

static double height_variance(schuler_scenario *s)
{
    spread heights = { 0 };
    const schuler_run_options options = { .errors = add_height, .user = &heights };
    schuler_result_free(mission_run(s, &options));
    schuler_scenario_free(s);
    assert_int_equal(heights.count, 800);
    return heights.sum2 / heights.count;
}

/* White noise of density N^2 through (k1 s^2 + k2 s + k3)/(s + 1/tau)^3: with k2 = 3/tau^2 (1 + e),
 * e = 0.0102, variance (27 + (9 (1+e)^2 - 6) + 3)/16 N^2/tau = 2.074 N^2/tau. 800 runs: a relative
 * sigma of sqrt(2/800) = 5 %, of which four. */
static void white_noise_of_the_barometer_is_averaged(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest("1500 s", "1500 s", 800, 10, "",
                                  "navigation: {vertical: baro}\n"
                                  "baro: {noise: 10 m/sqrt(Hz)}\n");
    const double e = 3.07495843134e-6 / 3e-4;
    const double expected = (24.0 + 9.0 * (1.0 + e) * (1.0 + e)) / 16.0 * 100.0 / 100.0;
    CHECK_REL(height_variance(s), expected, 4.0 * sqrt(2.0 / 800.0));
}

/* Weather of 1e5 s is a bias to a loop of 100 s: what it changes in a tau, sqrt(2 x 100/1e5) = 4 % of
 * sigma, is lost at most; the draws have four sigmas of 5 %. */
static void slow_weather_is_followed(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest("1500 s", "1500 s", 800, 10, "",
                                  "navigation: {vertical: baro}\n"
                                  "baro: {gauss_markov: 20 m, gauss_markov_time: 1e5 s}\n");
    CHECK_REL(height_variance(s), 400.0, 4.0 * sqrt(2.0 / 800.0) + 0.01);
}

/* Perfect sensors and a perfect barometer, on the manoeuvres: what is measured for the channel held to
 * the truth holds for this one, 0.1 mm horizontally; the height, which is corrected by the error of
 * an update alone, likewise. */
static void a_perfect_barometer_changes_nothing(void **state)
{
    (void)state;
    const char *const set[] = { "navigation.vertical=baro", "report.every=60 s" };
    const schuler_overrides o = { .set = set, .count_set = 2, .only = "numerical" };
    schuler_scenario *s = mission_gallery("manoeuvres", &o);
    mission_trace t = mission_errors(s, "none");
    for (size_t i = 0; i < t.count; i++)
        for (int k = 0; k < 3; k++) CHECK_NEAR(t.rows[i].r_n[k], 0.0, 1e-4);
    free(t.rows);
    schuler_scenario_free(s);
}

/* The level channels hardly see how the height is held: Coriolis as in the first test makes the inertia of
 * the east channel 3 (2 W cos L)^2 tau^2 = 3.2e-4 larger, which after a Schuler period is 1e-3 of a radian:
 * 1e-3 of the largest error, 2 R b/g = 1.3 km. */
static void the_level_channels_are_those_of_a_held_height(void **state)
{
    (void)state;
    mission_trace t[2];
    const char *const words[2] = { "navigation: {vertical: baro}\n",
                                   "navigation: {vertical: truth}\n" };
    for (int i = 0; i < 2; i++) {
        schuler_scenario *s =
            at_rest("84 min", "10 min", 1, 50, ", bias: [100 ug, -50 ug, 0 ug]", words[i]);
        t[i] = mission_errors(s, "accel.bias");
        schuler_scenario_free(s);
    }
    for (size_t i = 0; i < t[0].count; i++)
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(t[0].rows[i].r_n[k], t[1].rows[i].r_n[k], 1e-3 * 1300.0);
    free(t[0].rows);
    free(t[1].rows);
}

static const char noisy[] =
    "navigation: {vertical: baro, samples_per_update: 2}\n"
    "initial: {position: {normal: 20 m}}\n"
    "baro: {bias: {normal: 30 m}, scale_factor: 1 %, lag: {uniform: [1 s, 2 s]},"
    " noise: 1 m/sqrt(Hz), gauss_markov: 10 m, gauss_markov_time: 10 min}\n";

static schuler_status keep_bits(void *user, const char *id, int run, const schuler_error_row *rows,
                                size_t count)
{
    uint64_t *sum = user; /* FNV-1a over all rows, which come in one order */
    (void)id, (void)run;
    const unsigned char *const bytes = (const unsigned char *)rows;
    for (size_t i = 0; i < count * sizeof *rows; i++) *sum = (*sum ^ bytes[i]) * 0x100000001b3ULL;
    return SCHULER_OK;
}

static void the_bits_do_not_depend_on_width_or_threads(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest("100 s", "7 s", 30, 100, ", bias: {normal: 50 ug}", noisy);
    uint64_t reference = 0;
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++)
        for (int threads = 1; threads <= 2; threads++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            uint64_t sum = 0xcbf29ce484222325ULL;
            const schuler_run_options options = { .threads = threads,
                                                  .has_isa = 1,
                                                  .isa = (schuler_isa)isa,
                                                  .errors = keep_bits,
                                                  .user = &sum };
            schuler_result *r = mission_run(s, &options);
            assert_int_equal(r->row_count, 7 + 1); /* and the numerical one */
            schuler_result_free(r);
            if (reference == 0) reference = sum;
            assert_true(sum == reference);
        }
    schuler_scenario_free(s);
}

/* Common random numbers: what a source does does not depend on the others. */
static void a_source_alone_is_that_of_the_budget(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest("100 s", "10 s", 4, 100, ", bias: {normal: 50 ug}", noisy);
    mission_trace budget = { .id = "baro.gauss_markov", .run = 3 }, alone = budget;
    schuler_run_options options = { .errors = mission_keep, .user = &budget };
    schuler_result_free(mission_run(s, &options));
    const char *id = "baro.gauss_markov";
    s->only = (schuler_text_list){ .items = &id, .count = 1 };
    options.user = &alone;
    schuler_result_free(mission_run(s, &options));
    assert_int_equal(budget.count, alone.count);
    assert_true(budget.rows[10].r_n[2] != 0.0);
    assert_memory_equal(budget.rows, alone.rows, alone.count * sizeof *alone.rows);
    free(budget.rows);
    free(alone.rows);
    schuler_scenario_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_of_the_accelerometer_is_driven_out),
        cmocka_unit_test(a_bias_of_the_barometer_is_that_of_the_height),
        cmocka_unit_test(white_noise_of_the_barometer_is_averaged),
        cmocka_unit_test(slow_weather_is_followed),
        cmocka_unit_test(a_perfect_barometer_changes_nothing),
        cmocka_unit_test(the_level_channels_are_those_of_a_held_height),
        cmocka_unit_test(the_bits_do_not_depend_on_width_or_threads),
        cmocka_unit_test(a_source_alone_is_that_of_the_budget),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

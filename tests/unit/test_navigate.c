/* SPDX-License-Identifier: MIT */
/* Navigation over recorded increments, on files written here: a vehicle at rest, whose increments
 * are known in closed form. */
#include "recorded_at_rest.h"
#include "scenarios/increments.h"
#include <string.h>

/* Rounding only: ulp(6.4e6 m) = 1e-9 m a step, added at random over 3000 steps. */
static void at_rest_stays_at_rest(void **state)
{
    const recording r = { .steps = 3000, .every = 50 };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    assert_int_equal(result.steps, 3000);
    assert_int_equal(result.rows, 61);
    CHECK_NEAR(result.dt_s, dt_s, 1e-17);
    CHECK_NEAR(result.duration_s, 60.0, 1e-9);
    CHECK_NEAR(result.horizontal_m.max, 0.0, 1e-6);
    CHECK_NEAR(result.height_m.max, 0.0, 1e-6);
    CHECK_NEAR(result.attitude_rad.max, 0.0, 1e-12);
}

/* b t^2/2; the Schuler term changes it by (omega_s t)^2/12 = 5e-5 of it in 20 s, Coriolis less. At
 * rows k = 1..n, rms of (k/n)^2: sqrt(sum k^4/n^5) = sqrt(1/5 + 1/(2n) + 1/(3n^2) - 1/(30 n^4)). */
static void accelerometer_bias_grows_with_the_square_of_time(void **state)
{
    const double b_mps2 = 1e-3, t_s = 20.0, n = 20.0;
    const recording r = { .steps = 1000, .every = 50, .accel = { 0.0, 1e-3, 0.0 } };
    const double end_m = 0.5 * b_mps2 * t_s * t_s;
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_TRUTH, &result, NULL), SCHULER_OK);
    CHECK_REL(result.horizontal_m.final, end_m, 2e-4);
    CHECK_REL(result.horizontal_m.max, end_m, 2e-4);
    const double mean = 0.2 + 0.5 / n + 1.0 / (3.0 * n * n) - 1.0 / (30.0 * n * n * n * n);
    CHECK_REL(result.horizontal_m.rms, end_m * sqrt(mean), 2e-4);
    CHECK_REL(result.velocity_mps.final, b_mps2 * t_s, 2e-4);
    /* Held to the reference at each of its rows. */
    CHECK_NEAR(result.height_m.max, 0.0, 1e-5);
}

/* A bias that changes sign half-way stops what it started: the largest velocity error is b t/2, the
 * last is what Schuler and Coriolis terms left of it, below 2 omega_ie t/2 of it. */
static void the_largest_error_is_not_the_last(void **state)
{
    const recording r = { .steps = 1000, .every = 50, .accel = { 0.0, 1e-3, 0.0 }, .reverse = 1 };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_TRUTH, &result, NULL), SCHULER_OK);
    CHECK_REL(result.velocity_mps.max, 1e-3 * 10.0, 2e-3);
    CHECK_NEAR(result.velocity_mps.final, 0.0, 2e-3 * 1e-3 * 10.0);
}

/* Down-bias: the free channel falls by b t^2/2, gravity's gradient adds (t^2/6) 2g/R = 2e-4 of it.
 */
static void vertical_channel_is_free_unless_held(void **state)
{
    const recording r = { .steps = 1000, .every = 1000, .accel = { 0.0, 0.0, 1e-3 } };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    CHECK_REL(result.height_m.final, -0.5 * 1e-3 * 400.0, 1e-3);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_TRUTH, &result, NULL), SCHULER_OK);
    CHECK_NEAR(result.height_m.final, 0.0, 1e-5);
}

/* 20 s after a step of b the barometer's loop is at b t^2/2 exp(-t/tau), for rows every second to
 * (T/tau)^2; rows more than a quarter of tau apart are refused, with their place. */
static void the_references_height_is_a_barometer(void **state)
{
    recording r = { .steps = 1000, .every = 50, .accel = { 0.0, 0.0, 1e-3 } };
    schuler_navigate_result result;
    schuler_error error = { 0 };
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_BARO, &result, NULL), SCHULER_OK);
    CHECK_REL(result.height_m.final, -0.5 * 1e-3 * 400.0 * exp(-0.2), 1e-3);
    r.steps = r.every = 1300;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_BARO, &result, &error),
                     SCHULER_ERR_INPUT);
    assert_non_null(strstr(error.message, "at most 25 s apart"));
    assert_int_equal(error.place.line, 3);
}

/* Heading drift of a down-gyro: e t, the rest of the attitude follows with earth rate times t. */
static void gyro_drift_turns_the_attitude(void **state)
{
    const recording r = { .steps = 1000, .every = 50, .gyro = { 0.0, 0.0, 1e-6 } };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_TRUTH, &result, NULL), SCHULER_OK);
    CHECK_REL(result.attitude_rad.final, 1e-6 * 20.0, 2e-3);
}

/* Times that count from long ago carry rounding: ulp(1.7e9 s) = 2.4e-7 s is 1e-5 of a step. */
static void a_clock_that_counts_from_long_ago_is_read(void **state)
{
    const recording r = { .t0_s = 1.7e9, .steps = 3000, .every = 50 };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    assert_int_equal(result.steps, 3000);
    CHECK_NEAR(result.dt_s, dt_s, 1e-17);
}

/* Samples of a cubic: what is continued backwards is the cubic. */
static void samples_before_the_start_follow_the_first_ones(void **state)
{
    (void)state;
    static schuler_increments in; /* large */
    schuler_nav_setup setup = { 0 };
    in.n = 6;
    for (int k = 0; k < in.n; k++)
        for (int i = 0; i < 3; i++) {
            const double t = k + 1.0;
            in.dtheta[i][k] = 2.0 + i + 3.0 * t - 0.5 * t * t + 0.25 * t * t * t;
            in.dv[i][k] = -in.dtheta[i][k];
        }
    schuler_increments_prime(&in, &setup);
    for (int back = 0; back < SCHULER_PRIME; back++)
        for (int i = 0; i < 3; i++) {
            const double t = -back;
            const double expect = 2.0 + i + 3.0 * t - 0.5 * t * t + 0.25 * t * t * t;
            CHECK_NEAR(setup.prime_dtheta[back][i], expect, 1e-12);
            CHECK_NEAR(setup.prime_dv[back][i], -expect, 1e-12);
        }
    in.n = 1;
    schuler_increments_prime(&in, &setup);
    CHECK_NEAR(setup.prime_dtheta[2][0], in.dtheta[0][0], 0.0);
}

static void put_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void wrong_files_are_refused_with_their_place(void **state)
{
    static const struct {
        const char *imu; /* after the header */
        int line, column;
    } wrong[] = {
        { "0.02,0,0,0,0,0,-0.2\n0.04,0,0,0,0,zero,-0.2\n", 3, 14 },
        { "0.02,0,0,0,0,0,-0.2\n0.02,0,0,0,0,0,-0.2\n", 3, 1 },
        { "0.02,0,0,0,0,0,-0.2\n0.06,0,0,0,0,0,-0.2\n", 3, 1 },
        { "0.02,0,0,0,0,0,-0.2\n0.04,0,0\n", 3, 9 },
        { "-1,0,0,0,0,0,-0.2\n", 2, 1 },
        { "0.02,0,0,0,0,0,\n", 2, 16 },
        { "0.02,0,0,0,0,0,infinity\n", 2, 16 },
        { "", 0, 0 },
    };
    const files *f = *state;
    const recording r = { .steps = 10, .every = 5 };
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); i++) {
        char text[512];
        schuler_navigate_result result;
        schuler_error error = { 0 };
        record(f, &r);
        snprintf(text, sizeof(text), "%s\n%s", SCHULER_IMU_HEADER, wrong[i].imu);
        put_text(f->imu, text);
        assert_int_equal(navigate(f, "wgs84", SCHULER_VERTICAL_FREE, &result, &error),
                         SCHULER_ERR_INPUT);
        assert_string_equal(error.place.file, f->imu);
        assert_int_equal(error.place.line, wrong[i].line);
        assert_int_equal(error.place.column, wrong[i].column);
    }
}

/* The disturbance reaches the navigator: 30 s in a field that differs from the normal one by 1e-4
 * m/s^2 or more would be off by centimetres. Its values at the ends of a stretch are those at the
 * place. */
static void a_full_gravity_model_is_navigated_with(void **state)
{
    schuler_field_model *field = NULL;
    if (schuler_field_open(&field, "egm96", NULL) != SCHULER_OK) {
        print_message("egm96 is not installed: skipped\n");
        skip();
    }
    schuler_field_close(field);
    const recording r = { .steps = 1500, .every = 50, .gravity = "egm96" };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "egm96", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    CHECK_NEAR(result.horizontal_m.max, 0.0, 1e-6);
    CHECK_NEAR(result.height_m.max, 0.0, 1e-6);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    assert_true(result.horizontal_m.max + result.height_m.max > 0.01);
}

static void an_interrupt_stops_it(void **state)
{
    const files *f = *state;
    const recording r = { .steps = 10, .every = 5 };
    const volatile int stop = 1;
    int rows = 0;
    const schuler_navigate_options options = { .imu_file = f->imu,
                                               .reference_file = f->reference,
                                               .gravity = "wgs84",
                                               .row = count_row,
                                               .user = &rows,
                                               .stop = &stop };
    schuler_navigate_result result;
    record(f, &r);
    assert_int_equal(schuler_navigate(&options, &result, NULL), SCHULER_ERR_INTERRUPTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_rest_stays_at_rest),
        cmocka_unit_test(accelerometer_bias_grows_with_the_square_of_time),
        cmocka_unit_test(the_largest_error_is_not_the_last),
        cmocka_unit_test(vertical_channel_is_free_unless_held),
        cmocka_unit_test(the_references_height_is_a_barometer),
        cmocka_unit_test(gyro_drift_turns_the_attitude),
        cmocka_unit_test(a_clock_that_counts_from_long_ago_is_read),
        cmocka_unit_test(samples_before_the_start_follow_the_first_ones),
        cmocka_unit_test(wrong_files_are_refused_with_their_place),
        cmocka_unit_test(a_full_gravity_model_is_navigated_with),
        cmocka_unit_test(an_interrupt_stops_it),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

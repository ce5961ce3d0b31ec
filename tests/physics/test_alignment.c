/* SPDX-License-Identifier: MIT */
/* Self-alignment against the closed forms of gyrocompassing: phi_N = f_E/g, phi_E = -f_N/g,
 * phi_D = omega_E/(W cos L) - f_E/g tan L, of the sensors' errors in north, east, down, and what becomes
 * of them afterwards. */
#include "core/earth.h"
#include "mission.h"
#include <math.h>
#include <string.h>

static const double arcsec = SCHULER_RAD_PER_DEG / 3600.0;
static const double W = SCHULER_OMEGA_IE_RADPS;

/* Errors of a row at the start and at the end, over its runs. */
typedef struct {
    const char *id;
    int runs;
    double heading2, tilt2, worst_end_m;
    schuler_error_row start, end; /* of the last run */
} seen;

static schuler_status take(void *user, const char *id, int run, const schuler_error_row *rows,
                           size_t count)
{
    seen *const s = user;
    (void)run;
    if (strcmp(id, s->id) != 0) return SCHULER_OK;
    s->start = rows[0];
    s->end = rows[count - 1];
    s->heading2 += rows[0].heading_rad * rows[0].heading_rad;
    s->tilt2 += 0.5 * (rows[0].roll_rad * rows[0].roll_rad + rows[0].pitch_rad * rows[0].pitch_rad);
    s->worst_end_m = fmax(s->worst_end_m, hypot(s->end.r_n[0], s->end.r_n[1]));
    s->runs++;
    return SCHULER_OK;
}

/* At rest at 45 N, heading north, so that body axes are north, east, down. */
static seen align(const char *imu, const char *initial, const char *id, int runs)
{
    char text[1024];
    snprintf(text, sizeof text,
             "scenario: alignment\nseed: 8\nruns: %d\nreport: {every: 10 min}\n"
             "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m, "
             "heading: 0 deg}, for: 2 h}\nimu:\n  rate: 32 Hz\n%s\ninitial: {align: {%s}}\n",
             runs, imu, initial);
    schuler_scenario *const s = mission_text(text);
    seen out = { .id = id };
    const schuler_run_options options = { .threads = 2, .errors = take, .user = &out };
    schuler_result_free(mission_run(s, &options));
    schuler_scenario_free(s);
    assert_true(out.runs >= 1);
    return out;
}

#define PERFECT "  accel: {model: linear}\n  gyro: {model: linear}"
#define ROLLING "sway: {roll: 3 deg, pitch: 2 deg, heading: 1 deg, period: 7 s}"

static void perfect_sensors_find_the_attitude(void **state)
{
    (void)state;
    const seen still = align(PERFECT, "for: 10 min", "none", 1);
    /* 600 s of rounding of 6000 m/s: 1e-12 of it, over the turn of gravity, 0.03 rad */
    CHECK_NEAR(still.start.heading_rad, 0.0, 1e-10);
    CHECK_NEAR(still.start.roll_rad, 0.0, 1e-11);
    CHECK_NEAR(still.start.pitch_rad, 0.0, 1e-11);
    /* Swaying: what the samples' coning and sculling leave, of order h^6: micro arc seconds. */
    const seen rolling = align(PERFECT, "for: 10 min, " ROLLING, "none", 1);
    CHECK_NEAR(rolling.start.heading_rad, 0.0, 1e-2 * arcsec);
    CHECK_NEAR(rolling.start.roll_rad, 0.0, 1e-4 * arcsec);
}

/* Row D10. The filter's tilt is that of the end, its heading that of the middle of the time: the
 * earth turns one into the other by W T/2 = 2.2 %. */
static void constant_errors_give_tilt_and_heading(void **state)
{
    (void)state;
    static const char *const methods[] = { "coarse", "fine" };
    const double lag = 0.5 * W * 600.0, tilt = 50.0023058408226e-6, turn = 940.234874311679e-6;
    for (int m = 0; m < 2; m++) {
        char how[64];
        snprintf(how, sizeof how, "for: 10 min, method: %s", methods[m]);
        const seen north = align("  accel: {model: linear, bias: [50 ug, 0 ug, 0 ug]}\n"
                                 "  gyro: {model: linear}",
                                 how, "accel.bias", 1);
        /* phi_E = -tilt: pitch computed less true is -phi_E heading north */
        CHECK_NEAR(north.start.pitch_rad, tilt, lag * tilt);
        CHECK_NEAR(north.start.roll_rad, 0.0, lag * tilt);
        CHECK_NEAR(north.start.heading_rad, 0.0, lag * tilt);
        const seen east = align("  accel: {model: linear, bias: [0 ug, 50 ug, 0 ug]}\n"
                                "  gyro: {model: linear}",
                                how, "accel.bias", 1);
        CHECK_NEAR(east.start.roll_rad, -tilt, lag * tilt);
        CHECK_NEAR(east.start.pitch_rad, 0.0, lag * tilt);
        CHECK_NEAR(east.start.heading_rad, tilt, lag * tilt);
        const seen gyro = align("  accel: {model: linear}\n"
                                "  gyro: {model: linear, bias: [0 deg/h, 0.01 deg/h, 0 deg/h]}",
                                how, "gyro.bias", 1);
        CHECK_NEAR(gyro.start.heading_rad, -turn, turn * turn + 1e-5 * turn);
        CHECK_NEAR(gyro.start.roll_rad, 0.0, 1e-3 * turn);
    }
}

/* The errors stay in balance while the vehicle keeps its attitude: the east gyro and the east
 * accelerometer do not drift at all, the north accelerometer by W x phi only, the down gyro as t^2.
 * Given as errors of a start, the same would have gone kilometres. */
static void what_is_aligned_does_not_drift(void **state)
{
    (void)state;
    const seen gyro = align("  accel: {model: linear}\n"
                            "  gyro: {model: linear, bias: [0 deg/h, 0.01 deg/h, 0 deg/h]}",
                            "for: 10 min", "gyro.bias", 1);
    /* Unaligned: R b t = 1 nmi/h 0.6; second order in phi = 1e-3 is left. */
    assert_true(gyro.worst_end_m < 5.0);
    const seen east = align("  accel: {model: linear, bias: [0 ug, 50 ug, 0 ug]}\n"
                            "  gyro: {model: linear}",
                            "for: 10 min", "accel.bias", 1);
    /* The lag of the heading, 2 % of 50 urad, times W cos L R t: 2 m; Schuler would be 640 m. */
    assert_true(east.worst_end_m < 10.0);
    const seen north = align("  accel: {model: linear, bias: [50 ug, 0 ug, 0 ug]}\n"
                             "  gyro: {model: linear}",
                             "for: 10 min", "accel.bias", 1);
    /* W sin L phi R t and less, 160 m in 2 h: it shows, and stays far below. */
    assert_true(north.worst_end_m > 10.0 && north.worst_end_m < 400.0);
}

/* sigma of the heading N/(W cos L sqrt T), of the tilt almost nothing: R runs, sigma 1/sqrt(2 R). */
static void noise_of_the_gyros_shows_in_the_heading(void **state)
{
    (void)state;
    enum { RUNS = 200 };
    const double N = 0.003 * SCHULER_RAD_PER_DEG / 60.0;
    const double sigma = N / (W * sqrt(0.5) * sqrt(600.0));
    CHECK_REL(sigma, 0.69e-3, 0.01); /* as the reference has it */
    for (int swaying = 0; swaying < 2; swaying++) {
        const seen s = align("  accel: {model: linear}\n"
                             "  gyro: {model: linear, angle_random_walk: 0.003 deg/sqrt(h)}",
                             swaying ? "for: 10 min, " ROLLING : "for: 10 min",
                             "gyro.angle_random_walk", RUNS);
        assert_int_equal(s.runs, RUNS);
        CHECK_REL(sqrt(s.heading2 / RUNS), sigma, 4.5 / sqrt(2.0 * RUNS));
        /* what the angle walks in a few seconds of the filter's memory */
        assert_true(sqrt(s.tilt2 / RUNS) < N * sqrt(20.0));
    }
}

static void gyros_of_a_telephone_find_no_north_and_nothing_breaks(void **state)
{
    (void)state;
    const seen s = align("  accel: {model: linear, bias: {normal: 20 mg}}\n"
                         "  gyro: {model: linear, bias: {normal: 1000 deg/h}}",
                         "for: 1 min", "all", 20);
    assert_int_equal(s.runs, 20);
    assert_true(isfinite(s.end.r_n[0]) && isfinite(s.start.heading_rad));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(perfect_sensors_find_the_attitude),
        cmocka_unit_test(constant_errors_give_tilt_and_heading),
        cmocka_unit_test(what_is_aligned_does_not_drift),
        cmocka_unit_test(noise_of_the_gyros_shows_in_the_heading),
        cmocka_unit_test(gyros_of_a_telephone_find_no_north_and_nothing_breaks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

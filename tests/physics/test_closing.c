/* SPDX-License-Identifier: MIT */
/* With perfect sensors the navigator must return to the truth. */
#include "mission.h"

/* Largest horizontal error of the perfect navigator at any report, m. */
static double closing_m(schuler_scenario *s)
{
    const schuler_run_options options = { .threads = 1 };
    s->only = (schuler_text_list){ 0 };
    s->runs = 1;
    s->requirement.given = false;
    s->truth_gravity = s->nav_gravity; /* no data set is needed for it */
    /* No sources at all: a single lane. */
    memset(s->imu.triad[0].values, 0, sizeof(s->imu.triad[0].values));
    memset(s->imu.triad[1].values, 0, sizeof(s->imu.triad[1].values));
    s->position.given = s->velocity.given = s->tilt.given = s->heading.given = false;
    schuler_result *r = mission_run(s, &options);
    const double max_m = r->none.rms_max_m;
    assert_true(isfinite(max_m));
    schuler_result_free(r);
    return max_m;
}

/* Bounds in metres. What limits each flight is said in ARCHITECTURE.md: the kinks of the smooth
 * ramps seen by a polynomial through past samples, and rounding. */
static void every_gallery_mission_closes(void **state)
{
    (void)state;
    const struct {
        const char *name;
        double bound_m;
    } missions[] = {
        { "static", 1e-6 }, /* increments are exact: only rounding                      */
        { "manoeuvres", 1e-4 }, { "atlantic", 2e-4 }, { "tactical", 1e-4 }, { "city", 1e-4 },
        { "launch", 1e-4 },     { "fighter", 1e-4 },  { "polar", 1e-4 },    { "sculling", 1e-4 },
        { "submarine", 0.1 }, /* gimbals that turn by a degree in a sample              */
    };
    for (size_t i = 0; i < sizeof(missions) / sizeof(missions[0]); i++) {
        schuler_scenario *s = mission_gallery(missions[i].name, NULL);
        const double max_m = closing_m(s);
        print_message("%-12s closes to %.3g mm\n", missions[i].name, max_m * 1e3);
        assert_true(max_m < missions[i].bound_m);
        schuler_scenario_free(s);
    }
}

/* Flight along a parallel (reference section 9.2): all rates and forces constant in the local
 * frame. And over the pole of the earth-fixed frame's axis nothing happens: a route from 80 N to 80
 * N on the other side. */
static void steady_flight_closes_anywhere(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "scenario: parallel\ntrajectory:\n  kind: segments\n"
        "  start: {lat: 45 deg, lon: 7 deg, height: 10 km, heading: 90 deg, speed: 250 m/s}\n"
        "  segments: [cruise: {for: 1 h}]\n"
        "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n",
        "scenario: pole\ntrajectory:\n  kind: route\n  waypoints:\n"
        "    - {lat: 80 deg, lon: 10 deg, height: 10 km, speed: 250 m/s}\n"
        "    - {lat: 80 deg, lon: 191 deg, height: 10 km, speed: 250 m/s}\n"
        "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n",
    };
    for (size_t i = 0; i < sizeof(texts) / sizeof(texts[0]); i++) {
        schuler_scenario *s = mission_text(texts[i]);
        const double max_m = closing_m(s);
        print_message("%-12s closes to %.3g mm\n", s->name, max_m * 1e3);
        assert_true(max_m < 1e-5);
        schuler_scenario_free(s);
    }
}

/* Two samples: the rate linear in time is wrong in its second derivative, which leaves third order:
 * 2^3 for each halving, to a tenth. Four samples: fourth order inside the ramps, less at their
 * ends, where the second derivative of the rate jumps; over three halvings more than 2^8. */
static void halving_the_step_follows_the_order(void **state)
{
    (void)state;
    double error_m[2][4];
    for (int order = 0; order < 2; order++)
        for (int k = 0; k < 4; k++) {
            schuler_scenario *s = mission_gallery("manoeuvres", NULL);
            s->order = order == 0 ? 2 : 4;
            s->imu.rate_hz = 12.5 * (1 << k);
            error_m[order][k] = closing_m(s);
            print_message("order %d, %g Hz: %.4g mm\n", s->order, s->imu.rate_hz,
                          1e3 * error_m[order][k]);
            schuler_scenario_free(s);
        }
    for (int k = 0; k < 3; k++) CHECK_REL(error_m[0][k] / error_m[0][k + 1], 8.0, 0.1);
    assert_true(error_m[1][0] > 256.0 * error_m[1][3]);
}

/* A navigation cycle of several samples is a coarser position and gravity step, nothing else. */
static void slower_navigation_cycles_close_too(void **state)
{
    (void)state;
    for (int samples = 2; samples <= 4; samples *= 2) {
        schuler_scenario *s = mission_gallery("manoeuvres", NULL);
        s->samples_per_update = samples;
        const double max_m = closing_m(s);
        print_message("%d samples an update: %.3g mm\n", samples, max_m * 1e3);
        assert_true(max_m < (samples == 2 ? 1e-4 : 1e-3));
        schuler_scenario_free(s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_gallery_mission_closes),
        cmocka_unit_test(steady_flight_closes_anywhere),
        cmocka_unit_test(halving_the_step_follows_the_order),
        cmocka_unit_test(slower_navigation_cycles_close_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

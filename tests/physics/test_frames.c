/* SPDX-License-Identifier: MIT */
/* Three frames, one navigator: rates and Coriolis of the local-level ones against the reference's rows D4
 * and D5, and all of them against the truth and each other. */
#include "core/lanes3.h"
#include "mission.h"

/* North-east-down's own turn; the wander frame is tested through the missions. */
LANES_INLINE lanes frame_vertical_rate(lanes omega_x, lanes3 z)
{
    return omega_x * (z.z / z.x);
}

#include "mechanization/local_level.h"

/* As a frame file would. */
static const schuler_mechanization test_frame = { .name = "test", LOCAL_LEVEL_FUNCTIONS };

#define DEG SCHULER_RAD_PER_DEG

/* L at a place, turned by alpha about down. */
static lanes_quat axes_at(double lat_rad, double lon_rad, double alpha_rad)
{
    const schuler_mat3 C_n_e = schuler_C_n_e(lat_rad, lon_rad);
    const schuler_mat3 C_L_n = schuler_mat3_from_euler(0.0, 0.0, alpha_rad);
    const schuler_mat3 C_L_e = schuler_mat3_mul(&C_n_e, &C_L_n);
    const schuler_quat q = schuler_quat_from_mat3(&C_L_e);
    return (lanes_quat){ q.w, q.x, q.y, q.z };
}

static void rates_are_those_of_the_reference(void **state)
{
    (void)state;
    assert_non_null(test_frame.init);
    const local_place at = place_at(axes_at(45.0 * DEG, 77.0 * DEG, 0.0), 1e4);
    const lanes3 v = { 200.0, 100.0, -5.0 };
    const lanes3 omega = transport_rate(&at, v);
    CHECK_REL(omega.x, 1.56278367206724e-5, 1e-13); /* D4 */
    CHECK_REL(omega.y, -3.13608320439836e-5, 1e-13);
    CHECK_REL(omega.z, -1.56278367206724e-5, 1e-13);
    const lanes3 c = coriolis(1.0, at.z, omega, v); /* D4b, the other sign */
    CHECK_REL(-c.x, -0.0120321957636714, 1e-13);
    CHECK_REL(-c.y, 0.0231570136267305, 1e-13);
    CHECK_REL(-c.z, -0.0181475580122482, 1e-13);

    const local_place turned = place_at(axes_at(45.0 * DEG, 77.0 * DEG, 30.0 * DEG), 1e4);
    const lanes3 v_w = { 223.205080756888, -13.3974596215561, -5.0 };
    const lanes3 omega_w = transport_rate(&turned, v_w); /* D4c: x and y */
    CHECK_REL(omega_w.x, -2.1463124156942e-6, 1e-12);
    CHECK_REL(omega_w.y, -3.49731955942431e-5, 1e-13);

    /* The place itself, to the rounding of a quaternion: 2e-16 of 6.4e6 m. */
    const schuler_vec3 r_e = schuler_ecef_from_llh((schuler_llh){ 45.0 * DEG, 77.0 * DEG, 1e4 });
    CHECK_NEAR(turned.r.x, r_e.v[0], 5e-9);
    CHECK_NEAR(turned.r.y, r_e.v[1], 5e-9);
    CHECK_NEAR(turned.r.z, r_e.v[2], 5e-9);
}

/* f^n = (2 omega_ie + omega_en) x v - g, steady flight to the east. */
static void steady_flight_needs_the_force_of_the_reference(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    assert_int_equal(schuler_field_open(&field, "wgs84", NULL), SCHULER_OK);
    assert_int_equal(schuler_gravity_fit(&table, field, NULL), SCHULER_OK);
    const cycle_state cycle = { .gravity = table };
    const lanes_quat p = axes_at(45.0 * DEG, -120.0 * DEG, 0.0);
    const local_place at = place_at(p, 1e4);
    const lanes3 v = { 0.0, 250.0, 0.0 };
    const lanes3 omega = transport_rate(&at, v), g = rotate_back(p, cycle_gravity(&cycle, at.r));
    const lanes3 f = lanes3_sub(coriolis(1.0, at.z, omega, v), g);
    CHECK_NEAR(f.x, 0.0356302697678571, 1e-11); /* D5; the table of gravity holds 1e-11 */
    CHECK_NEAR(f.y, 0.0, 1e-11);
    CHECK_NEAR(f.z, -9.73986527011007, 1e-11);
    schuler_field_close(field);
}

typedef struct {
    double max_m;
    double north_m, east_m; /* at the end */
} closing;

static closing fly(schuler_scenario *s, const char *frame, schuler_isa isa)
{
    s->frame = schuler_mechanization_find(frame);
    assert_true(s->frame >= 0);
    mission_trace t = { .id = "none" };
    const schuler_run_options options = {
        .threads = 1, .has_isa = 1, .isa = isa, .errors = mission_keep, .user = &t
    };
    schuler_result *r = mission_run(s, &options);
    const closing c = { r->none.rms_max_m, t.rows[t.count - 1].r_n[0], t.rows[t.count - 1].r_n[1] };
    schuler_result_free(r);
    free(t.rows);
    return c;
}

static const char *const frames[] = { "ecef", "wander", "ned" };

static schuler_scenario *perfect(const char *name)
{
    schuler_scenario *s = mission_gallery(name, NULL);
    s->only = (schuler_text_list){ 0 };
    s->runs = 1;
    s->requirement.given = false;
    memset(s->imu.triad[0].values, 0, sizeof s->imu.triad[0].values);
    memset(s->imu.triad[1].values, 0, sizeof s->imu.triad[1].values);
    s->position.given = s->velocity.given = s->tilt.given = s->heading.given = false;
    return s;
}

/* 0.1 mm is the design's; frames agree to the same. */
static void every_frame_returns_to_the_truth(void **state)
{
    (void)state;
    static const char *const names[] = { "static", "manoeuvres", "atlantic" };
    for (size_t m = 0; m < 3; m++) {
        schuler_scenario *s = perfect(names[m]);
        closing first = { 0 };
        for (size_t f = 0; f < 3; f++) {
            const closing c = fly(s, frames[f], schuler_isa_best());
            print_message("%-11s %-7s %.3g mm\n", names[m], frames[f], c.max_m * 1e3);
            assert_true(c.max_m < 1e-4);
            if (f == 0) first = c;
            CHECK_NEAR(c.north_m, first.north_m, 1e-4);
            CHECK_NEAR(c.east_m, first.east_m, 1e-4);
        }
        schuler_scenario_free(s);
    }
}

/* Ten hours along a parallel, across the date line: 1 mm is asked. The limit of ned is rounding of its
 * position; and over the pole, where ned has ended. */
static void steady_flight_closes(void **state)
{
    (void)state;
#define IMU "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
    schuler_scenario *s =
        mission_text("scenario: parallel\ntrajectory: {kind: motion, for: 10 h, start: {lat: "
                     "45 deg, lon: 170 deg, height: 10 km}, parallel: {speed: 250 m/s}}\n" IMU);
    schuler_scenario *pole =
        mission_text("scenario: pole\ntrajectory: {kind: motion, for: 2 h, start: {lat: 85 "
                     "deg, lon: 10 deg, height: 10 km}, geodesic: {speed: 250 m/s}}\n" IMU);
    for (size_t f = 0; f < 3; f++) {
        const closing c = fly(s, frames[f], schuler_isa_best());
        print_message("parallel    %-7s %.3g mm\n", frames[f], c.max_m * 1e3);
        assert_true(c.max_m < 1e-3);
        if (f == 2) continue;
        const closing over = fly(pole, frames[f], schuler_isa_best());
        print_message("pole        %-7s %.3g mm\n", frames[f], over.max_m * 1e3);
        assert_true(over.max_m < 1e-5);
    }
    pole->frame = schuler_mechanization_find("ned");
    schuler_result *r = NULL;
    schuler_error err = { 0 };
    const schuler_run_options options = { .threads = 1 };
    assert_int_equal(schuler_simulate(pole, &options, &r, &err), SCHULER_ERR_NUMERIC);
    assert_non_null(strstr(err.message, "frame 'ned' ends at 89.5 deg"));
    schuler_scenario_free(s);
    schuler_scenario_free(pole);
}

/* Errors of sensors and start, a free vertical channel, and an algorithm of groups: the frames see the same
 * physics. They differ by what differs in second order of the errors, 1e-6 of them, and by the closing. */
static void errors_grow_alike(void **state)
{
    (void)state;
    static const char *const ways[] = { "truth", "free", "baro" };
    for (size_t w = 0; w < 3; w++) {
        char text[1200];
        snprintf(text, sizeof text,
                 "scenario: errors\nruns: 1\ntrajectory:\n  kind: segments\n"
                 "  start: {lat: 50 deg, lon: 179.9 deg, height: 3 km, heading: 80 deg, speed: 200 "
                 "m/s}\n"
                 "  segments: [cruise: {for: 10 min}, turn: {by: -70 deg}, cruise: {for: 10 min}]\n"
                 "imu: {rate: 50 Hz, accel: {model: linear, bias: 50 ug}, gyro: {model: linear, "
                 "bias: 0.01 "
                 "deg/h}}\ninitial: {tilt: 10 arcsec, heading: 2 arcmin, velocity: 0.05 m/s}\n"
                 "navigation: {vertical: %s, coning: optimal_4}\n",
                 ways[w]);
        schuler_scenario *s = mission_text(text);
        double first = 0.0;
        for (size_t f = 0; f < 3; f++) {
            s->frame = schuler_mechanization_find(frames[f]);
            const schuler_run_options options = { .threads = 1 };
            schuler_result *r = mission_run(s, &options);
            if (f == 0) first = r->all.rms_end_m;
            assert_true(first > 100.0);
            CHECK_REL(r->all.rms_end_m, first, 1e-6);
            schuler_result_free(r);
        }
        schuler_scenario_free(s);
    }
}

static void bits_do_not_depend_on_the_width(void **state)
{
    (void)state;
    schuler_scenario *s = perfect("manoeuvres");
    for (size_t f = 0; f < 3; f++) {
        const closing one = fly(s, frames[f], SCHULER_ISA_SCALAR);
        for (int isa = 1; isa < SCHULER_ISA_COUNT; isa++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            const closing c = fly(s, frames[f], (schuler_isa)isa);
            assert_memory_equal(&c, &one, sizeof c);
        }
    }
    schuler_scenario_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_are_those_of_the_reference),
        cmocka_unit_test(steady_flight_needs_the_force_of_the_reference),
        cmocka_unit_test(every_frame_returns_to_the_truth),
        cmocka_unit_test(steady_flight_closes),
        cmocka_unit_test(errors_grow_alike),
        cmocka_unit_test(bits_do_not_depend_on_the_width),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

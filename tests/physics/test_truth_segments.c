/* SPDX-License-Identifier: MIT */
/* What the manoeuvres of kind `segments` promise. */
#include "flights.h"
#include <stdlib.h>

static schuler_start at(double lat_deg, double h_m, double heading_deg, double speed_mps)
{
    return (schuler_start){ .lat_rad = lat_deg * DEG,
                            .lon_rad = 11.0 * DEG,
                            .h_m = h_m,
                            .heading_rad = heading_deg * DEG,
                            .speed_mps = speed_mps };
}

/* Body axes to NED at an instant. */
static schuler_mat3 attitude(const schuler_truth_state *s)
{
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(s->q_b_e);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&s->C_n_e);
    return schuler_mat3_mul(&C_e_n, &C_b_e);
}

static void speed_height_and_heading_end_where_they_were_sent(void **state)
{
    (void)state;
    schuler_accelerate_spec faster = { .to_mps = 140.0, .at_mps2 = 2.0, .jerk_mps3 = 1.0 };
    schuler_climb_spec climb = { .to_m = 3000.0, .at_mps = 11.0, .acceleration_mps2 = 1.0 };
    schuler_turn_spec turn = { .by_rad = -75.0 * DEG,
                               .bank_rad = 20.0 * DEG,
                               .roll_rate_radps = 5.0 * DEG };
    schuler_variant items[] = { { &schuler_segment_accelerate, &faster },
                                { &schuler_segment_climb, &climb },
                                { &schuler_segment_turn, &turn } };
    schuler_path path = flight_segments(at(40.0, 200.0, 20.0, 30.0), items, 3);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    /* Closed forms: change over rate, plus one ramp. */
    const double faster_s = 110.0 / 2.0 + 1.875 * 2.0 / 1.0;
    const double climb_s = 2800.0 / 11.0 + 1.875 * 11.0 / 1.0;
    const double rate_radps = tan(20.0 * DEG) * SCHULER_G0_MPS2 / 140.0;
    const double turn_s = 75.0 * DEG / rate_radps + 1.875 * tan(20.0 * DEG) / (5.0 * DEG);
    schuler_truth_state s;
    /* Durations are rounded to 1e-9 s each; acceleration is zero at the ends. */
    CHECK_NEAR(path.duration_s, faster_s + climb_s + turn_s, 1e-8);
    schuler_truth_at(truth, faster_s, &s);
    CHECK_NEAR(hypot(s.v_n.v[0], s.v_n.v[1]), 140.0, 1e-12);
    CHECK_NEAR(s.llh.h_m, 200.0, 5e-9);
    CHECK_NEAR(s.heading_rad, 20.0 * DEG, 1e-14);
    schuler_truth_at(truth, faster_s + climb_s, &s);
    CHECK_NEAR(s.llh.h_m, 3000.0, 5e-9);
    CHECK_NEAR(hypot(s.v_n.v[0], s.v_n.v[1]), 140.0, 1e-12);
    CHECK_NEAR(s.v_n.v[2], 0.0, 1e-12);
    schuler_truth_at(truth, path.duration_s, &s);
    CHECK_NEAR(s.heading_rad, (20.0 - 75.0 + 360.0) * DEG, 1e-14);
    CHECK_NEAR(s.roll_rad, 0.0, 1e-14);
    CHECK_NEAR(s.llh.h_m, 3000.0, 5e-9);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void the_nose_follows_the_flight_path_and_bank_the_turn(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    double highest_bank = 0.0, steepest = 0.0;
    for (double t_s = 31.0; t_s < path.duration_s; t_s += 0.7) {
        schuler_truth_state s, before, after;
        schuler_truth_at(truth, t_s, &s);
        const double speed_mps = hypot(s.v_n.v[0], s.v_n.v[1]);
        if (speed_mps < 0.1) continue;
        const schuler_mat3 C_b_n = attitude(&s);
        /* Forward is along the velocity. */
        const double v_mps = schuler_vec3_norm(s.v_n);
        for (int i = 0; i < 3; i++) CHECK_NEAR(C_b_n.m[i][0], s.v_n.v[i] / v_mps, 1e-11);
        /* tan(bank) = speed * rate of heading / g0, the rate by a central difference: h^2/6 times a
         * third derivative below 1 rad/s^3. */
        const double h_s = 1e-3;
        schuler_truth_at(truth, t_s - h_s, &before);
        schuler_truth_at(truth, t_s + h_s, &after);
        const double rate_radps =
            remainder(after.heading_rad - before.heading_rad, 2.0 * SCHULER_PI) / (2.0 * h_s);
        CHECK_NEAR(tan(s.roll_rad), speed_mps * rate_radps / SCHULER_G0_MPS2, 1e-5);
        highest_bank = fmax(highest_bank, fabs(s.roll_rad));
        steepest = fmax(steepest, fabs(s.pitch_rad));
    }
    CHECK_NEAR(highest_bank, 60.0 * DEG, 1e-8);
    CHECK_NEAR(steepest, atan2(12.0, 180.0), 1e-8);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* Bank by coordination leaves a side force of the Coriolis and curvature terms only: 0.03 m/s^2 at
 * 180 m/s. */
static void a_coordinated_turn_has_no_side_force(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = 3100; first + SCHULER_BLOCK < steps; first += SCHULER_BLOCK) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
        for (int k = 0; k < SCHULER_BLOCK; k++) CHECK_NEAR(block.dv_ib_b[1][k] / 0.01, 0.0, 0.06);
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void straight_flight_keeps_its_heading(void **state)
{
    (void)state;
    schuler_hold_spec hours = { .for_s = 4.0 * 3600.0 };
    schuler_variant items[] = { { &schuler_segment_cruise, &hours } };
    schuler_path path = flight_segments(at(-20.0, 9000.0, 60.0, 240.0), items, 1);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    for (double t_s = 0.0; t_s <= path.duration_s; t_s += 300.0) {
        schuler_truth_state s;
        schuler_truth_at(truth, t_s, &s);
        /* The course is carried as a vector of 1e-19 rounding, the state is rounded to double. */
        CHECK_NEAR(s.heading_rad, 60.0 * DEG, 1e-14);
        CHECK_NEAR(s.llh.h_m, 9000.0, 1e-8);
        CHECK_NEAR(atan2(s.v_n.v[1], s.v_n.v[0]), 60.0 * DEG, 1e-14);
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void a_turn_too_small_for_its_bank_takes_less(void **state)
{
    (void)state;
    schuler_turn_spec turn = { .by_rad = 1.0 * DEG,
                               .bank_rad = 30.0 * DEG,
                               .roll_rate_radps = 5.0 * DEG };
    schuler_variant items[] = { { &schuler_segment_turn, &turn } };
    schuler_path path = flight_segments(at(40.0, 5000.0, 0.0, 200.0), items, 1);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    const double ramp_s = 1.875 * tan(30.0 * DEG) / (5.0 * DEG);
    CHECK_NEAR(path.duration_s, 2.0 * ramp_s, 1e-8);
    schuler_truth_state s;
    schuler_truth_at(truth, ramp_s, &s);
    CHECK_NEAR(tan(s.roll_rad), 200.0 * 1.0 * DEG / ramp_s / SCHULER_G0_MPS2, 1e-9);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* A steep climb that starts within 10 ms needs pieces shorter still; the days after it must not be
 * built of such. */
static void a_sharp_ramp_does_not_leave_short_pieces_behind(void **state)
{
    (void)state;
    schuler_climb_spec climb = { .to_m = 21496.0, .at_mps = 0.042, .acceleration_mps2 = 8.0 };
    schuler_variant items[] = { { &schuler_segment_climb, &climb } };
    schuler_path path = flight_segments(at(21.3264, 8516.96, 77.9102, 0.00511121), items, 1);
    /* 309 000 s in pieces of 256 s at most: 1207, and some hundreds for the two ramps. */
    assert_in_range(path.count, 1207, 2500);
    schuler_path_free(&path);
}

static void a_hundred_circles_lose_nothing(void **state)
{
    (void)state;
    enum { TURNS = 25 };
    schuler_turn_spec turn = { .by_rad = 1440.0 * DEG,
                               .bank_rad = 45.0 * DEG,
                               .roll_rate_radps = 20.0 * DEG };
    schuler_variant items[TURNS];
    for (int i = 0; i < TURNS; i++) items[i] = (schuler_variant){ &schuler_segment_turn, &turn };
    schuler_path path = flight_segments(at(40.0, 1000.0, 30.0, 100.0), items, TURNS);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    schuler_truth_state s;
    schuler_truth_at(truth, path.duration_s, &s);
    /* Each turn's angle is rounded to double, 2e-15 of 25 rad. */
    CHECK_NEAR(s.heading_rad, 30.0 * DEG, TURNS * 4e-15);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* Build something wrong; the message must hold what is said. */
static void refuse(schuler_start start, schuler_variant *items, size_t count, const char *says)
{
    const schuler_segments_spec spec = { .start = start, .segments = { items, count } };
    schuler_path path = { 0 };
    schuler_diagnostics d = { 0 };
    assert_int_equal(flight_kind("segments")->build(&spec, &path, &d), SCHULER_ERR_INPUT);
    assert_int_equal(d.errors, 1);
    if (strstr(d.items[0].message, says) == NULL)
        fail_msg("'%s' is not in '%s'", says, d.items[0].message);
    if (count > 0) assert_int_equal(d.items[0].place.line, 7);
    assert_null(path.pieces);
    schuler_diagnostics_free(&d);
}

static void what_cannot_be_flown_is_refused_with_its_place(void **state)
{
    (void)state;
    const schuler_place here = { "flight.yaml", 7, 3, 4 };
    schuler_turn_spec turn = {
        .place = here, .by_rad = 1.0, .bank_rad = 0.4, .roll_rate_radps = 0.1
    };
    schuler_climb_spec climb = { here, 5000.0, 10.0, 1.0 };
    schuler_hold_spec north = { here, 20.0 * 3600.0 }, ages = { here, 3.5e6 };
    schuler_accelerate_spec none = { here, 0.0, 1.0, 1.0 };
    schuler_variant turn_item = { &schuler_segment_turn, &turn };
    schuler_variant climb_item = { &schuler_segment_climb, &climb };
    schuler_variant north_item = { &schuler_segment_cruise, &north };
    schuler_variant none_item = { &schuler_segment_accelerate, &none };
    schuler_variant ages_items[2] = { { &schuler_segment_hold, &ages },
                                      { &schuler_segment_hold, &ages } };
    refuse(at(45.0, 0.0, 0.0, 0.0), &turn_item, 1, "cannot turn at rest");
    refuse(at(45.0, 0.0, 0.0, 0.0), &climb_item, 1, "cannot climb at rest");
    refuse(at(45.0, 1000.0, 0.0, 250.0), &north_item, 1, "beyond latitude 89.9 deg");
    refuse(at(45.0, 1000.0, 181.0, 250.0), &north_item, 1, "beyond latitude 89.9 deg");
    refuse(at(45.0, 0.0, 0.0, 0.0), ages_items, 2, "longer than 1000 h");
    refuse(at(45.0, 0.0, 0.0, 0.0), NULL, 0, "lasts no time");
    schuler_start pole = at(89.95, 0.0, 0.0, 0.0);
    pole.place = here;
    refuse(pole, &ages_items[0], 1, "must start within 89.9 deg");
    /* Nothing changes, so nothing lasts. */
    const schuler_segments_spec spec = { .place = here,
                                         .start = at(45.0, 0.0, 0.0, 0.0),
                                         .segments = { &none_item, 1 } };
    schuler_path path = { 0 };
    schuler_diagnostics d = { 0 };
    assert_int_equal(flight_kind("segments")->build(&spec, &path, &d), SCHULER_ERR_INPUT);
    schuler_diagnostics_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(speed_height_and_heading_end_where_they_were_sent),
        cmocka_unit_test(the_nose_follows_the_flight_path_and_bank_the_turn),
        cmocka_unit_test(a_coordinated_turn_has_no_side_force),
        cmocka_unit_test(straight_flight_keeps_its_heading),
        cmocka_unit_test(a_turn_too_small_for_its_bank_takes_less),
        cmocka_unit_test(a_sharp_ramp_does_not_leave_short_pieces_behind),
        cmocka_unit_test(a_hundred_circles_lose_nothing),
        cmocka_unit_test(what_cannot_be_flown_is_refused_with_its_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Gravity of the real world beside the navigator's: what goes into the specific force, and what is
 * told to the navigator. EGM96 needs its data set; without it those tests skip. */
#include "flights.h"
#include "mission.h"
#include <stdlib.h>

static schuler_path straight(double lat_deg, double lon_deg, double h_m, double for_s)
{
    schuler_hold_spec cruise = { .for_s = for_s };
    schuler_variant items[] = { { &schuler_segment_cruise, &cruise } };
    const schuler_start start = { .lat_rad = lat_deg * DEG,
                                  .lon_rad = lon_deg * DEG,
                                  .h_m = h_m,
                                  .heading_rad = 75.0 * DEG,
                                  .speed_mps = 250.0 };
    return flight_segments(start, items, 1);
}

static schuler_field_model *open_field(const char *name)
{
    schuler_field_model *field = NULL;
    schuler_error err = { 0 };
    if (schuler_field_open(&field, name, &err) != SCHULER_OK) {
        print_message("skipped: %s\n", err.message);
        skip();
    }
    return field;
}

/* Normal fields need no data: grs80 as the world, wgs84 in the navigator, differ by 1.5e-6 m/s^2.
 */
static void another_normal_field_is_told_as_a_difference(void **state)
{
    (void)state;
    schuler_path path = straight(45.0, 7.0, 10000.0, 300.0);
    schuler_truth *same = flight_truth(&path, 0.01, "wgs84", "wgs84");
    schuler_truth *other = flight_truth(&path, 0.01, "grs80", "wgs84");
    schuler_field_model *grs80 = open_field("grs80"), *wgs84 = open_field("wgs84");
    schuler_truth_block a, b;
    schuler_truth_block_compute(same, schuler_isa_best(), 7000, SCHULER_BLOCK, &a);
    schuler_truth_block_compute(other, schuler_isa_best(), 7000, SCHULER_BLOCK, &b);
    assert_false(a.has_dg);
    assert_true(b.has_dg);
    for (int k = 0; k < SCHULER_BLOCK; k++) {
        const double t_s = (7000.5 + k) * 0.01;
        const schuler_motion m = schuler_path_at(&path, t_s);
        const schuler_vec3 dg_e = schuler_vec3_sub(schuler_field_gravity(grs80, m.r_e),
                                                   schuler_field_gravity(wgs84, m.r_e));
        const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
        const schuler_vec3 dg_b = schuler_mat3_apply_transposed(&C_b_e, dg_e);
        for (int i = 0; i < 3; i++) {
            assert_true(a.dg_truth_e[i][k] == 0.0 && a.dg_nav_e[i][k] == 0.0);
            assert_true(b.dg_nav_e[i][k] == 0.0);
            /* Two tables, each within 1.6e-12 of its field. */
            CHECK_NEAR(b.dg_truth_e[i][k], dg_e.v[i], 4e-12);
            CHECK_NEAR((b.dv_ib_b[i][k] - a.dv_ib_b[i][k]) / 0.01, -dg_b.v[i], 4e-12);
        }
    }
    schuler_field_close(grs80);
    schuler_field_close(wgs84);
    schuler_truth_free(same);
    schuler_truth_free(other);
    schuler_path_free(&path);
}

/* Off the samples the interpolation is within 1e-8 m/s^2 (1 ng) of the full model: over the Himalayas
 * at 5 km, where it is roughest, over the Alps at 2 km and over the Atlantic. */
static void the_disturbance_is_followed_between_samples(void **state)
{
    (void)state;
    static const double starts[][3] = { { 45.5, 6.0, 2000.0 },
                                        { 42.0, -40.0, 10000.0 },
                                        { 27.5, 85.0, 5000.0 } };
    schuler_field_model *egm96 = open_field("egm96");
    for (int place = 0; place < 3; place++) {
        schuler_path path = straight(starts[place][0], starts[place][1], starts[place][2], 800.0);
        schuler_truth *truth = flight_truth(&path, 0.01, "egm96", "wgs84");
        schuler_field_model *wgs84 = open_field("wgs84");
        double worst = 0.0, strongest = 0.0;
        for (int64_t first = 0; first < 79900; first += 1117) {
            schuler_truth_block block;
            schuler_truth_block_compute(truth, schuler_isa_best(), first, 1, &block);
            const double t_s = ((double)first + 0.5) * 0.01;
            const schuler_vec3 r_e = schuler_path_at(&path, t_s).r_e;
            const schuler_vec3 dg_e = schuler_vec3_sub(schuler_field_gravity(egm96, r_e),
                                                       schuler_field_gravity(wgs84, r_e));
            for (int i = 0; i < 3; i++) {
                worst = fmax(worst, fabs(block.dg_truth_e[i][0] - dg_e.v[i]));
                strongest = fmax(strongest, fabs(dg_e.v[i]));
                assert_true(block.dg_nav_e[i][0] == 0.0);
            }
        }
        CHECK_NEAR(worst, 0.0, 1e-8);
        assert_true(strongest > 5e-5); /* there is something to follow */
        schuler_field_close(wgs84);
        schuler_truth_free(truth);
        schuler_path_free(&path);
    }
    schuler_field_close(egm96);
}

static void manoeuvres_do_not_upset_the_disturbance(void **state)
{
    (void)state;
    schuler_field_model *egm96 = open_field("egm96");
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 0.01, "egm96", "wgs84");
    schuler_field_model *wgs84 = open_field("wgs84");
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = 0; first < steps; first += 1013) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, 1, &block);
        const schuler_vec3 r_e = schuler_path_at(&path, ((double)first + 0.5) * 0.01).r_e;
        const schuler_vec3 dg_e =
            schuler_vec3_sub(schuler_field_gravity(egm96, r_e), schuler_field_gravity(wgs84, r_e));
        for (int i = 0; i < 3; i++) CHECK_NEAR(block.dg_truth_e[i][0], dg_e.v[i], 1e-8);
    }
    schuler_field_close(wgs84);
    schuler_field_close(egm96);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* Root of the summed squares of its nine derivatives, 1/s^2. */
static double gradient_of_disturbance(const schuler_field_model *egm96,
                                      const schuler_field_model *wgs84, schuler_vec3 r_e)
{
    const double step_m = 100.0;
    double sum = 0.0;
    for (int a = 0; a < 3; a++) {
        schuler_vec3 dg_e[2];
        for (int k = 0; k < 2; k++) {
            schuler_vec3 at_e = r_e;
            at_e.v[a] += (k - 0.5) * step_m;
            dg_e[k] = schuler_vec3_sub(schuler_field_gravity(egm96, at_e),
                                       schuler_field_gravity(wgs84, at_e));
        }
        const double change = schuler_vec3_norm(schuler_vec3_sub(dg_e[1], dg_e[0])) / step_m;
        sum += change * change;
    }
    return sqrt(sum);
}

/* Where waves move the vehicle, hundreds of pieces share one line, from which the vehicle is 3 m away at
 * most and its ends are off by the waves: a change of the disturbance over 6 m. */
static void waves_leave_no_more_than_their_height(void **state)
{
    (void)state;
    schuler_field_model *egm96 = open_field("egm96"), *wgs84 = open_field("wgs84");
    schuler_scenario *s = mission_text(
        "scenario: waves\ntrajectory:\n  kind: segments\n"
        "  start: {lat: 45.5 deg, lon: 6 deg, height: 0 m, heading: 75 deg, speed: 6 m/s}\n"
        "  segments: [cruise: {for: 10 min}]\n"
        "  overlays: [sway: {motion: heave, distance: 2 m, period: 8 s}]\n"
        "imu: {rate: 10 Hz, accel: {model: linear}, gyro: {model: linear}}\n");
    schuler_truth *truth = flight_truth(&s->path, 0.1, "egm96", "wgs84");
    double worst = 0.0, largest_m = 0.0;
    const double gradient = gradient_of_disturbance(egm96, wgs84, s->path.pieces[0].r0_e);
    for (int64_t first = 0; first < 6000; first += 37) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, 1, &block);
        const schuler_vec3 r_e = schuler_path_at(&s->path, ((double)first + 0.5) * 0.1).r_e;
        const schuler_vec3 dg_e =
            schuler_vec3_sub(schuler_field_gravity(egm96, r_e), schuler_field_gravity(wgs84, r_e));
        const schuler_vec3 told_e = { { block.dg_truth_e[0][0], block.dg_truth_e[1][0],
                                        block.dg_truth_e[2][0] } };
        worst = fmax(worst, schuler_vec3_norm(schuler_vec3_sub(told_e, dg_e)));
        largest_m = fmax(largest_m, fabs(schuler_llh_from_ecef(r_e).h_m));
    }
    assert_true(largest_m > 1.9);
    CHECK_NEAR(worst, 0.0, 6.0 * gradient);
    assert_true(gradient < 1.3e-7);
    schuler_truth_free(truth);
    schuler_scenario_free(s);
    schuler_field_close(wgs84);
    schuler_field_close(egm96);
}

static void the_specific_force_holds_the_disturbance(void **state)
{
    (void)state;
    schuler_field_close(open_field("egm96"));
    schuler_path path = straight(45.5, 6.0, 2000.0, 60.0);
    schuler_truth *rough = flight_truth(&path, 0.01, "egm96", "wgs84");
    schuler_truth *smooth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    schuler_truth_block a, b;
    schuler_truth_block_compute(rough, schuler_isa_best(), 2000, SCHULER_BLOCK, &a);
    schuler_truth_block_compute(smooth, schuler_isa_best(), 2000, SCHULER_BLOCK, &b);
    for (int k = 0; k < SCHULER_BLOCK; k++) {
        const schuler_motion m = schuler_path_at(&path, (2000.5 + k) * 0.01);
        const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
        const schuler_vec3 dg_e = { { a.dg_truth_e[0][k], a.dg_truth_e[1][k],
                                      a.dg_truth_e[2][k] } };
        const schuler_vec3 dg_b = schuler_mat3_apply_transposed(&C_b_e, dg_e);
        /* The difference of two numbers of 10 m/s^2, rounded. */
        for (int i = 0; i < 3; i++)
            CHECK_NEAR((a.dv_ib_b[i][k] - b.dv_ib_b[i][k]) / 0.01, -dg_b.v[i], 2e-14);
        assert_true(schuler_vec3_norm(dg_e) > 1e-4);
    }
    schuler_truth_free(rough);
    schuler_truth_free(smooth);
    schuler_path_free(&path);
}

/* The same model on both sides: all of it is known to the navigator, and the specific force is that
 * of the other case. */
static void a_navigator_with_the_full_model_misses_nothing(void **state)
{
    (void)state;
    schuler_field_close(open_field("egm96"));
    schuler_path path = straight(45.5, 6.0, 2000.0, 60.0);
    schuler_truth *knows = flight_truth(&path, 0.01, "egm96", "egm96");
    schuler_truth *lacks = flight_truth(&path, 0.01, "egm96", "wgs84");
    schuler_truth *dreams = flight_truth(&path, 0.01, "wgs84", "egm96");
    schuler_truth_block a, b, c;
    schuler_truth_block_compute(knows, schuler_isa_best(), 1000, SCHULER_BLOCK, &a);
    schuler_truth_block_compute(lacks, schuler_isa_best(), 1000, SCHULER_BLOCK, &b);
    schuler_truth_block_compute(dreams, schuler_isa_best(), 1000, SCHULER_BLOCK, &c);
    for (int i = 0; i < 3; i++) {
        assert_memory_equal(a.dv_ib_b[i], b.dv_ib_b[i], sizeof a.dv_ib_b[i]);
        for (int k = 0; k < SCHULER_BLOCK; k++) {
            assert_true(a.dg_truth_e[i][k] == 0.0);
            CHECK_NEAR(a.dg_nav_e[i][k], b.dg_truth_e[i][k], 1e-15);
            CHECK_NEAR(c.dg_nav_e[i][k] + c.dg_truth_e[i][k], 0.0, 1e-15);
            CHECK_NEAR(c.dg_nav_e[i][k], a.dg_nav_e[i][k], 1e-15);
        }
    }
    schuler_truth_free(knows);
    schuler_truth_free(lacks);
    schuler_truth_free(dreams);
    schuler_path_free(&path);
}

static void at_rest_one_sample_is_enough(void **state)
{
    (void)state;
    schuler_field_model *egm96 = open_field("egm96");
    const schuler_static_spec spec = { .start = { .lat_rad = 0.8, .lon_rad = 0.1 },
                                       .for_s = 3600.0 };
    schuler_path path = flight_build("static", &spec);
    schuler_truth *truth = flight_truth(&path, 0.01, "egm96", "egm96");
    schuler_truth_block block;
    schuler_truth_block_compute(truth, schuler_isa_best(), 300000, 1, &block);
    const schuler_vec3 r_e = path.pieces[0].r0_e;
    const schuler_vec3 g_e = schuler_field_gravity(egm96, r_e);
    const schuler_vec3 known_e = schuler_gravity_at(schuler_truth_nav_gravity(truth), r_e);
    for (int i = 0; i < 3; i++) CHECK_NEAR(known_e.v[i] + block.dg_nav_e[i][0], g_e.v[i], 4e-15);
    schuler_field_close(egm96);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(another_normal_field_is_told_as_a_difference),
        cmocka_unit_test(the_disturbance_is_followed_between_samples),
        cmocka_unit_test(manoeuvres_do_not_upset_the_disturbance),
        cmocka_unit_test(waves_leave_no_more_than_their_height),
        cmocka_unit_test(the_specific_force_holds_the_disturbance),
        cmocka_unit_test(a_navigator_with_the_full_model_misses_nothing),
        cmocka_unit_test(at_rest_one_sample_is_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

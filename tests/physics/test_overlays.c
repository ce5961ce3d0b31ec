/* SPDX-License-Identifier: MIT */
/* Motions on top of a trajectory: they move the truth itself, so what they do is held to closed forms of
 * the motion, and a perfect navigator must return from them. */
#include "core/truth.h"
#include "mission.h"

#define HEAD "scenario: overlay\ntrajectory:\n"
#define REST "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
#define AT_REST                                                                                    \
    "  kind: static\n  start: {lat: 30 deg, lon: 20 deg, height: 100 m, heading: 40 deg}\n"        \
    "  for: 10 min\n"

static const double dt_s = 0.01;

static schuler_truth *truth_of(const schuler_scenario *s)
{
    schuler_truth *truth = NULL;
    assert_int_equal(schuler_truth_create(&truth, &s->path, dt_s, "wgs84", "wgs84", NULL),
                     SCHULER_OK);
    return truth;
}

/* Vibration down the z axis of a level vehicle at rest. Specific force: -g + u'' + 2 omega_ie x u' and the
 * change of gravity with height, -3.086e-6 u; their integrals are closed forms. The motion follows the
 * sinusoid to 1e-9 m/s, and less after integration: 1e-9 is asked of 0.03 m/s. */
static void vibration_integrates_to_its_closed_form(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(
        HEAD AT_REST "  overlays: [vibration: {axis: z, amplitude: 0.5 g, frequency: 37 Hz, phase: "
                     "20 deg}]\n" REST);
    schuler_scenario *still = mission_text(HEAD AT_REST REST);
    schuler_truth *truth = truth_of(s), *at_rest = truth_of(still);
    const double A = 0.5 * 9.80665, w = 2.0 * SCHULER_PI * 37.0, phase = 20.0 * SCHULER_RAD_PER_DEG;
    const double omega_n[3] = { SCHULER_OMEGA_IE_RADPS * cos(30.0 * SCHULER_RAD_PER_DEG), 0.0,
                                -SCHULER_OMEGA_IE_RADPS * sin(30.0 * SCHULER_RAD_PER_DEG) };
    schuler_truth_block block, rest;
    for (int64_t first = 0; first < 50000; first += 9973) {
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
        schuler_truth_block_compute(at_rest, schuler_isa_best(), first, SCHULER_BLOCK, &rest);
        for (int i = 0; i < block.n; i++) {
            const double a = w * (double)(first + i) * dt_s + phase, b = a + w * dt_s;
            const double dv = A / w * (cos(a) - cos(b));           /* of u'' = A sin   */
            const double du = -A / (w * w) * (sin(b) - sin(a));    /* u = -A/w^2 sin   */
            const double iu = A / (w * w * w) * (cos(b) - cos(a)); /* its integral     */
            /* 2 omega x (0, 0, u'): east 2 omega_N... in axes turned by the heading of 40 deg. */
            const double east = -2.0 * omega_n[0] * du;
            const double c = cos(40.0 * SCHULER_RAD_PER_DEG), sn = sin(40.0 * SCHULER_RAD_PER_DEG);
            CHECK_NEAR(block.dv_ib_b[0][i] - rest.dv_ib_b[0][i], east * sn, 1e-9);
            CHECK_NEAR(block.dv_ib_b[1][i] - rest.dv_ib_b[1][i], east * c, 1e-9);
            CHECK_NEAR(block.dv_ib_b[2][i] - rest.dv_ib_b[2][i], dv - 3.086e-6 * iu, 1e-9);
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(block.dtheta_ib_b[k][i], rest.dtheta_ib_b[k][i], 1e-15);
        }
    }
    schuler_truth_free(truth);
    schuler_truth_free(at_rest);
    schuler_scenario_free(s);
    schuler_scenario_free(still);
}

/* What a point of a swaying vehicle must do, written down again: place and attitude against the
 * trajectory without overlays. Pieces follow to 1e-9 m/s, so over 200 s the place to 2e-7 m at worst. */
static void places_and_attitudes_are_those_of_a_rigid_body(void **state)
{
    (void)state;
#define FLIGHT                                                                                     \
    "  kind: segments\n"                                                                           \
    "  start: {lat: 60 deg, lon: 179.9 deg, height: 3 km, heading: 80 deg, speed: 150 m/s}\n"      \
    "  segments: [hold: {for: 20 s}, turn: {by: 120 deg, bank: 40 deg}, cruise: {for: 60 s}]\n"
    schuler_scenario *plain = mission_text(HEAD FLIGHT REST);
    schuler_scenario *s = mission_text(
        HEAD FLIGHT
        "  overlays:\n"
        "    - sway: {motion: roll, angle: 4 deg, period: 3 s, phase: 30 deg}\n"
        "    - sway: {motion: yaw, angle: 2 deg, period: 1.7 s}\n"
        "    - sway: {motion: heave, distance: 2 m, period: 5 s, from: 30 s, ramp: 8 s}\n"
        "    - imu_at: {x: 7 m, y: -2 m, z: 1.5 m}\n"
        "    - indexing: {dwell: 11 s, rate: 30 deg/s, moves: [{by: 90 deg}, {about: outer, "
        "by: -180 deg}]}\n" REST);
    CHECK_NEAR(s->path.duration_s, plain->path.duration_s, 0.0);
    for (double t = 0.0; t < s->path.duration_s; t += 1.37) {
        const schuler_motion m0 = schuler_path_at(&plain->path, t),
                             m = schuler_path_at(&s->path, t);
        const double turn = 2.0 * SCHULER_PI * t, deg = SCHULER_RAD_PER_DEG;
        const double roll = 4.0 * deg * sin(turn / 3.0 + 30.0 * deg),
                     yaw = 2.0 * deg * sin(turn / 1.7);
        const double x = fmin(fmax((t - 30.0) / 8.0, 0.0), 1.0);
        const double heave = 2.0 * x * x * x * (10.0 - x * (15.0 - 6.0 * x)) * sin(turn / 5.0);
        const schuler_mat3 C_b0_e = schuler_mat3_from_quat(m0.q_b_e),
                           C_v_b0 = schuler_mat3_from_euler(roll, 0.0, yaw);
        schuler_vec3 at = schuler_mat3_apply(&C_v_b0, (schuler_vec3){ { 7.0, -2.0, 1.5 } });
        at.v[2] += heave;
        const schuler_vec3 r_e = schuler_vec3_add(m0.r_e, schuler_mat3_apply(&C_b0_e, at));
        for (int i = 0; i < 3; i++) CHECK_NEAR(m.r_e.v[i], r_e.v[i], 3e-7);

        /* Rounds of 11 s rest, 4 s turn (90 deg at 30 deg/s with ramps of 1 s), 11 s rest, 7 s turn. */
        const double into = fmod(t, 33.0), rounds = floor(t / 33.0);
        if ((into > 11.0 && into < 15.0) || into > 26.0) continue;
        const double inner = 90.0 * deg * (rounds + (into >= 15.0)), outer = -180.0 * deg * rounds;
        const schuler_mat3 R_outer = schuler_mat3_from_euler(outer, 0.0, 0.0),
                           R_inner = schuler_mat3_from_euler(0.0, 0.0, inner),
                           to_v = schuler_mat3_mul(&R_outer, &R_inner),
                           to_b0 = schuler_mat3_mul(&C_v_b0, &to_v),
                           expected = schuler_mat3_mul(&C_b0_e, &to_b0),
                           got = schuler_mat3_from_quat(m.q_b_e);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) CHECK_NEAR(got.m[i][j], expected.m[i][j], 1e-11);
    }
    schuler_scenario_free(s);
    schuler_scenario_free(plain);
}

static double largest_closing_m(const char *text)
{
    schuler_scenario *s = mission_text(text);
    s->runs = 1;
    const schuler_run_options options = { .threads = 1 };
    schuler_result *r = mission_run(s, &options);
    const double max_m = r->none.rms_max_m;
    schuler_result_free(r);
    schuler_scenario_free(s);
    return max_m;
}

/* Limits of the design: 2 mm after an hour for two samples, 0.1 mm for four, shaken up to 1.1 Hz. */
static void a_shaken_airliner_closes(void **state)
{
    (void)state;
#define SHAKEN(algorithm)                                                                          \
    HEAD "  kind: segments\n"                                                                      \
         "  start: {lat: 50 deg, lon: -7 deg, heading: 45 deg, speed: 230 m/s, height: 10 km}\n"   \
         "  segments: [cruise: {for: 25 min}, turn: {by: 90 deg}, cruise: {for: 33 min}]\n"        \
         "  overlays:\n    - gusts: {speed: 1.5 m/s, airspeed: 230 m/s}\n"                         \
         "    - sway: {motion: roll, angle: 1 deg, period: 1.7 s}\n"                               \
         "    - sway: {motion: pitch, angle: 0.5 deg, period: 1.1 s}\n"                            \
         "    - sway: {motion: yaw, angle: 0.5 deg, period: 0.91 s}\n" REST                        \
         "navigation: {coning: " algorithm "}\n"
    const double four_m = largest_closing_m(SHAKEN("cubic")),
                 two_m = largest_closing_m(SHAKEN("previous"));
    print_message("shaken for an hour: cubic %.3g mm, previous %.3g mm\n", four_m * 1e3,
                  two_m * 1e3);
    assert_true(four_m < 1e-4);
    assert_true(two_m < 2e-3);
}

/* A K2 of an accelerometer sees the square of the vibration: f = 10 ug/g^2 of (1 g)^2/2 on the average,
 * 5 ug, and a false acceleration of b gives b (1 - cos(ws t))/ws^2. The frequency lies above half the
 * sampling rate: what reaches the samples does not show it, and it rectifies all the same. */
static void vibration_rectifies(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(
        HEAD AT_REST "  overlays: [vibration: {axis: x, amplitude: 1 g, frequency: 83 Hz}]\n"
                     "imu: {rate: 100 Hz, accel: {model: ieee530, K2: 10 ug/g^2}, "
                     "gyro: {model: linear}}\n");
    s->runs = 1;
    const schuler_run_options options = { .threads = 1 };
    schuler_result *r = mission_run(s, &options);
    const double ws2 = 9.79324 / 6.36e6, t = 600.0;
    const double b = 5e-6 * 9.80665;
    /* Down, where 1 g stands, K2 gives a bias of height, which is held. */
    CHECK_NEAR(r->all.rms_end_m, b / ws2 * (1.0 - cos(sqrt(ws2) * t)),
               0.005 * b / ws2 * (1.0 - cos(sqrt(ws2) * t)));
    schuler_result_free(r);
    schuler_scenario_free(s);
}

/* The lines of a spectrum have all its power. Sea: the heave of a float is the elevation, whose rms is a
 * quarter of the significant height; the ends left off hold 2.5 % of the variance, and 1000 s of waves of
 * 10 s and more wander by some percent. */
static void a_sea_has_its_height(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(
        HEAD
        "  kind: static\n  start: {lat: 50 deg, lon: -20 deg}\n  for: 3 h\n"
        "  overlays: [sea: {height: 4 m, period: 9 s, draught: 0 m, direction: 30 deg}]\n" REST);
    double sum = 0.0, roll = 0.0, sum_roll = 0.0, pitch, heading;
    int n = 0;
    for (double t = 0.0; t < s->path.duration_s; t += 0.31, n++) {
        const schuler_motion m = schuler_path_at(&s->path, t);
        const schuler_llh llh = schuler_llh_from_ecef(m.r_e);
        const schuler_mat3 C_n_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad),
                           C_e_n = schuler_mat3_transpose(&C_n_e),
                           C_b_e = schuler_mat3_from_quat(m.q_b_e),
                           C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
        schuler_euler_from_mat3(&C_b_n, &roll, &pitch, &heading);
        sum += llh.h_m * llh.h_m;
        sum_roll += roll * roll;
    }
    CHECK_NEAR(sqrt(sum / n), 1.0, 0.05);
    /* Some degrees, as ships have it. */
    const double roll_deg = sqrt(sum_roll / n) / SCHULER_RAD_PER_DEG;
    print_message("sea: heave %.3f m, roll %.2f deg rms\n", sqrt(sum / n), roll_deg);
    assert_true(roll_deg > 1.0 && roll_deg < 10.0);
    schuler_scenario_free(s);
}

/* Turned about the vertical, a level gyro bias averages out: after whole turns what is left of the error
 * growth is a small part. */
static void a_carousel_averages_level_errors(void **state)
{
    (void)state;
#define BIAS                                                                                       \
    "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear, bias: [0.01 deg/h, 0 "      \
    "deg/h, 0 deg/h]}}\n"
    double end_m[2];
    static const char *const texts[] = {
        HEAD AT_REST BIAS,
        HEAD AT_REST "  overlays: [carousel: {rate: 6 deg/s}]\n" BIAS,
    };
    for (int i = 0; i < 2; i++) {
        schuler_scenario *s = mission_text(texts[i]);
        s->runs = 1;
        const schuler_run_options options = { .threads = 1 };
        schuler_result *r = mission_run(s, &options);
        end_m[i] = r->all.rms_end_m;
        schuler_result_free(r);
        schuler_scenario_free(s);
    }
    /* Standing still: g b t^3/6 = 17 m. Turning with W: at most g b t^2/2 * 2/W, 10 % of it. */
    CHECK_NEAR(end_m[0], 9.79 * 0.01 * SCHULER_RAD_PER_DEG / 3600.0 * 600.0 * 600.0 * 600.0 / 6.0,
               1.0);
    assert_true(end_m[1] < 0.1 * end_m[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vibration_integrates_to_its_closed_form),
        cmocka_unit_test(places_and_attitudes_are_those_of_a_rigid_body),
        cmocka_unit_test(a_shaken_airliner_closes),
        cmocka_unit_test(vibration_rectifies),
        cmocka_unit_test(a_sea_has_its_height),
        cmocka_unit_test(a_carousel_averages_level_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

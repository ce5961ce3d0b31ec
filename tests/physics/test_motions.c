/* SPDX-License-Identifier: MIT */
/* Test motions: the increments of the truth against the closed forms of the reference's section 9 and its
 * rows D5 to D8. The reference gives them for a frame that does not turn; here it stands on the earth, so
 * the earth's rate is taken off: its part is integrated from the truth's own attitude, whose error of 1e-16
 * counts times 7e-5. */
#include "true_motion.h"

#define IMU "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
#define MOTION(keys)                                                                               \
    "scenario: m\ntrajectory: {kind: motion, for: 2 min, start: {lat: 45 deg, lon: 7 deg}, " keys  \
    "}\n" IMU
#define FULL_TURN (2.0 * SCHULER_PI)

/* Earth rate in body axes integrated over step k: five-point Gauss-Legendre on C_e_b z. */
static schuler_vec3 earth_part(const motion *m, int64_t k)
{
    static const double x[5] = { -0.906179845938664, -0.5384693101056831, 0.0, 0.5384693101056831,
                                 0.906179845938664 };
    static const double w[5] = { 0.23692688505618908, 0.47862867049936647, 0.5688888888888889,
                                 0.47862867049936647, 0.23692688505618908 };
    schuler_vec3 sum = { { 0.0, 0.0, 0.0 } };
    for (int i = 0; i < 5; i++) {
        const schuler_motion at =
            schuler_path_at(&m->scenario->path, 0.01 * ((double)k + 0.5 + 0.5 * x[i]));
        const schuler_mat3 C_b_e = schuler_mat3_from_quat(at.q_b_e);
        for (int a = 0; a < 3; a++)
            sum.v[a] += 0.005 * w[i] * SCHULER_OMEGA_IE_RADPS * C_b_e.m[2][a];
    }
    return sum;
}

/* Increments of step k (from k to k + 1 hundredths) less the earth's part. */
static void step(const motion *m, int64_t k, double dtheta[3], double dv[3])
{
    schuler_truth_block block;
    schuler_truth_block_compute(m->truth, schuler_isa_best(), k, 1, &block);
    const schuler_vec3 earth = earth_part(m, k);
    for (int a = 0; a < 3; a++) {
        dtheta[a] = block.dtheta_ib_b[a][0] - earth.v[a];
        dv[a] = block.dv_ib_b[a][0];
    }
}

/* Relative to the largest of the three: pieces keep 5e-17 rad of attitude, times ten for the rate's
 * integral across a piece: 1e-15 rad, of 5e-3. */
static void coning_is_exact(void **state)
{
    (void)state;
    motion m = motion_start(MOTION("coning: {half_angle: 1 deg, frequency: 5 Hz}"));
    double dtheta[3], dv[3];
    step(&m, 10, dtheta, dv); /* D6: 0.10 .. 0.11 s */
    CHECK_NEAR(dtheta[0], 0.000854181570073543, 2e-15);
    CHECK_NEAR(dtheta[1], -0.00539309018185934, 2e-15);
    CHECK_NEAR(dtheta[2], -4.78479777787425e-5, 2e-15);
    const double a = SCHULER_RAD_PER_DEG, W = FULL_TURN * 5.0;
    for (int64_t k = 0; k < 12000; k += 397) { /* twenty steps make a turn */
        const double x1 = FULL_TURN * (double)(k % 20) / 20.0, x2 = x1 + FULL_TURN / 20.0;
        step(&m, k, dtheta, dv);
        CHECK_NEAR(dtheta[0], sin(a) * (cos(x2) - cos(x1)), 5e-15);
        CHECK_NEAR(dtheta[1], sin(a) * (sin(x2) - sin(x1)), 5e-15);
        CHECK_NEAR(dtheta[2], -W * (1.0 - cos(a)) * 0.01, 5e-15);
    }
    motion_end(&m);
}

static void spin_cone_is_exact(void **state)
{
    (void)state;
    motion m =
        motion_start(MOTION("spin_cone: {spin: 1 rad/s, precession: 0.1 rad/s, cone: 45 deg}"));
    double dtheta[3], dv[3];
    step(&m, 1000, dtheta, dv); /* D7b */
    CHECK_NEAR(dtheta[0], 0.01, 2e-15);
    CHECK_NEAR(dtheta[1], -8.97281693662408e-5, 2e-15);
    CHECK_NEAR(dtheta[2], 0.00070138809327518, 2e-15);
    schuler_truth_state at;
    schuler_truth_at(m.truth, 10.0, &at); /* D7 */
    CHECK_NEAR(remainder(at.roll_rad - 9.29289321881345, FULL_TURN), 0.0, 1e-13);
    CHECK_NEAR(at.pitch_rad, 0.785398163397448, 1e-13);
    CHECK_NEAR(remainder(at.heading_rad + 1.0, FULL_TURN), 0.0, 1e-13);
    const schuler_mat3 C = schuler_mat3_from_euler(at.roll_rad, at.pitch_rad, at.heading_rad);
    CHECK_NEAR(C.m[0][0], 0.38205142437009, 1e-13); /* D7c */
    CHECK_NEAR(C.m[0][1], -0.783922674591793, 1e-13);
    CHECK_NEAR(C.m[0][2], -0.489389363797004, 1e-13);
    motion_end(&m);
}

/* Specific force less gravity and Coriolis is (0, D sin wt, 0) in body axes, and after whole cycles the
 * velocity down is D J1(A) t (D8: 0.0499993750026042 of a mean). */
static void sculling_is_exact(void **state)
{
    (void)state;
    motion m = motion_start(MOTION("sculling: {angle: 10 mrad, force: 10 m/s^2, frequency: 4 Hz}"));
    motion still = motion_start(
        "scenario: m\ntrajectory: {kind: static, for: 2 min, start: {lat: 45 deg, lon: 7 "
        "deg}}\n" IMU);
    const double A = 0.01, D = 10.0, W = FULL_TURN * 4.0;
    double dtheta[3], dv[3];
    /* The first step: the vehicle has hardly moved yet, gravity is that of the start turned by roll. */
    for (int64_t k = 0; k < 25; k++) {
        const double t1 = 0.01 * (double)k, t2 = t1 + 0.01;
        step(&m, k, dtheta, dv);
        CHECK_NEAR(dtheta[0], A * (sin(W * t2) - sin(W * t1)), 5e-15);
        /* Gravity in body axes: -g (0, sin roll, cos roll), by Simpson's rule; Coriolis and the change
         * of gravity below 1e-5 m/s^2: velocities of 0.4 m/s. */
        double gy = 0.0;
        for (int i = 0; i <= 20; i++)
            gy += (i == 0 || i == 20 ? 1.0
                   : i % 2           ? 4.0
                                     : 2.0) *
                  sin(A * sin(W * (t1 + 0.0005 * i))) * 0.0005 / 3.0;
        CHECK_NEAR(dv[1], D / W * (cos(W * t1) - cos(W * t2)) - 9.80619776937738 * gy, 2e-6);
    }
    schuler_truth_state at, at_rest;
    for (int cycles = 1; cycles < 400; cycles += 57) {
        schuler_truth_at(m.truth, 0.25 * cycles, &at);
        schuler_truth_at(still.truth, 0.0, &at_rest);
        const schuler_vec3 v_n = schuler_mat3_apply_transposed(&at_rest.C_n_e, at.v_e);
        CHECK_REL(v_n.v[2], 0.0499993750026042 * 0.25 * cycles, 1e-11);
    }
    motion_end(&m);
    motion_end(&still);
}

/* D5, D5b: constant for ever, and the longitude grows in proportion. */
static void a_flight_along_a_parallel_is_steady(void **state)
{
    (void)state;
    motion m = motion_start(
        "scenario: m\ntrajectory: {kind: motion, for: 2 h, start: {lat: 45 deg, lon: 170 deg, "
        "height: 10 km}, parallel: {speed: 250 m/s}}\n" IMU);
    schuler_truth_block block;
    for (int64_t k = 0; k < 720000; k += 71993) {
        schuler_truth_block_compute(m.truth, schuler_isa_best(), k, 1, &block);
        CHECK_NEAR(block.dtheta_ib_b[0][0] / 0.01, 0.0, 1e-16);
        CHECK_REL(block.dtheta_ib_b[1][0] / 0.01, -9.06326314586025e-5, 2e-12);
        CHECK_REL(block.dtheta_ib_b[2][0] / 0.01, -9.06326314586025e-5, 2e-12);
        /* Heading east: body forward is east, right is south. */
        CHECK_NEAR(block.dv_ib_b[0][0] / 0.01, 0.0, 1e-11);
        CHECK_NEAR(block.dv_ib_b[1][0] / 0.01, -0.0356302697678571, 1e-11);
        CHECK_NEAR(block.dv_ib_b[2][0] / 0.01, -9.73986527011007, 1e-11);
    }
    schuler_truth_state at;
    schuler_truth_at(m.truth, 3600.0, &at);
    CHECK_NEAR(remainder(at.llh.lon_rad - 170.0 * SCHULER_RAD_PER_DEG - 5.5252746602318e-5 * 3600.0,
                         FULL_TURN),
               0.0, 1e-14);
    CHECK_NEAR(at.llh.lat_rad, 45.0 * SCHULER_RAD_PER_DEG, 1e-15);
    CHECK_NEAR(at.llh.h_m, 1e4, 2e-9);
    motion_end(&m);
}

/* A constant rate relative to the earth: what is left of the increments is the rate times the step. A
 * turntable turns about the vertical, tilted bodies too. */
static void constant_rates_are_constant(void **state)
{
    (void)state;
    motion m = motion_start(MOTION("constant_rate: {x: 0.3 rad/s, y: -0.2 rad/s, z: 0.5 rad/s}"));
    motion table = motion_start(
        "scenario: m\ntrajectory: {kind: motion, for: 2 min, start: {lat: 45 deg, lon: 7 deg, "
        "pitch: 30 deg}, turntable: {rate: 20 deg/s}}\n" IMU);
    double dtheta[3], dv[3];
    for (int64_t k = 0; k < 12000; k += 611) {
        step(&m, k, dtheta, dv);
        CHECK_NEAR(dtheta[0], 0.003, 2e-15);
        CHECK_NEAR(dtheta[1], -0.002, 2e-15);
        CHECK_NEAR(dtheta[2], 0.005, 2e-15);
        step(&table, k, dtheta, dv);
        const double part = 0.2 * SCHULER_RAD_PER_DEG;
        CHECK_NEAR(dtheta[0], -part * sin(30.0 * SCHULER_RAD_PER_DEG), 2e-15);
        CHECK_NEAR(dtheta[1], 0.0, 2e-15);
        CHECK_NEAR(dtheta[2], part * cos(30.0 * SCHULER_RAD_PER_DEG), 2e-15);
        CHECK_NEAR(dv[0], 0.01 * 9.80619776937738 * sin(30.0 * SCHULER_RAD_PER_DEG), 1e-12);
    }
    motion_end(&m);
    motion_end(&table);
}

static double closing_m(const char *text)
{
    schuler_scenario *s = mission_text(text);
    s->runs = 1;
    const schuler_run_options options = { .threads = 1 };
    schuler_result *r = mission_run(s, &options);
    const double max_m = r->none.rms_max_m;
    print_message("%s closes to %.3g mm\n", s->name, max_m * 1e3);
    schuler_result_free(r);
    schuler_scenario_free(s);
    return max_m;
}

/* Ten hours along a parallel and over the pole: rounding is all. */
static void steady_flights_close(void **state)
{
    (void)state;
    assert_true(
        closing_m("scenario: parallel, 10 h\ntrajectory: {kind: motion, for: 10 h, start: {lat: 45 "
                  "deg, lon: 170 deg, height: 10 km}, parallel: {speed: 250 m/s}}\n" IMU) < 1e-3);
    assert_true(
        closing_m("scenario: over the pole, 4 h\ntrajectory: {kind: motion, for: 4 h, start: {lat: "
                  "75 deg, lon: 10 deg, height: 10 km}, geodesic: {speed: 250 m/s}}\n" IMU) < 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coning_is_exact),
        cmocka_unit_test(spin_cone_is_exact),
        cmocka_unit_test(sculling_is_exact),
        cmocka_unit_test(a_flight_along_a_parallel_is_steady),
        cmocka_unit_test(constant_rates_are_constant),
        cmocka_unit_test(steady_flights_close),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

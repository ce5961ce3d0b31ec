/* SPDX-License-Identifier: MIT */
/* Manoeuvres in the vertical plane, turns of the body, series of manoeuvres and polynomials. */
#include "true_motion.h"

#define DEG SCHULER_RAD_PER_DEG
#define G0  SCHULER_G0_MPS2
/* Ramp of a change whose rate rises to `peak` with a slope of at most `slope`. */
#define RAMP_S(peak, slope) (1.875 * (peak) / (slope))
#define FLIGHT(start, segments)                                                                    \
    "scenario: m\ntrajectory: {kind: segments, start: {" start "}, segments: [" segments "]}\n"    \
    "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
#define HIGH "lat: 45 deg, lon: 7 deg, height: 5 km, heading: 30 deg, speed: 200 m/s"

static schuler_truth_state state_at(const motion *m, double t_s)
{
    schuler_truth_state s;
    schuler_truth_at(m->truth, t_s, &s);
    return s;
}

static double duration_s(const motion *m)
{
    return m->scenario->path.duration_s;
}

/* Specific force over the step that holds t, body axes. */
static schuler_vec3 force_at(const motion *m, double t_s)
{
    schuler_truth_block block;
    schuler_truth_block_compute(m->truth, schuler_isa_best(), (int64_t)(t_s * 100.0), 1, &block);
    return (schuler_vec3){ { block.dv_ib_b[0][0] / 0.01, block.dv_ib_b[1][0] / 0.01,
                             block.dv_ib_b[2][0] / 0.01 } };
}

/* A change along a trapezoid of smoothsteps, written anew: ramps of ramp_s, change/(plateau + ramp)
 * between. */
static double trapezoid(double change, double ramp_s, double plateau_s, double t_s)
{
    const double rate = change / (ramp_s + plateau_s), end_s = 2.0 * ramp_s + plateau_s;
    if (t_s > 0.5 * end_s) return change - trapezoid(change, ramp_s, plateau_s, end_s - t_s);
    const double x = t_s / ramp_s;
    return x < 1.0 ? rate * ramp_s * (2.5 * pow(x, 4) - 3.0 * pow(x, 5) + pow(x, 6))
                   : rate * (t_s - 0.5 * ramp_s);
}

/* Height is the integral of speed times the sine of the path angle: here by Simpson's rule, whose error
 * at 20000 intervals is below 1e-9 m. Joints are ticks, speed and angle exact. */
static void a_pull_bends_the_path_by_its_acceleration(void **state)
{
    (void)state;
    motion m = motion_start(
        FLIGHT(HIGH, "pull: {to: 50 deg, at: 3 g, jerk: 30 m/s^3}, hold: {for: 10 s}"));
    const double rate = 3.0 * G0 / 200.0, ramp_s = RAMP_S(3.0 * G0, 30.0);
    const double plateau_s = 50.0 * DEG / rate - ramp_s, T_s = 2.0 * ramp_s + plateau_s;
    CHECK_NEAR(duration_s(&m), T_s + 10.0, 1e-8);
    double h_m = 5000.0;
    const int n = 20000;
    for (int i = 0; i <= n; i++)
        h_m += (i == 0 || i == n ? 1.0
                : i % 2          ? 4.0
                                 : 2.0) *
               T_s / n / 3.0 * 200.0 * sin(trapezoid(50.0 * DEG, ramp_s, plateau_s, T_s * i / n));
    schuler_truth_state s = state_at(&m, T_s);
    CHECK_NEAR(s.llh.h_m, h_m, 1e-6); /* the end is known to 1e-9 s, at 150 m/s */
    s = state_at(&m, T_s + 10.0);
    CHECK_NEAR(s.llh.h_m, h_m + 2000.0 * sin(50.0 * DEG), 1e-6);
    CHECK_NEAR(s.pitch_rad, 50.0 * DEG, 1e-13);
    CHECK_NEAR(s.heading_rad, 30.0 * DEG, 1e-13);
    CHECK_NEAR(schuler_vec3_norm(s.v_n), 200.0, 1e-11);
    CHECK_NEAR(s.v_n.v[2], -200.0 * sin(50.0 * DEG), 1e-11);
    /* In the plateau: 3 g and the part of gravity across the path; Coriolis and curvature add less than
     * 2 omega v + v^2/R = 0.035 m/s^2. */
    const double t_s = ramp_s + 0.5 * plateau_s;
    const schuler_vec3 f = force_at(&m, t_s);
    CHECK_NEAR(f.v[2], -(3.0 * G0 + 9.79 * cos(25.0 * DEG)), 0.06);
    CHECK_NEAR(f.v[1], 0.0, 0.035);
    motion_end(&m);
}

/* The path angle is symmetric about the top, so height comes back; on top gravity helps. */
static void a_loop_returns_to_its_height_and_heading(void **state)
{
    (void)state;
    motion m = motion_start(FLIGHT(HIGH, "loop: {at: 6 g, jerk: 60 m/s^3}, hold: {for: 5 s}"));
    const double ramp_s = RAMP_S(6.0 * G0, 60.0), rate = 6.0 * G0 / 200.0;
    const double T_s = 360.0 * DEG / rate + ramp_s;
    CHECK_NEAR(duration_s(&m), T_s + 5.0, 1e-8);
    const schuler_truth_state top = state_at(&m, 0.5 * T_s), s = state_at(&m, duration_s(&m));
    CHECK_NEAR(fabs(top.roll_rad), SCHULER_PI, 1e-12);
    CHECK_NEAR(top.heading_rad, 210.0 * DEG, 1e-12);
    assert_true(top.llh.h_m > 5000.0 + 2.0 * 200.0 / rate);
    CHECK_NEAR(s.llh.h_m, 5000.0, 1e-8);
    CHECK_NEAR(s.heading_rad, 30.0 * DEG, 1e-13);
    CHECK_NEAR(remainder(s.roll_rad, 2.0 * SCHULER_PI), 0.0, 1e-13);
    CHECK_NEAR(s.pitch_rad, 0.0, 1e-13);
    CHECK_NEAR(force_at(&m, 0.5 * T_s).v[2], -(6.0 * G0 - 9.79), 0.06);
    CHECK_NEAR(force_at(&m, duration_s(&m) - 1.0).v[2], -9.79, 0.06);
    motion_end(&m);
}

/* Half a loop and half a roll: the other way, upright, higher. And down again by a split-S. */
static void half_loops_and_half_rolls_turn_round(void **state)
{
    (void)state;
    motion m =
        motion_start(FLIGHT(HIGH, "loop: {by: 180 deg, at: 4 g}, hold: {for: 2 s}, roll: {by: 180 "
                                  "deg, rate: 90 deg/s, acceleration: 900 deg/s^2}, "
                                  "hold: {for: 2 s}, roll: {by: -180 deg, rate: 90 deg/s, "
                                  "acceleration: 900 deg/s^2}, loop: {by: -180 deg, at: 4 "
                                  "g}, hold: {for: 2 s}"));
    const double half_s = 180.0 * DEG * 200.0 / (4.0 * G0) + RAMP_S(4.0 * G0, 20.0);
    const double roll_s = 2.0 + RAMP_S(90.0, 900.0);
    CHECK_NEAR(duration_s(&m), 2.0 * half_s + 2.0 * roll_s + 6.0, 1e-8);
    schuler_truth_state s = state_at(&m, half_s + 1.0);
    const double high_m = s.llh.h_m;
    CHECK_NEAR(fabs(s.roll_rad), SCHULER_PI, 1e-12);
    CHECK_NEAR(s.heading_rad, 210.0 * DEG, 1e-12);
    CHECK_NEAR(force_at(&m, half_s + 1.0).v[2], 9.79, 0.06); /* hangs in the straps */
    s = state_at(&m, half_s + 2.0 + roll_s + 1.0);
    CHECK_NEAR(remainder(s.roll_rad, 2.0 * SCHULER_PI), 0.0, 1e-12);
    CHECK_NEAR(s.heading_rad, 210.0 * DEG, 1e-12);
    CHECK_NEAR(s.llh.h_m, high_m, 1e-8);
    CHECK_NEAR(force_at(&m, half_s + 2.0 + roll_s + 1.0).v[2], -9.79, 0.06);
    s = state_at(&m, duration_s(&m));
    CHECK_NEAR(s.llh.h_m, 5000.0, 1e-7); /* down by the same bend */
    CHECK_NEAR(s.heading_rad, 30.0 * DEG, 1e-12);
    CHECK_NEAR(remainder(s.roll_rad, 2.0 * SCHULER_PI), 0.0, 1e-12);
    motion_end(&m);
}

static void the_body_turns_and_the_path_does_not(void **state)
{
    (void)state;
    motion still = motion_start(FLIGHT(HIGH, "hold: {for: 60 s}"));
    motion m = motion_start(FLIGHT(
        HIGH,
        "roll: {by: 720 deg, rate: 300 deg/s, acceleration: 1500 deg/s^2}, pitch: {by: 8 deg, "
        "rate: 4 deg/s}, yaw: {by: -3 deg, rate: 2 deg/s}, hold: {for: 50 s}"));
    double fastest = 0.0;
    for (int64_t k = 0; k < 300; k++) {
        schuler_truth_block block;
        schuler_truth_block_compute(m.truth, schuler_isa_best(), k, 1, &block);
        fastest = fmax(fastest, block.dtheta_ib_b[0][0] / 0.01);
    }
    CHECK_NEAR(fastest, 300.0 * DEG, 2e-4); /* the earth's rate and the turn of the level */
    const schuler_truth_state s = state_at(&m, 50.0), line = state_at(&still, 50.0);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(s.r_e.v[i], line.r_e.v[i],
                   4e-9); /* rounding of the earth's radius, four times */
        CHECK_NEAR(s.v_e.v[i], line.v_e.v[i], 1e-12);
    }
    /* Yaw, then pitch about the new right axis: both seen from level flight. */
    CHECK_NEAR(s.pitch_rad, 8.0 * DEG, 1e-13);
    CHECK_NEAR(s.heading_rad, 27.0 * DEG, 1e-13);
    CHECK_NEAR(remainder(s.roll_rad, 2.0 * SCHULER_PI), 0.0, 1e-13);
    motion_end(&still);
    motion_end(&m);
    m = motion_start(
        FLIGHT("lat: 45 deg, lon: 7 deg, heading: 350 deg",
               "yaw: {by: 40 deg, rate: 10 deg/s}, accelerate: {to: 5 m/s, at: 1 m/s^2}"));
    const schuler_truth_state goes = state_at(&m, duration_s(&m));
    CHECK_NEAR(goes.heading_rad, 30.0 * DEG, 1e-13);
    CHECK_NEAR(atan2(goes.v_n.v[1], goes.v_n.v[0]), 30.0 * DEG, 1e-13);
    motion_end(&m);
}

/* Along the equator a distance is the radius times the longitude. Accelerating and braking are symmetric, so
 * each covers half its speed times its time. */
static void stop_and_go_drives_and_stands(void **state)
{
    (void)state;
    motion m =
        motion_start(FLIGHT("lat: 0 deg, lon: 0 deg, heading: 90 deg",
                            "stop_and_go: {times: 3, speed: 15 m/s, at: 2 m/s^2, jerk: 1.5 m/s^3, "
                            "drive: 20 s, stop: 12 s}"));
    const double change_s = 15.0 / 2.0 + RAMP_S(2.0, 1.5), round_s = 2.0 * change_s + 32.0;
    CHECK_NEAR(duration_s(&m), 3.0 * round_s, 1e-7);
    for (int i = 0; i < 3; i++) {
        schuler_truth_state s = state_at(&m, i * round_s + change_s + 10.0);
        CHECK_NEAR(s.v_n.v[1], 15.0, 1e-12);
        s = state_at(&m, (i + 1) * round_s - 6.0);
        CHECK_NEAR(schuler_vec3_norm(s.v_n), 0.0, 1e-14);
        CHECK_NEAR(s.llh.lon_rad * SCHULER_WGS84_A_M, (i + 1) * 15.0 * (change_s + 20.0), 1e-6);
    }
    motion_end(&m);
}

static double heading_rate(const motion *m, double t_s)
{
    const double h_s = 1e-2;
    const double change = state_at(m, t_s + h_s).heading_rad - state_at(m, t_s - h_s).heading_rad;
    return remainder(change, 2.0 * SCHULER_PI) / (2.0 * h_s);
}

static void circles_have_their_radius(void **state)
{
    (void)state;
    motion m = motion_start(FLIGHT(HIGH, "orbit: {turns: -2.5, radius: 6 km}"));
    const double bank = atan(200.0 * 200.0 / (6000.0 * G0)), rate = 200.0 / 6000.0;
    const double T_s = 5.0 * SCHULER_PI / rate + RAMP_S(tan(bank), 5.0 * DEG);
    CHECK_NEAR(duration_s(&m), T_s, 1e-8);
    CHECK_NEAR(heading_rate(&m, 0.5 * T_s), -rate, 1e-11);
    CHECK_NEAR(state_at(&m, 0.5 * T_s).roll_rad, -bank, 1e-9);
    CHECK_NEAR(state_at(&m, T_s).heading_rad, 210.0 * DEG, 1e-12);
    motion_end(&m);
    /* Flat: no roll, and the sideways force is v^2/r; Coriolis at 8 m/s is 1e-3 m/s^2. */
    m = motion_start(FLIGHT("lat: 45 deg, lon: 7 deg, heading: 350 deg, speed: 8 m/s",
                            "turn: {by: 200 deg, radius: 25 m, jerk: 2 m/s^3}"));
    const double across = 8.0 * 8.0 / 25.0, flat_s = 200.0 * DEG * 25.0 / 8.0 + RAMP_S(across, 2.0);
    CHECK_NEAR(duration_s(&m), flat_s, 1e-8);
    CHECK_NEAR(state_at(&m, 0.5 * flat_s).roll_rad, 0.0, 1e-13);
    CHECK_NEAR(heading_rate(&m, 0.5 * flat_s), 8.0 / 25.0, 1e-11);
    CHECK_NEAR(force_at(&m, 0.5 * flat_s).v[1], across, 2e-3);
    CHECK_NEAR(state_at(&m, flat_s).heading_rad, 190.0 * DEG, 1e-12);
    motion_end(&m);
    m = motion_start(
        FLIGHT(HIGH, "s_turn: {by: 40 deg, bank: 45 deg, roll_rate: 30 deg/s, times: 2}"));
    const double quarter_s =
        40.0 * DEG / (G0 / 200.0) + RAMP_S(1.0, 30.0 * DEG); /* one of 40 deg, level to level */
    const double half_s = 80.0 * DEG / (G0 / 200.0) + RAMP_S(1.0, 30.0 * DEG);
    CHECK_NEAR(duration_s(&m), 2.0 * quarter_s + 3.0 * half_s, 1e-7);
    CHECK_NEAR(state_at(&m, quarter_s).heading_rad, 70.0 * DEG, 1e-9);
    CHECK_NEAR(state_at(&m, quarter_s + half_s).heading_rad, 350.0 * DEG, 1e-9);
    CHECK_NEAR(state_at(&m, quarter_s + 2.0 * half_s).heading_rad, 70.0 * DEG, 1e-9);
    CHECK_NEAR(state_at(&m, duration_s(&m)).heading_rad, 30.0 * DEG, 1e-13);
    motion_end(&m);
}

/* The Bernstein polynomial by its definition, with binomials. */
static double bernstein(const double *points, int n, double x)
{
    double sum = 0.0, binomial = 1.0;
    for (int i = 0; i <= n; i++) {
        sum += points[i] * binomial * pow(x, i) * pow(1.0 - x, n - i);
        binomial = binomial * (n - i) / (i + 1);
    }
    return sum;
}

static void polynomials_are_those_of_their_points(void **state)
{
    (void)state;
    motion m =
        motion_start(FLIGHT(HIGH, "polynomial: {for: 80 s, speed: [150 m/s, 260 m/s, 240 m/s], "
                                  "path_angle: [20 deg, 0 deg], turn: 50 deg, roll: [30 deg, 0 "
                                  "deg]}, hold: {for: 1 s}"));
    static const double speed[] = { 200, 200, 200, 150, 260, 240, 240, 240 };
    static const double angle[] = { 0, 0, 0, 20, 0, 0, 0 }, turn[] = { 0, 0, 0, 50, 50, 50 };
    double before_h_m = 5000.0;
    for (int k = 0; k <= 80; k++) {
        const schuler_truth_state s = state_at(&m, k);
        const double x = k / 80.0, path = bernstein(angle, 6, x) * DEG;
        const double v = bernstein(speed, 7, x);
        CHECK_NEAR(schuler_vec3_norm(s.v_n), v, 1e-11);
        CHECK_NEAR(-s.v_n.v[2], v * sin(path), 1e-11);
        const double heading = atan2(s.v_n.v[1], s.v_n.v[0]);
        CHECK_NEAR(heading, (30.0 + bernstein(turn, 5, x)) * DEG, 1e-13);
        if (k >
            0) { /* the height is that of the climb: trapezoid rule, second derivative 0.3 m/s^3 */
            const double climb = 0.5 * (-s.v_n.v[2] - state_at(&m, k - 1).v_n.v[2]);
            CHECK_NEAR(s.llh.h_m - before_h_m, climb, 0.3 / 12.0);
        }
        before_h_m = s.llh.h_m;
    }
    motion_end(&m);
    m = motion_start(FLIGHT(HIGH, "polynomial: {for: 60 s, height: [5500 m, 4000 m]}"));
    static const double height[] = { 5000, 5000, 5000, 5500, 4000, 4000, 4000 };
    for (int k = 0; k <= 60; k += 4)
        CHECK_NEAR(state_at(&m, k).llh.h_m, bernstein(height, 6, k / 60.0), 2e-9);
    motion_end(&m);
}

/* Where two pieces meet, position, velocity, acceleration, attitude and rate are the same from both. What
 * the fit leaves of a velocity, 1e-14 (1 + v/100) m/s, its derivative has times 2 n^2/T for a piece of
 * length T and degree n = 10; the attitude likewise. */
static void pieces_join_smoothly(void **state)
{
    (void)state;
    static const char *const names[] = { "fighter", "launch" };
    for (size_t f = 0; f < sizeof names / sizeof names[0]; f++) {
        schuler_scenario *s = mission_gallery(names[f], NULL);
        const schuler_path *const path = &s->path;
        for (size_t i = 1; i < path->count; i++) {
            const schuler_motion a = schuler_piece_at(&path->pieces[i - 1], 1.0);
            const schuler_motion b = schuler_piece_at(&path->pieces[i], -1.0);
            const double T_s = fmin(path->pieces[i - 1].duration_s, path->pieces[i].duration_s);
            const double v = 1.0 + 0.01 * schuler_vec3_norm(a.v_e);
            const double q = a.q_b_e.w * b.q_b_e.w + a.q_b_e.x * b.q_b_e.x + a.q_b_e.y * b.q_b_e.y +
                             a.q_b_e.z * b.q_b_e.z;
            CHECK_NEAR(fabs(q), 1.0, 1e-15);
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(b.r_e.v[c], a.r_e.v[c], 3e-9);
                CHECK_NEAR(b.v_e.v[c], a.v_e.v[c], 1e-12 * v);
                CHECK_NEAR(b.a_e.v[c], a.a_e.v[c], 4e-12 * v / T_s);
                CHECK_NEAR(b.omega_eb_b.v[c], a.omega_eb_b.v[c], 1e-12 + 2e-14 / T_s);
            }
        }
        schuler_scenario_free(s);
    }
}

static void refuse(const char *text, const char *says)
{
    char path[] = "/tmp/schuler-test-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), (ssize_t)strlen(text));
    close(fd);
    schuler_scenario *s = NULL;
    schuler_diagnostics d = { 0 };
    assert_int_equal(schuler_scenario_load(&s, path, NULL, &d), SCHULER_ERR_INPUT);
    unlink(path);
    assert_null(s);
    assert_int_equal(d.errors, 1);
    assert_int_equal(d.items[0].place.line, 2);
    if (!strstr(d.items[0].message, says))
        fail_msg("'%s' is not in '%s'", says, d.items[0].message);
    schuler_diagnostics_free(&d);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    refuse(FLIGHT(HIGH, "pull: {to: 9 deg, at: 1 g}, climb: {to: 6 km, at: 9 m/s}"),
           "climb starts from level flight");
    refuse(FLIGHT(HIGH, "pull: {to: 9 deg, at: 1 g}, turn: {by: 9 deg}"),
           "turn starts from level flight");
    refuse(FLIGHT("lat: 45 deg, lon: 7 deg", "pull: {to: 9 deg, at: 1 g}"), "at rest");
    refuse(FLIGHT(HIGH, "orbit: {turns: 1, radius: 300 m}"), "85 deg, which takes 357 m");
    refuse(FLIGHT(HIGH, "pull: {to: -60 deg, at: 1 g}, hold: {for: 5 min}"), "-1000 to 120000 m");
    refuse(FLIGHT(HIGH, "pull: {to: 90 deg, at: 1 g}, hold: {for: 1 h}"), "-1000 to 120000 m");
    refuse(FLIGHT(HIGH, "polynomial: {for: 9 s, height: 6 km, path_angle: 3 deg}"),
           "goes without one of path_angle");
    refuse(FLIGHT(HIGH, "polynomial: {for: 9 s, speed: []}"), "a list of 1 to 16 values");
    refuse(FLIGHT(HIGH, "polynomial: {for: 9 s, speed: [200 m/s, 9 deg]}"), "speed");
    refuse(FLIGHT(HIGH, "polynomial: {for: 9 s, speed: [200 m/s, -9 m/s]}"), "out of range");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pull_bends_the_path_by_its_acceleration),
        cmocka_unit_test(a_loop_returns_to_its_height_and_heading),
        cmocka_unit_test(half_loops_and_half_rolls_turn_round),
        cmocka_unit_test(the_body_turns_and_the_path_does_not),
        cmocka_unit_test(stop_and_go_drives_and_stands),
        cmocka_unit_test(circles_have_their_radius),
        cmocka_unit_test(polynomials_are_those_of_their_points),
        cmocka_unit_test(pieces_join_smoothly),
        cmocka_unit_test(what_makes_no_sense_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

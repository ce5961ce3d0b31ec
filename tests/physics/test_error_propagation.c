/* SPDX-License-Identifier: MIT */
/* Single errors of a navigator at rest against the linear error-propagation reference and closed
 * forms. */
#include "core/earth.h"
#include "mission.h"

/* Level seven-state model at rest, psi-angle form: rN, rE, vN, vE, psiN, psiE, psiD. Independent of
 * the simulator: only linear equations on the local ellipsoid. */
enum { N_STATES = 7 };
typedef struct {
    double F[N_STATES][N_STATES];
} level_model;

static level_model level_at(double lat_rad, double g_mps2)
{
    const double W = SCHULER_OMEGA_IE_RADPS, s = sin(lat_rad), c = cos(lat_rad);
    level_model m = { { { 0 } } };
    m.F[0][2] = m.F[1][3] = 1.0;
    m.F[2][0] = -g_mps2 / schuler_earth_meridian_radius(lat_rad);
    m.F[3][1] = -g_mps2 / schuler_earth_transverse_radius(lat_rad);
    m.F[2][3] = -2.0 * W * s, m.F[3][2] = 2.0 * W * s;
    m.F[2][5] = g_mps2, m.F[3][4] = -g_mps2;
    m.F[4][5] = -W * s, m.F[5][4] = W * s, m.F[5][6] = W * c, m.F[6][5] = -W * c;
    return m;
}

/* P' = F P + P F^T + diag(q), fourth-order Runge-Kutta; 1 s steps leave (w dt)^4 = 1e-12. */
static void covariance_slope(const level_model *m, const double q[N_STATES], double (*P)[N_STATES],
                             double (*dP)[N_STATES])
{
    for (int i = 0; i < N_STATES; i++)
        for (int j = 0; j < N_STATES; j++) {
            dP[i][j] = i == j ? q[i] : 0.0;
            for (int k = 0; k < N_STATES; k++)
                dP[i][j] += m->F[i][k] * P[k][j] + P[i][k] * m->F[j][k];
        }
}

static void covariance(const level_model *m, const double q[N_STATES], int seconds,
                       double P[N_STATES][N_STATES])
{
    const double step[4] = { 0.0, 0.5, 0.5, 1.0 },
                 weight[4] = { 1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6 };
    memset(P, 0, sizeof(double[N_STATES][N_STATES]));
    for (int t = 0; t < seconds; t++) {
        double sum[N_STATES][N_STATES] = { { 0 } }, slope[N_STATES][N_STATES] = { { 0 } };
        for (int stage = 0; stage < 4; stage++) {
            double at[N_STATES][N_STATES];
            for (int i = 0; i < N_STATES * N_STATES; i++)
                (&at[0][0])[i] = (&P[0][0])[i] + step[stage] * (&slope[0][0])[i];
            covariance_slope(m, q, at, slope);
            for (int i = 0; i < N_STATES * N_STATES; i++)
                (&sum[0][0])[i] += weight[stage] * (&slope[0][0])[i];
        }
        for (int i = 0; i < N_STATES * N_STATES; i++) (&P[0][0])[i] += (&sum[0][0])[i];
    }
}

static const char static_mission[] =
    "scenario: at rest\nruns: %d\n"
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m}, for: %s}\n"
    "report: {every: 1 h}\n"
    "imu:\n  rate: 50 Hz\n  accel: {model: linear, %s}\n  gyro: {model: linear, %s}\n"
    "initial: {%s}\n";

static schuler_scenario *at_rest(int runs, const char *duration, const char *accel,
                                 const char *gyro, const char *initial)
{
    char text[2048];
    snprintf(text, sizeof(text), static_mission, runs, duration, accel, gyro, initial);
    return mission_text(text);
}

/* Published in the reference as E11: 45 deg, h = 0, after 1 h and 4 h, (north, east) in m, linear
 * model. The simulator is non-linear: 0.1 % of the displacement. Initial heading is computed minus
 * true heading, which is -psi_D: the reference's row is for psi_D = +1 mrad. */
static void single_errors_move_as_the_reference_says(void **state)
{
    (void)state;
    const struct {
        const char *source, *accel, *gyro, *initial;
        double expected_m[2][2];
    } rows[] = {
        { "accel.bias",
          "bias: [50 ug, 0 ug, 0 ug]",
          "bias: 0 deg/h",
          "",
          { { 395.409651994, 1.62510975406 }, { 191.319607112, -128.419944581 } } },
        { "accel.bias",
          "bias: [0 ug, 50 ug, 0 ug]",
          "bias: 0 deg/h",
          "",
          { { -1.62510975406, 399.053870678 }, { 128.419944581, 199.207860465 } } },
        { "gyro.bias",
          "bias: 0 ug",
          "bias: [0.01 deg/h, 0 deg/h, 0 deg/h]",
          "",
          { { -160.046716573, 1344.27527409 }, { -1650.16940984, 4224.59097452 } } },
        { "gyro.bias",
          "bias: 0 ug",
          "bias: [0 deg/h, 0.01 deg/h, 0 deg/h]",
          "",
          { { -1335.75839041, -160.041534204 }, { -3826.43376268, -1650.03392818 } } },
        { "gyro.bias",
          "bias: 0 ug",
          "bias: [0 deg/h, 0 deg/h, 0.01 deg/h]",
          "",
          { { -89.5966272896, -8.64274374391 }, { -1497.67357981, -398.637005662 } } },
        { "initial.tilt",
          "bias: 0 ug",
          "bias: 0 deg/h",
          "tilt: [0.1 mrad, 0 mrad]",
          { { 145.316528433, -781.049494821 }, { 150.137689473, -222.905673291 } } },
        { "initial.tilt",
          "bias: 0 ug",
          "bias: 0 deg/h",
          "tilt: [0 mrad, 0.1 mrad]",
          { { 764.231667305, 145.303142409 }, { 47.8283086932, 150.086660327 } } },
        { "initial.heading",
          "bias: 0 ug",
          "bias: 0 deg/h",
          "heading: -1 mrad",
          { { 1420.66458807, 170.214420435 }, { 4069.65734544, 1754.91674821 } } },
        { "initial.velocity",
          "bias: 0 ug",
          "bias: 0 deg/h",
          "velocity: [0.1 m/s, 0 m/s, 0 m/s]",
          { { -76.8428445709, -14.4287362493 }, { -48.6030924931, -45.2097475607 } } },
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        schuler_scenario *s = at_rest(1, "4 h", rows[i].accel, rows[i].gyro, rows[i].initial);
        mission_trace t = mission_errors(s, rows[i].source);
        assert_int_equal(t.count, 5);
        for (int k = 0; k < 2; k++) {
            const double *e = rows[i].expected_m[k], size_m = hypot(e[0], e[1]);
            const schuler_error_row *at = &t.rows[k == 0 ? 1 : 4];
            CHECK_NEAR(at->r_n[0], e[0], 1e-3 * size_m);
            CHECK_NEAR(at->r_n[1], e[1], 1e-3 * size_m);
        }
        free(t.rows);
        schuler_scenario_free(s);
    }
}

/* E12: the same, each started from the tilt and heading that it would have given a self-alignment (the
 * reference's D10): a level accelerometer's bias tilts by b/g, that of the east one turns the heading too,
 * the east gyro turns it by b/(W cos L). What is level to its own bias does not swing, and east errors
 * are gone to the second order. The signs are those of phi: tilt about north and east, heading less -phi_D. */
static void an_error_that_aligned_itself_moves_as_the_reference_says(void **state)
{
    (void)state;
    const struct {
        const char *accel, *gyro, *initial;
        double expected_m[2][2], size_m;
    } rows[] = {
        { "bias: [50 ug, 0 ug, 0 ug]",
          "bias: 0 deg/h",
          "tilt: [0 urad, -50.0023058408226 urad]",
          { { 13.276196376, -71.0298119099 }, { 167.404349921, -203.466735505 } },
          400.0 },
        { "bias: [0 ug, 50 ug, 0 ug]",
          "bias: 0 deg/h",
          "tilt: [50.0023058408226 urad, 0 urad], heading: 50.0023058408226 urad",
          { { 0.0, 0.0 }, { 0.0, 0.0 } },
          400.0 },
        { "bias: 0 ug",
          "bias: [0.01 deg/h, 0 deg/h, 0 deg/h]",
          "",
          { { -160.046716573, 1344.27527409 }, { -1650.16940984, 4224.59097452 } },
          4500.0 },
        { "bias: 0 ug",
          "bias: [0 deg/h, 0.01 deg/h, 0 deg/h]",
          "heading: -940.234874311679 urad",
          { { 0.0, 0.0 }, { 0.0, 0.0 } },
          4200.0 },
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        schuler_scenario *s = at_rest(1, "4 h", rows[i].accel, rows[i].gyro, rows[i].initial);
        mission_trace t = mission_errors(s, "all");
        for (int k = 0; k < 2; k++) {
            const schuler_error_row *const at = &t.rows[k == 0 ? 1 : 4];
            for (int axis = 0; axis < 2; axis++)
                CHECK_NEAR(at->r_n[axis], rows[i].expected_m[k][axis], 1e-3 * rows[i].size_m);
        }
        free(t.rows);
        schuler_scenario_free(s);
    }
}

/* A navigator that believes to be 1 km away is level there: it shows no attitude error and stays
 * (reference section 3). Only the earth's rate of the wrong latitude turns it, W sin(L) 1 km/R =
 * 8e-9 rad/s, which in 300 s moves it by R e w^2 t^3/6 = 0.4 m. Its constant error is no drift. */
static void an_initial_position_error_stays(void **state)
{
    (void)state;
    for (int axis = 0; axis < 2; axis++) {
        schuler_scenario *s =
            at_rest(1, "300 s", "bias: 0 ug", "bias: 0 deg/h",
                    axis == 0 ? "position: [1 km, 0 m, 0 m]" : "position: [0 m, 1 km, 0 m]");
        s->report_s = 10.0;
        mission_trace t = mission_errors(s, "initial.position");
        CHECK_NEAR(t.rows[0].roll_rad, 0.0, 1e-12);
        CHECK_NEAR(t.rows[0].pitch_rad, 0.0, 1e-12);
        CHECK_NEAR(t.rows[0].heading_rad, 0.0, 1e-12);
        CHECK_NEAR(t.rows[t.count - 1].r_n[axis], 1000.0, 1.0);
        CHECK_NEAR(t.rows[t.count - 1].r_n[1 - axis], 0.0, 1.0);
        const schuler_run_options options = { .threads = 1 };
        schuler_result *r = mission_run(s, &options);
        CHECK_NEAR(mission_row(r, "initial.position")->slope_mps[0], 0.0, 1.0 / 300.0);
        schuler_result_free(r);
        free(t.rows);
        schuler_scenario_free(s);
    }
}

/* At the equator the level channels do not couple through the Coriolis term, and in the psi form an
 * accelerometer or a start leaves the attitude alone: the north channel is a pure Schuler pendulum,
 * w^2 = g/R_M (D1b, D3's formula). Reference section 3. Left: the gradient of g along the meridian,
 * f and m of the normal field, a few 1e-3 of (g/R) times the latitude difference of 1e-4 rad, and
 * the chord for the arc: below 1e-5. */
static void on_the_equator_the_north_channel_is_a_schuler_pendulum(void **state)
{
    (void)state;
    static const char text[] =
        "scenario: equator\nruns: 1\n"
        "trajectory: {kind: static, start: {lat: 0 deg, lon: 7 deg, height: 0 m}, for: 5064 s}\n"
        "report: {every: 633 s}\n"
        "imu: {rate: 50 Hz, accel: {model: linear, bias: [50 ug, 0 ug, 0 ug]}, gyro: {model: "
        "linear}}\n"
        "initial: {velocity: [0.1 m/s, 0 m/s, 0 m/s]}\n";
    schuler_scenario *s = mission_text(text);
    mission_trace bias = mission_errors(s, "accel.bias");
    mission_trace velocity = mission_errors(s, "initial.velocity");
    const double w = sqrt(9.78032533590389 / schuler_earth_meridian_radius(0.0));
    const double b_mps2 = 50e-6 * SCHULER_G0_MPS2;
    for (size_t i = 1; i < bias.count; i++) {
        const double t = bias.rows[i].time_s;
        CHECK_NEAR(bias.rows[i].r_n[0], b_mps2 / (w * w) * (1.0 - cos(w * t)),
                   1e-5 * 2.0 * b_mps2 / (w * w));
        CHECK_NEAR(bias.rows[i].v_n[0], b_mps2 / w * sin(w * t), 1e-5 * b_mps2 / w);
        CHECK_NEAR(velocity.rows[i].r_n[0], 0.1 / w * sin(w * t), 1e-5 * 0.1 / w);
    }
    free(bias.rows);
    free(velocity.rows);
    schuler_scenario_free(s);
}

/* With the vertical held to the truth nothing moves along it. */
static void the_held_vertical_channel_stays(void **state)
{
    (void)state;
    schuler_scenario *s =
        at_rest(1, "1 h", "bias: 1 mg", "bias: 0 deg/h", "position: [0 m, 0 m, 10 m]");
    mission_trace t = mission_errors(s, "all");
    /* What a third of a second of 1 mg makes of it: b t^2/2 = 0.5 mm; and the fall of the sphere
     * below a tangent, d^2/2R = 5 m at 8 km. */
    const schuler_error_row *end = &t.rows[t.count - 1];
    const double d2 = end->r_n[0] * end->r_n[0] + end->r_n[1] * end->r_n[1];
    CHECK_NEAR(end->r_n[2], d2 / (2.0 * 6378e3), 1e-3 + 0.01 * d2 / (2.0 * 6378e3));
    free(t.rows);
    schuler_scenario_free(s);
}

/* D11: free height runs away as cosh(t/570 s): 275.8 m after 1 h from 1 m, for 2g/R with R =
 * sqrt(R_M R_P). The ellipsoid's vertical gradient is 2g/R (1 + f + m ...) = 2g/R * 1.0017 and the
 * earth's rotation takes 3 W^2 off: together 0.3 % in kappa^2, so 0.15 % in kappa t = 6.31, 1 % in
 * the growth. */
static void the_free_vertical_channel_runs_away(void **state)
{
    (void)state;
    schuler_scenario *s =
        at_rest(1, "1 h", "bias: 0 ug", "bias: 0 deg/h", "position: [0 m, 0 m, -1 m]");
    s->vertical = SCHULER_VERTICAL_FREE;
    mission_trace t = mission_errors(s, "initial.position");
    CHECK_REL(-t.rows[t.count - 1].r_n[2], 275.794903647839, 0.01);
    free(t.rows);
    schuler_scenario_free(s);
}

typedef struct {
    double sum2[2];
    int count;
} moments;

static schuler_status add_moments(void *user, const char *id, int run,
                                  const schuler_error_row *rows, size_t count)
{
    moments *m = user;
    (void)run;
    if (strcmp(id, "all") != 0) return SCHULER_OK;
    for (int i = 0; i < 2; i++) m->sum2[i] += rows[count - 1].r_n[i] * rows[count - 1].r_n[i];
    m->count++;
    return SCHULER_OK;
}

/* 1000 runs: the sampling error of a sigma is 1/sqrt(2000) = 2.2 %; four of them. The linear
 * covariance and the single-channel closed form (E9, E10, with local radii) differ by the coupling
 * of the earth's rate. */
static void random_walks_spread_as_the_covariance_says(void **state)
{
    (void)state;
    enum { RUNS = 1000 };
    const double lat_rad = SCHULER_PI / 4.0, g_mps2 = 9.80619776937738, t_s = 3600.0; /* D2 */
    const double radius[2] = { schuler_earth_meridian_radius(lat_rad),
                               schuler_earth_transverse_radius(lat_rad) };
    const level_model model = level_at(lat_rad, g_mps2);
    for (int accel = 0; accel < 2; accel++) {
        /* Level axes only: the vertical ones have no first-order effect, or (gyro D) a small one.
         */
        schuler_scenario *s = at_rest(
            RUNS, "1 h",
            accel ? "velocity_random_walk: [0.02 m/s/sqrt(h), 0.02 m/s/sqrt(h), 0 m/s/sqrt(h)]"
                  : "bias: 0 ug",
            accel ? "bias: 0 deg/h"
                  : "angle_random_walk: [0.003 deg/sqrt(h), 0.003 deg/sqrt(h), 0 deg/sqrt(h)]",
            "");
        moments m = { { 0 }, 0 };
        const schuler_run_options options = { .errors = add_moments, .user = &m };
        schuler_result_free(mission_run(s, &options));
        assert_int_equal(m.count, RUNS);

        const double N = accel ? 0.02 / 60.0 : 0.003 * SCHULER_RAD_PER_DEG / 60.0;
        double q[N_STATES] = { 0 }, P[N_STATES][N_STATES];
        q[accel ? 2 : 4] = q[accel ? 3 : 5] = N * N;
        covariance(&model, q, 3600, P);
        for (int axis = 0; axis < 2; axis++) {
            const double sigma = sqrt(m.sum2[axis] / RUNS), sampling = 4.0 / sqrt(2.0 * RUNS);
            CHECK_REL(sigma, sqrt(P[axis][axis]), sampling);
            const double w = sqrt(g_mps2 / radius[axis]), wt = w * t_s;
            const double closed2 =
                accel ? N * N / (w * w) * (t_s / 2.0 - sin(2.0 * wt) / (4.0 * w))
                      : radius[axis] * radius[axis] * N * N *
                            (1.5 * t_s - 2.0 * sin(wt) / w + sin(2.0 * wt) / (4.0 * w));
            CHECK_REL(sigma, sqrt(closed2), sampling);
            print_message("%s %s: sigma %.4f m, covariance %.4f m, closed form %.4f m\n",
                          accel ? "VRW" : "ARW", axis ? "east" : "north", sigma,
                          sqrt(P[axis][axis]), sqrt(closed2));
        }
        schuler_scenario_free(s);
    }
}

/* Linear sources add: with fixed values the joint error is the sum of the single ones. What is left
 * is of second order, (error / earth radius) of the error: 1e-3. */
static void single_errors_add_up_to_the_joint_one(void **state)
{
    (void)state;
    schuler_scenario *s = at_rest(
        1, "1 h", "bias: [20 ug, -30 ug, 10 ug], scale_factor: 50 ppm, misalignment: 5 arcsec",
        "bias: [0.004 deg/h, -0.003 deg/h, 0.005 deg/h], scale_factor: 5 ppm, misalignment: 5 "
        "arcsec",
        "position: [10 m, -20 m, 5 m], velocity: [0.05 m/s, -0.02 m/s, 0.01 m/s], tilt: [5 arcsec, "
        "-4 arcsec], "
        "heading: 1 arcmin");
    static const char *const ids[] = { "accel.bias",         "accel.scale_factor",
                                       "accel.misalignment", "gyro.bias",
                                       "gyro.scale_factor",  "gyro.misalignment",
                                       "initial.position",   "initial.velocity",
                                       "initial.tilt",       "initial.heading" };
    double sum[2] = { 0 }, size_m = 0.0;
    for (size_t i = 0; i < sizeof(ids) / sizeof(ids[0]); i++) {
        mission_trace t = mission_errors(s, ids[i]);
        const schuler_error_row *end = &t.rows[t.count - 1];
        for (int k = 0; k < 2; k++) sum[k] += end->r_n[k];
        size_m += hypot(end->r_n[0], end->r_n[1]);
        free(t.rows);
    }
    mission_trace t = mission_errors(s, "all");
    for (int k = 0; k < 2; k++) CHECK_NEAR(t.rows[t.count - 1].r_n[k], sum[k], 1e-3 * size_m);
    free(t.rows);
    schuler_scenario_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_errors_move_as_the_reference_says),
        cmocka_unit_test(an_error_that_aligned_itself_moves_as_the_reference_says),
        cmocka_unit_test(an_initial_position_error_stays),
        cmocka_unit_test(on_the_equator_the_north_channel_is_a_schuler_pendulum),
        cmocka_unit_test(the_held_vertical_channel_stays),
        cmocka_unit_test(the_free_vertical_channel_runs_away),
        cmocka_unit_test(random_walks_spread_as_the_covariance_says),
        cmocka_unit_test(single_errors_add_up_to_the_joint_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Self-alignment where the plumb line is not the ellipsoid's normal: EGM96 in the world, normal gravity
 * in the navigator. A horizontal disturbance dg is felt as an accelerometer's error -dg, so the attitude
 * found is that of the plumb line: phi_N = -dg_E/g, phi_E = dg_N/g, phi_D = dg_E/g tan L, and this
 * tilt cancels the disturbance where the vehicle stays. Needs the data set; skips without. */
#include "core/earth.h"
#include "core/gravity.h"
#include "mission.h"
#include <math.h>

static const double W = SCHULER_OMEGA_IE_RADPS;
static const double minutes = 10.0;

/* In the Alps; heading north, so that body axes are north, east, down. */
#define PLACE "lat: 45.5 deg, lon: 6 deg, height: 2000 m, heading: 0 deg"
static const schuler_llh place = { 45.5 * SCHULER_RAD_PER_DEG, 6.0 * SCHULER_RAD_PER_DEG, 2000.0 };

/* EGM96 less normal gravity there, north, east, down; and normal gravity. */
static schuler_vec3 disturbance(double *g_mps2)
{
    schuler_field_model *egm96 = NULL, *wgs84 = NULL;
    schuler_error err = { 0 };
    if (schuler_field_open(&egm96, "egm96", &err) != SCHULER_OK) {
        print_message("skipped: %s\n", err.message);
        skip();
    }
    assert_int_equal(schuler_field_open(&wgs84, "wgs84", &err), SCHULER_OK);
    const schuler_vec3 r_e = schuler_ecef_from_llh(place);
    const schuler_vec3 normal_e = schuler_field_gravity(wgs84, r_e);
    const schuler_vec3 dg_e = schuler_vec3_sub(schuler_field_gravity(egm96, r_e), normal_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(place.lat_rad, place.lon_rad);
    *g_mps2 = schuler_vec3_norm(normal_e);
    schuler_field_close(egm96);
    schuler_field_close(wgs84);
    return schuler_mat3_apply_transposed(&C_n_e, dg_e);
}

static mission_trace rest(const char *gravity, const char *accel, const char *initial,
                          const char *id)
{
    char text[1024];
    snprintf(text, sizeof text,
             "scenario: deflection\nruns: 1\nreport: {every: 5 min}\ntruth: {gravity: %s}\n"
             "trajectory: {kind: static, start: {" PLACE "}, for: 30 min}\n"
             "imu: {rate: 32 Hz, accel: {model: linear%s}, gyro: {model: linear}}\n%s",
             gravity, accel, initial);
    schuler_scenario *const s = mission_text(text);
    mission_trace t = mission_errors(s, id);
    schuler_scenario_free(s);
    return t;
}

static double horizontal(const schuler_error_row *row)
{
    return hypot(row->r_n[0], row->r_n[1]);
}

/* The filter's tilt is that of the end of the alignment, its heading that of the middle: the earth turns
 * one into the other by W T/2 = 2.2 %. Second order in the tilt is 4e-5 of it. */
static void the_attitude_found_is_that_of_the_plumb_line(void **state)
{
    (void)state;
    static const char *const methods[] = { "coarse", "fine" };
    double g_mps2;
    const schuler_vec3 dg_n = disturbance(&g_mps2);
    const double north = dg_n.v[0] / g_mps2, east = dg_n.v[1] / g_mps2;
    const double lag = 0.5 * W * minutes * 60.0 * hypot(north, east);
    assert_true(fabs(north) > 5.0 * lag && fabs(east) > 5.0 * lag);
    for (int m = 0; m < 2; m++) {
        char initial[96];
        snprintf(initial, sizeof initial, "initial: {align: {for: %g min, method: %s}}\n", minutes,
                 methods[m]);
        mission_trace t = rest("egm96", "", initial, "gravity.disturbance");
        /* heading north: roll computed less true is -phi_N, pitch -phi_E, heading -phi_D */
        CHECK_NEAR(t.rows[0].roll_rad, east, lag);
        CHECK_NEAR(t.rows[0].pitch_rad, -north, lag);
        CHECK_NEAR(t.rows[0].heading_rad, -east * tan(place.lat_rad), lag);
        free(t.rows);
        /* What knows the disturbance has the attitude, as with perfect sensors in normal gravity. */
        t = rest("egm96", "", initial, "none");
        CHECK_NEAR(t.rows[0].roll_rad, 0.0, 1e-11);
        CHECK_NEAR(t.rows[0].pitch_rad, 0.0, 1e-11);
        CHECK_NEAR(t.rows[0].heading_rad, 0.0, 1e-10);
        free(t.rows);
    }
}

/* Only the turn of the tilt with the earth is left, W sin L phi_E in t: an acceleration dg_N W sin L t east,
 * which swings to a (t - sin(w t)/w)/w^2. The east part leaves the lag of the heading, W T/2 of
 * that, and the tilt found is that of up to 20 s before the end, the filter's memory: t^3/6 begins so much
 * earlier. With exact attitude it is dg (1 - cos(w t))/w^2, thirty times as much. */
static void the_tilt_cancels_the_disturbance_at_rest(void **state)
{
    (void)state;
    double g_mps2;
    const schuler_vec3 dg_n = disturbance(&g_mps2);
    const double level_mps2 = hypot(dg_n.v[0], dg_n.v[1]);
    mission_trace exact = rest("egm96", "", "", "gravity.disturbance");
    mission_trace found =
        rest("egm96", "", "initial: {align: {for: 10 min}}\n", "gravity.disturbance");
    for (size_t i = 1; i < exact.count; i++) {
        const double t_s = exact.rows[i].time_s;
        const double w = sqrt(g_mps2 / 6.38e6); /* an earth radius between the two, to 0.3 % */
        const double swing_m = level_mps2 / (w * w) * (1.0 - cos(w * t_s));
        /* Coriolis and the turn of the plane of the swing: W t of it at most. */
        CHECK_NEAR(horizontal(&exact.rows[i]), swing_m, (W * t_s + 0.003) * swing_m);
        const double per_m = W * sin(place.lat_rad) * (t_s - sin(w * t_s) / w) / (w * w);
        const double left_m = fabs(dg_n.v[0]) * per_m;
        const double lag = 0.5 * W * minutes * 60.0 * level_mps2 / fabs(dg_n.v[0]);
        const double off = W * t_s + lag + 3.0 * 20.0 / t_s;
        CHECK_NEAR(horizontal(&found.rows[i]), left_m, (off + 0.003) * left_m);
    }
    assert_true(horizontal(&found.rows[found.count - 1]) <
                horizontal(&exact.rows[exact.count - 1]) / 30.0);
    free(exact.rows);
    free(found.rows);
}

/* At rest gravity and accelerometers cannot be told apart: the disturbance does from the alignment on what
 * a bias of -dg does. Not the same only in second order: the bias turns with the tilted vehicle, and the vertical
 * part of it is a scale factor of 1e-4 to the level ones. */
static void a_disturbance_is_an_accelerometers_bias(void **state)
{
    (void)state;
    double g_mps2;
    const schuler_vec3 dg_n = disturbance(&g_mps2);
    char bias[160];
    snprintf(bias, sizeof bias, ", bias: [%.17g m/s^2, %.17g m/s^2, %.17g m/s^2]", -dg_n.v[0],
             -dg_n.v[1], -dg_n.v[2]);
    mission_trace gravity =
        rest("egm96", "", "initial: {align: {for: 10 min}}\n", "gravity.disturbance");
    mission_trace sensor = rest("wgs84", bias, "initial: {align: {for: 10 min}}\n", "accel.bias");
    assert_int_equal(gravity.count, sensor.count);
    for (size_t i = 0; i < gravity.count; i++) {
        const schuler_error_row *const a = &gravity.rows[i], *const b = &sensor.rows[i];
        const double tilt = schuler_vec3_norm(dg_n) / g_mps2;
        CHECK_NEAR(a->roll_rad, b->roll_rad, 2.0 * tilt * tilt);
        CHECK_NEAR(a->pitch_rad, b->pitch_rad, 2.0 * tilt * tilt);
        CHECK_NEAR(a->heading_rad, b->heading_rad, 4.0 * tilt * tilt);
        /* a tilt of second order, unsupported */
        const double off_m = g_mps2 * tilt * tilt * a->time_s * a->time_s;
        CHECK_NEAR(a->r_n[0], b->r_n[0], 1e-6 + off_m);
        CHECK_NEAR(a->r_n[1], b->r_n[1], 1e-6 + off_m);
    }
    free(gravity.rows);
    free(sensor.rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_attitude_found_is_that_of_the_plumb_line),
        cmocka_unit_test(the_tilt_cancels_the_disturbance_at_rest),
        cmocka_unit_test(a_disturbance_is_an_accelerometers_bias),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

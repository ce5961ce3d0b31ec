/* SPDX-License-Identifier: MIT */
/* What EGM96 does to a navigator with normal gravity and perfect sensors: random great circles at 10 km,
 * 250 m/s, 10 h, vertical held. Each against the linear equation of its errors, integrated here with
 * GeographicLib's own values; all of them against an independent study of 40 other circles.
 * `test_gravity_drift all` takes 40 too and prints the table. Needs the data set; skips without. */
#include "core/earth.h"
#include "core/gravity.h"
#include "core/random.h"
#include "mission.h"
#include <math.h>

enum { CIRCLES = 40, TIMES = 6, STARTS = 2 };

static const int hours[TIMES] = { 1, 2, 4, 6, 8, 10 };
/* The study's rms radial errors, nmi: attitude exact at the start; level with the plumb line there. */
static const double study_nmi[STARTS][TIMES] = { { 0.15, 0.18, 0.25, 0.28, 0.35, 0.34 },
                                                 { 0.29, 0.24, 0.26, 0.28, 0.39, 0.42 } };
static const char *const rows[STARTS] = { "gravity.disturbance", "all" };
static const double m_per_nmi = 1852.0;
static int circles = 8;

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

/* Level with the plumb line: phi_N = -dg_E/g, phi_E = dg_N/g (test_deflection). */
static schuler_scenario *circle(int i, const schuler_field_model *egm96,
                                const schuler_field_model *wgs84, schuler_vec3 *phi_e)
{
    const schuler_stream stream = { 96, (uint64_t)i, 1, 0, SCHULER_USE_DRAW };
    const schuler_llh p = { asin(schuler_stream_uniform(stream, 0)),
                            SCHULER_PI * schuler_stream_uniform(stream, 1), 10000.0 };
    const double heading_rad = SCHULER_PI * schuler_stream_uniform(stream, 2);
    const schuler_vec3 r_e = schuler_ecef_from_llh(p), normal_e = schuler_field_gravity(wgs84, r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(p.lat_rad, p.lon_rad);
    const schuler_vec3 dg_n = schuler_mat3_apply_transposed(
        &C_n_e, schuler_vec3_sub(schuler_field_gravity(egm96, r_e), normal_e));
    const double g_mps2 = schuler_vec3_norm(normal_e), deg = SCHULER_RAD_PER_DEG;
    const schuler_vec3 phi_n = { { -dg_n.v[1] / g_mps2, dg_n.v[0] / g_mps2, 0.0 } };
    *phi_e = schuler_mat3_apply(&C_n_e, phi_n);
    char text[1024];
    snprintf(text, sizeof text,
             "scenario: great circle\nruns: 1\nreport: {every: 1 h}\ntruth: {gravity: egm96}\n"
             "trajectory:\n  kind: motion\n  for: 10 h\n  geodesic: {speed: 250 m/s}\n"
             "  start: {lat: %.9f deg, lon: %.9f deg, height: 10 km, heading: %.9f deg}\n"
             "imu: {rate: 10 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
             "initial: {tilt: [%.9f urad, %.9f urad]}\n"
             "navigation: {gravity: wgs84, vertical: truth}\n",
             p.lat_rad / deg, p.lon_rad / deg, heading_rad / deg, phi_n.v[0] * 1e6,
             phi_n.v[1] * 1e6);
    return mission_text(text);
}

/* ---- The linear equation ----
 * In earth-fixed axes, gyros exact: r' = v, v' = gamma(r_true + r) - gamma(r_true) - dg - 2 W x v - phi x f,
 * phi fixed in inertial axes. Height is held, so r u = 0 and v u = -r u' for the vertical u, and what is
 * integrated is the rest of v. Runge-Kutta of steps of two minutes: Schuler's
 * swing is exact to 300 (w h)^5/120 = 2e-4. */
enum { EVERY_S = 60, SAMPLES = 36000 / EVERY_S + 1 };

typedef struct {
    schuler_vec3 r_e, v_e;
} errors;

/* What drives it at one instant. */
typedef struct {
    schuler_vec3 r_e, up_e, up_rate_e, driving_e[STARTS];
} instant;

static schuler_vec3 up_at(const schuler_path *path, double t_s)
{
    const schuler_llh p = schuler_llh_from_ecef(schuler_path_at(path, t_s).r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(p.lat_rad, p.lon_rad);
    return (schuler_vec3){ { -C_n_e.m[0][2], -C_n_e.m[1][2], -C_n_e.m[2][2] } };
}

static instant at(const schuler_path *path, double t_s, const schuler_field_model *egm96,
                  const schuler_field_model *wgs84, schuler_vec3 phi0_e)
{
    const schuler_motion m = schuler_path_at(path, t_s);
    const schuler_vec3 W_e = { { 0.0, 0.0, SCHULER_OMEGA_IE_RADPS } };
    const schuler_vec3 g_e = schuler_field_gravity(egm96, m.r_e);
    const schuler_vec3 dg_e = schuler_vec3_sub(g_e, schuler_field_gravity(wgs84, m.r_e));
    const schuler_vec3 f_e = schuler_vec3_sub(
        schuler_vec3_add(m.a_e, schuler_vec3_scale(2.0, schuler_vec3_cross(W_e, m.v_e))), g_e);
    const double turned = SCHULER_OMEGA_IE_RADPS * t_s, c = cos(turned), s = sin(turned);
    const schuler_vec3 phi_e = { { c * phi0_e.v[0] + s * phi0_e.v[1],
                                   -s * phi0_e.v[0] + c * phi0_e.v[1], phi0_e.v[2] } };
    instant i = { .r_e = m.r_e, .up_e = up_at(path, t_s) };
    i.up_rate_e = schuler_vec3_sub(up_at(path, t_s + 0.5), up_at(path, t_s - 0.5));
    i.driving_e[0] = schuler_vec3_scale(-1.0, dg_e);
    i.driving_e[1] = schuler_vec3_sub(i.driving_e[0], schuler_vec3_cross(phi_e, f_e));
    return i;
}

static errors rate(const instant *at, int start, const schuler_gravity_table *table, errors x)
{
    const schuler_vec3 W_e = { { 0.0, 0.0, SCHULER_OMEGA_IE_RADPS } };
    const double up_mps = -schuler_vec3_dot(x.r_e, at->up_rate_e);
    const schuler_vec3 v_e = schuler_vec3_add(x.v_e, schuler_vec3_scale(up_mps, at->up_e));
    const schuler_vec3 gradient_e =
        schuler_vec3_sub(schuler_gravity_at(table, schuler_vec3_add(at->r_e, x.r_e)),
                         schuler_gravity_at(table, at->r_e));
    const schuler_vec3 coriolis_e = schuler_vec3_scale(2.0, schuler_vec3_cross(W_e, v_e));
    const schuler_vec3 turn_e = schuler_vec3_scale(up_mps, at->up_rate_e);
    const schuler_vec3 a_e = schuler_vec3_add(
        schuler_vec3_sub(schuler_vec3_sub(gradient_e, coriolis_e), turn_e), at->driving_e[start]);
    /* With such a vertical part that v stays horizontal. Height is held along the navigator's vertical,
     * u + r/R: of the disturbance's vertical part that leaves a level one, 1e-4 of Schuler's. */
    const double off = schuler_vec3_dot(a_e, at->up_e) + schuler_vec3_dot(x.v_e, at->up_rate_e);
    const schuler_vec3 along_e =
        schuler_vec3_add(at->up_e, schuler_vec3_scale(1.0 / 6.38e6, x.r_e));
    return (errors){ v_e, schuler_vec3_sub(a_e, schuler_vec3_scale(off, along_e)) };
}

static errors moved(errors x, errors rate, double by_s)
{
    return (errors){ schuler_vec3_add(x.r_e, schuler_vec3_scale(by_s, rate.r_e)),
                     schuler_vec3_add(x.v_e, schuler_vec3_scale(by_s, rate.v_e)) };
}

/* Radial errors at the hours, nmi. */
static void integrate(const instant *on, int start, const schuler_gravity_table *table,
                      double r_nmi[TIMES])
{
    const double h_s = 2.0 * EVERY_S;
    errors x = { { { 0.0 } }, { { 0.0 } } };
    int t = 0;
    for (int k = 0; k + 2 < SAMPLES; k += 2) {
        const errors k1 = rate(&on[k], start, table, x);
        const errors k2 = rate(&on[k + 1], start, table, moved(x, k1, h_s / 2.0));
        const errors k3 = rate(&on[k + 1], start, table, moved(x, k2, h_s / 2.0));
        const errors k4 = rate(&on[k + 2], start, table, moved(x, k3, h_s));
        x = moved(moved(x, k1, h_s / 6.0), k2, h_s / 3.0);
        x = moved(moved(x, k3, h_s / 3.0), k4, h_s / 6.0);
        if ((k + 2) * EVERY_S == 3600 * hours[t]) r_nmi[t++] = schuler_vec3_norm(x.r_e) / m_per_nmi;
    }
}

/* ---- The navigator ---- */

typedef struct {
    double r_nmi[STARTS][TIMES], numerical_nmi;
} drift;

static schuler_status take(void *user, const char *id, int run, const schuler_error_row *row,
                           size_t count)
{
    drift *const d = user;
    (void)run;
    for (size_t k = 0; k < count; k++) {
        const double r_nmi = hypot(row[k].r_n[0], row[k].r_n[1]) / m_per_nmi;
        if (strcmp(id, "none") == 0) d->numerical_nmi = fmax(d->numerical_nmi, r_nmi);
        for (int s = 0; s < STARTS; s++)
            for (int t = 0; t < TIMES; t++)
                if (strcmp(id, rows[s]) == 0 && fabs(row[k].time_s - 3600.0 * hours[t]) < 1.0)
                    d->r_nmi[s][t] = r_nmi;
    }
    return SCHULER_OK;
}

/* Both starts of one circle; adds the squares to the sums. What is left of the larger of them: Runge-Kutta
 * 2e-4, Simpson's rule of 30 km on the shortest waves (3e-3 of those, which are a twentieth of the
 * disturbance), errors of second order r/R = 4e-4 where r is largest. */
static void fly(int i, const schuler_field_model *egm96, const schuler_field_model *wgs84,
                const schuler_gravity_table *table, double sum[STARTS][TIMES])
{
    schuler_vec3 phi_e;
    schuler_scenario *const scenario = circle(i, egm96, wgs84, &phi_e);
    instant on[SAMPLES];
    for (int k = 0; k < SAMPLES; k++)
        on[k] = at(&scenario->path, (double)k * EVERY_S, egm96, wgs84, phi_e);
    drift d = { .numerical_nmi = 0.0 };
    const schuler_run_options options = { .threads = 1, .errors = take, .user = &d };
    schuler_result_free(mission_run(scenario, &options));
    schuler_scenario_free(scenario);
    CHECK_NEAR(d.numerical_nmi, 0.0, 1e-6);
    double linear_nmi[STARTS][TIMES], largest_nmi = 0.0;
    for (int s = 0; s < STARTS; s++) integrate(on, s, table, linear_nmi[s]);
    for (int t = 0; t < TIMES; t++) {
        for (int s = 0; s < STARTS; s++) largest_nmi = fmax(largest_nmi, linear_nmi[s][t]);
        for (int s = 0; s < STARTS; s++) {
            CHECK_NEAR(d.r_nmi[s][t], linear_nmi[s][t], 1e-3 * largest_nmi);
            sum[s][t] += d.r_nmi[s][t] * d.r_nmi[s][t];
        }
    }
}

/* Squares of the horizontal disturbance have 2.8 times their mean as standard deviation over the earth
 * (4000 places at 10 km), and so at most have the squares of what they drive. The logarithm of a mean of n
 * then has 2.8/sqrt(n), and that of a rms half of it. Forty circles do not say more. */
static void a_full_field_drifts_as_its_linear_equation_and_a_study_say(void **state)
{
    (void)state;
    schuler_field_model *egm96 = open_field("egm96"), *wgs84 = open_field("wgs84");
    schuler_gravity_table table;
    assert_int_equal(schuler_gravity_fit(&table, wgs84, NULL), SCHULER_OK);
    double sum[STARTS][TIMES] = { { 0 } };
    for (int i = 0; i < circles; i++) fly(i, egm96, wgs84, &table, sum);
    schuler_field_close(egm96);
    schuler_field_close(wgs84);
    const double sigma = 0.5 * 2.8 * sqrt(1.0 / circles + 1.0 / CIRCLES);
    for (int s = 0; s < STARTS; s++) {
        print_message("%-20s rms (study), nmi, %d circles:", rows[s], circles);
        for (int t = 0; t < TIMES; t++) {
            const double rms_nmi = sqrt(sum[s][t] / circles);
            print_message("  %d h %.2f (%.2f)", hours[t], rms_nmi, study_nmi[s][t]);
            CHECK_NEAR(log(rms_nmi / study_nmi[s][t]), 0.0, 3.0 * sigma);
        }
        print_message("\n");
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "all") == 0) circles = CIRCLES;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_full_field_drifts_as_its_linear_equation_and_a_study_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

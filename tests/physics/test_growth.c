/* SPDX-License-Identifier: MIT */
/* What `explain` says of growth at rest, against published numbers and against the engine. */
#include "core/earth.h"
#include "mission.h"
#include "scenarios/growth.h"
#include "scenarios/sources.h"
#include "sensors/chain.h"

#define UG        (1e-6 * SCHULER_G0_MPS2)
#define DEG_PER_H (SCHULER_RAD_PER_DEG / 3600.0)

static const schuler_mat3 level_north = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };

/* The sphere of the reference's closed forms, 45 deg north. */
static schuler_rest on_the_sphere(void)
{
    return (schuler_rest){ .lat_rad = SCHULER_PI / 4.0,
                           .g_mps2 = SCHULER_G0_MPS2,
                           .radius_m = { 6371000.0, 6371000.0 },
                           .C_b_n = level_north };
}

static schuler_growth along(schuler_growth_entry entry, schuler_growth_process process, int axis)
{
    schuler_growth g = { .entry = entry, .process = process, .components = 1 };
    g.axis_n[0][axis] = 1.0;
    return g;
}

static double after(schuler_growth_law law, schuler_growth g, const schuler_rest *rest, int axis,
                    double t_s)
{
    double r_m[2];
    schuler_growth_response(&g, rest, law, 0, t_s, r_m);
    return r_m[axis];
}

/* Rows E3 to E8 of the error-propagation reference: closed forms evaluated with 40 digits; 1e-12. Rows
 * E9 and E10 hold a quadrature here, whose error is below (w dt)^4/180 with w dt <= 0.02: 1e-9. */
static void closed_forms_give_the_published_numbers(void **state)
{
    (void)state;
    enum { N, E, D };
    const schuler_rest rest = on_the_sphere();
    const schuler_growth_law law = SCHULER_GROWTH_PENDULUM;
    const schuler_growth bias = along(SCHULER_ENTERS_ACCEL, SCHULER_GROWS_CONSTANT, N),
                         drift = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_CONSTANT, N),
                         azimuth = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_CONSTANT, D),
                         tilt = along(SCHULER_ENTERS_TILT, SCHULER_GROWS_CONSTANT, E),
                         velocity = along(SCHULER_ENTERS_VELOCITY, SCHULER_GROWS_CONSTANT, N);
    const double period_s = 5064.34557735239;
    CHECK_REL(50.0 * UG * after(law, bias, &rest, N, 3600.0), 396.117395501158, 1e-12);
    CHECK_REL(50.0 * UG * after(law, bias, &rest, N, period_s / 2.0), 637.1, 1e-12);
    const double hour_nmi = 0.01 * DEG_PER_H * after(law, drift, &rest, E, 3600.0) / SCHULER_NMI_M;
    CHECK_REL(hour_nmi, 0.730784923527925, 1e-12);
    CHECK_REL(0.01 * DEG_PER_H * after(law, drift, &rest, E, 7200.0) / SCHULER_NMI_M,
              1.13731352645359, 1e-12);
    CHECK_REL(0.1e-3 * after(law, tilt, &rest, N, period_s / 2.0), 1274.2, 1e-12);
    CHECK_REL(0.1 * after(law, velocity, &rest, N, period_s / 4.0), 80.6015632161212, 1e-12);
    const schuler_growth heading = schuler_growth_of_start(SCHULER_ENTERS_HEADING);
    CHECK_REL(-1e-3 * after(law, heading, &rest, N, 3600.0) / SCHULER_NMI_M, 0.777236564494498,
              1e-12);
    CHECK_REL(-0.01 * DEG_PER_H * after(law, azimuth, &rest, N, 3600.0) / SCHULER_NMI_M,
              0.0487783775843817, 1e-12);

    const schuler_growth arw = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_WHITE, N),
                         vrw = along(SCHULER_ENTERS_ACCEL, SCHULER_GROWS_WHITE, N);
    const double N_gyro = 0.003 * SCHULER_RAD_PER_DEG / 60.0;
    CHECK_REL(N_gyro * after(law, arw, &rest, E, 3600.0), 467.107679689737, 1e-9);
    CHECK_REL(N_gyro * after(law, arw, &rest, E, 36000.0), 1282.13642931141, 1e-9);
    CHECK_REL(0.02 / 60.0 * after(law, vrw, &rest, N, 3600.0), 11.0933207885881, 1e-9);
}

/* Rows E11: the level model at 45 deg, after 1 h and 4 h. Printed with 12 digits; the gravity of the
 * reference has 15, ours is of the same ellipsoid: 1e-9 of the displacement. */
static void the_model_with_earth_rate_gives_the_published_numbers(void **state)
{
    (void)state;
    const struct {
        schuler_growth_entry entry;
        int axis;
        double size, expected_m[2][2];
    } rows[] = {
        { SCHULER_ENTERS_ACCEL,
          0,
          50.0 * UG,
          { { 395.409651994, 1.62510975406 }, { 191.319607112, -128.419944581 } } },
        { SCHULER_ENTERS_ACCEL,
          1,
          50.0 * UG,
          { { -1.62510975406, 399.053870678 }, { 128.419944581, 199.207860465 } } },
        { SCHULER_ENTERS_GYRO,
          0,
          0.01 * DEG_PER_H,
          { { -160.046716573, 1344.27527409 }, { -1650.16940984, 4224.59097452 } } },
        { SCHULER_ENTERS_GYRO,
          1,
          0.01 * DEG_PER_H,
          { { -1335.75839041, -160.041534204 }, { -3826.43376268, -1650.03392818 } } },
        { SCHULER_ENTERS_GYRO,
          2,
          0.01 * DEG_PER_H,
          { { -89.5966272896, -8.64274374391 }, { -1497.67357981, -398.637005662 } } },
        { SCHULER_ENTERS_TILT,
          0,
          0.1e-3,
          { { 145.316528433, -781.049494821 }, { 150.137689473, -222.905673291 } } },
        { SCHULER_ENTERS_TILT,
          1,
          0.1e-3,
          { { 764.231667305, 145.303142409 }, { 47.8283086932, 150.086660327 } } },
        { SCHULER_ENTERS_TILT, /* psi_D, as the reference has it */
          2,
          1e-3,
          { { 1420.66458807, 170.214420435 }, { 4069.65734544, 1754.91674821 } } },
        { SCHULER_ENTERS_VELOCITY,
          0,
          0.1,
          { { -76.8428445709, -14.4287362493 }, { -48.6030924931, -45.2097475607 } } },
    };
    schuler_rest rest;
    assert_int_equal(schuler_rest_make(&rest, SCHULER_PI / 4.0, 0.0, &level_north, NULL),
                     SCHULER_OK);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        for (int k = 0; k < 2; k++) {
            const schuler_growth g = along(rows[i].entry, SCHULER_GROWS_CONSTANT, rows[i].axis);
            const double *const e = rows[i].expected_m[k], t_s = k ? 14400.0 : 3600.0;
            double r_m[2];
            schuler_growth_response(&g, &rest, SCHULER_GROWTH_EARTH, 0, t_s, r_m);
            for (int n = 0; n < 2; n++)
                CHECK_NEAR(rows[i].size * r_m[n], e[n], 1e-9 * hypot(e[0], e[1]));
        }
}

/* The first law is the first term of a series in (w t)^2 whose next one is at most a twelfth of it
 * (x(2): t^4/24 against t^2/2); w t = 0.0744 after a minute. */
static void in_the_first_minute_the_pendulum_has_not_begun_to_swing(void **state)
{
    (void)state;
    const schuler_rest rest = on_the_sphere();
    const double wt2 = 3600.0 * SCHULER_G0_MPS2 / 6371000.0;
    for (int process = SCHULER_GROWS_CONSTANT; process <= SCHULER_GROWS_SINUSOID; process++)
        for (int gyro = 0; gyro < 2; gyro++) {
            schuler_growth g = along(gyro ? SCHULER_ENTERS_GYRO : SCHULER_ENTERS_ACCEL,
                                     (schuler_growth_process)process, 0);
            g.time_s[0] = 20.0;
            g.longest_s = 1e5;
            g.dt_s = 0.01;
            g.frequency_hz[0] = 0.01;
            const double first = after(SCHULER_GROWTH_FIRST, g, &rest, gyro, 60.0);
            CHECK_REL(after(SCHULER_GROWTH_PENDULUM, g, &rest, gyro, 60.0), first, wt2 / 6.0);
            assert_true(first > 0.0);
        }
    const schuler_growth bias = along(SCHULER_ENTERS_ACCEL, SCHULER_GROWS_CONSTANT, 0);
    CHECK_REL(after(SCHULER_GROWTH_FIRST, bias, &rest, 0, 60.0), 1800.0, 1e-12);
}

/* Limits of correlated noise and of a sinusoid that have closed forms of their own: far shorter than
 * the pendulum's period it is white, N^2 = 2 sigma^2 T (second order: 4 sigma^2 T), T w = 1e-4; far
 * longer a constant drawn once, t/T = 1e-4; resonance is A t/(2 w) for t w >> 1, the rest 1/(w t). */
static void correlated_noise_has_the_right_limits(void **state)
{
    (void)state;
    const schuler_rest rest = on_the_sphere();
    const schuler_growth_law law = SCHULER_GROWTH_PENDULUM;
    const schuler_growth white = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_WHITE, 0),
                         constant = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_CONSTANT, 0);
    schuler_growth g = along(SCHULER_ENTERS_GYRO, SCHULER_GROWS_GAUSS_MARKOV, 0);
    const double w = sqrt(SCHULER_G0_MPS2 / 6371000.0), t_s = 36000.0;
    for (int second = 0; second < 2; second++) {
        g.process = second ? SCHULER_GROWS_GAUSS_MARKOV_2 : SCHULER_GROWS_GAUSS_MARKOV;
        g.time_s[0] = 1e-4 / w;
        CHECK_REL(after(law, g, &rest, 1, t_s),
                  sqrt((second ? 4.0 : 2.0) * g.time_s[0]) * after(law, white, &rest, 1, t_s),
                  1e-3);
        g.time_s[0] = 1e4 * t_s;
        CHECK_REL(after(law, g, &rest, 1, t_s), after(law, constant, &rest, 1, t_s), 1e-3);
    }
    schuler_growth tone = along(SCHULER_ENTERS_ACCEL, SCHULER_GROWS_SINUSOID, 0);
    tone.frequency_hz[0] = w / (2.0 * SCHULER_PI);
    const double long_s = 3.6e6;
    CHECK_REL(after(law, tone, &rest, 0, long_s), long_s / (2.0 * w) / sqrt(2.0),
              1.0 / (w * long_s));
}

static const char mission[] =
    "scenario: growth\nseed: 11\nruns: %d\n"
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 200 m, roll: %s, pitch: "
    "%s,"
    " heading: 30 deg}, for: 1 h}\n"
    "report: {every: 1 h}\n"
    "imu: {rate: 5 Hz, accel: {model: %s%s}, gyro: {model: %s%s}}\ninitial: {%s}\n";

static schuler_scenario *mission_of(int runs, const char *lean, const char *models[2],
                                    const char *keys[2], const char *initial)
{
    char text[2048];
    snprintf(text, sizeof text, mission, runs, lean, lean, models[0], keys[0], models[1], keys[1],
             initial);
    return mission_text(text);
}

/* Level, an hour. Left out of the closed form is the earth's rate: in that time it turns the error of
 * attitude by W t = 0.26 rad, out of the channel that it was in, which loses at most 1 - cos(W t) =
 * 3.4 %; what comes into the other channel is at right angles, and is squared again. With the earth's
 * rate, what is left is of second order in the error, the same 0.1 % as in test_error_propagation.c.
 * Four sampling errors for what is drawn. */
static void at_rest_the_engine_agrees(void **state)
{
    (void)state;
    enum { RUNS = 300 };
    static const struct {
        const char *id, *accel, *gyro, *initial;
    } rows[] = {
        { "accel.bias", ", bias: [50 ug, 30 ug, 20 ug]", "", "" },
        { "gyro.bias", "", ", bias: [0.01 deg/h, 0 deg/h, 0 deg/h]", "" },
        { "gyro.bias", "", ", bias: [0 deg/h, 0.01 deg/h, 0 deg/h]", "" },
        { "gyro.bias", "", ", bias: [0 deg/h, 0 deg/h, 0.01 deg/h]", "" },
        { "gyro.bias", "", ", bias: {normal: 0.01 deg/h}", "" },
        { "gyro.bias_ramp", "", ", bias_ramp: [0.01 deg/h/h, 0 deg/h/h, 0 deg/h/h]", "" },
        { "initial.tilt", "", "", "tilt: [0.1 mrad, 0 mrad]" },
        { "initial.tilt", "", "", "tilt: [0 mrad, 0.1 mrad]" },
        { "initial.heading", "", "", "heading: 1 mrad" },
        { "initial.velocity", "", "", "velocity: [0.1 m/s, -0.05 m/s, 0 m/s]" },
        { "accel.velocity_random_walk", ", velocity_random_walk: 0.02 m/s/sqrt(h)", "", "" },
        { "gyro.angle_random_walk", "", ", angle_random_walk: 0.003 deg/sqrt(h)", "" },
        { "gyro.bias_instability", "", ", bias_instability: 0.01 deg/h", "" },
        { "gyro.bias_random_walk", "", ", bias_random_walk: 0.01 deg/h/sqrt(h)", "" },
        { "accel.bias_random_walk", ", bias_random_walk: 20 ug/sqrt(h)", "", "" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const char *models[] = { "linear", "linear" }, *keys[] = { rows[i].accel, rows[i].gyro };
        schuler_scenario *s = mission_of(RUNS, "0 deg", models, keys, rows[i].initial);
        error_source sources[SOURCES_MAX];
        assert_int_equal(schuler_sources_list(s, sources), 1);
        schuler_rest rest;
        assert_int_equal(schuler_rest_of(&rest, s, NULL), SCHULER_OK);
        schuler_growth g;
        const error_source *const source = &sources[0];
        if (source->kind == SOURCE_SENSOR)
            assert_true(schuler_growth_of_param(
                s->imu.triad[source->instrument].params, source->param,
                s->imu.triad[source->instrument].values, source->instrument, &rest, 0.2, &g));
        else
            g = schuler_growth_of_start(source->kind == SOURCE_TILT      ? SCHULER_ENTERS_TILT
                                        : source->kind == SOURCE_HEADING ? SCHULER_ENTERS_HEADING
                                                                         : SCHULER_ENTERS_VELOCITY);
        const schuler_run_options options = { .threads = 1 };
        schuler_result *r = mission_run(s, &options);
        const schuler_budget_row *const row = mission_row(r, rows[i].id);
        const double pendulum_m =
            schuler_growth_rms(&g, &rest, SCHULER_GROWTH_PENDULUM, source->value, 3600.0);
        const double earth_m =
            schuler_growth_rms(&g, &rest, SCHULER_GROWTH_EARTH, source->value, 3600.0);
        /* One axis alone at worst: the sampling error of a sigma. */
        const double sampling = row->drawn ? 4.0 / sqrt(2.0 * RUNS) : 0.0;
        print_message("%-28s engine %9.3f m, pendulum %9.3f m, with earth rate %9.3f m\n",
                      rows[i].id, row->rms_end_m, pendulum_m, earth_m);
        CHECK_REL(row->rms_end_m, earth_m, 1e-3 + sampling);
        CHECK_REL(earth_m, pendulum_m, 0.034);
        schuler_result_free(r);
        schuler_scenario_free(s);
    }
}

/* An example as it would stand in a scenario; times and frequencies that an hour is long enough for. */
static void keys_of(const schuler_param *params, int index, char text[200])
{
    const schuler_param *const p = &params[index];
    snprintf(text, 200, ", %s: %s%s%s%s", p->key, p->example, p->companion ? ", " : "",
             p->companion ? p->companion : "",
             !p->companion                                     ? ""
             : strcmp(p->companion, "sinusoid_frequency") == 0 ? ": 0.001 Hz"
                                                               : ": 500 s");
}

static int check_source(const schuler_sensor_model *model, schuler_instrument instrument, int index)
{
    enum { RUNS = 150 };
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    schuler_chain_params(model, instrument, params);
    if (params[index].number == 0) return 0;
    const double lean_rad = 20.0 * SCHULER_RAD_PER_DEG;
    const schuler_mat3 C_b_n =
        schuler_mat3_from_euler(lean_rad, lean_rad, 30.0 * SCHULER_RAD_PER_DEG);
    schuler_rest rest;
    assert_int_equal(schuler_rest_make(&rest, SCHULER_PI / 4.0, 200.0, &C_b_n, NULL), SCHULER_OK);
    schuler_growth g;
    if (!schuler_growth_of_param(params, index, NULL, instrument, &rest, 0.2, &g)) return 0;

    char text[200];
    keys_of(params, index, text);
    const char *models[] = { "linear", "linear" }, *keys[] = { "", "" };
    models[instrument] = model->name;
    keys[instrument] = text;
    schuler_scenario *s = mission_of(RUNS, "20 deg", models, keys, "");
    const schuler_triad *const triad = &s->imu.triad[instrument];
    schuler_value *const value = &s->imu.triad[instrument].values[index];
    assert_true(schuler_growth_of_param(params, index, triad->values, instrument, &rest, 0.2, &g));
    const double example_m = schuler_growth_rms(&g, &rest, SCHULER_GROWTH_EARTH, value, 3600.0);
    for (int c = 0; c < params[index].components && example_m > 1000.0; c++) {
        value->a[c] *= 1000.0 / example_m;
        value->b[c] *= 1000.0 / example_m;
    }
    const double expected_m = fmin(example_m, 1000.0);
    char id[96];
    snprintf(id, sizeof id, "%s.%s", schuler_instrument_name(instrument), params[index].key);
    const schuler_run_options options = { .threads = 1 };
    schuler_result *r = mission_run(s, &options);
    const schuler_budget_row *const row = mission_row(r, id);
    print_message("%-13s %-28s engine %9.3f m, explained %9.3f m\n", model->name, id,
                  row->rms_end_m, expected_m);
    /* Of the axes one by one: fixed values of all three may cancel. */
    schuler_value apart = *value;
    if (apart.draw == SCHULER_DRAW_FIXED) apart.draw = SCHULER_DRAW_NORMAL;
    CHECK_NEAR(row->rms_end_m, expected_m,
               (1e-3 + (row->drawn ? 4.0 / sqrt(2.0 * RUNS) : 0.0)) *
                   schuler_growth_rms(&g, &rest, SCHULER_GROWTH_EARTH, &apart, 3600.0));
    schuler_result_free(r);
    schuler_scenario_free(s);
    return 1;
}

/* Whatever of any model and stage is said to have a closed form, leaning by 20 deg so that all axes
 * take part, its example brought down to a kilometre so that what is left is of second order again. */
static void every_source_with_a_closed_form_does_what_it_says(void **state)
{
    (void)state;
    const schuler_sensor_model *const *models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    int checked = 0;
    for (int m = 0; models[m]; m++)
        for (int k = 0; k < SCHULER_INSTRUMENTS; k++) {
            const schuler_instrument instrument = (schuler_instrument)k;
            if (!models[m]->params[k]) continue;
            schuler_param params[SCHULER_PARAMS_MAX + 1];
            const int count = schuler_chain_params(models[m], instrument, params);
            int own = 0;
            while (models[m]->params[k][own].key) own++;
            /* The stages are the same after every model. */
            for (int i = 0; i < (m == 0 ? count : own); i++)
                checked += check_source(models[m], instrument, i);
        }
    assert_true(checked > 40);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms_give_the_published_numbers),
        cmocka_unit_test(the_model_with_earth_rate_gives_the_published_numbers),
        cmocka_unit_test(in_the_first_minute_the_pendulum_has_not_begun_to_swing),
        cmocka_unit_test(correlated_noise_has_the_right_limits),
        cmocka_unit_test(at_rest_the_engine_agrees),
        cmocka_unit_test(every_source_with_a_closed_form_does_what_it_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

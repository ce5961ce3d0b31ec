/* SPDX-License-Identifier: MIT */
/* What a good scenario file turns into. */
#include "scenario_text.h"

static const double deg = 3.14159265358979323846 / 180.0, g = 9.80665;

/* The file that the interface description shows, with the trajectory kept short. */
static const char whole[] =
    "scenario: One hour north-east at 45 N\n"
    "seed: 42\n"
    "runs: 100\n"
    "truth:\n"
    "  gravity: grs80\n"
    "trajectory:\n"
    "  kind: segments\n"
    "  start: {lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 0 m/s}\n"
    "  segments:\n"
    "    - hold:       {for: 10 min}\n"
    "    - accelerate: {to: 100 m/s, at: 2 m/s^2}\n"
    "    - climb:      {to: 2000 m, at: 10 m/s}\n"
    "    - turn:       {by: 90 deg, bank: 25 deg}\n"
    "    - cruise:     {for: 90 min}\n"
    "imu:\n"
    "  use: hg9900\n"
    "  rate: 200 Hz\n"
    "  accel:\n"
    "    bias: 30 ug\n"
    "    velocity_random_walk: 0.003 m/s/sqrt(h)\n"
    "  gyro:\n"
    "    model: linear\n"
    "    bias: [0.003 deg/h, 0 deg/h, 0 deg/h]\n"
    "initial:\n"
    "  position: {normal: 10 m}\n"
    "  velocity: [0.1 m/s, 0 m/s, 0 m/s]\n"
    "  tilt: {normal: 10 arcsec}\n"
    "  heading: {uniform: 1 arcmin}\n"
    "navigation:\n"
    "  frame: ecef\n"
    "  gravity: wgs84\n"
    "  vertical: free\n"
    "  coning: previous\n"
    "  samples_per_update: 8\n"
    "errors: {without: [gyro.misalignment, initial]}\n"
    "requirement: {drift: 1 nmi/h, statistic: R95}\n"
    "report: {every: 15 s}\n";

static void every_key_arrives_in_si(void **state)
{
    (void)state;
    loaded l;
    load_good(&l, whole, NULL);
    const schuler_scenario *s = l.s;
    assert_string_equal(s->name, "One hour north-east at 45 N");
    assert_string_equal(s->file, l.path);
    assert_int_equal(s->seed, 42);
    assert_int_equal(s->runs, 100);
    assert_string_equal(s->truth_gravity, "grs80");
    assert_string_equal(s->nav_gravity, "wgs84");
    assert_string_equal(s->trajectory->name, "segments");
    assert_true(s->path.count > 0);
    assert_true(s->path.duration_s > 6000.0);
    assert_string_equal(s->imu.name, "hg9900");
    assert_string_equal(s->imu.title, "Honeywell HG9900 (with changes)");
    CHECK_NEAR(s->imu.rate_hz, 200.0, 0.0);
    const schuler_value *bias = value_of(&s->imu, SCHULER_ACCEL, "bias");
    assert_int_equal(bias->draw, SCHULER_DRAW_FIXED);
    CHECK_REL(bias->a[2], 30e-6 * g, 1e-15);
    assert_string_equal(bias->text, "30 ug");
    assert_string_equal(bias->place.file, l.path);
    CHECK_REL(value_of(&s->imu, SCHULER_ACCEL, "velocity_random_walk")->a[1], 0.003 / 60, 1e-15);
    /* Untouched values of the part stay. */
    CHECK_REL(value_of(&s->imu, SCHULER_ACCEL, "scale_factor")->a[0], 100e-6, 1e-15);
    CHECK_REL(value_of(&s->imu, SCHULER_GYRO, "bias")->a[0], 0.003 * deg / 3600, 1e-15);
    CHECK_NEAR(value_of(&s->imu, SCHULER_GYRO, "bias")->a[1], 0.0, 0.0);
    CHECK_REL(value_of(&s->imu, SCHULER_GYRO, "angle_random_walk")->a[0], 0.002 * deg / 60, 1e-15);
    assert_int_equal(s->position.draw, SCHULER_DRAW_NORMAL);
    CHECK_NEAR(s->position.a[2], 10.0, 0.0);
    CHECK_NEAR(s->velocity.a[0], 0.1, 0.0);
    CHECK_REL(s->tilt.a[1], 10 * deg / 3600, 1e-15);
    CHECK_REL(s->heading.b[0], deg / 60, 1e-15);
    CHECK_REL(s->heading.a[0], -deg / 60, 1e-15);
    assert_int_equal(s->vertical, SCHULER_VERTICAL_FREE);
    assert_int_equal(s->order, 2);
    assert_int_equal(s->samples_per_update, 8);
    assert_int_equal(s->without.count, 2);
    assert_string_equal(s->without.items[1], "initial");
    assert_true(s->requirement.given);
    CHECK_REL(s->requirement.drift_mps, 1852.0 / 3600, 1e-15);
    assert_int_equal(s->requirement.statistic, SCHULER_STAT_R95);
    CHECK_NEAR(s->report_s, 15.0, 0.0);
    assert_int_equal(l.d.kept, 0);
    unload(&l);
}

static void defaults_are_filled_in(void **state)
{
    (void)state;
    loaded l;
    load_good(&l, "scenario: x\n" TRAJECTORY "imu: {use: hg9900}\n", NULL);
    const schuler_scenario *s = l.s;
    assert_int_equal(s->seed, 1);
    assert_int_equal(s->runs, 100);
    assert_string_equal(s->truth_gravity, "wgs84");
    assert_string_equal(s->nav_gravity, "wgs84");
    assert_int_equal(s->frame, 0);
    assert_int_equal(s->vertical, SCHULER_VERTICAL_TRUTH);
    assert_int_equal(s->order, 4);
    assert_int_equal(s->samples_per_update, 1);
    assert_false(s->position.given || s->velocity.given || s->tilt.given || s->heading.given);
    assert_true(schuler_value_is_zero(&s->position, 3));
    assert_int_equal(s->only.count + s->without.count, 0);
    assert_false(s->requirement.given);
    assert_string_equal(s->imu.title, "Honeywell HG9900");
    CHECK_NEAR(s->imu.rate_hz, 100.0, 0.0);
    unload(&l);
}

/* At most 720 reports, round, and not closer than 10 s unless asked for. */
static void the_report_interval_follows_the_duration(void **state)
{
    (void)state;
    static const struct {
        const char *duration;
        double every_s;
    } table[] = { { "5 s", 5 },    { "1 h", 10 },   { "2 h", 10 },  { "7201 s", 20 },
                  { "4 h", 20 },   { "10 h", 60 },  { "12 h", 60 }, { "24 h", 120 },
                  { "50 h", 300 }, { "100 h", 600 } };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        char text[300];
        snprintf(
            text, sizeof text,
            "scenario: x\ntrajectory: {kind: static, start: {lat: 1 deg, lon: 7 deg, height: 0 "
            "m}, for: %s}\nimu: {use: ln200}\n",
            table[i].duration);
        loaded l;
        load_good(&l, text, NULL);
        CHECK_NEAR(l.s->report_s, table[i].every_s, 0.0);
        unload(&l);
    }
}

/* The digest by sha256sum of coreutils 9.1. */
static void the_hash_is_of_the_file_as_it_is(void **state)
{
    (void)state;
    static const char text[] = "scenario: x\n" TRAJECTORY "imu: {use: hg9900}\n";
    const char *const set[] = { "seed=7" };
    const schuler_overrides o = { .set = set, .count_set = 1 };
    loaded l;
    load_good(&l, text, &o);
    assert_int_equal(l.s->seed, 7);
    assert_string_equal(l.s->sha256,
                        "ff2ba9cb91a39b7c78a25f54e777e7415ab2952cd2b42fffd9e1e125088b12d9");
    unload(&l);
}

static void imu_without_a_part_is_what_it_says(void **state)
{
    (void)state;
    loaded l;
    load_good(&l,
              "scenario: x\n" TRAJECTORY "imu:\n  accel: {model: linear}\n  gyro: {model: linear, "
              "gauss_markov: 1 deg/h, gauss_markov_time: 5 min}\n",
              NULL);
    assert_string_equal(l.s->imu.name, "custom");
    CHECK_NEAR(l.s->imu.rate_hz, 100.0, 0.0);
    const schuler_triad *accel = &l.s->imu.triad[SCHULER_ACCEL];
    for (int i = 0; accel->params[i].key; i++) {
        const schuler_param *p = &accel->params[i];
        assert_false(accel->values[i].given);
        /* A parameter that is no source has its default, a source is off. */
        CHECK_NEAR(accel->values[i].a[0], p->number == 0 ? p->def : 0.0, 0.0);
    }
    CHECK_NEAR(value_of(&l.s->imu, SCHULER_GYRO, "gauss_markov_time")->a[2], 300.0, 0.0);
    unload(&l);
}

static void a_density_becomes_a_random_walk(void **state)
{
    (void)state;
    static const struct {
        const char *sided;
        double factor;
    } table[] = { { "two", 1.0 }, { "one", 0.70710678118654752440 } };
    for (int i = 0; i < 2; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "scenario: x\n" TRAJECTORY "imu:\n  accel: {model: linear, noise_density: 10 "
                 "ug/sqrt(Hz), sided: %s}\n  gyro: {model: linear, noise_density: [1 deg/h/rtHz, 2 "
                 "deg/h/rtHz, 3 deg/h/rtHz], sided: %s}\n",
                 table[i].sided, table[i].sided);
        loaded l;
        load_good(&l, text, NULL);
        const schuler_value *accel = value_of(&l.s->imu, SCHULER_ACCEL, "velocity_random_walk");
        CHECK_REL(accel->a[0], 9.80665e-5 * table[i].factor, 1e-15);
        assert_true(accel->given);
        char spelled[60];
        snprintf(spelled, sizeof spelled, "10 ug/sqrt(Hz) %s-sided", table[i].sided);
        assert_string_equal(accel->text, spelled);
        /* (deg/h)/sqrt(Hz) is 1/60 deg/sqrt(h): stochastic-error reference, section 1. */
        CHECK_REL(value_of(&l.s->imu, SCHULER_GYRO, "angle_random_walk")->a[2],
                  3 * deg / 3600 * table[i].factor, 1e-15);
        unload(&l);
    }
}

static void a_part_can_be_a_file_beside_the_scenario(void **state)
{
    (void)state;
    static const char part[] = "sensor: mine\ntitle: My own\nrate: 400 Hz\n"
                               "accel: {model: linear, bias: 1 mg}\ngyro: {model: linear}\n";
    static const char text[] = "scenario: x\n" TRAJECTORY "imu: {use: mine.yaml}\n";
    loaded l;
    make_folder(&l);
    write_file(l.dir, "s.yaml", text, strlen(text));
    write_file(l.dir, "mine.yaml", part, strlen(part));
    l.rc = schuler_scenario_load(&l.s, l.path, NULL, &l.d);
    if (l.rc != SCHULER_OK) fail_msg("%s", l.d.items[0].message);
    assert_string_equal(l.s->imu.name, "mine.yaml");
    assert_string_equal(l.s->imu.title, "My own");
    CHECK_NEAR(l.s->imu.rate_hz, 400.0, 0.0);
    CHECK_REL(value_of(&l.s->imu, SCHULER_ACCEL, "bias")->a[0], 1e-3 * g, 1e-15);
    char path[80];
    snprintf(path, sizeof path, "%s/mine.yaml", l.dir);
    unlink(path);
    unload(&l);
}

static void overrides_replace_what_the_file_says(void **state)
{
    (void)state;
    static const char *const set[] = { "imu.gyro.bias={normal: 7 deg/h}",
                                       "trajectory.segments.0.hold.for=20 min",
                                       "initial.heading=2 mrad", "scenario=other name",
                                       "imu.rate=50 Hz" };
    const schuler_overrides o = { .set = set,
                                  .count_set = 5,
                                  .imu = "ln200",
                                  .only = "gyro , accel.bias,",
                                  .without = "gyro.misalignment",
                                  .has_seed = 1,
                                  .seed = INT64_MAX,
                                  .has_runs = 1,
                                  .runs = 3 };
    loaded l, plain;
    load_good(&plain, whole, NULL);
    load_good(&l, whole, &o);
    const schuler_scenario *s = l.s;
    assert_string_equal(s->name, "other name");
    assert_int_equal(s->seed, INT64_MAX);
    assert_int_equal(s->runs, 3);
    assert_string_equal(s->imu.name, "ln200");
    CHECK_NEAR(s->imu.rate_hz, 50.0, 0.0);
    CHECK_REL(value_of(&s->imu, SCHULER_GYRO, "bias")->a[0], 7 * deg / 3600, 1e-15);
    /* The file's own changes of the other part are gone: this is the ln200's bias. */
    CHECK_REL(value_of(&s->imu, SCHULER_ACCEL, "bias")->a[0], 0.2e-3 * g, 1e-15);
    CHECK_NEAR(s->heading.a[0], 2e-3, 0.0);
    /* Times are kept as whole ticks of 1/10^6 s or finer. */
    CHECK_NEAR(s->path.duration_s - plain.s->path.duration_s, 600.0, 1e-5);
    assert_int_equal(s->only.count, 2);
    assert_string_equal(s->only.items[0], "gyro");
    assert_string_equal(s->only.items[1], "accel.bias");
    assert_int_equal(s->without.count, 1);
    assert_string_equal(s->without.items[0], "gyro.misalignment");
    unload(&l);
    unload(&plain);

    const schuler_overrides only_imu = { .imu = "stim300" };
    load_good(&l, whole, &only_imu);
    assert_string_equal(l.s->imu.title, "Sensonor STIM300 (10 g)");
    CHECK_NEAR(l.s->imu.rate_hz, 200.0, 0.0); /* of the mission, not of the part */
    unload(&l);
}

static void doubtful_values_are_warned_of(void **state)
{
    (void)state;
    loaded l;
    load_good(
        &l,
        "scenario: x\ntrajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 "
        "m}, for: 1 h}\nimu:\n  use: hg9900\n  gyro: {bias: 10 deg/h}\nrequirement: {drift: 1 "
        "nmi/h, statistic: CEP}\n",
        NULL);
    assert_int_equal(l.d.warnings, 2);
    assert_int_equal(l.d.errors, 0);
    assert_true(l.d.items[0].is_warning);
    assert_string_equal(l.d.items[0].message,
                        "imu.gyro.bias: 10 deg/h is about 970 times what is usual in the class "
                        "'navigation' (0.01 deg/h); is the unit right?");
    assert_int_equal(l.d.items[0].place.line, 5);
    assert_int_equal(l.d.items[0].place.column, 16);
    assert_string_equal(l.d.items[0].excerpt, "  gyro: {bias: 10 deg/h}");
    assert_non_null(strstr(l.d.items[1].message, "shorter than one Schuler period (84.4 min)"));
    assert_int_equal(l.d.items[1].place.line, 6);
    unload(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_arrives_in_si),
        cmocka_unit_test(defaults_are_filled_in),
        cmocka_unit_test(the_report_interval_follows_the_duration),
        cmocka_unit_test(the_hash_is_of_the_file_as_it_is),
        cmocka_unit_test(imu_without_a_part_is_what_it_says),
        cmocka_unit_test(a_density_becomes_a_random_walk),
        cmocka_unit_test(a_part_can_be_a_file_beside_the_scenario),
        cmocka_unit_test(overrides_replace_what_the_file_says),
        cmocka_unit_test(doubtful_values_are_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

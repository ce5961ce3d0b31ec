/* SPDX-License-Identifier: MIT */
/* What is said of a scenario file that is wrong, and where. */
#include "core/document_private.h"
#include "scenario_text.h"
#include "scenarios/part.h"

#define HEAD "scenario: x\n" TRAJECTORY /* two lines */
#define IMU  "imu: {use: hg9900}\n"

typedef struct {
    const char *text;
    int line, column, width;
    const char *message;
} mistake;

static void check_all(const mistake *table, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        loaded l;
        load(&l, table[i].text, NULL);
        if (l.rc != SCHULER_ERR_INPUT) fail_msg("taken: %s", table[i].text);
        const schuler_error *e = &l.d.items[0];
        /* A message that ends in ~ is only begun: it goes on with a long list of names. */
        const size_t length = strlen(table[i].message);
        if (table[i].message[length - 1] == '~')
            assert_memory_equal(e->message, table[i].message, length - 1);
        else
            assert_string_equal(e->message, table[i].message);
        assert_int_equal(e->place.line, table[i].line);
        assert_int_equal(e->place.column, table[i].column);
        assert_int_equal(e->place.width, table[i].width);
        assert_string_equal(e->place.file, l.path);
        assert_true(e->excerpt[0] != '\0');
        assert_int_equal(e->excerpt_column, table[i].column);
        assert_int_equal(l.d.errors, 1);
        unload(&l);
    }
}

static void mistakes_in_the_scenario_have_their_place(void **state)
{
    (void)state;
    static const mistake table[] = {
        { TRAJECTORY IMU, 1, 1, 1,
          "the file needs the key 'scenario', for example: One hour at 45 N" },
        { HEAD, 1, 1, 1, "the file needs the key 'imu', for example: {use: hg9900}" },
        { "scenario: x\n" IMU, 1, 1, 1,
          "the file needs the key 'trajectory', for example: {kind: static, start: {lat: 45 deg, "
          "lon: 7 deg}, for: 1 h}" },
        { HEAD IMU "ruins: 5\n", 4, 1, 5, "unknown key 'ruins'; did you mean 'runs'?" },
        { HEAD IMU "runs: 0\n", 4, 7, 1, "runs: 0 is out of range; allowed: 1 to 100000" },
        { HEAD IMU "runs: 5\nruns: many\n", 5, 1, 4,
          "duplicate key 'runs' (first given on line 4)" },
        { HEAD IMU "runs: many\n", 4, 7, 4, "runs: 'many' is not a whole number" },
        { HEAD IMU "seed: -1\n", 4, 7, 2,
          "seed: -1 is out of range; allowed: 0 to 9223372036854775807" },
        { HEAD IMU "seed: 9223372036854775808\n", 4, 7, 19,
          "seed: 9223372036854775808 is out of range; allowed: 0 to 9223372036854775807" },
        { HEAD IMU "truth: {gravity: wgs85}\n", 4, 18, 5,
          "truth.gravity: unknown gravity model 'wgs85'; did you mean 'wgs84'?" },
        { HEAD IMU "truth: {gravity: ../egm96}\n", 4, 18, 8,
          "truth.gravity: unknown gravity model '../egm96'; known: wgs84, grs80, egm84, egm96, "
          "egm2008" },
        { HEAD IMU "navigation: {frame: wandre}\n", 4, 21, 6,
          "navigation.frame: there is no frame 'wandre'; did you mean 'wander'?" },
        { HEAD IMU "navigation: {vertical: bara}\n", 4, 24, 4,
          "navigation.vertical: unknown 'bara'; did you mean 'baro'?" },
        { HEAD "imu: {use: hg9900, rate: 1 Hz}\n"
               "navigation: {vertical: baro, baro_time: 30 s, samples_per_update: 8}\n",
          4, 1, 10,
          "navigation.baro_time: 30 s is too short for navigation updates every 8 s; allowed: 32 s "
          "and more" },
        { HEAD IMU "navigation: {vertical: baro, baro_time: 0.5 s}\n", 4, 41, 5,
          "navigation.baro_time: 0.5 s is out of range; allowed: 1 to 100000 s" },
        { HEAD IMU "baro: {bais: 3 m}\n", 4, 8, 4,
          "unknown key 'bais' in 'baro'; did you mean 'bias'?" },
        { HEAD IMU "navigation: {vertical: baro}\nbaro: {lag: {normal: 1 s}}\n", 5, 14, 6,
          "baro.lag: cannot be negative, so it cannot be drawn about zero; write one value or "
          "{uniform: [LOW, HIGH]}" },
        { HEAD IMU "navigation: {vertical: baro}\nbaro: {gauss_markov: 20 m}\n", 5, 22, 4,
          "'baro' needs the key 'gauss_markov_time' beside 'gauss_markov', for example: 1 h" },
        { HEAD IMU "navigation: {vertical: baro}\nbaro: {gauss_markov_time: 1 h}\n", 5, 1, 4,
          "'baro' has 'gauss_markov_time' without 'gauss_markov'" },
        { HEAD IMU "navigation: {vertical: baro}\nbaro: {noise: 1 m}\n", 5, 17, 1,
          "baro.noise: 'm' is a unit of length, but another is expected (such as '1 m/sqrt(Hz)')" },
        { HEAD IMU "errors: {only: baro.nose}\n", 4, 16, 9,
          "errors.only: no error source or group 'baro.nose'; did you mean 'baro.noise'?" },
        { HEAD IMU "navigation: {coning: optimal_6}\n", 4, 22, 9,
          "navigation.coning: there is no algorithm 'optimal_6'; did you mean 'optimal_2'?" },
        { HEAD IMU "navigation: {samples_per_update: 16}\n", 4, 34, 2,
          "navigation.samples_per_update: unknown '16'; did you mean '1'?" },
        { HEAD IMU "initial: {alig: {for: 10 min}}\n", 4, 11, 4,
          "unknown key 'alig' in 'initial'; did you mean 'align'?" },
        { HEAD IMU "initial: {align: {for: 10 min}, tilt: 1 mrad}\n", 4, 11, 5,
          "initial.align: tilt and heading are found by it and cannot be given too" },
        { HEAD IMU "initial: {tilt: [1 mrad, 2 mrad, 3 mrad]}\n", 4, 17, 1,
          "initial.tilt: one value or a list of 2 is expected, found a list of 3" },
        { HEAD IMU "initial: {heading: [1 mrad, 2 mrad]}\n", 4, 20, 1,
          "initial.heading: a single value is expected, found a list" },
        { HEAD IMU "errors: {only: gyro.bais}\n", 4, 16, 9,
          "errors.only: no error source or group 'gyro.bais'; did you mean 'gyro.bias'?" },
        { HEAD IMU "errors: {without: [gyro, odometer]}\n", 4, 26, 8,
          "errors.without: no error source or group 'odometer'; known: accel, accel.bias, "
          "accel.scale_factor, accel.misalignment, ~" },
        { HEAD IMU "requirement: {drift: 1 nmi/h}\n", 4, 1, 11,
          "'requirement' needs the key 'statistic': CEP, R95, R99, rms or one_axis. There is no "
          "default, because "
          "a "
          "drift limit means nothing without it: the sensors that drift 0.5 nmi/h CEP drift 1.0 "
          "nmi/h R95" },
        { HEAD IMU "requirement: {statistic: CEP}\n", 4, 1, 11,
          "'requirement' needs the key 'drift', for example: 1 nmi/h" },
        { HEAD IMU "requirement: {drift: 1 nmi/h, statistic: CEP50}\n", 4, 42, 5,
          "requirement.statistic: unknown 'CEP50'; did you mean 'CEP'?" },
        { HEAD IMU "requirement: {drift: 1 nmi, statistic: CEP}\n", 4, 24, 3,
          "requirement.drift: 'nmi' is a unit of length, but speed is expected (such as '1 "
          "nmi/h')" },
        { HEAD IMU "report: {every: 10 ms}\n", 4, 1, 6,
          "report.every: this gives 720000 reports in 7200 s; allowed: 100000" },
        { "scenario: x\ntrajectory: {start: {}}\n" IMU, 2, 1, 10,
          "'trajectory' needs the key 'kind', for example: static" },
        { "scenario: x\ntrajectory: {kind: statc}\n" IMU, 2, 20, 5,
          "trajectory.kind: there is no kind 'statc'; did you mean 'static'?" },
        { "scenario: x\ntrajectory: {kind: motoin}\n" IMU, 2, 20, 6,
          "trajectory.kind: there is no kind 'motoin'; did you mean 'motion'?" },
        { "scenario: x\ntrajectory: static\n" IMU, 2, 13, 6,
          "trajectory: a map of keys is expected, found 'static'" },
    };
    check_all(table, sizeof table / sizeof table[0]);
}

static void mistakes_in_the_imu_have_their_place(void **state)
{
    (void)state;
    static const mistake table[] = {
        { HEAD "imu: {use: hg9990}\n", 3, 12, 6,
          "no part 'hg9990' in the catalog, and no such file; did you mean 'hg9900'?" },
        { HEAD "imu: {use: hg9900, rate: 0.5 Hz}\n", 3, 26, 6,
          "imu.rate: 0.5 Hz is out of range; allowed: 1 to 10000 Hz" },
        { HEAD "imu: {use: hg9900, rate: 100 s}\n", 3, 30, 1,
          "imu.rate: 's' is a unit of time, but frequency is expected (such as '100 Hz')" },
        { HEAD "imu: {use: hg9900, gyro: {model: cubic}}\n", 3, 34, 5,
          "imu.gyro.model: there is no gyro model 'cubic'; known: linear, conventional, "
          "ring_laser, fibre_optic, vibratory, spinning_mass, gyro_datasheet" },
        { HEAD "imu: {use: hg9900, gyro: {scale: 5 ppm}}\n", 3, 27, 5,
          "unknown key 'scale' in 'imu.gyro'; known: model, noise_density, sided, "
          "allan_floor, bias, scale_factor, misalignment, ~" },
        { HEAD "imu: {accel: {model: linear}}\n", 3, 1, 3,
          "'imu' needs the key 'gyro' (or 'use: NAME', a part of the catalog), for example: "
          "{model: "
          "linear, bias: 0.01 deg/h}" },
        { HEAD "imu: {accel: {model: linear}, gyro: {bias: 1 deg/h}}\n", 3, 31, 4,
          "'imu.gyro' needs the key 'model', for example: linear" },
        { HEAD "imu: {use: hg9900, gyro: {gauss_markov: 1 deg/h}}\n", 3, 41, 7,
          "'imu.gyro' needs the key 'gauss_markov_time' beside 'gauss_markov', for example: 100 "
          "s" },
        { HEAD "imu: {use: hg9900, gyro: {gauss_markov_time: 1 h}}\n", 3, 46, 3,
          "'imu.gyro' needs the key 'gauss_markov' beside 'gauss_markov_time', for example: "
          "0.003 deg/h" },
        { HEAD "imu: {use: hg9900, gyro: {noise_density: 1 deg/h/rtHz}}\n", 3, 27, 13,
          "'imu.gyro' needs the key 'sided' beside 'noise_density': one or two; a one-sided "
          "density, as most data sheets give, is sqrt(2) times the random walk, a two-sided one is "
          "the random walk" },
        { HEAD "imu: {use: hg9900, gyro: {noise_density: 1 deg/h/rtHz, sided: both}}\n", 3, 63, 4,
          "imu.gyro.sided: one or two is expected, found 'both'" },
        { HEAD "imu: {use: hg9900, gyro: {sided: one}}\n", 3, 27, 5,
          "'imu.gyro' has 'sided' without 'noise_density'" },
        { HEAD "imu: {use: hg9900, accel: {noise_density: 1 ug/rtHz, sided: one, "
               "velocity_random_walk: 1 m/s/sqrt(h)}}\n",
          3, 28, 13,
          "'imu.accel' has both 'noise_density' and 'velocity_random_walk', which mean the same; "
          "give one of them" },
        { HEAD "imu: {use: hg9900, accel: {bias: 1 g/h}}\n", 3, 36, 3,
          "imu.accel.bias: 'g/h' is a unit of jerk, but acceleration is expected (such as '1 "
          "ug')" },
        { HEAD "imu: {use: hg9900, accel: 5}\n", 3, 27, 1,
          "imu.accel: a map of keys is expected, found '5'" },
        { HEAD "imu: {use: hg9900, accel: {bias: 1 mg, bias: 5}}\n", 3, 40, 4,
          "duplicate key 'bias' (first given on line 3)" },
        { HEAD "imu: hg9900\n", 3, 6, 6, "imu: a map of keys is expected, found 'hg9900'" },
        { HEAD "imu: {use: [a]}\n", 3, 12, 1, "imu.use: a part's name is expected, found a list" },
    };
    check_all(table, sizeof table / sizeof table[0]);
}

/* One file with a mistake of every kind of the user-experience study, found in one pass. */
static void all_mistakes_are_said_at_once(void **state)
{
    (void)state;
    static const char text[] = "scenario: x\n"
                               "trajectory:\n"
                               "  kind: segments\n"
                               "  start: {lat: 45 deg, lon: 7 deg, height: 0 m, speed: 100 deg}\n"
                               "  segments:\n"
                               "    - cruise: {}\n"
                               "imu:\n"
                               "  use: hg9900\n"
                               "  gyro:\n"
                               "    bais: 0.01 deg/h\n"
                               "    scale_factor: 5 ppm\n"
                               "    scale_factor: 6 ppm\n"
                               "  accel: {bias: 50}\n";
    static const struct {
        int line, column;
        const char *message;
    } expected[] = {
        { 12, 5, "duplicate key 'scale_factor' (first given on line 11)" },
        { 13, 17, "imu.accel.bias: unit missing; write for example '50 ug'" },
        { 10, 5, "unknown key 'bais' in 'imu.gyro'; did you mean 'bias'?" },
        { 4, 60,
          "trajectory.start.speed: 'deg' is a unit of angle, but speed is expected (such as '100 "
          "m/s')" },
        { 6, 7, "'trajectory.segments[0].cruise' needs the key 'for', for example: " },
    };
    loaded l;
    load(&l, text, NULL);
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const schuler_error *e = &l.d.items[i];
        if (strncmp(e->message, expected[i].message, strlen(expected[i].message)) != 0)
            assert_string_equal(e->message, expected[i].message);
        assert_int_equal(e->place.line, expected[i].line);
        assert_int_equal(e->place.column, expected[i].column);
    }
    assert_int_equal(l.d.errors, sizeof expected / sizeof expected[0]);
    assert_string_equal(l.d.items[2].excerpt, "    bais: 0.01 deg/h");
    unload(&l);
}

static void mistaken_overrides_are_named(void **state)
{
    (void)state;
    static const struct {
        schuler_overrides o;
        const char *set, *file, *message;
    } table[] = {
        { { 0 },
          "imu.gyro.bias=5",
          "--set imu.gyro.bias=5",
          "imu.gyro.bias: unit missing; write for example '5 deg/h'" },
        { { 0 },
          "imu.gyro.bais=5 deg/h",
          "--set imu.gyro.bais=5 deg/h",
          "unknown key 'bais' in 'imu.gyro'; did you mean 'bias'?" },
        { { 0 },
          "imu.gyro",
          "--set",
          "'imu.gyro': KEY=VALUE is expected, such as imu.gyro.bias='0.01 deg/h'" },
        { { 0 },
          "scenario.x=1",
          "--set scenario.x=1",
          "a single value is there, so there can be no key 'x'" },
        { { .imu = "hg9990" },
          NULL,
          "--imu hg9990",
          "no part 'hg9990' in the catalog, and no such file; did you mean 'hg9900'?" },
        { { .only = "gyro,gyros" },
          NULL,
          "--only gyro,gyros",
          "errors.only: no error source or group 'gyros'; did you mean 'gyro'?" },
        { { .without = "initial.headng" },
          NULL,
          "--without initial.headng",
          "errors.without: no error source or group 'initial.headng'; did you mean "
          "'initial.heading'?" },
        { { .has_runs = 1, .runs = -4 },
          NULL,
          "--runs -4",
          "runs: -4 is out of range; allowed: 1 to 100000" },
        { { .has_seed = 1, .seed = UINT64_MAX }, NULL, "--seed", "the seed is out of range" },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        schuler_overrides o = table[i].o;
        o.set = &table[i].set;
        o.count_set = table[i].set ? 1 : 0;
        loaded l;
        load(&l, HEAD IMU, &o);
        assert_int_equal(l.rc, SCHULER_ERR_INPUT);
        assert_string_equal(l.d.items[0].message, table[i].message);
        assert_string_equal(l.d.items[0].place.file, table[i].file);
        assert_int_equal(l.d.items[0].place.line, 0);
        assert_int_equal(l.d.errors, 1);
        unload(&l);
    }
}

static void what_is_no_scenario_is_refused(void **state)
{
    (void)state;
    loaded l;
    make_folder(&l);
    assert_int_equal(schuler_scenario_load(&l.s, l.path, NULL, &l.d), SCHULER_ERR_FILE);
    assert_int_equal(schuler_scenario_load(&l.s, l.dir, NULL, &l.d), SCHULER_ERR_FILE);
    write_file(l.dir, "s.yaml",
               "\x7f"
               "ELF\x02\0\0",
               7);
    assert_int_equal(schuler_scenario_load(&l.s, l.path, NULL, &l.d), SCHULER_ERR_INPUT);
    write_file(l.dir, "s.yaml", "- a\n", 4);
    const char *const set = "a.b=1";
    const schuler_overrides o = { .set = &set, .count_set = 1, .imu = "ln200", .only = "gyro" };
    assert_int_equal(schuler_scenario_load(&l.s, l.path, &o, &l.d), SCHULER_ERR_INPUT);
    assert_int_equal(l.d.errors, 4);
    assert_string_equal(l.d.items[3].message, "a map of keys is expected, found a list");
    assert_null(l.s);
    unload(&l);
}

/* The rule of the catalog, which a part of the user need not obey. */
static void a_catalog_value_without_a_source_is_refused(void **state)
{
    (void)state;
    static const char text[] = "sensor: x\nsources: {a: one}\n"
                               "accel: {model: linear, bias: 1 mg, scale_factor: {value: 1 ppm, "
                               "source: a}}\n"
                               "gyro: {model: linear, bias: {value: 1 deg/h, assumed: true}}\n";
    for (int strict = 0; strict < 2; strict++) {
        schuler_diagnostics d = { 0 };
        schuler_document *doc;
        assert_int_equal(schuler_document_parse(&doc, "p", text, sizeof text - 1, &d), SCHULER_OK);
        schuler_reading r = { .arena = schuler_arena_create(), .d = &d };
        schuler_part part = { .source_count = 0 };
        schuler_part_read(&r, doc, "p", strict, &part);
        assert_int_equal(d.errors, strict ? 2 : 0);
        if (strict) {
            assert_string_equal(d.items[0].message,
                                "accel.bias: a catalog value needs 'source: NAME', or 'assumed: "
                                "true' with a note");
            assert_string_equal(d.items[1].message,
                                "gyro.bias: an assumed value needs 'note: WHY'");
        }
        schuler_arena_free(r.arena);
        schuler_document_free(doc);
        schuler_diagnostics_free(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_in_the_scenario_have_their_place),
        cmocka_unit_test(mistakes_in_the_imu_have_their_place),
        cmocka_unit_test(all_mistakes_are_said_at_once),
        cmocka_unit_test(mistaken_overrides_are_named),
        cmocka_unit_test(what_is_no_scenario_is_refused),
        cmocka_unit_test(a_catalog_value_without_a_source_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

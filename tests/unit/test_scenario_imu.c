/* SPDX-License-Identifier: MIT */
/* The sensors of a scenario: parts put together, specimens, temperature, mounting. */
#include "scenario_text.h"
#include "scenarios/sources.h"

#define HEAD "scenario: x\n" TRAJECTORY
#define BARE "imu:\n  accel: {model: linear}\n  gyro: {model: linear}\n"

static void triads_of_two_parts_make_one_imu(void **state)
{
    (void)state;
    loaded l;
    load_good(&l, HEAD "imu: {accel: {use: hg9900}, gyro: {use: stim300, bias: 2 deg/h}}\n", NULL);
    const schuler_imu *imu = &l.s->imu;
    CHECK_REL(value_of(imu, SCHULER_ACCEL, "bias")->a[0], 25e-6 * 9.80665, 1e-15);
    CHECK_REL(value_of(imu, SCHULER_GYRO, "bias")->a[0], 2 * SCHULER_RAD_PER_DEG / 3600, 1e-15);
    CHECK_REL(value_of(imu, SCHULER_GYRO, "angle_random_walk")->a[0],
              0.15 * SCHULER_RAD_PER_DEG / 60, 1e-15);
    unload(&l);
    /* Over a part that has both, one triad of another. */
    load_good(&l, HEAD "imu: {use: hg9900, gyro: {use: stim300}}\n", NULL);
    CHECK_REL(value_of(&l.s->imu, SCHULER_GYRO, "angle_random_walk")->a[0],
              0.15 * SCHULER_RAD_PER_DEG / 60, 1e-15);
    CHECK_REL(value_of(&l.s->imu, SCHULER_ACCEL, "bias")->a[0], 25e-6 * 9.80665, 1e-15);
    unload(&l);
}

static void a_specimen_is_the_same_in_every_run(void **state)
{
    (void)state;
    loaded l;
    static const char text[] = HEAD
        "runs: 5\nimu:\n%s  accel: {model: linear, bias: {normal: 1 mg, per: unit}, scale_factor: "
        "{normal: 10 ppm, per: run}}\n  gyro: {model: linear}\n";
    char with[600], without[600];
    snprintf(with, sizeof with, text, "  unit: 3\n");
    snprintf(without, sizeof without, text, "");
    double bias[2][5], scale[2][5];
    for (int u = 0; u < 2; u++) {
        load_good(&l, u ? with : without, NULL);
        error_source sources[SOURCES_MAX];
        assert_int_equal(schuler_sources_list(l.s, sources), 2);
        for (uint64_t run = 0; run < 5; run++) {
            bias[u][run] = schuler_source_draw(&sources[0], 1, l.s->seed, run);
            scale[u][run] = schuler_source_draw(&sources[1], 1, l.s->seed, run);
        }
        unload(&l);
    }
    for (int run = 0; run < 5; run++) {
        /* Specimen 3 is the one that run 3 would have had; what belongs to a run is as before. */
        assert_true(bias[1][run] == bias[0][3]);
        assert_true(scale[1][run] == scale[0][run]);
        assert_true(run == 3 || bias[0][run] != bias[0][3]);
    }
}

static void a_floor_of_the_allan_deviation_is_a_flicker_coefficient(void **state)
{
    (void)state;
    loaded l;
    load_good(&l,
              HEAD "imu:\n  accel: {model: linear}\n  gyro: {model: linear, allan_floor: 0.3 "
                   "deg/h}\n",
              NULL);
    /* C1: floor = 0.66428247026796 B. */
    const schuler_value *v = value_of(&l.s->imu, SCHULER_GYRO, "bias_instability");
    CHECK_REL(v->a[0] * 0.66428247026796, 0.3 * SCHULER_RAD_PER_DEG / 3600, 1e-14);
    assert_string_equal(v->text, "0.3 deg/h Allan floor");
    unload(&l);
}

static void temperature_is_a_profile_or_a_warm_up(void **state)
{
    (void)state;
    loaded l;
    double rate;
    load_good(&l,
              HEAD BARE "  temperature:\n    reference: 25 degC\n    profile:\n      - {at: 10 s, "
                        "is: 20 degC}\n      - {at: 110 s, is: 45 degC}\n      - {at: 120 s, is: "
                        "45 degC}\n",
              NULL);
    assert_true(l.s->imu.has_temperature);
    const schuler_temperature *t = &l.s->imu.temperature;
    CHECK_NEAR(schuler_temperature_at(t, 0.0, &rate), -5.0, 1e-14);
    CHECK_NEAR(rate, 0.0, 0.0);
    CHECK_NEAR(schuler_temperature_at(t, 60.0, &rate), 7.5, 1e-13);
    CHECK_NEAR(rate, 0.25, 1e-15);
    CHECK_NEAR(schuler_temperature_at(t, 500.0, &rate), 20.0, 1e-14);
    CHECK_NEAR(rate, 0.0, 0.0);
    unload(&l);
    load_good(&l,
              HEAD BARE "  temperature: {reference: 25 degC, warm_up: {from: 20 degC, to: 60 degC, "
                        "time: 10 min}}\n",
              NULL);
    t = &l.s->imu.temperature;
    CHECK_NEAR(schuler_temperature_at(t, 0.0, &rate), -5.0, 1e-14);
    CHECK_REL(rate, 40.0 / 600.0, 1e-15);
    /* 60 - 40 exp(-1) - 25; exp(-1) = 0.36787944117144233 */
    CHECK_NEAR(schuler_temperature_at(t, 600.0, &rate), 35.0 - 40.0 * 0.36787944117144233, 1e-13);
    unload(&l);
}

static void mistakes_are_told(void **state)
{
    (void)state;
    static const char *const table[][2] = {
        { HEAD BARE "  temperature: {reference: 25 degC}\n",
          "'imu.temperature' needs either 'profile' or 'warm_up', for example: profile: [{at: 0 s, "
          "is: 20 degC}, {at: 10 min, is: 45 degC}]" },
        { HEAD BARE "  temperature: {reference: 25 degC, warm_up: {from: 1 K, to: 2 K}}\n",
          "'imu.temperature.warm_up' needs the key 'time', for example: 10 min" },
        { HEAD BARE "  temperature: {reference: 25 degC, profile: [{at: 5 s, is: 2 K}, {at: 5 s, "
                    "is: 3 K}]}\n",
          "imu.temperature.profile: the times must increase from point to point" },
        { HEAD "imu: {accel: {use: hg9901}, gyro: {model: linear}}\n",
          "no part 'hg9901' in the catalog, and no such file; did you mean 'hg9900'?" },
        { HEAD "imu: {unit: -1, use: hg9900}\n",
          "imu.unit: -1 is out of range; allowed: 0 to 4294967295" },
        { HEAD "imu: {accel: {model: linear, bias: {normal: 1 mg, per: flight}}, gyro: {model: "
               "linear}}\n",
          "imu.accel.bias.per: unit or run is expected, found 'flight'" },
        { HEAD "imu: {accel: {model: linear, gauss_markov: 1 ug, gauss_markov_time: {normal: 1 "
               "s}}, gyro: {model: linear}}\n",
          NULL },
        { HEAD "imu: {accel: {model: linear, allan_floor: 1 ug, bias_instability: 1 ug}, gyro: "
               "{model: linear}}\n",
          "'imu.accel' has both 'allan_floor' and 'bias_instability', which mean the same; give "
          "one "
          "of them" },
        { HEAD
          "imu: {rate: 200 Hz, accel: {model: linear, delay: 0.33 s}, gyro: {model: linear}}\n",
          "imu.accel.delay: at 200 Hz at most 0.32 s (64 samples) are allowed" },
        { HEAD "imu: {accel: {model: linear, input_axes: [1, 0, 0, 0, 1, 0, 1, 1, 0]}, gyro: "
               "{model: linear}}\n",
          "imu.accel.input_axes: the three axes lie in a plane, so the input cannot be found from "
          "what they measure" },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        loaded l;
        load(&l, table[i][0], NULL);
        if (l.rc != SCHULER_ERR_INPUT) fail_msg("taken: %s", table[i][0]);
        if (table[i][1]) assert_string_equal(l.d.items[0].message, table[i][1]);
        assert_true(l.d.items[0].place.line > 0);
        unload(&l);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triads_of_two_parts_make_one_imu),
        cmocka_unit_test(a_specimen_is_the_same_in_every_run),
        cmocka_unit_test(a_floor_of_the_allan_deviation_is_a_flicker_coefficient),
        cmocka_unit_test(temperature_is_a_profile_or_a_warm_up),
        cmocka_unit_test(mistakes_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

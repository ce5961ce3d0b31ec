/* SPDX-License-Identifier: MIT */
#include "scenario_text.h"
#include "sensors/catalog.h"

static const double deg = 3.14159265358979323846 / 180.0, g = 9.80665;

static schuler_part *part_of(const char *name)
{
    schuler_diagnostics d = { 0 };
    schuler_part *part = NULL;
    if (schuler_part_load(&part, name, &d) != SCHULER_OK)
        fail_msg("%s: %s", d.items[0].place.file, d.items[0].message);
    assert_int_equal(d.errors + d.warnings, 0);
    schuler_diagnostics_free(&d);
    return part;
}

static void every_part_is_read_and_each_value_has_its_source(void **state)
{
    (void)state;
    size_t count = 0;
    for (const schuler_catalog_entry *e = schuler_catalog; e->name; e++, count++) {
        assert_int_equal(strlen(e->text), e->length);
        if (count > 0) assert_true(strcmp(e[-1].name, e->name) < 0);
        schuler_part *part = part_of(e->name);
        assert_string_equal(part->imu.name, e->name);
        assert_non_null(part->maker);
        assert_non_null(part->grade);
        assert_non_null(part->technology);
        assert_non_null(part->notes);
        assert_non_null(strstr(part->notes, "ot published"));
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            const schuler_triad *t = &part->imu.triad[i];
            int given = 0;
            for (int k = 0; t->params[k].key; k++) {
                const schuler_value *v = &t->values[k];
                if (!v->given) continue;
                given++;
                assert_true(v->source != NULL || v->assumed);
                assert_false(schuler_value_is_zero(v, t->params[k].components));
            }
            assert_true(given >= 2);
        }
        schuler_part_free(part);
    }
    assert_true(count >= 4);
    schuler_part_free(NULL);
}

/* The rows of the sensor catalog's sheet that these parts are made of. */
static void the_figures_are_those_of_the_sheets(void **state)
{
    (void)state;
    static const struct {
        const char *part;
        schuler_instrument instrument;
        const char *key;
        schuler_draw draw;
        double number, unit;
        bool assumed;
    } table[] = {
        { "hg9900", SCHULER_GYRO, "bias", SCHULER_DRAW_NORMAL, 0.0035, 1.0 / 3600, false },
        { "hg9900", SCHULER_GYRO, "angle_random_walk", SCHULER_DRAW_FIXED, 0.002, 1.0 / 60, false },
        { "stim300", SCHULER_GYRO, "bias", SCHULER_DRAW_NORMAL, 4, 1.0 / 3600, false },
        { "stim300", SCHULER_GYRO, "angle_random_walk", SCHULER_DRAW_FIXED, 0.15, 1.0 / 60, false },
        { "ln200", SCHULER_GYRO, "bias", SCHULER_DRAW_NORMAL, 1, 1.0 / 3600, false },
        { "ln200", SCHULER_GYRO, "angle_random_walk", SCHULER_DRAW_FIXED, 0.07, 1.0 / 60, false },
        { "ln200", SCHULER_GYRO, "gauss_markov", SCHULER_DRAW_FIXED, 0.35, 1.0 / 3600, false },
        { "bmi088", SCHULER_GYRO, "bias", SCHULER_DRAW_NORMAL, 1, 1, false },
        /* A one-sided density is sqrt(2) times the random walk. */
        { "bmi088", SCHULER_GYRO, "angle_random_walk", SCHULER_DRAW_FIXED, 0.014,
          0.70710678118654752440, true },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        schuler_part *part = part_of(table[i].part);
        const schuler_value *v = value_of(&part->imu, table[i].instrument, table[i].key);
        assert_int_equal(v->draw, table[i].draw);
        assert_int_equal(v->assumed, table[i].assumed);
        CHECK_REL(v->a[0], table[i].number * table[i].unit * deg, 2e-15);
        schuler_part_free(part);
    }
    schuler_part *part = part_of("hg9900");
    const schuler_imu *hg9900 = &part->imu;
    CHECK_REL(value_of(hg9900, SCHULER_ACCEL, "bias")->a[0], 25e-6 * g, 2e-15);
    CHECK_REL(value_of(hg9900, SCHULER_ACCEL, "scale_factor")->a[0], 100e-6, 2e-15);
    CHECK_REL(value_of(hg9900, SCHULER_GYRO, "scale_factor")->a[0], 5e-6, 2e-15);
    /* 100 urad is 3 sigma; 7 ug rms over 10 Hz is 7/sqrt(10) ug/sqrt(Hz) one-sided. Both rounded in
     * the file to the digits shown, half a unit of the last is 5e-2/33.3 and 5e-2/2.2. */
    const schuler_value *misalignment = value_of(hg9900, SCHULER_ACCEL, "misalignment");
    CHECK_REL(misalignment->a[5], 100e-6 / 3, 1.6e-3);
    assert_true(misalignment->assumed);
    const schuler_value *walk = value_of(hg9900, SCHULER_ACCEL, "velocity_random_walk");
    CHECK_REL(walk->a[0], 7e-6 * g / sqrt(10.0) / sqrt(2.0), 2.3e-2);
    assert_true(walk->assumed);
    assert_false(value_of(hg9900, SCHULER_GYRO, "misalignment")->given);
    schuler_part_free(part);
    part = part_of("ln200");
    CHECK_NEAR(value_of(&part->imu, SCHULER_ACCEL, "gauss_markov_time")->a[0], 60.0, 0.0);
    CHECK_NEAR(value_of(&part->imu, SCHULER_GYRO, "gauss_markov_time")->a[0], 100.0, 0.0);
    CHECK_REL(value_of(&part->imu, SCHULER_ACCEL, "velocity_random_walk")->a[0], 0.03 / 60, 2e-15);
    schuler_part_free(part);
}

static void an_unknown_part_lists_what_there_is(void **state)
{
    (void)state;
    schuler_diagnostics d = { 0 };
    schuler_part *part;
    assert_int_equal(schuler_part_load(&part, "hg9990", &d), SCHULER_ERR_INPUT);
    assert_int_equal(schuler_part_load(&part, "/no/where.yaml", &d), SCHULER_ERR_INPUT);
    assert_int_equal(schuler_part_load(&part, "", &d), SCHULER_ERR_INPUT);
    assert_int_equal(schuler_part_load(&part, "/tmp", &d), SCHULER_ERR_FILE);
    assert_null(part);
    assert_string_equal(d.items[0].message,
                        "no part 'hg9990' in the catalog, and no such file; did "
                        "you mean 'hg9900'?");
    assert_string_equal(d.items[1].message,
                        "no part '/no/where.yaml' in the catalog, and no such file; known: bmi088, "
                        "hg9900, ln200, stim300");
    schuler_diagnostics_free(&d);
}

static void a_part_file_is_checked_like_a_scenario(void **state)
{
    (void)state;
    static const char text[] = "sensor: x\nrat: 5 Hz\nsources: {a: one}\n"
                               "accel: {model: linear, bias: {normal: 1 mg, source: b}}\n"
                               "gyro: {model: liner}\n";
    loaded l;
    make_folder(&l);
    write_file(l.dir, "s.yaml", text, strlen(text));
    schuler_part *part;
    assert_int_equal(schuler_part_load(&part, l.path, &l.d), SCHULER_ERR_INPUT);
    assert_null(part);
    assert_int_equal(l.d.errors, 3);
    assert_string_equal(l.d.items[0].message, "unknown key 'rat'; did you mean 'rate'?");
    assert_int_equal(l.d.items[0].place.line, 2);
    assert_string_equal(l.d.items[0].excerpt, "rat: 5 Hz");
    assert_string_equal(l.d.items[1].message,
                        "accel.bias: no source 'b' in the file's 'sources'; known: a");
    assert_int_equal(l.d.items[1].place.line, 4);
    assert_string_equal(l.d.items[2].message,
                        "gyro.model: there is no gyro model 'liner'; did you mean 'linear'?");
    unload(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_part_is_read_and_each_value_has_its_source),
        cmocka_unit_test(the_figures_are_those_of_the_sheets),
        cmocka_unit_test(an_unknown_part_lists_what_there_is),
        cmocka_unit_test(a_part_file_is_checked_like_a_scenario),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

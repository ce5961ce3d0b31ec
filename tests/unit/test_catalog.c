/* SPDX-License-Identifier: MIT */
#include "scenario_text.h"
#include "scenarios/part.h"
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

static int figures_of(const schuler_triad *t)
{
    int given = 0;
    for (int k = 0; t->model && t->params[k].key; k++) {
        const schuler_value *v = &t->values[k];
        if (!v->given) continue;
        given++;
        if (!t->params[k].choices) {
            assert_true(v->source != NULL || v->assumed);
            assert_false(schuler_value_is_zero(v, t->params[k].components));
        }
        assert_true(!v->assumed || v->note != NULL);
        /* what a setting or the printed table of the paper says has none */
        if (t->params[k].number && v->source && strcmp(v->source, "paper") != 0 &&
            v->qualifier == NULL)
            fail_msg("%s has no qualifier", t->params[k].key);
    }
    return given;
}

static void every_part_is_read_and_each_value_has_its_source(void **state)
{
    (void)state;
    int imus = 0, accels = 0, gyros = 0, papers = 0, corrected = 0;
    for (const schuler_catalog_entry *e = schuler_catalog; e->name; e++) {
        assert_int_equal(strlen(e->text), e->length);
        if (e > schuler_catalog) assert_true(strcmp(e[-1].name, e->name) < 0);
        schuler_part *part = part_of(e->name);
        assert_string_equal(part->imu.name, e->name);
        assert_non_null(part->maker);
        assert_non_null(part->technology);
        assert_non_null(part->grade);
        assert_non_null(strstr("consumer industrial tactical navigation strategic", part->grade));
        assert_non_null(part->notes);
        assert_non_null(strstr(part->notes, "ot published"));
        assert_true(part->source_count >= 1);
        const bool accel = part->imu.triad[SCHULER_ACCEL].model != NULL;
        const bool gyro = part->imu.triad[SCHULER_GYRO].model != NULL;
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            assert_true(figures_of(&part->imu.triad[i]) >= (part->imu.triad[i].model ? 2 : 0));
        if (strncmp(e->name, "paper-", 6) == 0) {
            const bool marked = strstr(e->name, "-corrected") != NULL;
            papers += !marked;
            corrected += marked;
            assert_true(marked == (strstr(part->imu.title, "corrected reading") != NULL));
        } else {
            imus += accel && gyro;
            accels += accel && !gyro;
            gyros += gyro && !accel;
        }
        schuler_part_free(part);
    }
    assert_true(imus >= 25);
    assert_true(accels + gyros >= 15);
    assert_true(gyros >= 5);
    assert_int_equal(papers, 10);
    assert_int_equal(corrected, 10);
    schuler_part_free(NULL);
}

/* A value without a source is refused in the catalog, and in no other file. */
static void a_value_without_a_source_is_refused(void **state)
{
    (void)state;
    static const char *const broken[] = { "bias: {normal: 1 mg}", "bias: 1 mg",
                                          "bias: {normal: 1 mg, assumed: true}",
                                          "bias: {normal: 1 mg, source: other}" };
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        char text[256];
        snprintf(text, sizeof text, "sensor: x\nsources: {a: b}\naccel: {model: linear, %s}\n",
                 broken[i]);
        schuler_diagnostics d = { 0 };
        schuler_reading r = { .arena = schuler_arena_create(), .d = &d };
        schuler_document *doc = NULL;
        schuler_part part = { 0 };
        assert_int_equal(schuler_document_parse(&doc, "x", text, strlen(text), &d), SCHULER_OK);
        schuler_part_read(&r, doc, "x", true, &part);
        assert_int_equal(d.errors, 1);
        schuler_document_free(doc);
        schuler_arena_free(r.arena);
        schuler_diagnostics_free(&d);
    }
}

/* Figures in SI as the collected sheets have them, to six digits. A floor of the Allan deviation is
 * sqrt(2 ln 2/pi) of the flicker coefficient that it becomes. */
static void figures_are_those_that_were_collected(void **state)
{
    (void)state;
    enum { A = SCHULER_ACCEL, G = SCHULER_GYRO };
    static const struct {
        const char *part;
        int instrument;
        const char *key;
        double si;
    } table[] = {
        { "adis16405", G, "angle_random_walk", 0.000581776 },
        { "adis16448", G, "bias", 0.00872665 },
        { "adis16448", G, "angle_random_walk", 0.000191986 },
        { "adis16448", G, "g_sensitivity", 2.66961e-05 },
        { "adis16448", G, "bias_temperature", 8.72665e-05 },
        { "adis16448", A, "bias", 0.196133 },
        { "adis16448", A, "velocity_random_walk", 0.00183333 },
        { "adis16448", A, "saturation", 176.52 },
        { "adxrs646", G, "angle_random_walk", 0.000174533 },
        { "adxrs646", G, "bias_instability", 5.81776e-05 / 0.66428247026796 },
        { "astrix-200", G, "angle_random_walk", 2.90888e-08 },
        { "bjtb20cj01", A, "saturation", 392.266 },
        { "cgys30cj3a", G, "angle_random_walk", 3.49066e-05 },
        { "hg1700-ag58", G, "bias", 4.84814e-06 },
        { "hg1700-ag58", A, "velocity_random_walk", 0.0003302 },
        { "hg4930-a", G, "bias", 9.69627e-05 },
        { "hg4930-a", A, "scale_factor", 1000e-6 },
        { "hg4930-c", G, "bias", 3.3937e-05 },
        { "hg4930-c", G, "bias_instability", 1.21203e-06 / 0.66428247026796 },
        { "hg4930-c", G, "g_sensitivity", 2.47186e-07 },
        { "hg4930-c", A, "bias", 0.0166713 },
        { "hg4930-c", A, "velocity_random_walk", 0.0005 },
        { "imx-5", G, "bias", 0.00523599 },
        { "imx-5", A, "velocity_random_walk", 0.000333333 },
        { "jdsj25tk01-01", A, "K0", 9.80665e-05 },
        { "jdsj25tk01-01", A, "K1", 10e-6 },
        { "ln-100", G, "bias", 1.45444e-08 },
        { "ln-100", G, "angle_random_walk", 2.90888e-07 },
        { "ln-100", A, "gauss_markov", 9.80665e-05 },
        { "ltm210s1b", G, "bias", 1.21203e-06 },
        { "mmimu", G, "gauss_markov", 2.42407e-05 },
        { "mpu-9250", A, "scale_temperature", 260e-6 },
        { "mpu-9250", G, "bias", 0.523599 },
        { "ms1010", A, "bias", 0.011768 },
        { "ms1010", A, "misalignment", 0.01 },
        { "mti-300", A, "bias_instability", 0.0001471 / 0.66428247026796 },
        { "mti-300", A, "velocity_random_walk", 0.000588399 / 1.4142135623731 },
        { "openimu300ri", A, "bias", 0.0490333 },
        { "sd1521-025", A, "bias", 0.980665 },
        { "stim210", G, "bias", 4.84814e-05 },
        { "stim300-80g", A, "bias", 0.11768 },
        { "uins-3", A, "bias", 0.4 },
        { "uins-3", G, "bandwidth", 250.0 },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        schuler_part *part = part_of(table[i].part);
        const schuler_value *v =
            value_of(&part->imu, (schuler_instrument)table[i].instrument, table[i].key);
        assert_true(v->given);
        CHECK_REL(v->a[0], table[i].si, 5e-6);
        schuler_part_free(part);
    }
}

/* Table 1 of the paper, row by row: range g, bandwidth Hz, density ug/sqrt(Hz), bias % of span, scale
 * factor %, cross axis %, misalignment rad. */
static void the_paper_is_as_it_was_printed(void **state)
{
    (void)state;
    static const struct {
        const char *part;
        double R, BW, v, B, K, k, N;
    } table[10] = {
        { "paper-adxl321", 18, 2500, 320, 1.7, 10, 2, 0.0175 },
        { "paper-adxl78", 35, 400, 1100, 2, 5, 5, 0.0175 },
        { "paper-cxl25lp1", 25, 100, 1000, 2, 5, 5, 0.035 },
        { "paper-ioa", 10, 100, 300, 2, 5, 3, 0.01 },
        { "paper-foa", 20, 100, 120, 2, 5, 3, 0.01 },
        { "paper-qa750", 30, 500, 70, 0.027, 2, 0, 0.007 },
        { "paper-qa3000-030", 60, 500, 70, 0.0067, 2, 0, 0.001 },
        { "paper-a3022-050-p", 20, 1000, 350, 4.2, 5, 3, 0 },
        { "paper-s1210l-025", 25, 1000, 158, 2, 2, 3, 0 },
        { "paper-s1221x-025", 25, 1500, 25, 2, 2, 3, 0 },
    };
    for (int i = 0; i < 10; i++) {
        schuler_part *part = part_of(table[i].part);
        const schuler_imu *imu = &part->imu;
        const schuler_value *v = value_of(imu, SCHULER_ACCEL, "bias_of_span");
        CHECK_REL(value_of(imu, SCHULER_ACCEL, "range")->a[0], table[i].R * g, 1e-14);
        CHECK_REL(value_of(imu, SCHULER_ACCEL, "bandwidth")->a[0], table[i].BW, 1e-14);
        assert_true(v->per_unit && v->draw == SCHULER_DRAW_UNIFORM);
        CHECK_REL(v->b[0], 1e-2 * table[i].B, 1e-14);
        CHECK_REL(-v->a[0], 1e-2 * table[i].B, 1e-14);
        v = value_of(imu, SCHULER_ACCEL, "scale_factor");
        assert_true(v->per_unit && v->draw == SCHULER_DRAW_UNIFORM);
        CHECK_REL(v->b[0], 1e-2 * table[i].K, 1e-14);
        v = value_of(imu, SCHULER_ACCEL, "cross_axis");
        CHECK_NEAR(v->a[0], 0.0, 0.0);
        CHECK_NEAR(v->b[0], 1e-2 * table[i].k, 1e-17);
        CHECK_NEAR(value_of(imu, SCHULER_ACCEL, "misalignment")->a[0], table[i].N, 1e-17);
        v = value_of(imu, SCHULER_ACCEL, "velocity_random_walk");
        assert_true(v->per_unit && v->draw == SCHULER_DRAW_UNIFORM);
        CHECK_REL(v->b[0] * sqrt(2.0), 1e-6 * table[i].v * g, 1e-14);
        CHECK_REL(v->a[0], 0.8 * v->b[0], 1e-14);
        schuler_part_free(part);
    }
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
    assert_non_null(strstr(d.items[1].message,
                           "no part '/no/where.yaml' in the catalog, and no such file; known: "));
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
        cmocka_unit_test(a_value_without_a_source_is_refused),
        cmocka_unit_test(figures_are_those_that_were_collected),
        cmocka_unit_test(the_paper_is_as_it_was_printed),
        cmocka_unit_test(the_figures_are_those_of_the_sheets),
        cmocka_unit_test(an_unknown_part_lists_what_there_is),
        cmocka_unit_test(a_part_file_is_checked_like_a_scenario),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

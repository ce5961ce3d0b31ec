/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/units.h"
#include <locale.h>
#include <stdio.h>
#include <string.h>

/* Each conversion is a few rounded operations on exactly given constants: 4 ulp. */
#define ULPS 1e-15

static const schuler_dim none = SCHULER_DIM_NONE, length = SCHULER_DIM_LENGTH,
                         time = SCHULER_DIM_TIME, frequency = SCHULER_DIM_FREQUENCY,
                         angle = SCHULER_DIM_ANGLE, rate = SCHULER_DIM_RATE,
                         speed = SCHULER_DIM_SPEED, accel = SCHULER_DIM_ACCEL,
                         arw = SCHULER_DIM_ARW, vrw = SCHULER_DIM_VRW, rrw = SCHULER_DIM_RRW,
                         accel_rw = SCHULER_DIM_ACCEL_RW, jerk = SCHULER_DIM_JERK,
                         temperature = SCHULER_DIM_TEMPERATURE;

/* Definitions: SI brochure; 1 ft = 0.3048 m, 1 nmi = 1852 m, 1 mi = 5280 ft, g = 9.80665 m/s^2, 1
 * Gal = 1 cm/s^2. */
static void every_unit_has_its_defined_value(void **state)
{
    (void)state;
    const double deg = 3.14159265358979323846 / 180.0;
    const struct {
        const char *unit;
        double si;
        schuler_dim dim;
    } table[] = {
        { "m", 1, length },
        { "km", 1000, length },
        { "cm", 0.01, length },
        { "mm", 0.001, length },
        { "um", 1e-6, length },
        { "\u00b5m", 1e-6, length },
        { "ft", 0.3048, length },
        { "in", 0.0254, length },
        { "nmi", 1852, length },
        { "NM", 1852, length },
        { "mi", 1609.344, length },
        { "s", 1, time },
        { "sec", 1, time },
        { "ms", 1e-3, time },
        { "us", 1e-6, time },
        { "min", 60, time },
        { "h", 3600, time },
        { "hr", 3600, time },
        { "hour", 3600, time },
        { "hours", 3600, time },
        { "day", 86400, time },
        { "days", 86400, time },
        { "Hz", 1, frequency },
        { "kHz", 1000, frequency },
        { "mHz", 1e-3, frequency },
        { "rad", 1, angle },
        { "mrad", 1e-3, angle },
        { "urad", 1e-6, angle },
        { "nrad", 1e-9, angle },
        { "deg", deg, angle },
        { "\u00b0", deg, angle },
        { "mdeg", deg / 1000, angle },
        { "arcmin", deg / 60, angle },
        { "arcsec", deg / 3600, angle },
        { "mas", deg / 3600000, angle },
        { "dps", deg, rate },
        { "dph", deg / 3600, rate },
        { "g", 9.80665, accel },
        { "mg", 9.80665e-3, accel },
        { "ug", 9.80665e-6, accel },
        { "\u00b5g", 9.80665e-6, accel },
        { "\u03bcg", 9.80665e-6, accel },
        { "ng", 9.80665e-9, accel },
        { "Gal", 0.01, accel },
        { "mGal", 1e-5, accel },
        { "uGal", 1e-8, accel },
        { "kt", 1852.0 / 3600, speed },
        { "kts", 1852.0 / 3600, speed },
        { "kn", 1852.0 / 3600, speed },
        { "mph", 1609.344 / 3600, speed },
        { "%", 0.01, none },
        { "ppm", 1e-6, none },
        { "ppb", 1e-9, none },
        { "K", 1, temperature },
        { "mK", 1e-3, temperature },
        { "degC", 1, temperature },
        { "\u00b0C", 1, temperature },
        { "m/s", 1, speed },
        { "km/h", 1 / 3.6, speed },
        { "nmi/h", 1852.0 / 3600, speed },
        { "m/s^2", 1, accel },
        { "m/s2", 1, accel },
        { "m/s\u00b2", 1, accel },
        { "m/s/s", 1, accel },
        { "m*s^-2", 1, accel },
        { "m/s^3", 1, jerk },
        { "m/s\u00b3", 1, jerk },
        { "1/s", 1, frequency },
        { "1/(1/Hz)", 1, frequency },
        { "deg/h", deg / 3600, rate },
        { "\u00b0/h", deg / 3600, rate },
        { "deg / h", deg / 3600, rate },
        { "rad/s", 1, rate },
        { "deg/sqrt(h)", deg / 60, arw },
        { "deg/rt(h)", deg / 60, arw },
        { "deg/rth", deg / 60, arw },
        { "deg/rthr", deg / 60, arw },
        { "\u00b0/\u221ah", deg / 60, arw },
        { "\u00b0/\u221a(h)", deg / 60, arw },
        { "deg/h^0.5", deg / 60, arw },
        { "deg*h^-0.5", deg / 60, arw },
        { "deg/h^(1/2)", deg / 60, arw },
        { "deg\u00b7h^-0.5", deg / 60, arw },
        { "deg/h/sqrt(Hz)", deg / 3600, arw },
        { "(deg/h)/rtHz", deg / 3600, arw },
        { "deg/s/\u221aHz", deg, arw },
        { "m/s/sqrt(h)", 1.0 / 60, vrw },
        { "ug/sqrt(Hz)", 9.80665e-6, vrw },
        { "ug/rtHz", 9.80665e-6, vrw },
        { "deg/h/sqrt(h)", deg / 3600 / 60, rrw },
        { "ug/sqrt(h)", 9.80665e-6 / 60, accel_rw },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        double si = 0.0;
        schuler_dim dim = { 0 };
        schuler_error err = { 0 };
        if (schuler_unit_parse(table[i].unit, &si, &dim, &err) != SCHULER_OK)
            fail_msg("%s: %s", table[i].unit, err.message);
        check_near_at(si, table[i].si, ULPS * table[i].si, table[i].unit, __FILE__, __LINE__);
        if (!schuler_dim_equal(dim, table[i].dim)) fail_msg("%s: wrong dimension", table[i].unit);
    }
}

/* The conversion table of the stochastic-error reference, section 1, all digits printed there. */
static void the_reference_conversions_hold(void **state)
{
    (void)state;
    const struct {
        const char *text;
        schuler_dim dim;
        double si, relative;
    } table[] = {
        { "1 deg/sqrt(h)", arw, 2.908882087e-4, 2e-10 },
        { "1 m/s/sqrt(h)", vrw, 1.0 / 60, ULPS },
        { "60 deg/h/sqrt(Hz)", arw, 2.908882087e-4, 2e-10 },     /* (deg/h)/rtHz = 1/60 deg/rth */
        { "1 deg/s/sqrt(Hz)", arw, 60 * 2.908882087e-4, 2e-10 }, /* (deg/s)/rtHz = 60 deg/rth  */
        { "1 ug/sqrt(Hz)", vrw, 9.80665e-6, ULPS },
        { "1 deg/h", rate, 4.848136811e-6, 2e-10 },
        { "1 deg/h/sqrt(h)", rrw, 8.080228e-8, 6e-8 },
        { "1 arcsec", angle, 4.848136811e-6, 2e-10 },
        { "10 ug/sqrt(Hz)", vrw, 9.80665e-5, ULPS },
        { "1699.5 ug/sqrt(Hz)", vrw, 1.0 / 60, 3e-5 }, /* five digits in the source */
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        double si = 0.0;
        assert_int_equal(schuler_quantity_parse(table[i].text, table[i].dim, &si, NULL), 0);
        check_near_at(si, table[i].si, table[i].relative * table[i].si, table[i].text, __FILE__,
                      __LINE__);
    }
}

static void numbers_are_read_exactly(void **state)
{
    (void)state;
    const struct {
        const char *text;
        double value;
    } table[] = {
        { "1 m", 1.0 },
        { "1m", 1.0 },
        { " -1.5  m ", -1.5 },
        { "+2 m", 2.0 },
        { ".5 m", 0.5 },
        { "5. m", 5.0 },
        { "1e3 m", 1e3 },
        { "1E-3m", 1e-3 },
        { "012 m", 12.0 },
        { "1e+2 m", 100.0 },
        { "-0 m", -0.0 },
        { "0.1 m", 0.1 },
        { "6378137.0 m", 6378137.0 },
        { "9007199254740993 m", 9007199254740992.0 },
        { "0.30000000000000004 m", 0.30000000000000004 },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        double si = 0.0;
        assert_int_equal(schuler_quantity_parse(table[i].text, length, &si, NULL), SCHULER_OK);
        assert_memory_equal(&si, &table[i].value, sizeof si);
    }
    double si;
    assert_int_equal(schuler_quantity_parse("1e-4", none, &si, NULL), SCHULER_OK);
    CHECK_NEAR(si, 1e-4, 0.0);
}

static void the_locale_does_not_matter(void **state)
{
    (void)state;
    const char *const names[] = { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE" };
    const char *set = NULL;
    for (size_t i = 0; i < 4 && !set; i++) set = setlocale(LC_ALL, names[i]);
    double si = 0.0;
    assert_int_equal(schuler_quantity_parse("1.5 m", length, &si, NULL), SCHULER_OK);
    CHECK_NEAR(si, 1.5, 0.0);
    setlocale(LC_ALL, "C");
    if (!set) print_message("no locale with a decimal comma is installed\n");
}

static void mistakes_say_what_and_where(void **state)
{
    (void)state;
    const struct {
        const char *text;
        schuler_dim dim;
        const char *message;
        int column, width;
    } table[] = {
        { "50", accel, "unit missing; write for example '50 ug'", 1, 2 },
        { "0", angle, "unit missing; write for example '0 deg'", 1, 1 },
        { "100 deg", speed, "'deg' is a unit of angle, but speed is expected (such as '100 m/s')",
          5, 3 },
        { "5 kg", accel,
          "'kg' is of another dimension, but acceleration is expected (such as '5 ug')", 3, 2 },
        { "5 hz", frequency, "unknown unit 'hz'; did you mean 'Hz'?", 3, 2 },
        { "5 degg/h", rate, "unknown unit 'degg'; did you mean 'deg'?", 3, 4 },
        { "5 furlong", length, "unknown unit 'furlong'", 3, 7 },
        { "5 deg/fortnight", rate, "unknown unit 'fortnight'", 7, 9 },
        { "5 \u00b5x", length, "unknown unit '\u00b5x'", 3, 2 },
        { "fast", speed, "'fast' is not a number with a unit, such as '100 m/s'", 1, 4 },
        { "", speed, "value missing; write for example '100 m/s'", 1, 0 },
        { "nan m", length, "'nan m' is not a number with a unit, such as '100 m'", 1, 5 },
        { "inf m", length, "'inf m' is not a number with a unit, such as '100 m'", 1, 5 },
        { "-inf m", length, "'-inf m' is not a number with a unit, such as '100 m'", 1, 6 },
        { "0x10 m", length, "unknown unit 'x'", 2, 1 },
        { "1e999 m", length, "the number 1e999 is out of range", 1, 5 },
        { "1e-999 m", length, "the number 1e-999 is out of range", 1, 6 },
        { "1e308 km", length, "'1e308 km' is out of range", 1, 8 },
        { "1e-307 ppb*ppb", none, "'1e-307 ppb*ppb' is out of range", 1, 14 },
        { "0,5 deg", angle, "write the decimal mark as a point, for example '1.5'", 1, 1 },
        { "5 deg/", rate, NULL, 0, 0 },
        { "5 deg/sqrt(h", arw, NULL, 0, 0 },
        { "5 sqrt(m)", length,
          "'sqrt(m)' is of another dimension, but length is expected (such as "
          "'5 m')",
          3, 7 },
        { "5 m^0.25", length, NULL, 3, 6 },
        { "5 m^99", length, NULL, 3, 4 },
        { "5 sqrt(sqrt(m))", length, NULL, 0, 0 },
        { "5 m 6", length, "'6' does not belong to the unit", 5, 1 },
        { "5 m s", speed, "'s' does not belong to the unit", 5, 1 },
        { "5 ppm", length, "'ppm' has no dimension, but length is expected (such as '5 m')", 3, 3 },
        { "5 m", none, "'m' is a unit of length, but a plain number is expected (such as '5 ppm')",
          3, 1 },
        { "\u00b11 mg", accel,
          "'\u00b11 mg': write {uniform: 50 ug} for limits or {normal: 50 ug} for 1 sigma", 1, 5 },
        { "1 Hz", time, "'Hz' is a unit of frequency, but time is expected (such as '1 s')", 3, 2 },
        { "5 deg/h", frequency,
          "'deg/h' is a unit of angular rate, but frequency is expected (such as '5 Hz')", 3, 5 },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        schuler_error err = { 0 };
        double si = 77.0;
        if (schuler_quantity_parse(table[i].text, table[i].dim, &si, &err) != SCHULER_ERR_INPUT)
            fail_msg("'%s' was taken", table[i].text);
        CHECK_NEAR(si, 77.0, 0.0);
        if (table[i].message) assert_string_equal(err.message, table[i].message);
        if (table[i].column == 0) continue;
        assert_int_equal(err.place.column, table[i].column);
        assert_int_equal(err.place.width, table[i].width);
        assert_int_equal(schuler_quantity_parse(table[i].text, table[i].dim, &si, NULL), 10);
    }
}

static void hostile_units_are_refused_without_harm(void **state)
{
    (void)state;
    char text[4096];
    schuler_dim dim;
    double si;
    const char *const pieces[] = {
        "(", "sqrt(", "\u221a", "m*", "m/", "1/", "m^", "((m)", "\u00b5"
    };
    for (size_t i = 0; i < sizeof pieces / sizeof pieces[0]; i++) {
        text[0] = '\0';
        for (int k = 0; k < 400; k++) strcat(text, pieces[i]);
        assert_int_equal(schuler_unit_parse(text, &si, &dim, NULL), SCHULER_ERR_INPUT);
    }
    /* A fourth root has no half exponent to go into; dropped, it would pass as a plain number. */
    assert_int_equal(schuler_unit_parse("sqrt(sqrt(m))", &si, &dim, NULL), SCHULER_ERR_INPUT);
    /* Dimensions that cancel while the value runs away. */
    text[0] = '\0';
    for (int k = 0; k < 110; k++) strcat(text, k > 0 ? "*km/mm" : "km/mm");
    assert_int_equal(schuler_unit_parse(text, &si, &dim, NULL), SCHULER_ERR_INPUT);
}

static void dimensions_have_names_and_examples(void **state)
{
    (void)state;
    const char *example;
    assert_string_equal(schuler_dim_name(rate, &example), "angular rate");
    assert_string_equal(example, "deg/h");
    assert_string_equal(schuler_dim_name(speed, NULL), "speed");
    assert_string_equal(schuler_dim_name((schuler_dim){ .length2 = 7 }, &example),
                        "another quantity");
    assert_string_equal(example, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unit_has_its_defined_value),
        cmocka_unit_test(the_reference_conversions_hold),
        cmocka_unit_test(numbers_are_read_exactly),
        cmocka_unit_test(the_locale_does_not_matter),
        cmocka_unit_test(mistakes_say_what_and_where),
        cmocka_unit_test(hostile_units_are_refused_without_harm),
        cmocka_unit_test(dimensions_have_names_and_examples),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

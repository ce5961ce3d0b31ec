/* SPDX-License-Identifier: MIT */
/* The fast reader of numbers gives what strtod gives, bit for bit. */
#include "check.h"
#include "scenarios/decimal.h"
#include "scenarios/digits.h"
#include "simulated_noise.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static locale_t c_locale;

static void same_as_strtod(const char *text)
{
    char *end;
    double got = -77.0;
    const double expected = strtod_l(text, &end, c_locale);
    const char *const after = schuler_decimal_read(text, c_locale, &got);
    if (after == end && memcmp(&got, &expected, sizeof got) == 0) return;
    print_error("'%s': %.17g and '%s' instead of %.17g and '%s'\n", text, got,
                after ? after : "nothing", expected, end);
    fail();
}

static void numbers_of_every_form_are_read(void **state)
{
    static const char *const texts[] = {
        "0",
        "-0",
        "+1",
        "1.",
        ".5",
        "-.5e1",
        "00012.500,",
        "1e5",
        "1E+05",
        "1e-5 ",
        "123456789012345678",
        "9007199254740993",
        "9007199254740992.9999999",
        "18446744073709551615",
        "18446744073709551616",
        "99999999999999999999",
        "1e27",
        "1e28",
        "1e-27",
        "1e-28",
        "1e308",
        "1e309",
        "-1e999",
        "4.9e-324",
        "2.2250738585072011e-308",
        "1e-400",
        "0e999999999999",
        "0.000000000000000000000000000001",
        "0000000000000000000000000000001.5",
        "1e000000000000000000005",
        "8.5070591730234616e37",
        "179769313486231580793e289",
        "3.0000000000000000000000000000000001\n",
        "5e22",
        "1e23",
        "7e-23",
        "1e54",
        "1e55",
        "1e-54",
        "1e-55",
        "1.2649803080022615e-24",
        "9999999999999999999e-54",
    };
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) same_as_strtod(texts[i]);
}

static void seventeen_digits_come_back(void **state)
{
    noise_source s = { .state = 1 };
    (void)state;
    for (int i = 0; i < 200000; i++) {
        char text[64];
        const double x = noise_normal(&s) * pow(10.0, 90.0 * noise_uniform(&s) - 45.0);
        double got;
        schuler_digits(text, x);
        assert_non_null(schuler_decimal_read(text, c_locale, &got));
        assert_memory_equal(&got, &x, sizeof x);
        snprintf(text, sizeof text, "%.*g", 1 + i % 19, x);
        same_as_strtod(text);
    }
}

/* Decimal numbers half way between two doubles, and one digit to either side. */
static void halves_are_rounded_to_even(void **state)
{
    noise_source s = { .state = 2 };
    (void)state;
    for (int i = 0; i < 20000; i++) {
        char text[64];
        const unsigned long long whole =
            (1ull << 53) + 2 * (unsigned long long)(noise_uniform(&s) * 0x1p52) + 1;
        for (int off = -1; off <= 1;
             off++) { /* whole lies between doubles: they are 2 apart there */
            snprintf(text, sizeof text, "%llu%s", whole + (unsigned long long)(off < 0 ? -1 : 0),
                     off < 0   ? ".99"
                     : off > 0 ? ".01"
                               : "");
            same_as_strtod(text);
        }
    }
}

static void what_is_no_number_is_not_read(void **state)
{
    static const char *const texts[] = { "",    "-",   "+",  ".",  "e5", "-.e3",
                                         "nan", "inf", "x1", " 1", ",1", "--1" };
    double value;
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        assert_null(schuler_decimal_read(texts[i], c_locale, &value));
    /* What follows is left to the caller. */
    assert_string_equal(schuler_decimal_read("0x10", c_locale, &value), "x10");
    assert_string_equal(schuler_decimal_read("1e", c_locale, &value), "e");
    assert_string_equal(schuler_decimal_read("1e+", c_locale, &value), "e+");
    assert_string_equal(schuler_decimal_read("1.2.3", c_locale, &value), ".3");
    assert_string_equal(schuler_decimal_read("1,5", c_locale, &value), ",5");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_every_form_are_read),
        cmocka_unit_test(seventeen_digits_come_back),
        cmocka_unit_test(halves_are_rounded_to_even),
        cmocka_unit_test(what_is_no_number_is_not_read),
    };
    c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c_locale) return 1;
    const int failures = cmocka_run_group_tests(tests, NULL, NULL);
    freelocale(c_locale);
    return failures;
}

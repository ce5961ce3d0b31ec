/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/random.h"
#include "scenarios/digits.h"
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* printf's own 17 digits are correctly rounded in glibc, so the text must be the same, always. */
static void check_as_printf(double x)
{
    char wanted[64], got[SCHULER_DIGITS_MAX];
    snprintf(wanted, sizeof(wanted), "%.17g", x);
    const size_t length = schuler_digits(got, x);
    if (strcmp(got, wanted) != 0) {
        print_error("%a: '%s' instead of '%s'\n", x, got, wanted);
        fail();
    }
    assert_int_equal(length, strlen(got));
}

static void numbers_come_out_as_printf_writes_them(void **state)
{
    (void)state;
    static const double known[] = {
        0.0,
        1.0,
        -1.0,
        0.1,
        0.5,
        1e-4,
        9.9999999999999991e-5,
        1e-5,
        123456.0,
        1e15,
        1e16,
        1e17,
        1e18,
        1e22,
        1e23,
        9.999999999999999e22,
        1e100,
        DBL_MAX,
        DBL_MIN,
        5e-324,
        1e-11,
        1e-12,
        1e-27,
        1e-300,
        0.01,
        2.0 / 3.0,
        99.999999999999986,
        9007199254740992.0,
        9007199254740993.0,
        99999999999999984.0,
        0.099999999999999992,
    };
    for (size_t i = 0; i < sizeof(known) / sizeof(known[0]); i++) {
        check_as_printf(known[i]);
        check_as_printf(-known[i]);
    }
}

/* Sizes that data files hold, and any bits at all. */
static void random_numbers_come_out_as_printf_writes_them(void **state)
{
    (void)state;
    for (uint64_t n = 0; n < 100000; n++) {
        const uint64_t counter[2] = { n, 0 }, key[2] = { 1, 2 };
        uint64_t bits[2];
        schuler_threefry2x64(counter, key, bits);
        const double fraction = (double)(bits[0] >> 11) / 9007199254740992.0;
        check_as_printf((fraction - 0.5) * pow(10.0, (double)(bits[1] % 64) - 44.0));
        double any;
        memcpy(&any, &bits[1], sizeof(any));
        if (isfinite(any)) check_as_printf(any);
    }
}

/* Halfway cases: a power of two below 2^57 with more than 17 digits ends in 5 and rounds to even.
 */
static void ties_go_to_even(void **state)
{
    (void)state;
    for (int e = -130; e <= 60; e++)
        for (int m = 1; m < 200; m += 2) check_as_printf(ldexp((double)m, e));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_come_out_as_printf_writes_them),
        cmocka_unit_test(random_numbers_come_out_as_printf_writes_them),
        cmocka_unit_test(ties_go_to_even),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

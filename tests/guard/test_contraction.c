/* SPDX-License-Identifier: MIT */
/* Compiled with the project's flags and with the fused instruction allowed: it must not be used. */
#include "check.h"

static void a_product_is_rounded_before_it_is_added(void **state)
{
    (void)state;
#ifdef __x86_64__
    if (!__builtin_cpu_supports("fma")) skip();
#endif
    /* (1 + e)(1 - e) - 1 = -e^2 exactly; the product alone rounds to 1, since e^2 = 2^-60. */
    volatile double a = 1.0 + 0x1p-30, b = 1.0 - 0x1p-30, c = -1.0;
    CHECK_NEAR(a * b + c, 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_product_is_rounded_before_it_is_added) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

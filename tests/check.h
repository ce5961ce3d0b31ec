/* SPDX-License-Identifier: MIT */
/* cmocka plus comparisons of doubles that say what they saw. */
#ifndef SCHULER_TESTS_CHECK_H
#define SCHULER_TESTS_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
/* cmocka must come after the four above. */
#include <cmocka.h>

static inline void check_near_at(double got, double expected, double tolerance, const char *what,
                                 const char *file, int line)
{
    const double difference = got - expected;
    if (fabs(difference) <= tolerance) return; /* also false for NaN */
    print_error("%s: got %.17g, expected %.17g, difference %.3g, tolerance %.3g\n", what, got,
                expected, difference, tolerance);
    _fail(file, line);
}

/* Absolute tolerance. The message names the expression. */
#define CHECK_NEAR(got, expected, tolerance)                                                       \
    check_near_at((got), (expected), (tolerance), #got, __FILE__, __LINE__)
/* Relative to the expected value. */
#define CHECK_REL(got, expected, relative)                                                         \
    check_near_at((got), (expected), fabs(expected) * (relative), #got, __FILE__, __LINE__)

#endif

/* SPDX-License-Identifier: MIT */
#include "scenarios/decimal.h"
#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum { DIGITS_MAX = 19, EXPONENT_MAX = 27, EXPONENT_LIMIT = 100000 };

typedef struct {
    uint64_t digits; /* all of them as one number                             */
    int count;       /* of them, from the first that is not zero              */
    int exponent;    /* of ten, to multiply it with                           */
    bool negative;
} decimal;

static inline bool is_digit(char c)
{
    return (unsigned)(c - '0') < 10;
}

/* NULL when there is no digit. The digits are only right up to DIGITS_MAX of them. */
static const char *scan(const char *p, decimal *d)
{
    *d = (decimal){ .negative = *p == '-' };
    if (*p == '-' || *p == '+') p++;
    const char *const first = p;
    uint64_t digits = 0;
    while (is_digit(*p)) digits = 10 * digits + (uint64_t)(*p++ - '0');
    int written = (int)(p - first < EXPONENT_LIMIT ? p - first : EXPONENT_LIMIT);
    const char *lead = first;
    if (*p == '.') {
        const char *const point = ++p;
        while (is_digit(*p)) digits = 10 * digits + (uint64_t)(*p++ - '0');
        const int after = (int)(p - point < EXPONENT_LIMIT ? p - point : EXPONENT_LIMIT);
        d->exponent = -after;
        written += after;
    }
    if (written == 0) return NULL;
    if (written > DIGITS_MAX) /* zeros in front do not count */
        for (; lead < p && (*lead == '0' || *lead == '.'); lead++) written -= *lead == '0';
    d->count = written;
    d->digits = digits;
    if (*p == 'e' || *p == 'E') {
        const char *q = p + 1;
        const bool down = *q == '-';
        if (*q == '-' || *q == '+') q++;
        if (!is_digit(*q)) return p; /* the caller finds an 'e' behind the number */
        int exponent = 0;
        for (; is_digit(*q); q++)
            if (exponent < EXPONENT_LIMIT) exponent = 10 * exponent + (*q - '0');
        d->exponent += down ? -exponent : exponent;
        p = q;
    }
    return p;
}

/* With 64 bits of significand the digits and powers of ten up to 10^27 are exact, so that one rounding
 * is left, to 64 bits, and two for powers up to 10^54: within 2^-62 and 2^-61 of the number. Rounding
 * again to 53 is right unless that has gone to, or near, the middle between two doubles: then false. */
static bool scale(const decimal *d, double *value)
{
#if LDBL_MANT_DIG >= 64
    static const long double power[EXPONENT_MAX + 1] = {
        1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,  1e7L,  1e8L,  1e9L,
        1e10L, 1e11L, 1e12L, 1e13L, 1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L,
        1e20L, 1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L,
    };
    const int size = d->exponent < 0 ? -d->exponent : d->exponent;
    if (d->count > DIGITS_MAX || size > 2 * EXPONENT_MAX) return false;
    const int first = size < EXPONENT_MAX ? size : EXPONENT_MAX;
    long double x = (long double)d->digits, around = 0x1p-62L;
    x = d->exponent < 0 ? x / power[first] : x * power[first];
    if (size > first) {
        x = d->exponent < 0 ? x / power[size - first] : x * power[size - first];
        around = 0x1p-61L;
    }
    const double below = (double)(x * (1.0L - around)), above = (double)(x * (1.0L + around));
    if (below != above) return false;
    *value = d->negative ? -below : below;
    return true;
#else
    (void)d;
    (void)value;
    return false;
#endif
}

const char *schuler_decimal_read(const char *text, locale_t c, double *value)
{
    decimal d;
    const char *const end = scan(text, &d);
    if (end && !scale(&d, value)) *value = strtod_l(text, NULL, c);
    return end;
}

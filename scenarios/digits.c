/* SPDX-License-Identifier: MIT */
#include "scenarios/digits.h"
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

__extension__ typedef unsigned __int128 wide;

enum { SIGNIFICANT = 17, HALF = 27, POWERS = 2 * HALF + 1 };

static const uint64_t LOWEST = 10000000000000000u;    /* 10^16: smallest number of 17 digits */
static const uint64_t TOO_MANY = 100000000000000000u; /* 10^17 */

static uint64_t power_of_five(int p)
{
    uint64_t five = 1;
    for (int i = 0; i < p; i++) five *= 5;
    return five;
}

/* round((high 2^64 + low) 2^-shift) to even. */
static uint64_t rounded(wide high, uint64_t low, int shift)
{
    const wide one = 1;
    const bool far = shift > 64; /* the point lies within high */
    const uint64_t whole =
        far ? (uint64_t)(high >> (shift - 64)) : (uint64_t)(((high << 64) | low) >> shift);
    const wide rest = far ? high & ((one << (shift - 64)) - 1) : low & ((one << shift) - 1);
    const wide half = one << (far ? shift - 65 : shift - 1);
    const bool above = rest > half || (rest == half && far && low > 0);
    return whole + (above || (rest == half && (whole & 1)) ? 1 : 0);
}

/* round(m 2^e 10^p) to even, exactly: m has 53 bits, 5^p at most 63 for each half of the powers, so the
 * product fits in 128 bits, or in 192. The caller sees to 0 <= p < POWERS and to a result below 10^18. */
static uint64_t scaled(uint64_t m, int e, int p)
{
    const int first = p < HALF ? p : HALF, shift = -(e + p);
    const wide product = (wide)m * power_of_five(first);
    if (shift <= 0) return (uint64_t)(product << -shift);
    if (p == first) return rounded(product >> 64, (uint64_t)product, shift);
    const uint64_t more = power_of_five(p - first);
    const wide low = (wide)(uint64_t)product * more;
    return rounded((product >> 64) * more + (low >> 64), (uint64_t)low, shift);
}

/* 17 digits and decimal exponent of a positive normal number, or false when it is out of reach. */
static bool shift_to_digits(double x, uint64_t *digits, int *exponent)
{
    int e;
    const uint64_t m = (uint64_t)ldexp(frexp(x, &e), 53);
    e -= 53;
    /* floor(log2 x) log10(2) is the exponent or one less: 78913/2^18 is log10(2) to 2e-6. */
    int d = (int)floor((double)(e + 52) * (78913.0 / 262144.0));
    for (;; d++) {
        const int p = SIGNIFICANT - 1 - d;
        if (p < 0 || p >= POWERS) return false;
        *digits = scaled(m, e, p);
        if (*digits < TOO_MANY) break;
    }
    *exponent = d;
    return *digits >= LOWEST;
}

static size_t put_exponent(char *text, int d)
{
    char *p = text;
    *p++ = 'e';
    *p++ = d < 0 ? '-' : '+';
    const int size = d < 0 ? -d : d; /* below 100 here */
    *p++ = (char)('0' + size / 10);
    *p++ = (char)('0' + size % 10);
    return (size_t)(p - text);
}

/* "%g": exponent form below 1e-4, no trailing zeros. d is below 17. */
static size_t lay_out(char *text, const char *digits, int count, int d)
{
    char *p = text;
    const bool scientific = d < -4;
    int before = scientific ? 1 : d + 1; /* digits in front of the point */
    if (before <= 0) {
        *p++ = '0';
        *p++ = '.';
        for (int i = before; i < 0; i++) *p++ = '0';
        memcpy(p, digits, (size_t)count);
        p += count;
    } else {
        for (int i = 0; i < before; i++) *p++ = i < count ? digits[i] : '0';
        if (count > before) {
            *p++ = '.';
            memcpy(p, digits + before, (size_t)(count - before));
            p += count - before;
        }
    }
    if (scientific) p += put_exponent(p, d);
    *p = '\0';
    return (size_t)(p - text);
}

/* Subnormal, tiny and huge numbers are rare in data files: printf does them. */
static size_t by_printf(char *text, double x)
{
    const int n = snprintf(text, SCHULER_DIGITS_MAX, "%.17g", x);
    for (char *p = text; *p; p++)
        if (*p == ',') *p = '.'; /* a locale's decimal comma */
    return n < 0 ? 0 : (size_t)n;
}

size_t schuler_digits(char *text, double x)
{
    const double size = fabs(x);
    uint64_t digits;
    int exponent;
    if (x == 0.0) {
        strcpy(text, signbit(x) ? "-0" : "0");
        return strlen(text);
    }
    if (!isnormal(x) || !shift_to_digits(size, &digits, &exponent)) return by_printf(text, x);
    char written[SIGNIFICANT];
    for (int i = SIGNIFICANT - 1; i >= 0; i--, digits /= 10) written[i] = (char)('0' + digits % 10);
    int count = SIGNIFICANT;
    while (count > 1 && written[count - 1] == '0') count--;
    size_t n = 0;
    if (x < 0.0) text[n++] = '-';
    return n + lay_out(text + n, written, count, exponent);
}

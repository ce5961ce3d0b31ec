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

/* clang-format off */
static const uint64_t power_of_five[HALF + 1] = {
    1, 5, 25, 125, 625, 3125, 15625, 78125, 390625, 1953125, 9765625, 48828125, 244140625,
    1220703125, 6103515625u, 30517578125u, 152587890625u, 762939453125u, 3814697265625u,
    19073486328125u, 95367431640625u, 476837158203125u, 2384185791015625u, 11920928955078125u,
    59604644775390625u, 298023223876953125u, 1490116119384765625u, 7450580596923828125u,
};
/* clang-format on */

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
    const wide product = (wide)m * power_of_five[first];
    if (shift <= 0) return (uint64_t)(product << -shift);
    if (p == first) return rounded(product >> 64, (uint64_t)product, shift);
    const uint64_t more = power_of_five[p - first];
    const wide low = (wide)(uint64_t)product * more;
    return rounded((product >> 64) * more + (low >> 64), (uint64_t)low, shift);
}

/* 17 digits and decimal exponent of a positive normal number, or false when it is out of reach. */
static bool shift_to_digits(double x, uint64_t *digits, int *exponent)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    const uint64_t m = (bits & ((1ull << 52) - 1)) | 1ull << 52;
    const int e = (int)(bits >> 52) - 1075; /* x = m 2^e */
    /* floor(log2 x) log10(2) is the exponent or one less: 78913/2^18 is log10(2) to 2e-6. */
    int d = ((e + 52) * 78913) >> 18;
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
    /* Two chains of divisions, side by side. */
    uint32_t high = (uint32_t)(digits / 100000000), low = (uint32_t)(digits % 100000000);
    for (int i = 0; i < 8; i++, high /= 10, low /= 10) {
        written[SIGNIFICANT - 1 - i] = (char)('0' + low % 10);
        written[SIGNIFICANT - 9 - i] = (char)('0' + high % 10);
    }
    written[0] = (char)('0' + high);
    int count = SIGNIFICANT;
    while (count > 1 && written[count - 1] == '0') count--;
    size_t n = 0;
    if (x < 0.0) text[n++] = '-';
    return n + lay_out(text + n, written, count, exponent);
}

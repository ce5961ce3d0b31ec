/* SPDX-License-Identifier: MIT */
/* The little that is needed of UTF-8: how long a character is, and how many there are. */
#ifndef SCHULER_CORE_UTF8_H
#define SCHULER_CORE_UTF8_H

#include <stddef.h>

/** Bytes of the character at s (1..4), or 0 when it is not valid UTF-8: a lone or missing
 * continuation byte, an overlong form, a surrogate, beyond U+10FFFF. Reads at most n bytes. */
static inline size_t schuler_utf8_length(const char *text, size_t n)
{
    const unsigned char *s = (const unsigned char *)text;
    if (n == 0) return 0;
    if (s[0] < 0x80) return 1;
    const size_t length = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
    if (s[0] < 0xc2 || s[0] > 0xf4 || n < length) return 0;
    for (size_t i = 1; i < length; i++)
        if ((s[i] & 0xc0) != 0x80) return 0;
    if (s[0] == 0xe0 && s[1] < 0xa0) return 0;
    if (s[0] == 0xed && s[1] > 0x9f) return 0;
    if (s[0] == 0xf0 && s[1] < 0x90) return 0;
    if (s[0] == 0xf4 && s[1] > 0x8f) return 0;
    return length;
}

/** Code point of a character of known length. */
static inline unsigned schuler_utf8_point(const char *text, size_t length)
{
    const unsigned char *s = (const unsigned char *)text;
    static const unsigned char lead[5] = { 0, 0x7f, 0x1f, 0x0f, 0x07 };
    unsigned point = s[0] & lead[length];
    for (size_t i = 1; i < length; i++) point = point << 6 | (s[i] & 0x3fU);
    return point;
}

/** Characters in the first n bytes of valid UTF-8. */
static inline int schuler_utf8_count(const char *text, size_t n)
{
    int count = 0;
    for (size_t i = 0; i < n; i++) count += ((unsigned char)text[i] & 0xc0) != 0x80;
    return count;
}

#endif

/* SPDX-License-Identifier: MIT */
/* Decimal numbers of data files, read fast and to the last bit. */
#ifndef SCHULER_SCENARIOS_DECIMAL_H
#define SCHULER_SCENARIOS_DECIMAL_H

#include <locale.h>

/** Read the number at the start of a text: sign, digits with or without a point, exponent. No blanks
 *  in front, no hexadecimal, no "inf" or "nan".
 *  Given      text    ends with any character that is no part of a number
 *             c       the C locale (numbers with unusual many digits go to strtod_l)
 *  Returned   value   the nearest double, as strtod gives it; infinite when it is too large
 *             the function returns the first character after the number, NULL when there is none */
const char *schuler_decimal_read(const char *text, locale_t c, double *value);

#endif

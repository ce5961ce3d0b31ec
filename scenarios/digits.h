/* SPDX-License-Identifier: MIT */
/* Doubles as text with 17 significant digits, fast: data files are mostly made of them. */
#ifndef SCHULER_SCENARIOS_DIGITS_H
#define SCHULER_SCENARIOS_DIGITS_H

#include "core/api.h"
#include <stddef.h>

SCHULER_BEGIN_C

enum { SCHULER_DIGITS_MAX = 32 }; /* room one number needs, with its NUL */

/** Write x as printf's "%.17g" does in the C locale, whatever the locale of the program.
 *  Given      x     any double
 *  Returned   text  SCHULER_DIGITS_MAX bytes, NUL-terminated; the function returns its length
 *  Errors     none */
SCHULER_API size_t schuler_digits(char *text, double x);

SCHULER_END_C

#endif

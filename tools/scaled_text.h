/* SPDX-License-Identifier: MIT */
/* A value as the user wrote it, times a factor. */
#ifndef SCHULER_TOOLS_SCALED_TEXT_H
#define SCHULER_TOOLS_SCALED_TEXT_H

#include <stddef.h>

/** "0.0035 deg/h 1σ" and 2 give "0.007 deg/h 1σ": every number of it that is no exponent and no count of
 *  sigmas, with three digits.
 *  Returned   out   cut when it is too long */
void scaled_text(const char *text, double factor, char *out, size_t size);

#endif

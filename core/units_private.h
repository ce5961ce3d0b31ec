/* SPDX-License-Identifier: MIT */
/* A quantity taken apart, for messages that speak of number and unit. Private to core. */
#ifndef SCHULER_CORE_UNITS_PRIVATE_H
#define SCHULER_CORE_UNITS_PRIVATE_H

#include "core/units.h"

typedef struct {
    double si;        /* number * unit_si                                                        */
    double unit_si;   /* value of one unit; 1 when there is none                                 */
    const char *unit; /* where the unit begins in the text; at its end when there is none        */
} schuler_quantity;

/** As schuler_quantity_parse. example: a quantity as one would write it here ("2 m/s^2"), its unit
 * is what messages propose; NULL = the usual one of the dimension. */
schuler_status schuler_quantity_read(const char *text, schuler_dim dim, const char *example,
                                     schuler_quantity *out, schuler_error *err);

/** Read a plain number at the start of text: decimal, independent of the locale, correctly rounded.
 *  Returned   value;  end  the first byte after it
 *  Errors     SCHULER_ERR_INPUT: none there, or too large or too small for a double */
schuler_status schuler_number_read(const char *text, double *value, const char **end,
                                   schuler_error *err);

/** First byte that is not a space or a tab. */
const char *schuler_skip_space(const char *text);

#endif

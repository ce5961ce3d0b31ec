/* SPDX-License-Identifier: MIT */
/* Strict reading of tables of numbers: one header line with exactly the expected names, then rows
 * of as many numbers. Streams, so memory does not grow with the file. A file whose name ends with .nc is
 * read as NetCDF: variables of those names, along one dimension; a place's line is then the row. */
#ifndef SCHULER_SCENARIOS_CSV_H
#define SCHULER_SCENARIOS_CSV_H

#include "core/error.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum { SCHULER_CSV_COLUMNS_MAX = 16, SCHULER_CSV_LINE_MAX = 1024 };

typedef struct schuler_csv schuler_csv;

/** Open a file and check its header.
 *  Given      path     borrowed, must outlive the reader; header  the names, comma-separated
 *  Returned   out      owned by the caller: schuler_csv_close
 *  Errors     SCHULER_ERR_FILE cannot be read; SCHULER_ERR_INPUT with place; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_csv_open(schuler_csv **out, const char *path,
                                                              const char *header,
                                                              schuler_error *err);
SCHULER_API void schuler_csv_close(schuler_csv *csv); /* NULL is fine */

/** The next row.
 *  Returned   values   one finite number per column
 *             got_row  0 at the end of the file
 *  Errors     as above; a wrong number of fields, an empty line, anything but a plain number */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_csv_next(schuler_csv *csv, double *values,
                                                              int *got_row, schuler_error *err);

/** Refuse a value of the row last read: fills err with the place of that column (counted from 0).
 */
SCHULER_API schuler_status schuler_csv_refuse(const schuler_csv *csv, int column,
                                              schuler_error *err, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/** The line of the row last read, from 1; the header is the first. Of NetCDF the row, from 1. */
SCHULER_API int schuler_csv_line(const schuler_csv *csv);

/** Part of the file that has been read, in [0, 1]; 0 when its size is not known. */
SCHULER_API double schuler_csv_fraction(const schuler_csv *csv);

SCHULER_END_C

#endif

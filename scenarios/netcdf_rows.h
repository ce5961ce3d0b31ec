/* SPDX-License-Identifier: MIT */
/* Rows of a NetCDF file: the variables of the expected names, all along one dimension. */
#ifndef SCHULER_SCENARIOS_NETCDF_ROWS_H
#define SCHULER_SCENARIOS_NETCDF_ROWS_H

#include "core/error.h"
#include <stdint.h>

typedef struct netcdf_rows netcdf_rows;

/** Open a file.
 *  Given      path    borrowed, must outlive the reader;  header  the names, comma-separated
 *  Returned   out     owned by the caller: netcdf_rows_close
 *  Errors     SCHULER_ERR_FILE, SCHULER_ERR_INPUT, SCHULER_ERR_MEMORY */
SCHULER_NODISCARD schuler_status netcdf_rows_open(netcdf_rows **out, const char *path,
                                                  const char *header, schuler_error *err);
void netcdf_rows_close(netcdf_rows *rows); /* NULL is fine */

/** The next row; *got = 0 at the end. Errors SCHULER_ERR_INPUT: a value that is not finite. */
SCHULER_NODISCARD schuler_status netcdf_rows_next(netcdf_rows *rows, double *values, int *got,
                                                  schuler_error *err);
int netcdf_rows_number(const netcdf_rows *rows); /* of the row last read, from 1 */
double netcdf_rows_fraction(const netcdf_rows *rows);

#endif

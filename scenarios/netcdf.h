/* SPDX-License-Identifier: MIT */
/* Tables of numbers as NetCDF-4 files: a variable for each column, with its unit, along the first one.
 * The NetCDF library is loaded when the first file is opened, so that nothing else waits for it or needs
 * it. */
#ifndef SCHULER_SCENARIOS_NETCDF_H
#define SCHULER_SCENARIOS_NETCDF_H

#include "core/error.h"
#include "scenarios/data_tables.h"
#include <stddef.h>
#include <stdint.h>

SCHULER_BEGIN_C

typedef struct schuler_netcdf schuler_netcdf;

/* Of the whole file. */
typedef struct {
    const char *name;
    const char *text; /* NULL: the number; any bytes but NUL */
    uint64_t number;
} schuler_netcdf_attribute;

/** Does a path ask for such a file? 1 when it ends with ".nc". */
SCHULER_API int schuler_netcdf_named(const char *path);

/** Start a file.
 *  Given      path        borrowed until it is closed, its name stays in err; replaced when it exists
 *             table       borrowed; its title and columns are described in the file
 *             rows        how many there will be
 *             attributes  count of them
 *  Returned   out         owned by the caller: schuler_netcdf_close
 *  Errors     SCHULER_ERR_FILE, also when there is no NetCDF library; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_netcdf_create(
    schuler_netcdf **out, const char *path, const schuler_table *table, int64_t rows,
    const schuler_netcdf_attribute *attributes, int count, schuler_error *err);

/** The next row, one number for each column. An error is kept for schuler_netcdf_close; _failed tells. */
SCHULER_API void schuler_netcdf_put(schuler_netcdf *file, const double *values);
SCHULER_API int schuler_netcdf_failed(const schuler_netcdf *file);

/** Write what is left, close and free; NULL is fine.
 *  Errors     SCHULER_ERR_FILE the first thing that went wrong, or not as many rows as announced */
SCHULER_API schuler_status schuler_netcdf_close(schuler_netcdf *file, schuler_error *err);

SCHULER_END_C

#endif

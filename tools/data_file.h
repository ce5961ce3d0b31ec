/* SPDX-License-Identifier: MIT */
/* A data file being written, CSV or, when its name ends with .nc, NetCDF; complete or absent. */
#ifndef SCHULER_TOOLS_DATA_FILE_H
#define SCHULER_TOOLS_DATA_FILE_H

#include "scenarios/netcdf.h"
#include "tools/outfile.h"

/* Zero-initialised = none; all functions are fine with that. */
typedef struct {
    const schuler_table *table;
    outfile file;
    schuler_netcdf *netcdf; /* NULL: CSV */
} data_file;

/** Start a file. Errors are said; EXIT_DONE, EXIT_INPUT or EXIT_FAILED.
 *  Given      rows, attributes   for NetCDF, see schuler_netcdf_create */
exit_code data_file_open(data_file *d, const char *path, const schuler_table *table, int64_t rows,
                         const schuler_netcdf_attribute *attributes, int count);
/** One number for each column. Errors are kept. */
void data_file_put(data_file *d, const double *values);
bool data_file_failed(const data_file *d);

/* As outfile_complete, outfile_publish, outfile_drop. */
exit_code data_file_complete(data_file *d);
exit_code data_file_publish(data_file *d);
void data_file_drop(data_file *d);

#endif

/* SPDX-License-Identifier: MIT */
/* The files of `run -o DIR`. */
#ifndef SCHULER_TOOLS_RESULT_DIRECTORY_H
#define SCHULER_TOOLS_RESULT_DIRECTORY_H

#include "scenarios/covariance.h"
#include "tools/outfile.h"
#include "tools/simulation_arguments.h"

/** Write them all and publish the directory. Says errors.
 *  Given      dir, errors   as opened; errors holds its rows already
 *  Returned   netcdf        is there a result.nc? Not without the NetCDF library, which is said */
exit_code result_directory_write(outdir *dir, outfile *errors, const schuler_result *result,
                                 const schuler_covariance *linear, const simulation_arguments *a,
                                 bool *netcdf);

#endif

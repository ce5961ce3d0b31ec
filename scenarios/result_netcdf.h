/* SPDX-License-Identifier: MIT */
/* The result of a simulation as a NetCDF-4 file, complete in itself: what each run of each source came to,
 * the error over time, the true track, and the scenario's text.
 *
 * Dimensions: source (the budget's rows, then all, then none), run, time (the report times), track (points
 * of the true path) and letter. Where all runs of a source are the same, each has its figures. */
#ifndef SCHULER_SCENARIOS_RESULT_NETCDF_H
#define SCHULER_SCENARIOS_RESULT_NETCDF_H

#include "scenarios/covariance.h"

SCHULER_BEGIN_C

#define SCHULER_RESULT_FORMAT "schuler-result-1"
enum { SCHULER_RESULT_TRACK_MAX = 2000 }; /* points of the track */

/** Can such files be written and read here?
 *  Errors     SCHULER_ERR_FILE: there is no NetCDF library, err says which one is needed */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_result_netcdf_usable(schuler_error *err);

/** Write one. The same inputs give the same bytes: nothing in it depends on the hour, on threads or on the
 *  instruction set.
 *  Given      path      replaced when it exists; what is there after an error is of no use
 *             linear    the same scenario's covariance, or NULL: no figures of it
 *             command   what made the result, for provenance
 *  Errors     SCHULER_ERR_FILE, also when there is no NetCDF library; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_result_netcdf_write(
    const char *path, const schuler_result *result, const schuler_covariance *linear,
    const char *command, schuler_error *err);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* A result read back from the file that scenarios/result_netcdf.h writes. */
#ifndef SCHULER_SCENARIOS_RESULT_FILE_H
#define SCHULER_SCENARIOS_RESULT_FILE_H

#include "core/error.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum { SCHULER_RESULT_NAME_MAX = 64, SCHULER_RESULT_SOURCES_MAX = 1000 };

typedef struct {
    /* As in the file: perhaps not UTF-8 when another program wrote it. */
    char *scenario_name, *scenario_sha256, *version;
    size_t source_count, run_count, track_count; /* each at least 1; track_count at least 2 */
    char (*names)[SCHULER_RESULT_NAME_MAX];      /* of the sources; "all" and "none" are the last */
    double *end_m, *max_m, *slope_mps,
        *velocity_rms_mps;                /* [source][run], finite                  */
    double *lat_deg, *lon_deg, *height_m; /* of the track: in +-90, +-180; first to last */
} schuler_result_file;

/** Read one.
 *  Returned   out   to be freed by schuler_result_file_free; all zero after an error
 *  Errors     SCHULER_ERR_FILE there is no NetCDF library; SCHULER_ERR_INPUT it cannot be read, is no
 *             result, or holds what no result holds; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_result_file_read(schuler_result_file *out,
                                                                      const char *path,
                                                                      schuler_error *err);
SCHULER_API void schuler_result_file_free(schuler_result_file *file); /* all zero is fine */

/** The number of a source; -1 when there is none of that name. */
SCHULER_API int schuler_result_file_find(const schuler_result_file *file, const char *name);

SCHULER_END_C

#endif

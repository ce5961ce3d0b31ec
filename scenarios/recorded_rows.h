/* SPDX-License-Identifier: MIT */
/* The file of a recorded trajectory. */
#ifndef SCHULER_SCENARIOS_RECORDED_ROWS_H
#define SCHULER_SCENARIOS_RECORDED_ROWS_H

#include "core/trajectory.h"

/** Read all rows.
 *  Given      path   borrowed, must outlive out
 *  Returned   out    items owned by the caller: free
 *  Errors     SCHULER_ERR_FILE, SCHULER_ERR_INPUT with place, SCHULER_ERR_MEMORY; in d */
SCHULER_NODISCARD schuler_status schuler_recorded_rows(schuler_recorded_samples *out,
                                                       const char *path, schuler_diagnostics *d);

#endif

/* SPDX-License-Identifier: MIT */
/* The files that schuler truth writes. */
#ifndef SCHULER_TOOLS_TRUTH_FILES_H
#define SCHULER_TOOLS_TRUTH_FILES_H

#include "core/truth.h"
#include "scenarios/scenario.h"
#include "tools/verbs.h"
#include <stdbool.h>

typedef struct {
    const char *imu, *reference; /* paths; NULL: not wanted                              */
    bool rates;                  /* the IMU's file holds rates at the rows' times        */
    int64_t every;               /* steps between the reference's rows; the last has one */
    bool quiet;
    const char *command; /* as given, for provenance                                */
} truth_files;

/** Write them; neither appears unless both are whole. Says errors. */
exit_code truth_files_write(const schuler_truth *truth, const schuler_scenario *scenario,
                            const truth_files *wanted);

/** A command line as a shell reads it; to be freed, NULL when out of memory. */
char *truth_files_command(int argc, char *const *argv);

#endif

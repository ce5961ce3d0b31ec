/* SPDX-License-Identifier: MIT */
/* errors.csv row by row: lanes of equal length, source by source, run by run. */
#ifndef SCHULER_TOOLS_REPORT_LANES_H
#define SCHULER_TOOLS_REPORT_LANES_H

#include "tools/verbs.h"
#include <stddef.h>
#include <stdio.h>

typedef struct {
    const char *path;
    FILE *file;
    char *text; /* the line that was read last */
    size_t room, line;
    char prefix[96]; /* "gyro.bias,17," of the lane        */
    size_t row_count;
    char **times; /* as they are written in the first lane */
} report_lanes;

/** Open the file, check its head, learn the times from the first lane (of `id`). Says errors. */
exit_code report_lanes_open(report_lanes *l, const char *path, const char *id);
/** All rows of one lane; of those whose number is in `keep`, north and east in m. Says errors. */
exit_code report_lanes_read(report_lanes *l, const char *id, int run, const size_t *keep,
                            size_t count, double *north_m, double *east_m);
/** Whether the next lane is this one. */
int report_lanes_next_is(report_lanes *l, const char *id, int run);
/** Nothing may follow. Says errors. */
exit_code report_lanes_end(report_lanes *l);
void report_lanes_close(report_lanes *l);

#endif

/* SPDX-License-Identifier: MIT */
/* Parts of the catalog and sensor files, for verbs that show them. */
#ifndef SCHULER_TOOLS_SENSOR_PART_H
#define SCHULER_TOOLS_SENSOR_PART_H

#include "scenarios/scenario.h"
#include "tools/verbs.h"
#include <stdio.h>

/** Load by catalog name or file; what is neither gets the nearest name. Says errors and warnings.
 *  Returned   *part, to be freed, when EXIT_DONE */
exit_code sensor_part_load(schuler_part **part, const char *name, const schuler_plugins *plugins);

/** "imu", "accelerometer" or "gyro". */
const char *sensor_part_kind(const schuler_part *part);

/** The first of these keys (NULL-terminated) that the triad has a value for; NULL: none of them. */
const schuler_value *sensor_part_figure(const schuler_part *part, schuler_instrument instrument,
                                        const char *const *keys);

/* Every figure of a part, its sources, and what is assumed. */
void sensor_part_show(FILE *out, const schuler_part *part);
/* Two parts side by side, every figure that either has. */
void sensor_part_diff(FILE *out, const schuler_part *a, const schuler_part *b);

/* Which parts to list; NULL lets all through. */
typedef struct {
    const char *kind, *grade;       /* exact words  */
    const char *technology, *maker; /* parts of text */
} sensor_filter;

extern const char *const sensor_kinds[], *const sensor_grades[];

/** The table of the catalog; as CSV and JSON when the file names are not NULL ("-" is standard
 *  output, where the table is not printed then). Says errors. */
exit_code sensor_list(const sensor_filter *filter, const char *csv, const char *json);

#endif

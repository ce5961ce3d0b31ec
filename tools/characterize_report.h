/* SPDX-License-Identifier: MIT */
/* What `schuler characterize` measured, as tables, files and a picture. */
#ifndef SCHULER_TOOLS_CHARACTERIZE_REPORT_H
#define SCHULER_TOOLS_CHARACTERIZE_REPORT_H

#include "scenarios/characterize.h"
#include "tools/verbs.h"
#include <jansson.h>
#include <stdio.h>

typedef struct {
    const schuler_imu *imu;
    schuler_characterized *found;
} characterize_sensor;

/* All of the same instrument. */
typedef struct {
    characterize_sensor *sensor;
    int count;
    schuler_instrument instrument;
    const schuler_characterize_options *options;
} characterize_report;

/* Units for people: of the output, of its noise. */
typedef struct {
    const char *output, *noise;
    double output_si, noise_si;
} characterize_units;

characterize_units characterize_units_of(schuler_instrument instrument);

exit_code characterize_print(const characterize_report *r);
json_t *characterize_json(const characterize_report *r);
/* Tables for outfile_write, of a characterize_report. */
/** One row for each sensor, SI. */
void characterize_put_table(FILE *out, const void *report);
/** sensor, time, output of the first unit, SI. */
void characterize_put_series(FILE *out, const void *report);
/** sensor, tau, Allan deviation simulated with its error, and by the data sheet, SI. */
void characterize_put_allan(FILE *out, const void *report);
/** Time series and Allan deviations side by side, to a file that ends with .svg or .png. */
exit_code characterize_plot(const characterize_report *r, const char *path);

#endif

/* SPDX-License-Identifier: MIT */
/* The page of `schuler report`: what it is made from, and its parts. */
#ifndef SCHULER_TOOLS_REPORT_H
#define SCHULER_TOOLS_REPORT_H

#include "core/embedded.h"
#include "tools/json.h"
#include <stdbool.h>

/* The page holds at most this many times and end points, however long the mission and many the runs. */
enum { REPORT_TIMES = 201, REPORT_ENDS = 2000 };

/* Files of tools/report/ and the chart library "chart"; ended by name NULL. */
extern const schuler_embedded schuler_report_files[];

/* Horizontal error of a source (or all, or none) at the times kept. */
typedef struct {
    double *rms_m; /* over its runs */
    int runs;
} report_curve;

typedef struct {
    size_t row_count; /* of a lane in errors.csv */
    size_t time_count;
    double *times_s;
    size_t curve_count; /* the sources of the budget, then all, then none */
    report_curve *curves;
    double *low_m, *median_m, *high_m; /* 5, 50, 95 % of the joint runs at the times kept */
    double *north_m, *east_m;          /* per joint run: at the end                       */
    int joint_runs;
    double r50_m, r95_m; /* about the true position: radii that hold half and 95 % of the ends */
} report_curves;

/** result.json, with the keys that the page needs. Says errors; EXIT_INPUT when it is not one.
 *  Returned   *out to be freed by json_decref */
exit_code report_result_read(const char *path, json_t **out);
/** scenario.yaml of the same result. *out is to be freed. Says errors. */
exit_code report_scenario_read(const char *path, const json_t *result, char **out);
/** errors.csv of the same result, read once from begin to end. Says errors. */
exit_code report_curves_read(const char *path, const json_t *result, report_curves *out);
void report_curves_free(report_curves *c);

/** JSON as it may stand in a script element. false: out of memory. */
bool report_put_json(FILE *out, const json_t *root, int digits);
/** The curves as JSON; NULL when out of memory. */
json_t *report_curves_json(const report_curves *c);

typedef struct {
    const json_t *result, *curves;
    const char *scenario;
} report_parts;

/** The page. false: out of memory. */
bool report_page_put(FILE *out, const report_parts *parts);

#endif

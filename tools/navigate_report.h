/* SPDX-License-Identifier: MIT */
/* What schuler navigate tells: errors and their growth, faults of the data, where the time went. */
#ifndef SCHULER_TOOLS_NAVIGATE_REPORT_H
#define SCHULER_TOOLS_NAVIGATE_REPORT_H

#include "scenarios/navigate.h"
#include "tools/verbs.h"
#include <jansson.h>

typedef struct {
    const char *frame, *vertical; /* as given */
} navigate_names;

/** Faults on standard error, also when the navigation has failed. */
void navigate_warn(const schuler_navigate_result *r, const schuler_navigate_options *o);
exit_code navigate_print(const schuler_navigate_result *r, const schuler_navigate_options *o,
                         const navigate_names *names);
/** NULL: out of memory. */
json_t *navigate_json(const schuler_navigate_result *r, const schuler_navigate_options *o,
                      const navigate_names *names);

/* The shown figures: name, JSON key and unit, how many of the unit make the SI unit; which ones. */
typedef struct {
    const char *name, *key, *unit;
    double per_si;
    size_t figures, error; /* offsets in schuler_navigate_result, schuler_navigate_errors */
} navigate_figure;

enum { NAVIGATE_FIGURES = 4 };
extern const navigate_figure navigate_figures[NAVIGATE_FIGURES];

const schuler_error_figures *navigate_figures_of(const schuler_navigate_result *r, int i);
double navigate_error_of(const schuler_navigate_errors *e, int i); /* in the unit shown */

typedef struct {
    double seconds, rows_per_s;            /* all of the work; rows of increments */
    double reading, navigating, comparing; /* shares of it */
} navigate_speed;
navigate_speed navigate_speed_of(const schuler_navigate_result *r);

#endif

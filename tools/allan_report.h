/* SPDX-License-Identifier: MIT */
/* What `schuler allan` found, as tables and files. */
#ifndef SCHULER_TOOLS_ALLAN_REPORT_H
#define SCHULER_TOOLS_ALLAN_REPORT_H

#include "scenarios/identify.h"
#include "tools/verbs.h"
#include <jansson.h>
#include <stdio.h>

typedef struct {
    const char *file;                   /* the data */
    const schuler_recording *recording; /* its values are gone */
    const schuler_identified *found;
    double level;
    unsigned terms;
} allan_report;

/* A coefficient in the unit of data sheets. */
typedef struct {
    const char *name, *key, *unit; /* key: of sensor files, and of the JSON */
    double si;                     /* what one unit is */
} allan_unit;

allan_unit allan_unit_of(schuler_instrument instrument, schuler_allan_term term);
/** Of deviations, means and densities' roots: "deg/h" or "ug". */
const char *allan_rate_unit(schuler_instrument instrument, double *si);

/** Why there is no value, for people: "not seen in 6 h: below 0.0009". Returns 0 when there is one. */
int allan_reason(char *text, size_t size, const allan_report *r, int column, int term);
/** Seconds with a unit that suits: "6 h". */
void allan_time(char *text, size_t size, double t_s);

exit_code allan_print(const allan_report *r, int with_spectrum);
json_t *allan_json(const allan_report *r);
/* Tables for outfile_write, of an allan_report. */
/** Deviations with their limits and fit, SI. */
void allan_put_deviations(FILE *out, const void *report);
/** Densities at every frequency, two-sided, SI. */
void allan_put_spectrum(FILE *out, const void *report);

/** A sensor file of what was fitted.
 *  Returned   EXIT_INPUT when an instrument has neither one nor three columns: said */
exit_code allan_put_sensor(FILE *out, const allan_report *r, const char *name);

/** A log-log plot by gnuplot, to a file that ends with .svg or .png. Says errors. */
exit_code allan_plot(const allan_report *r, const char *path);

#endif

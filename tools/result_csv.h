/* SPDX-License-Identifier: MIT */
/* The result files of `-o DIR`. All go to streams whose owner checks them. */
#ifndef SCHULER_TOOLS_RESULT_CSV_H
#define SCHULER_TOOLS_RESULT_CSV_H

#include "scenarios/covariance.h"
#include <stdio.h>

void errors_csv_header(FILE *out);
/** All report rows of one lane. */
void errors_csv_rows(FILE *out, const char *id, int run, const schuler_error_row *rows,
                     size_t count);

/** linear: its covariance, or NULL. */
void budget_csv(FILE *out, const schuler_result *result, const schuler_covariance *linear);
/** The scenario as it was read, under a comment that says what made this result from it. */
void scenario_copy(FILE *out, const schuler_scenario *scenario, const char *switches);

#endif

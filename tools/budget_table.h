/* SPDX-License-Identifier: MIT */
/* What `run` prints: header, error budget, sums, verdict. */
#ifndef SCHULER_TOOLS_BUDGET_TABLE_H
#define SCHULER_TOOLS_BUDGET_TABLE_H

#include "scenarios/covariance.h"
#include "tools/verbs.h"
#include <stdbool.h>
#include <stdio.h>

/** Scenario, duration, IMU, runs and seed. */
void budget_header(FILE *out, const schuler_result *result);
/** The sources by size, then the joint run and what checks it. Small sources are folded into one
 *  line unless all are wanted.
 *  Given    linear   the same by covariance, or NULL
 *  Errors   false when out of memory */
bool budget_table(FILE *out, const schuler_result *result, const schuler_covariance *linear,
                  bool all);
/** Whether simulation and covariance say the same, and of which sources they do not. */
void budget_agreement(FILE *out, const schuler_result *result, const schuler_covariance *linear);
/** The row with the largest share, or with the next one below that of a row; NULL when there is none. */
const schuler_budget_row *budget_largest(const schuler_result *result,
                                         const schuler_budget_row *below);
/** The verdict in words, or the drift when no requirement was stated. */
void budget_verdict(FILE *out, const schuler_result *result);
/** The exit status a verdict leads to. */
exit_code budget_exit(const schuler_result *result);

#endif

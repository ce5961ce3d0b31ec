/* SPDX-License-Identifier: MIT */
/* What `run` prints: header, error budget, sums, verdict. */
#ifndef SCHULER_TOOLS_BUDGET_TABLE_H
#define SCHULER_TOOLS_BUDGET_TABLE_H

#include "scenarios/simulation.h"
#include "tools/verbs.h"
#include <stdbool.h>
#include <stdio.h>

/** Scenario, duration, IMU, runs and seed. */
void budget_header(FILE *out, const schuler_result *result);
/** The sources by size, then the joint run and what checks it. Small sources are folded into one
 *  line unless all are wanted.
 *  Errors   false when out of memory */
bool budget_table(FILE *out, const schuler_result *result, bool all);
/** The verdict in words, or the drift when no requirement was stated. */
void budget_verdict(FILE *out, const schuler_result *result);
/** The exit status a verdict leads to. */
exit_code budget_exit(const schuler_result *result);

#endif

/* SPDX-License-Identifier: MIT */
/* The error budget: per-run metrics of every row, and what follows from them. */
#ifndef SCHULER_SCENARIOS_BUDGET_H
#define SCHULER_SCENARIOS_BUDGET_H

#include "scenarios/plan.h"

/** A result with all arrays allocated and rows named; NULL when out of memory. */
schuler_result *schuler_budget_create(const simulation_plan *plan);

/** The row a plan row is stored in. */
schuler_budget_row *schuler_budget_row_at(schuler_result *result, const simulation_plan *plan,
                                          int row);

/** From the per-run metrics to sums, shares, RSS and the verdict.
 *  Given   chunk_curves_m2   [chunk][report]: summed squares of the horizontal error, m^2
 *  Errors  SCHULER_ERR_MEMORY */
schuler_status schuler_budget_finish(schuler_result *result, const simulation_plan *plan,
                                     const double *chunk_curves_m2);

#endif

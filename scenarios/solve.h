/* SPDX-License-Identifier: MIT */
/* How large sources may be for the requirement to be just met, the others held and the draws the same. */
#ifndef SCHULER_SCENARIOS_SOLVE_H
#define SCHULER_SCENARIOS_SOLVE_H

#include "scenarios/simulation.h"

SCHULER_BEGIN_C

/* The drift is met to so much of the limit. */
#define SCHULER_SOLVE_TOLERANCE 1e-3

typedef struct {
    double factor; /* of the values as they are; INFINITY: up to a million times nothing is missed;
                           negative: without the sources the requirement is still not met */
    double drift_mps;   /* with that factor; INFINITY and negative: without the sources    */
    double without_mps; /* the drift without them                                          */
    int simulations;    /* that it took                                                    */
} schuler_solution;

/** Multiply the values of some sources by one factor until the drift is the limit.
 *  Given    s      with a requirement; as before when this returns
 *           ids    sources with a value
 *  Errors   SCHULER_ERR_INPUT (no requirement, unknown source), and those of schuler_simulate */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_solve(schuler_scenario *s,
                                                           const schuler_run_options *options,
                                                           const char *const *ids, size_t count,
                                                           schuler_solution *out,
                                                           schuler_error *err);

SCHULER_END_C

#endif

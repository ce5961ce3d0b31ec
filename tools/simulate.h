/* SPDX-License-Identifier: MIT */
/* The engine as a verb runs it: progress, Ctrl-C, messages. */
#ifndef SCHULER_TOOLS_SIMULATE_H
#define SCHULER_TOOLS_SIMULATE_H

#include "scenarios/covariance.h"
#include "tools/outfile.h"
#include "tools/simulation_arguments.h"

/** Simulate with the threads and instruction set that were asked for. Says what goes wrong.
 *  Given      errors   a file for the errors over time, or NULL
 *  Returned   out      owned by the caller when EXIT_DONE, else untouched */
exit_code simulate(const schuler_scenario *scenario, const simulation_arguments *a, outfile *errors,
                   schuler_result **out);

/** Threads, instruction set and Ctrl-C as they were asked for; no callbacks. */
schuler_run_options simulation_options(const simulation_arguments *a);
/** Say why a simulation did not end well, and the exit status for it. */
exit_code simulation_status(schuler_status status, const schuler_error *error);

/** Make the truth of a scenario for all simulations with these arguments from now on. Says what goes wrong.
 *  Returned   out   owned by the caller, who outlives the simulations */
exit_code simulation_truth(const schuler_scenario *scenario, simulation_arguments *a,
                           schuler_truth **out);

/** The covariance of a scenario. Says what goes wrong.
 *  Returned   out   owned by the caller when EXIT_DONE, else untouched */
exit_code simulate_linear(const schuler_scenario *scenario, const simulation_arguments *a,
                          schuler_covariance **out);

#endif

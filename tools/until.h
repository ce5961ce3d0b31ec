/* SPDX-License-Identifier: MIT */
/* run --until: as many runs as a precision of the drift needs. */
#ifndef SCHULER_TOOLS_UNTIL_H
#define SCHULER_TOOLS_UNTIL_H

#include "tools/simulation_arguments.h"
#include "tools/verbs.h"

/** Double the runs of a scenario, from those it has, until half the width of the 95 % limits of its joint drift
 *  (the requirement's statistic, else CEP) is within a->until of the drift. Only the joint runs are simulated
 *  here. Says what goes wrong.
 *  Returned   scenario, a   as if that number had been given by --runs; untouched unless EXIT_DONE
 *  Exit       EXIT_INPUT: it takes more runs than there can be */
exit_code until_runs(schuler_scenario *scenario, simulation_arguments *a);

#endif

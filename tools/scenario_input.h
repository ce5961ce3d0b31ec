/* SPDX-License-Identifier: MIT */
/* Reading a scenario for a verb. */
#ifndef SCHULER_TOOLS_SCENARIO_INPUT_H
#define SCHULER_TOOLS_SCENARIO_INPUT_H

#include "scenarios/scenario.h"
#include "tools/verbs.h"
#include <stdbool.h>

/** Load a scenario and say every mistake in it; warnings unless quiet. From here on Ctrl-C is a
 *  flag (tools/stop.h).
 *  Given      overrides   may be NULL
 *  Returned   out         owned by the caller when EXIT_DONE, else NULL; EXIT_INPUT or EXIT_FAILED */
exit_code scenario_input(const char *file, const schuler_overrides *overrides, bool quiet,
                         schuler_scenario **out);

#endif

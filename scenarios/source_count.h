/* SPDX-License-Identifier: MIT */
#ifndef SCHULER_SCENARIOS_SOURCE_COUNT_H
#define SCHULER_SCENARIOS_SOURCE_COUNT_H

#include "scenarios/scenario.h"

SCHULER_BEGIN_C

/** Error sources that act in a scenario: given, not zero, not switched off. Errors: none. */
SCHULER_API int schuler_scenario_source_count(const schuler_scenario *s);

SCHULER_END_C

#endif

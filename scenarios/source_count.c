/* SPDX-License-Identifier: MIT */
#include "scenarios/source_count.h"
#include "scenarios/sources.h"

int schuler_scenario_source_count(const schuler_scenario *s)
{
    error_source sources[SOURCES_MAX];
    return schuler_sources_list(s, sources);
}

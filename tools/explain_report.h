/* SPDX-License-Identifier: MIT */
/* What `explain` has found out, as text and as JSON. */
#ifndef SCHULER_TOOLS_EXPLAIN_REPORT_H
#define SCHULER_TOOLS_EXPLAIN_REPORT_H

#include "scenarios/growth.h"
#include "scenarios/simulation.h"
#include "tools/explain_subject.h"
#include "tools/json.h"
#include <stdio.h>

typedef struct {
    explain_subject subject;
    const schuler_plugins *plugins;
    const schuler_imu *imu; /* of the scenario or of --imu; NULL: none                            */
    /* A value to reckon with. */
    schuler_value value;
    bool has_value, is_example; /* is_example: not what the scenario or part says                */
    /* At rest, where the scenario starts or at 45 deg. */
    bool has_growth;
    schuler_growth growth;
    schuler_rest rest;
    double duration_s;
    /* In the scenario; NULL: none was given. */
    const schuler_scenario *scenario;
    const char *absent; /* why the scenario does not have the source; NULL: it does      */
    const schuler_result *result; /* NULL when absent; its judgement is of the CEP                */
    const schuler_budget_row *row;
} explanation;

/** One sigma of the rms that sampling leaves, m; 0 when every run is the same. */
double explain_sampling_m(const schuler_budget_row *row);
/** Times at which growth is shown, the duration last; how many. */
enum { EXPLAIN_TIMES = 10 };
int explain_times(double duration_s, double times_s[EXPLAIN_TIMES]);
/** Whether a law still holds: the first up to half an hour, the pendulum until the earth has turned by
 *  a quarter. */
static inline bool explain_holds(schuler_growth_law law, double t_s)
{
    return law == SCHULER_GROWTH_EARTH || t_s <= (law == SCHULER_GROWTH_FIRST ? 1800.0 : 21600.0);
}

void explain_print(FILE *out, const explanation *e);
/** Format schuler-explain-1; owned by the caller, NULL when out of memory. */
json_t *explain_json(const explanation *e);

#endif

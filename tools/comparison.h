/* SPDX-License-Identifier: MIT */
/* Several IMUs on one mission, and how they are shown. */
#ifndef SCHULER_TOOLS_COMPARISON_H
#define SCHULER_TOOLS_COMPARISON_H

#include "scenarios/paired.h"
#include "tools/json.h"

typedef struct {
    const char *name; /* as given to --imu */
    schuler_scenario *scenario;
    schuler_result *result;
    schuler_judgement judgement; /* of the requirement; without one, the limits of the CEP */
    schuler_paired against_best;
} compared;

typedef struct {
    size_t count;
    compared *items; /* the best first */
    schuler_statistic statistic;
    bool required;
} comparison;

/** The value of the statistic that they are ranked by, m/s. */
double comparison_drift(const compared *item);

/** Ranking, ratios and the budgets side by side.
 *  Given    all   show every source, however small
 *  Errors   false when out of memory */
bool comparison_text(FILE *out, const comparison *c, bool all);
json_t *comparison_json(const comparison *c);
/** One line a source and IMU; what is a comparison. */
void comparison_csv(FILE *out, const void *what);

#endif

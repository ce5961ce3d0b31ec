/* SPDX-License-Identifier: MIT */
/* SOURCE=FROM..TO of `sweep`. */
#ifndef SCHULER_TOOLS_SWEEP_AXIS_H
#define SCHULER_TOOLS_SWEEP_AXIS_H

#include "scenarios/scenario.h"
#include "tools/verbs.h"
#include <stdbool.h>

enum { SWEEP_POINTS_MAX = 200 };

typedef struct {
    char id[64], unit[32]; /* of TO */
    int points;
    double size[SWEEP_POINTS_MAX];   /* SI, as schuler_source_size has it */
    double factor[SWEEP_POINTS_MAX]; /* of the scenario's value            */
    double unit_si;
} sweep_axis;

/** Read an axis for a scenario. Says what is wrong with it.
 *  Given     even   steps of equal length; else of equal ratio */
exit_code sweep_axis_read(sweep_axis *axis, const schuler_scenario *s, const char *text, int points,
                          bool even);

#endif

/* SPDX-License-Identifier: MIT */
/* What the columns of the data files are. */
#ifndef SCHULER_SCENARIOS_DATA_TABLES_H
#define SCHULER_SCENARIOS_DATA_TABLES_H

#include "core/api.h"

SCHULER_BEGIN_C

typedef struct {
    const char *name; /* as in the header of a CSV file */
    const char *unit; /* as UDUNITS spells it           */
    const char *long_name;
} schuler_column;

typedef struct {
    const char *title;
    int count;
    const schuler_column *columns;
} schuler_table;

SCHULER_API extern const schuler_table schuler_imu_table;        /* SCHULER_IMU_HEADER        */
SCHULER_API extern const schuler_table schuler_rates_table;      /* SCHULER_RATES_HEADER      */
SCHULER_API extern const schuler_table schuler_trajectory_table; /* SCHULER_TRAJECTORY_HEADER */

SCHULER_END_C

#endif

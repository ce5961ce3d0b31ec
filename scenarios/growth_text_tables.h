/* SPDX-License-Identifier: MIT */
/* The texts by schuler_acts, one table for each kind of instrument. */
#ifndef SCHULER_SCENARIOS_GROWTH_TEXT_TABLES_H
#define SCHULER_SCENARIOS_GROWTH_TEXT_TABLES_H

#include "scenarios/growth_text.h"

enum { GROWTH_TEXTS = SCHULER_ACTS_RESPONSE + 1 };

extern const schuler_growth_text growth_text_accel[GROWTH_TEXTS], growth_text_gyro[GROWTH_TEXTS];

#endif

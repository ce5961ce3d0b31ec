/* SPDX-License-Identifier: MIT */
/* Units that results are shown in. */
#ifndef SCHULER_TOOLS_RESULT_UNITS_H
#define SCHULER_TOOLS_RESULT_UNITS_H

#include "core/earth.h"
#include "scenarios/simulation.h"

static inline double nmi_per_h(double mps)
{
    return mps /
           (SCHULER_NMI_M / 3600.0); /* as the unit is read, so that a limit prints as written */
}

/* Name of a requirement's statistic. */
const char *statistic_name(schuler_statistic statistic);
/* "PASS", "FAIL", "INCONCLUSIVE". */
const char *verdict_name(schuler_verdict verdict);

/** Decimals that show a column of numbers with about four digits for the largest of them. */
int decimals_for(double largest);

#endif

/* SPDX-License-Identifier: MIT */
#include "tools/result_units.h"
#include <math.h>

const char *statistic_name(schuler_statistic statistic)
{
    switch (statistic) {
    case SCHULER_STAT_CEP:
        return "CEP";
    case SCHULER_STAT_R95:
        return "R95";
    case SCHULER_STAT_R99:
        return "R99";
    case SCHULER_STAT_ONE_AXIS:
        return "one axis 95 %";
    default:
        return "rms";
    }
}

const char *verdict_name(schuler_verdict verdict)
{
    switch (verdict) {
    case SCHULER_VERDICT_PASS:
        return "PASS";
    case SCHULER_VERDICT_FAIL:
        return "FAIL";
    case SCHULER_VERDICT_INCONCLUSIVE:
        return "INCONCLUSIVE";
    case SCHULER_VERDICT_NONE:
        break;
    }
    return "none";
}

int decimals_for(double largest)
{
    if (!(largest > 0.0) || !isfinite(largest)) return 3;
    const double decimals = 3.0 - floor(log10(largest));
    return (int)fmin(fmax(decimals, 0.0), 9.0);
}

/* SPDX-License-Identifier: MIT */
#include "sensors/temperature.h"
#include <math.h>

double schuler_temperature_at(const schuler_temperature *t, double t_s, double *rate_Kps)
{
    if (t->count == 0) {
        if (!(t->time_s > 0.0)) {
            *rate_Kps = 0.0;
            return t->end_K - t->reference_K;
        }
        const double left = exp(-fmax(t_s, 0.0) / t->time_s);
        *rate_Kps = (t->end_K - t->start_K) * left / t->time_s;
        return t->end_K - (t->end_K - t->start_K) * left - t->reference_K;
    }
    size_t next = 0;
    while (next < t->count && t->at_s[next] <= t_s) next++;
    *rate_Kps = 0.0;
    if (next == 0) return t->is_K[0] - t->reference_K;
    if (next == t->count) return t->is_K[t->count - 1] - t->reference_K;
    const double slope = (t->is_K[next] - t->is_K[next - 1]) / (t->at_s[next] - t->at_s[next - 1]);
    *rate_Kps = slope;
    return t->is_K[next - 1] + slope * (t_s - t->at_s[next - 1]) - t->reference_K;
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/sampling.h"
#include <stdio.h>

sampling_step sampling_step_of(double before_s, double t_s, double interval_s)
{
    const double step_s = t_s - before_s;
    if (step_s > 0.5 * interval_s && step_s < 1.5 * interval_s) return SAMPLING_NEXT;
    if (step_s == 0.0) return SAMPLING_REPEATED;
    if (step_s < 0.0) return SAMPLING_BACKWARD;
    return step_s > interval_s ? SAMPLING_GAP : SAMPLING_SOON;
}

void sampling_describe(char *text, size_t size, sampling_step step, double before_s, double t_s,
                       double interval_s)
{
    if (step == SAMPLING_REPEATED)
        snprintf(text, size, "time %.12g s is repeated", t_s);
    else if (step == SAMPLING_BACKWARD)
        snprintf(text, size, "time runs back from %.12g s to %.12g s", before_s, t_s);
    else if (step == SAMPLING_GAP)
        snprintf(text, size, "a gap: %.12g s follows %.12g s, but the interval is %.6g s", t_s,
                 before_s, interval_s);
    else
        snprintf(text, size, "time %.12g s follows %.12g s too soon: the interval is %.6g s", t_s,
                 before_s, interval_s);
}

double sampling_median(double *steps_s, int count)
{
    for (int i = 1; i < count; i++) /* sorted by insertion */
        for (int k = i; k > 0 && steps_s[k] < steps_s[k - 1]; k--) {
            const double swap = steps_s[k];
            steps_s[k] = steps_s[k - 1];
            steps_s[k - 1] = swap;
        }
    return steps_s[count / 2];
}

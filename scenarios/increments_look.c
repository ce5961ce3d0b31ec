/* SPDX-License-Identifier: MIT */
/* The values of recorded increments: spikes, and sensors that stand still. */
#include "scenarios/increments.h"
#include <math.h>
#include <string.h>

/* Whether one of three is beyond a limit; no maximum, which would call the mathematical library. */
static int beyond(const double v[3], double limit)
{
    return fabs(v[0]) > limit || fabs(v[1]) > limit || fabs(v[2]) > limit;
}

static double largest(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static void follow(increments_run *run, const double v[3], int line, int is_first,
                   schuler_fault *fault)
{
    if (!is_first && v[0] == run->last[0] && v[1] == run->last[1] && v[2] == run->last[2]) {
        if (++run->run < SCHULER_STUCK_ROWS) return;
        if (fault->count == 0) fault->first_line = run->line;
        fault->count += run->run == SCHULER_STUCK_ROWS ? SCHULER_STUCK_ROWS : 1;
        if ((double)run->run > fault->worst) fault->worst = (double)run->run;
        return;
    }
    run->changed = !is_first;
    run->run = 1;
    run->line = line;
    memcpy(run->last, v, sizeof run->last);
}

void schuler_increments_look(schuler_increments *in, const double *row)
{
    const int line = schuler_csv_line(in->csv), is_first = in->rows == 1;
    schuler_fault *const of = in->faults->of;
    if (beyond(row + 1, SCHULER_PLAUSIBLE_RADPS * in->dt_s))
        schuler_fault_found(in->faults, SCHULER_FAULT_RATE_SPIKE, line,
                            largest(row + 1) / in->dt_s);
    if (beyond(row + 4, SCHULER_PLAUSIBLE_MPS2 * in->dt_s))
        schuler_fault_found(in->faults, SCHULER_FAULT_FORCE_SPIKE, line,
                            largest(row + 4) / in->dt_s);
    follow(&in->runs[0], row + 1, line, is_first, &of[SCHULER_FAULT_STUCK_GYRO]);
    follow(&in->runs[1], row + 4, line, is_first, &of[SCHULER_FAULT_STUCK_ACCEL]);
}

/* Exact data of a vehicle at rest never change. */
void schuler_increments_judge(schuler_increments *in)
{
    for (int i = 0; i < 2; i++)
        if (!in->runs[i].changed)
            in->faults->of[SCHULER_FAULT_STUCK_GYRO + i] = (schuler_fault){ .count = 0 };
}

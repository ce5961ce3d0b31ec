/* SPDX-License-Identifier: MIT */
#include "scenarios/faults.h"
#include <math.h>

const schuler_fault_text schuler_fault_texts[SCHULER_FAULT_KINDS] = {
    [SCHULER_FAULT_GAP] = { "gap", "gaps where samples are missing", "s", 0, 0 },
    [SCHULER_FAULT_REPEATED] = { "repeated_time", "rows with the time of the row before", NULL, 0,
                                 0 },
    [SCHULER_FAULT_BACKWARD] = { "backward_time", "rows with a time before that of an earlier row",
                                 "s", 0, 0 },
    [SCHULER_FAULT_SOON] = { "early_time", "rows half an interval or less after the row before",
                             "s", 0, 0 },
    [SCHULER_FAULT_JITTER] = { "jitter", "times off the constant interval", "s", 0, 0 },
    [SCHULER_FAULT_RATE_SPIKE] = { "rate_spike", "rates beyond any vehicle's", "rad/s", 0, 0 },
    [SCHULER_FAULT_FORCE_SPIKE] = { "force_spike", "specific forces beyond any vehicle's", "m/s^2",
                                    0, 0 },
    [SCHULER_FAULT_STUCK_GYRO] = { "stuck_gyro", "rows where the three angles stand still", "rows",
                                   0, 1 },
    [SCHULER_FAULT_STUCK_ACCEL] = { "stuck_accel", "rows where the three velocities stand still",
                                    "rows", 0, 1 },
    [SCHULER_FAULT_REFERENCE_BETWEEN] = { "reference_between",
                                          "reference times between two samples", "s", 1, 0 },
    [SCHULER_FAULT_REFERENCE_NOT_COVERED] = { "reference_not_covered",
                                              "reference rows after the last sample", NULL, 1, 0 },
    [SCHULER_FAULT_REFERENCE_VELOCITY] = { "reference_velocity",
                                           "reference velocities that are not the change of "
                                           "position",
                                           "m/s", 1, 0 },
};

void schuler_fault_found(schuler_faults *faults, schuler_fault_kind kind, int line, double size)
{
    schuler_fault *const f = &faults->of[kind];
    if (f->count++ == 0) f->first_line = line;
    f->worst = fmax(f->worst, size);
}

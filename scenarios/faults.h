/* SPDX-License-Identifier: MIT */
/* What is odd in recorded data: every kind that is looked for, how often, and where first. */
#ifndef SCHULER_SCENARIOS_FAULTS_H
#define SCHULER_SCENARIOS_FAULTS_H

#include "core/error.h"
#include <stddef.h>
#include <stdint.h>

SCHULER_BEGIN_C

typedef enum {
    SCHULER_FAULT_GAP,         /* samples are missing before this row; size: of the gap, s      */
    SCHULER_FAULT_REPEATED,    /* the time of the row before                                    */
    SCHULER_FAULT_BACKWARD,    /* time runs back; size: by how much, s                          */
    SCHULER_FAULT_SOON,        /* half an interval after the row before, or less; size: s       */
    SCHULER_FAULT_JITTER,      /* time off the grid of a constant interval; size: by, s         */
    SCHULER_FAULT_RATE_SPIKE,  /* a mean rate no vehicle has; size: rad/s                       */
    SCHULER_FAULT_FORCE_SPIKE, /* a mean specific force no vehicle has; size: m/s^2             */
    SCHULER_FAULT_STUCK_GYRO,  /* row of a run of equal increments; size: rows of the longest   */
    SCHULER_FAULT_STUCK_ACCEL,
    SCHULER_FAULT_REFERENCE_BETWEEN,     /* its time is between two samples; size: off, s       */
    SCHULER_FAULT_REFERENCE_NOT_COVERED, /* after the last sample; size: last one's time, s     */
    SCHULER_FAULT_REFERENCE_VELOCITY, /* not the change of position since the row before; m/s   */
    SCHULER_FAULT_KINDS
} schuler_fault_kind;

typedef struct {
    int64_t count;
    int first_line;
    double worst; /* the largest size */
} schuler_fault;

typedef struct {
    schuler_fault of[SCHULER_FAULT_KINDS];
} schuler_faults;

typedef struct {
    const char *key;  /* "gap"                                                     */
    const char *what; /* "samples are missing", after a count                      */
    const char *unit; /* of the size; "" when it has none, NULL when it has no size */
    int in_reference; /* 1: a row of the reference, 0: of the increments           */
    int may_be_so;    /* 1: legal in exact data; worth saying, no warning          */
} schuler_fault_text;

SCHULER_API extern const schuler_fault_text schuler_fault_texts[SCHULER_FAULT_KINDS];

/* More than any vehicle with people or instruments in it. */
#define SCHULER_PLAUSIBLE_RADPS 40.0
#define SCHULER_PLAUSIBLE_MPS2  1000.0

enum { SCHULER_STUCK_ROWS = 20 }; /* equal rows in a row that count as stuck */

/** One more, found at a line. */
void schuler_fault_found(schuler_faults *faults, schuler_fault_kind kind, int line, double size);

SCHULER_END_C

#endif

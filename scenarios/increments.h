/* SPDX-License-Identifier: MIT */
/* Recorded increments read in blocks, their times checked. */
#ifndef SCHULER_SCENARIOS_INCREMENTS_H
#define SCHULER_SCENARIOS_INCREMENTS_H

#include "mechanization/mechanization.h"
#include "scenarios/csv.h"

enum { SCHULER_INCREMENTS_BLOCK = 256 };

typedef struct {
    schuler_csv *csv;
    double t0_s, dt_s; /* start of the first interval; the constant interval                     */
    int64_t read;      /* rows read so far                                                        */
    int n, used;       /* in the block, and how many of them are spent                            */
    double dtheta[3][SCHULER_INCREMENTS_BLOCK], dv[3][SCHULER_INCREMENTS_BLOCK];
} schuler_increments;

/** Open a file of increments and read its first block.
 *  Given      t0_s   where the first interval starts
 *  Returned   in     zero-initialised by the caller; schuler_increments_close in any case */
SCHULER_NODISCARD schuler_status schuler_increments_open(schuler_increments *in, const char *path,
                                                         double t0_s, schuler_error *err);
void schuler_increments_close(schuler_increments *in);

/** Make sure that there are unspent increments: reads the next block when there are none.
 * Afterwards in->used < in->n, or the file is at its end. */
SCHULER_NODISCARD schuler_status schuler_increments_more(schuler_increments *in,
                                                         schuler_error *err);

/** The samples before the start, which a recording does not have: the cubic through the first four,
 *  continued backwards; of lower degree when there are fewer. Call it before any are spent. */
void schuler_increments_prime(const schuler_increments *in, schuler_nav_setup *setup);

/** Does a time fall on the grid of the increments?
 *  Returned   step   the nearest step's number, counted from the start; the function returns 1 when
 * the time is its time to 1e-6 of a step and to rounding */
int schuler_increments_on_grid(const schuler_increments *in, double t_s, int64_t *step);

#endif

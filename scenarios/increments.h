/* SPDX-License-Identifier: MIT */
/* Recorded increments read in blocks, one for each step of a constant interval; what is odd in them is
 * counted. */
#ifndef SCHULER_SCENARIOS_INCREMENTS_H
#define SCHULER_SCENARIOS_INCREMENTS_H

#include "mechanization/mechanization.h"
#include "scenarios/csv.h"
#include "scenarios/faults.h"

enum { SCHULER_INCREMENTS_BLOCK = 256 };
#define SCHULER_BRIDGED_S 60.0 /* longest gap that is bridged */

/* Equal rows of a triad that follow each other. */
typedef struct {
    double last[3];
    int64_t run;
    int line;    /* where it began                 */
    int changed; /* 1: not all rows are the same   */
} increments_run;

typedef struct {
    /* given */
    int bridge; /* 1: a gap is filled with the row after it, rows out of time are left out;
                   0: either is an error                                                        */
    const volatile int *stop; /* or NULL */
    schuler_faults *faults;
    /* found */
    schuler_csv *csv;
    double t0_s, dt_s; /* start of the first interval; the constant interval                     */
    int irregular;     /* 1: dt_s is a mean, the times keep it only about                        */
    int64_t rows;      /* of the file so far                                                      */
    int64_t read;      /* steps so far, with those of gaps, without rows left out                 */
    int n, used;       /* in the block, and how many of them are spent                            */
    double dtheta[3][SCHULER_INCREMENTS_BLOCK], dv[3][SCHULER_INCREMENTS_BLOCK];
    /* private */
    double row[SCHULER_CSV_COLUMNS_MAX];
    int64_t repeat; /* how many steps the row still gives                                         */
    double before_s;
    increments_run runs[2]; /* gyros, accelerometers */
    int failed;
    schuler_error first_error;
} schuler_increments;

/** Open a file of increments and read its first block.
 *  Given      t0_s   where the first interval starts
 *             in     zero-initialised but for what is given; schuler_increments_close in any case
 *  Errors     as schuler_increments_more */
SCHULER_NODISCARD schuler_status schuler_increments_open(schuler_increments *in, const char *path,
                                                         double t0_s, schuler_error *err);
void schuler_increments_close(schuler_increments *in);

/** Make sure that there are unspent increments: reads the next block when there are none.
 *  Afterwards in->used < in->n, or the file is at its end.
 *  Errors     SCHULER_ERR_INPUT: what schuler_csv_next refuses; times that end the navigation, once
 *             the rest of the file has been looked at too, so that faults has all; _INTERRUPTED */
SCHULER_NODISCARD schuler_status schuler_increments_more(schuler_increments *in,
                                                         schuler_error *err);

/** The samples before the start, which a recording does not have: the cubic through the first four,
 *  continued backwards; of lower degree when there are fewer. Call it before any are spent. */
void schuler_increments_prime(const schuler_increments *in, schuler_nav_setup *setup);

/** Does a time fall on a grid of times?
 *  Returned   step   the nearest step's number, counted from the start; the function returns 1 when
 * the time is its time to 1e-6 of a step and to rounding */
int schuler_increments_on_grid(double t0_s, double dt_s, double t_s, int64_t *step);

/** The interval of a file's times, from its first rows; where those do not keep one, the mean of the
 *  whole file.
 *  Returned   irregular   1: it is a mean
 *             the function returns the interval, not necessarily a sensible one; 0 when it cannot be
 *             told: no row, or a file that can be read only once */
double schuler_increments_interval(const char *path, double t0_s, int *irregular);
/** The interval between two times, freed of their rounding where a whole number of samples a second
 *  explains it. */
double schuler_increments_step(double t0_s, double t1_s);

/** Look at a row's values.
 *  Given      row   of the file: time, three angles, three velocities */
void schuler_increments_look(schuler_increments *in, const double *row);
/** At the end: rows that stand still from the first to the last are no fault. */
void schuler_increments_judge(schuler_increments *in);

#endif

/* SPDX-License-Identifier: MIT */
/* Least squares of a handful of unknowns that may not be negative. */
#ifndef SCHULER_SENSORS_ALLAN_SOLVE_H
#define SCHULER_SENSORS_ALLAN_SOLVE_H

#include "sensors/allan_fit.h"

/* Normal equations of the weighted problem, columns scaled to a diagonal of ones. */
typedef struct {
    double A[SCHULER_ALLAN_TERMS][SCHULER_ALLAN_TERMS], b[SCHULER_ALLAN_TERMS];
    double scale[SCHULER_ALLAN_TERMS]; /* unknown = scaled unknown times this; 0: column is zero */
} allan_normal;

/** Given   x  count rows, one column for each term;  s, w  values and weights */
void allan_normal_equations(allan_normal *out, const double (*x)[SCHULER_ALLAN_TERMS],
                            const double *s, const double *w, int count);

/** Solution with the terms of `set` alone, the others 0.
 *  Given      right  right-hand side in scaled columns
 *  Returned   1; or 0 when the columns cannot be told apart, then c is not set */
int allan_solve(const allan_normal *e, const double right[SCHULER_ALLAN_TERMS], unsigned set,
                double c[SCHULER_ALLAN_TERMS]);

/** The best solution without negative values among the terms of `terms`.
 *  Returned   c  zero outside the set; the function returns the set of positive ones */
unsigned allan_solve_positive(const allan_normal *e, unsigned terms, double c[SCHULER_ALLAN_TERMS]);

#endif

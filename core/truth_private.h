/* SPDX-License-Identifier: MIT */
/* What a truth is made of, for the files that compute it. Private to core. */
#ifndef SCHULER_CORE_TRUTH_PRIVATE_H
#define SCHULER_CORE_TRUTH_PRIVATE_H

#include "core/path_gravity.h"

/* Steps of a piece: k is wholly inside when first <= k < end. */
typedef struct {
    int64_t first, end;
    double s0; /* s at the start of step first */
} piece_steps;

struct schuler_truth {
    const schuler_path *path;
    double dt_s;
    int64_t steps;
    int parts;           /* a step is integrated in so many at least         */
    int densest;         /* most pieces that begin within one step's length  */
    piece_steps *pieces; /* one per piece of the path */
    schuler_gravity_table truth_table, nav_table;
    schuler_path_gravity dg; /* beyond the tables */
};

/** The piece's polynomials with their time derivatives multiplied out; s0, ds, dt_s and the
 *  quadrature are left to the caller. */
void schuler_truth_prepare(const schuler_truth *truth, const schuler_piece *piece,
                           schuler_truth_run *run);

/** The steps from k on that lie in one piece.
 *  Given      p       a piece near it;  left   at most so many steps
 *  Returned   p       the piece of step k;  run, index   for the lane code
 *             how many steps; 0 = step k holds a joint of two pieces, run is not set */
int schuler_truth_next_run(const schuler_truth *truth, size_t *p, int64_t k, int left,
                           schuler_truth_run *run, double *index);

#endif

/* SPDX-License-Identifier: MIT */
/* Specific force and rate at instants within each step, for errors that are not linear in them. */
#ifndef SCHULER_CORE_TRUTH_NODES_H
#define SCHULER_CORE_TRUTH_NODES_H

#include "core/truth.h"

SCHULER_BEGIN_C

enum { SCHULER_NODES_MAX = 24 };

/* Nodes of a Gauss-Legendre quadrature over each step: the integral over a step is dt times the sum
 * of weight times value. A step that holds a joint of two pieces has the same nodes: what is joined
 * there is the third derivative of position, of no account for an error term. */
typedef struct {
    int nodes;                                                     /* in a step                  */
    double weight[SCHULER_NODES_MAX], fraction[SCHULER_NODES_MAX]; /* of the step             */
    double f_ib_b[3][SCHULER_NODES_MAX][SCHULER_BLOCK];     /* m/s^2, without what gravity has
                                                                    beyond its table           */
    double omega_ib_b[3][SCHULER_NODES_MAX][SCHULER_BLOCK]; /* rad/s                      */
    double omega_end_b[3][SCHULER_BLOCK + 1]; /* before the first step, at the end of each     */
} schuler_truth_nodes;

/** Instantaneous values of steps first+1 .. first+n, n <= SCHULER_BLOCK. */
SCHULER_API void schuler_truth_nodes_compute(const schuler_truth *truth, schuler_isa isa,
                                             int64_t first, int n, schuler_truth_nodes *out);

SCHULER_END_C

#endif

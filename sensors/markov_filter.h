/* SPDX-License-Identifier: MIT */
/* Increments of a sum of first-order Gauss-Markov processes from one random number a sample.
 *
 * Over equal steps dt the increments I_k of one process of correlation time T are an ARMA(1, 1)
 * process: with phi = e^-x, x = dt/T, the sequence I_k - phi I_(k-1) has covariances c0 and c1 and no
 * others. The spectrum of a sum of independent ones is, in c = cos(2 pi f dt),
 *
 *     S(c) = sum of (c0_i + 2 c1_i c)/(1 + phi_i^2 - 2 phi_i c)
 *          = s^2 product of (1 + zeta_j^2 - 2 zeta_j c)/(1 + phi_i^2 - 2 phi_i c)
 *
 * and S rises from pole to pole, so that one real zero lies between each two neighbouring poles and
 * one below c = -1. The filter with these poles and zeros, in partial fractions,
 *
 *     I = direct e + sum of x_i,   x_i' = phi_i x_i + feed_i e,   e white, N(0, 1)
 *
 * has exactly the covariances of the increments, for any dt, with one e for all the processes. */
#ifndef SCHULER_SENSORS_MARKOV_FILTER_H
#define SCHULER_SENSORS_MARKOV_FILTER_H

#include "core/api.h"

SCHULER_BEGIN_C

enum { SCHULER_MARKOV_MAX = 24 };

/* Correlation sigma^2 exp(-|t|/T). */
typedef struct {
    double T_s, sigma;
} schuler_markov_process;

/* Of the integral of the process over dt_s: units of sigma times s. */
typedef struct {
    int members;
    double direct, phi[SCHULER_MARKOV_MAX], feed[SCHULER_MARKOV_MAX];
    double x[SCHULER_MARKOV_MAX]; /* dt/T, phi = e^-x */
} schuler_markov_filter;

/** Given     p   1 .. SCHULER_MARKOV_MAX processes, T_s rising, sigma > 0; all T_s but the first are
 *                dt_s/100 at least (far below that a process is white, and they cannot be told apart)
 *  Returned  the filter, its members in the order of p
 *  Source    spectral factorisation (A. Papoulis, Probability, Random Variables, and Stochastic
 *            Processes); the interlacing zeros make it a bracketed search */
SCHULER_API schuler_markov_filter schuler_markov_filter_of(const schuler_markov_process *p,
                                                           int members, double dt_s);

/** What makes the filter stationary from the first sample: x = l w, w independent, N(0, 1).
 *  Returned  l   lower triangle, Cholesky factor of feed_i feed_j/(1 - phi_i phi_j) */
SCHULER_API void schuler_markov_filter_start(const schuler_markov_filter *f,
                                             double l[SCHULER_MARKOV_MAX][SCHULER_MARKOV_MAX]);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Covariances of overlapping Allan variances of one record at different tau: neighbours share most of
 * their data, so limits that took them as independent would be far too narrow.
 *
 * For Gaussian noise the covariance of the mean squares of two series of second differences D, D' is
 * the sum over lags d of w(d) 2 R(d)^2 (w: how many pairs are d apart, R: their covariance), and a ramp
 * adds to each D its mean mu: 4 mu mu' R(d). R is linear in the squared coefficients
 * c = (Q^2, N^2, B^2, K^2), so that all sums can be taken once per record, before c is known. */
#ifndef SCHULER_SENSORS_ALLAN_COVARIANCE_H
#define SCHULER_SENSORS_ALLAN_COVARIANCE_H

#include "sensors/allan_fit.h"

enum { ALLAN_RANDOM = 4 }; /* terms that are random: all before SCHULER_ALLAN_RAMP */

/* For one pair of tau. square is symmetric. */
typedef struct {
    double square[ALLAN_RANDOM][ALLAN_RANDOM]; /* of c_a c_b */
    double ramp[ALLAN_RANDOM];                 /* of c_a R^2  */
} allan_pair;

typedef struct {
    int count;
    allan_pair *pairs; /* (i, j), j <= i, at i (i + 1)/2 + j; owned */
} allan_covariance;

/** Given      n, dt_s  samples and their interval;  m  count averaging factors, each 1 .. n/3
 *             bank     of the flicker noise, members 0: ideal flicker noise
 *  Returned   SCHULER_OK or SCHULER_ERR_MEMORY; pairs freed by allan_covariance_free */
SCHULER_NODISCARD schuler_status allan_covariance_create(allan_covariance *out, int64_t n,
                                                         double dt_s, const int64_t *m, int count,
                                                         const schuler_flicker_bank *bank);
void allan_covariance_free(allan_covariance *c);

/** Covariance of sigma^2 at tau i and j for squared coefficients c, the ramp's last. */
double allan_covariance_at(const allan_covariance *v, int i, int j,
                           const double c[SCHULER_ALLAN_TERMS]);

#endif

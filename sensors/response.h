/* SPDX-License-Identifier: MIT */
/* Response of an instrument to its input: exact steps of low-pass filters, interpolation of a delay. */
#ifndef SCHULER_SENSORS_RESPONSE_H
#define SCHULER_SENSORS_RESPONSE_H

#include "core/api.h"

SCHULER_BEGIN_C

/* One step for an input u: (y, y')_2 = phi (y, y')_1 + sum of node_j u_j, u_j the input at the three
 * Gauss-Legendre nodes of the step, exact when u is a parabola there. The nodes add up to gamma, what
 * an input does that is constant over the step. For any input the integral of y over the step is that
 * of u less keep . ((y, y')_2 - (y, y')_1). */
typedef struct {
    double phi[2][2], gamma[2], keep[2], node[3][2];
} schuler_response;

/** H(s) = w^2/(s^2 + 2 zeta w s + w^2), w = 2 pi f.
 *  Given      f_hz   natural frequency, > 0;  zeta   damping, > 0, over 1 too;  dt_s   step
 *  Returned   the step; unit gain at rest;  no overflow for any f dt */
SCHULER_API schuler_response schuler_second_order(double f_hz, double zeta, double dt_s);
/** H(s) = w/(s + w); y' is not used. */
SCHULER_API schuler_response schuler_first_order(double f_hz, double dt_s);

/** |H(f)| of the second-order response. */
SCHULER_API double schuler_second_order_gain(double f_n_hz, double zeta, double f_hz);
/** Delay at low frequency, 2 zeta/w, s. */
SCHULER_API double schuler_second_order_delay(double f_n_hz, double zeta);
/** The frequency where the gain is 1/sqrt(2), Hz. */
SCHULER_API double schuler_second_order_minus_3_db(double f_n_hz, double zeta);
/** One-sided noise bandwidth, Hz: pi f_n/(4 zeta); of the first-order response pi/2 f. */
SCHULER_API double schuler_second_order_noise_bandwidth(double f_n_hz, double zeta);

enum { SCHULER_DELAY_STEPS_MAX = 64 };
/** Weights of the increments d, d+1, d+2, d+3 samples ago in the increment that is late by `steps`
 *  samples: Lagrange's cubic on the accumulated increments; they sum to 1.
 *  Given      steps    0 .. SCHULER_DELAY_STEPS_MAX
 *  Returned   d, the whole part of steps */
SCHULER_API int schuler_delay_weights(double steps, double weight[4]);

SCHULER_END_C

#endif

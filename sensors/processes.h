/* SPDX-License-Identifier: MIT */
/* Closed forms of the noise processes of inertial sensors: Allan variances, exact discrete
 * recursions, the flicker bank. Everything is written for a rate (rad/s, or m/s^2 of an
 * accelerometer); "angle" is its integral. Spectra are two-sided, so the random walk coefficient is
 * N = sqrt(S).
 *  Source    IEEE Std 952-1997 annex C; N. El-Sheimy, H. Hou, X. Niu, IEEE Trans. Instrum. Meas.
 *            57(1), 2008; every form re-derived from sigma^2(tau) = 1/2 <(mean' - mean)^2>
 *  Domain    tau_s > 0, T_s > 0, coefficients of any size; no errors */
#ifndef SCHULER_SENSORS_PROCESSES_H
#define SCHULER_SENSORS_PROCESSES_H

#include "core/api.h"
#include "sensors/markov_filter.h"
#include <stddef.h>

SCHULER_BEGIN_C

/* Floor of the Allan deviation of flicker noise in units of B: sqrt(2 ln 2/pi). */
#define SCHULER_FLICKER_FLOOR 0.66428247026796

/* ---- Allan variance at tau, (rad/s)^2 or (m/s^2)^2 -------------------------------------------- */

/** 3 Q^2/tau^2; Q in rad or m/s. A counter of resolution LSB that carries its remainder has
 *  Q = LSB/sqrt(12). */
SCHULER_API double schuler_process_quantization(double Q, double tau_s);
/** N^2/tau; N in rad/sqrt(s) or m/s/sqrt(s). */
SCHULER_API double schuler_process_white(double N, double tau_s);
/** (2 ln 2/pi) B^2, the same at every tau; S(f) = B^2/(2 pi |f|). */
SCHULER_API double schuler_process_flicker(double B, double tau_s);
/** K^2 tau/3; K in rad/s/sqrt(s) or m/s^2/sqrt(s). */
SCHULER_API double schuler_process_random_walk(double K, double tau_s);
/** R^2 tau^2/2 of the rate R t. */
SCHULER_API double schuler_process_ramp(double R, double tau_s);
/** First-order Gauss-Markov: correlation sigma^2 exp(-|t|/T). Largest at tau = 1.8926 T. */
SCHULER_API double schuler_process_gauss_markov(double sigma, double T_s, double tau_s);
/** Second-order Gauss-Markov, critically damped: correlation sigma^2 exp(-|t|/T) (1 + |t|/T). */
SCHULER_API double schuler_process_gauss_markov_2(double sigma, double T_s, double tau_s);
/** A sinusoid of the rate: amplitude^2 (sin^2(pi f tau)/(pi f tau))^2. */
SCHULER_API double schuler_process_sinusoid(double amplitude, double f_hz, double tau_s);

/* ---- Flicker noise as a bank of Gauss-Markov processes ---------------------------------------- */

/* What `bias_instability` has when nothing else is said: flicker at every time that samples see. */
#define SCHULER_FLICKER_SHORTEST_S 0.0
#define SCHULER_FLICKER_LONGEST_S  1e5

/* Time constants shortest_s ratio^i, i = 0 .. members - 1, all of the same variance. */
typedef struct {
    double shortest_s, ratio;
    int members;
    int endless; /* the first member stands for itself and for all shorter ones, without end */
} schuler_flicker_bank;

/** The bank that the simulator uses for `bias_instability` at an interval of the samples: ratio 4,
 *  from the shortest time to the longest. Below dt/16 the bank is endless: there are members of
 *  every shorter time, as far as increments can tell. */
SCHULER_API schuler_flicker_bank schuler_flicker_bank_of(double shortest_s, double longest_s,
                                                         double dt_s);
/** Member i for the coefficient B. The one that stands for an endless tail of times T/r^k has the
 *  tail's sums of sigma^2 T and of sigma^2 T^2: over ten T and more nothing else is left of it. */
SCHULER_API schuler_markov_process schuler_flicker_bank_member(const schuler_flicker_bank *bank,
                                                               double B, int i);
/** sigma_i/B = sqrt(ln(ratio)/pi). */
SCHULER_API double schuler_flicker_bank_sigma(double ratio);
/** Allan variance of the bank for the coefficient B. */
SCHULER_API double schuler_process_flicker_bank(const schuler_flicker_bank *bank, double B,
                                                double tau_s);

/* ---- Exact discrete recursions over an interval of dt ------------------------------------------ */

/* b' = phi b + l11 w1;  integral over dt = gain b + l21 w1 + l22 w2;  w independent, N(0, 1).
 * q = l l^T. */
typedef struct {
    double phi, gain, q11, q12, q22, l11, l21, l22;
} schuler_process_step;

/** Source: R. G. Brown, P. Y. C. Hwang, exact discretisation; re-derived. */
SCHULER_API schuler_process_step schuler_gauss_markov_step(double sigma, double T_s, double dt_s);
SCHULER_API schuler_process_step schuler_random_walk_step(double K, double dt_s);

/** Weights of the fractional filter of order 1/2: driven by white noise of standard deviation B it
 *  gives flicker noise of coefficient B, whatever the interval of the samples.
 *  Returned   h   n weights; h[0] = 1, h[k] -> 1/sqrt(pi k)
 *  Source     N. J. Kasdin, Proc. IEEE 83(5), 1995 */
SCHULER_API void schuler_fractional_weights(double *h, size_t n);

SCHULER_END_C

#endif

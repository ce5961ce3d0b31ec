/* SPDX-License-Identifier: MIT */
/* Closed forms of optical gyros: the Sagnac effect of a ring and of a fibre coil, and what lock-in
 * makes of a ring laser. SI and radians; a pulse is one whole turn (2 pi) of the beat phase. */
#ifndef SCHULER_SENSORS_OPTICS_H
#define SCHULER_SENSORS_OPTICS_H

#include "core/api.h"

SCHULER_BEGIN_C

#define SCHULER_LIGHT_MPS 299792458.0 /* in vacuum, exact */

/* ---- Ring laser ------------------------------------------------------------------------------- */

/** Angle of a pulse, rad: lambda L/(4 A); the beat frequency is the rate divided by it.
 *  Given      wavelength_m;  perimeter_m, area_m2 > 0   of the ring */
SCHULER_API double schuler_ring_pulse(double wavelength_m, double perimeter_m, double area_m2);
/** Area of an equilateral triangle, m^2. */
SCHULER_API double schuler_ring_triangle_area(double perimeter_m);

/** Mean rate that a ring shows without dither: d(psi)/dt = (2 pi/K) (Omega + Omega_L sin psi) advances
 *  by sgn(Omega) sqrt(Omega^2 - Omega_L^2), and not at all within the lock-in rate Omega_L >= 0. */
SCHULER_API double schuler_lock_in_rate(double omega_radps, double lock_in_radps);

/** Angle random walk, rad/sqrt(s), that lock-in leaves under a sinusoidal dither whose phase at the
 *  turnarounds is random:  N = Omega_L sqrt(K/(2 pi Omega_D)).
 *  Given      pulse_rad   K;  dither_radps > 0   peak rate Omega_D of the dither
 *  Domain     Omega_D much above Omega_L; the dither frequency drops out
 *  Source     each turnaround, of angular acceleration alpha, adds the angle
 *             Omega_L sqrt(2 pi/(S alpha)) sin(psi0 + pi/4), S = 2 pi/K, by stationary phase; same
 *             form in F. Aronowitz, Fundamentals of the ring laser gyro, RTO-AG-339, 1999 */
SCHULER_API double schuler_lock_in_random_walk(double lock_in_radps, double pulse_rad,
                                               double dither_radps);

/* ---- Fibre-optic gyro ------------------------------------------------------------------------- */

/** Sagnac phase for each rad/s: 2 pi L D/(lambda c), in s (rad per rad/s).
 *  Given      length_m   of the fibre;  diameter_m   of the coil;  wavelength_m   in vacuum
 *  Source     H. C. Lefevre, The Fiber-Optic Gyroscope, 2nd ed., 2014 */
SCHULER_API double schuler_fibre_gain(double length_m, double diameter_m, double wavelength_m);

SCHULER_END_C

#endif

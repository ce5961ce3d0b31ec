/* SPDX-License-Identifier: MIT */
/* The vertical channel: inertial height by itself runs away in ten minutes, so a barometer steadies
 * it. Third-order loop, e = height - barometer, up positive:
 *
 *     h' = v - k1 e    v' = (inertial) - k2 e - a_c    a_c' = k3 e
 *
 * With k1 = 3/tau, k2 = 3/tau^2 + 2g/R, k3 = 1/tau^3 all three poles are at -1/tau: an accelerometer
 * bias ends in a_c and leaves neither height nor velocity, a bias of the barometer is the height's.
 *  Source    W. S. Widnall, P. K. Sinha, J. Guidance and Control 3(2), 1980 (the loop; the gains are
 *            re-derived: s^3 + k1 s^2 + (k2 - 2g/R) s + k3 = (s + 1/tau)^3) */
#ifndef SCHULER_MECHANIZATION_VERTICAL_H
#define SCHULER_MECHANIZATION_VERTICAL_H

#include "core/api.h"

SCHULER_BEGIN_C

typedef enum {
    SCHULER_VERTICAL_TRUTH, /* height and vertical velocity are put to the true ones            */
    SCHULER_VERTICAL_FREE,  /* inertial alone                                                   */
    SCHULER_VERTICAL_BARO   /* the loop above                                                   */
} schuler_vertical;

#define SCHULER_BARO_TIME_S 100.0 /* tau when nothing is said */
/* The loop is good for updates that come at least so many in a tau. */
#define SCHULER_BARO_UPDATES_MIN 4.0

typedef struct {
    double k1_ps, k2_ps2, k3_ps3;
    double gradient_ps2; /* 2g/R */
} schuler_baro_gains;

typedef struct {
    double e_m;      /* height less barometer after the last update */
    double a_c_mps2; /* what it takes for the accelerometers' error, up */
} schuler_baro_loop;

/** Gains for a triple pole.
 *  Given      tau_s > 0;  g_mps2 and lat_rad of the place: R is the mean radius of curvature there */
SCHULER_API schuler_baro_gains schuler_baro_gains_of(double tau_s, double g_mps2, double lat_rad);

/** One update, T after the one before.
 *  Given      e_m   height less barometer before the update
 *  Returned   *dh_m, *dv_mps   to be added to height and up-velocity */
SCHULER_API void schuler_baro_update(schuler_baro_loop *loop, const schuler_baro_gains *gains,
                                     double T_s, double e_m, double *dh_m, double *dv_mps);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* A test stand: one triad of many specimens on a motion of one's choice, without navigation. */
#ifndef SCHULER_SENSORS_STAND_H
#define SCHULER_SENSORS_STAND_H

#include "sensors/chain.h"

SCHULER_BEGIN_C

/** The true input at an instant, body axes: specific force in m/s^2, angular rate in rad/s. */
typedef void (*schuler_stand_input)(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3]);

typedef struct {
    schuler_chain_setup chain;
    const schuler_lane_spec *specs; /* one for each specimen; copied */
    size_t specimens;
    schuler_stand_input input;
    void *user;
} schuler_stand_setup;

typedef struct schuler_stand schuler_stand;

/** Errors  those of schuler_chain_create */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_stand_create(schuler_stand **out,
                                                                  const schuler_stand_setup *setup,
                                                                  schuler_error *err);
SCHULER_API void schuler_stand_free(schuler_stand *stand); /* NULL is fine */

/** The next n <= SCHULER_BLOCK steps. All calls but the last must be for whole blocks. The true
 *  increments are integrals of the input by three-point Gauss-Legendre: exact to degree five.
 *  Returned   out   [specimen][axis][SCHULER_BLOCK]: measured increments, rad or m/s */
SCHULER_API void schuler_stand_next(schuler_stand *stand, int n, double *out);

/** What the model alone (no stages, no noise) indicates for a constant input.
 *  Given      values   [param][component] of the model's own parameters, SI, as in a
 *                      schuler_lane_spec; alpha_ib_b   angular acceleration, rad/s^2
 *  Returned   out      indicated specific force or rate on the three input axes
 *  Errors     SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_indicate(const schuler_sensor_model *model, schuler_instrument instrument,
                 const schuler_lane_spec *values, const double f_ib_b[3],
                 const double omega_ib_b[3], const double alpha_ib_b[3], double out[3]);

SCHULER_END_C

#endif

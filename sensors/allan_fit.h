/* SPDX-License-Identifier: MIT */
/* Noise coefficients from Allan variances: weighted least squares on sigma^2(tau), linear in the
 * squared coefficients, none of which may be negative.
 *
 *     sigma^2(tau) = 3 Q^2/tau^2 + N^2/tau + B^2 f(tau) + K^2 tau/3 + R^2 tau^2/2
 *
 * f is the flicker floor 2 ln 2/pi, or that of the simulator's bank of Gauss-Markov processes, which
 * falls off outside its band. The weights are the inverse variances of the sigma^2 under the fitted
 * coefficients (degrees of freedom/sigma^4); the limits use their whole covariance. */
#ifndef SCHULER_SENSORS_ALLAN_FIT_H
#define SCHULER_SENSORS_ALLAN_FIT_H

#include "sensors/allan.h"
#include "sensors/processes.h"

SCHULER_BEGIN_C

typedef enum {
    SCHULER_ALLAN_QUANTIZATION,
    SCHULER_ALLAN_WHITE,
    SCHULER_ALLAN_FLICKER,
    SCHULER_ALLAN_RANDOM_WALK,
    SCHULER_ALLAN_RAMP,
    SCHULER_ALLAN_TERMS,
} schuler_allan_term;

typedef enum {
    SCHULER_ALLAN_NOT_ASKED, /* left out by the caller                                             */
    SCHULER_ALLAN_FITTED,   /* value and both limits                                              */
    SCHULER_ALLAN_NOT_SEEN, /* cannot be told from zero; upper limit only                         */
    SCHULER_ALLAN_UNSURE,   /* there is something, but the limits are a factor of ten apart       */
    SCHULER_ALLAN_NO_DATA,  /* the record has too few tau to tell this term from the others       */
} schuler_allan_state;

/* One coefficient, SI: rad or m/s (Q), per sqrt(s) (N), per s (B), per s sqrt(s) (K), per s^2 (R).
 * lower and upper hold the level together; an upper limit alone holds half the rest. */
typedef struct {
    schuler_allan_state state;
    double value, lower, upper;
} schuler_allan_coefficient;

typedef struct {
    schuler_allan_coefficient term[SCHULER_ALLAN_TERMS];
    double worst;       /* largest distance of a sigma^2 from the fit, in its standard deviations */
    double worst_tau_s; /* and where: above about 5 there is something that the terms do not have */
} schuler_allan_fit;

/* What does not depend on the values: one design serves all columns of a record. */
typedef struct schuler_allan_design schuler_allan_design;

/** Given      n, dt_s  samples and their interval;  m  count factors as of schuler_allan_factors
 *             bank     of the flicker noise; members = 0: ideal flicker noise
 *  Returned   out      owned by the caller: schuler_allan_design_free
 *  Errors     SCHULER_ERR_INPUT a factor is not in 1 .. n/3; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_allan_design_create(schuler_allan_design **out, int64_t n, double dt_s, const int64_t *m,
                            int count, const schuler_flicker_bank *bank);
SCHULER_API void schuler_allan_design_free(schuler_allan_design *d); /* NULL is fine */

/** Fit.
 *  Given      sigma2  one value for each factor of the design
 *             terms   bit k: fit term k;  level  of the limits, 0.95
 *  Returned   out     complete. A record without any noise gives values of zero.
 *  Errors     SCHULER_ERR_NUMERIC a sigma2 is negative or not finite */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_allan_fit_terms(const schuler_allan_design *d,
                                                                     const double *sigma2,
                                                                     unsigned terms, double level,
                                                                     schuler_allan_fit *out);

/** Allan variance of fitted terms at factor i of the design: those with a value. */
SCHULER_API double schuler_allan_fit_at(const schuler_allan_design *d, const schuler_allan_fit *fit,
                                        int i);

SCHULER_END_C

#endif

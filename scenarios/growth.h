/* SPDX-License-Identifier: MIT */
/* How far a single error carries a navigator that stands still: the closed forms of the Schuler
 * pendulum, and the linear model with the earth's rate. Vertical channel held. What moves the vehicle
 * (scale factors, misalignment under acceleration) is not in here but in the engine.
 *  Source    K. R. Britting, Inertial Navigation Systems Analysis, 1971; D. H. Titterton, J. L.
 *            Weston, Strapdown Inertial Navigation Technology, 2nd ed., ch. 12; re-derived */
#ifndef SCHULER_SCENARIOS_GROWTH_H
#define SCHULER_SCENARIOS_GROWTH_H

#include "scenarios/scenario.h"

SCHULER_BEGIN_C

/* Three accuracies of one thing. With w^2 = g/R and x1 = sin(w t)/w, x(k+1) = the integral of x(k):
 * the response to an impulse of specific force is x1, of a level rate g x2, of a rate about the
 * vertical g W cos(L) x3; to a constant one the next x. */
typedef enum {
    SCHULER_GROWTH_FIRST,    /* x(k) = t^k/k!: before the pendulum swings back, t << 84 min       */
    SCHULER_GROWTH_PENDULUM, /* each level channel by itself: leaves out the earth's rate, which
                                turns directions by W t (15 deg each hour)                       */
    SCHULER_GROWTH_EARTH,    /* both channels and heading, with the earth's rate: any time       */
    SCHULER_GROWTH_LAWS
} schuler_growth_law;

/* Where the error enters. */
typedef enum {
    SCHULER_ENTERS_POSITION, /* m, of the start; level there                                     */
    SCHULER_ENTERS_VELOCITY, /* m/s, of the start                                                */
    SCHULER_ENTERS_TILT,     /* phi about north and east, rad, of the start                      */
    SCHULER_ENTERS_HEADING,  /* computed minus true, rad, of the start                           */
    SCHULER_ENTERS_ACCEL,    /* error of the specific force, measured minus true                 */
    SCHULER_ENTERS_GYRO,     /* error of the angular rate                                        */
} schuler_growth_entry;

/* How it behaves in time, and what the value of the source then is. */
typedef enum {
    SCHULER_GROWS_CONSTANT,       /* the error itself; the only one for errors of the start      */
    SCHULER_GROWS_RAMP,           /* its slope                                                   */
    SCHULER_GROWS_DECAY,          /* at the start; dies away as exp(-t/time_s)                   */
    SCHULER_GROWS_WHITE,          /* root of the two-sided density                               */
    SCHULER_GROWS_WALK,           /* root of the density of its derivative                       */
    SCHULER_GROWS_GAUSS_MARKOV,   /* sigma; correlated as exp(-|t|/time_s)                       */
    SCHULER_GROWS_GAUSS_MARKOV_2, /* sigma; correlated as exp(-|t|/time_s) (1 + |t|/time_s)      */
    SCHULER_GROWS_FLICKER,        /* B of the bank from time_s to longest_s                      */
    SCHULER_GROWS_SINUSOID,       /* amplitude at frequency_hz, random phase                     */
} schuler_growth_process;

typedef struct {
    schuler_growth_entry entry;
    schuler_growth_process process;
    int components;
    double axis_n[SCHULER_VALUE_MAX][3];    /* what one unit of a component is, north-east-down */
    double time_s[SCHULER_VALUE_MAX];       /* of each component                                */
    double frequency_hz[SCHULER_VALUE_MAX]; /* of each component                                */
    double longest_s, dt_s;                 /* flicker: end of the bank; interval of samples     */
} schuler_growth;

/* A place and attitude at rest. */
typedef struct {
    double lat_rad, g_mps2;
    double radius_m[2]; /* of the Schuler pendulum along the meridian and across it             */
    schuler_mat3 C_b_n;
    double f_b[3], omega_ib_b[3]; /* what perfect sensors measure there                         */
} schuler_rest;

/** Normal gravity of WGS84 there.
 *  Errors     SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_rest_make(schuler_rest *out, double lat_rad,
                                                               double h_m,
                                                               const schuler_mat3 *C_b_n,
                                                               schuler_error *err);
/** At rest where a scenario starts, in its attitude. Errors as above. */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_rest_of(schuler_rest *out,
                                                             const schuler_scenario *s,
                                                             schuler_error *err);

/** Position error north and east after t for one unit of a component, m per unit: signed when the
 *  error is determined (constant, ramp, decay), else rms, not negative.
 *  Given      t_s   0 .. SCHULER_TRAJECTORY_LONGEST_S */
SCHULER_API void schuler_growth_response(const schuler_growth *growth, const schuler_rest *rest,
                                         schuler_growth_law law, int component, double t_s,
                                         double out_m[2]);
/** Horizontal rms error after t for a value that is fixed or drawn (components are drawn each by
 *  itself; fixed ones add with their signs unless they are noise), m. */
SCHULER_API double schuler_growth_rms(const schuler_growth *growth, const schuler_rest *rest,
                                      schuler_growth_law law, const schuler_value *value,
                                      double t_s);

/** The growth of a sensor parameter.
 *  Given      params    of the triad, ended by key NULL;  index  of the source in it
 *             values    of the same indices, for the settings that go with it; NULL = their defaults
 *  Returned   whether there is a closed form at rest; else out is untouched */
SCHULER_API bool schuler_growth_of_param(const schuler_param *params, int index,
                                         const schuler_value *values, schuler_instrument instrument,
                                         const schuler_rest *rest, double dt_s,
                                         schuler_growth *out);
/** The growth of an error of the start; entry is one of the first four. */
SCHULER_API schuler_growth schuler_growth_of_start(schuler_growth_entry entry);

SCHULER_END_C

#endif

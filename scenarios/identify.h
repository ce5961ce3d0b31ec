/* SPDX-License-Identifier: MIT */
/* Noise coefficients of a recording: Allan deviation, fit and spectrum of each column. */
#ifndef SCHULER_SCENARIOS_IDENTIFY_H
#define SCHULER_SCENARIOS_IDENTIFY_H

#include "scenarios/recording.h"
#include "sensors/allan_fit.h"
#include "sensors/spectrum.h"

SCHULER_BEGIN_C

enum { SCHULER_PER_DECADE = 10 };

typedef struct {
    unsigned
        terms;    /* bit k: fit term k of schuler_allan_term                                     */
    double level; /* of the limits: 0.95                                                         */
    int ideal_flicker; /* 1: flicker noise of unlimited band, 0: the simulator's bank              */
    int segment; /* 0: no spectrum; -1: of a length that suits; else its length, even           */
    int threads; /* 0: as many as processors; never changes the result                          */
    const volatile int
        *stop; /* or NULL                                                           */
} schuler_identify_options;

/* Unit: rad/s or m/s^2, whatever the column was. */
typedef struct {
    double mean;
    double sigma2[SCHULER_ALLAN_POINTS_MAX]; /* Allan variance at each tau                      */
    double limits[SCHULER_ALLAN_POINTS_MAX]
                 [2];                       /* of it, from its degrees of freedom              */
    double model[SCHULER_ALLAN_POINTS_MAX]; /* what was fitted                                 */
    schuler_allan_fit fit;
    double
        *density; /* two-sided, segment/2 + 1 values; NULL: no spectrum                         */
} schuler_identified_column;

typedef struct {
    int64_t n, m[SCHULER_ALLAN_POINTS_MAX];
    double dt_s, tau_s[SCHULER_ALLAN_POINTS_MAX];
    int points, columns, segment;
    schuler_identified_column column[SCHULER_RECORDING_COLUMNS_MAX];
} schuler_identified;

/** Analyse all columns of a recording.
 *  Given      r    its values are used up: they are phases afterwards
 *  Returned   out  owned by the caller: schuler_identified_free
 *  Errors     SCHULER_ERR_INPUT segment is odd, below 8 or longer than the recording;
 *             SCHULER_ERR_MEMORY; SCHULER_ERR_INTERRUPTED; SCHULER_ERR_NUMERIC values overflow */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_identify(schuler_identified **out, schuler_recording *r,
                 const schuler_identify_options *options, schuler_error *err);
SCHULER_API void schuler_identified_free(schuler_identified *i); /* NULL is fine */

SCHULER_END_C

#endif

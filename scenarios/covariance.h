/* SPDX-License-Identifier: MIT */
/* The budget by linear covariance: how each source's error spreads along the mission, in one pass and without
 * a random number.
 *
 * What a sensor makes of a value is not linearised: its own chain (model and stages) runs along the truth with
 * one component at one sigma, and what it adds to the true increments drives the linear error of the
 * navigator (scenarios/linear_error.h). Random processes act through their exact steps. So a row differs
 * from the Monte Carlo of the same source by the sampling error of that, and by what the navigator does
 * that is not linear. */
#ifndef SCHULER_SCENARIOS_COVARIANCE_H
#define SCHULER_SCENARIOS_COVARIANCE_H

#include "core/isa.h"
#include "scenarios/simulation.h"

SCHULER_BEGIN_C

typedef struct {
    char id[64];
    const char *uncovered; /* why there is no figure; NULL: there is one         */
    double end_m;          /* horizontal rms at the end                          */
    double *rms_curve_m;   /* at each report time                                */
    double mean_n_m[2];    /* at the end, north and east: of what is not drawn   */
    double P_n_m2[3];      /* at the end: covariance NN, NE, EE of what is drawn */
} schuler_covariance_row;

typedef struct {
    size_t row_count;
    schuler_covariance_row *rows; /* one per source, in the order of the tables */
    size_t time_count;
    double *times_s;              /* report times, without 0: those of the simulation */
    schuler_covariance_row total; /* of the sources that are covered */
} schuler_covariance;

/** Given    options   truth, isa and stop are looked at
 *  Errors   as schuler_simulate */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_covariance_run(const schuler_scenario *scenario, const schuler_run_options *options,
                       schuler_covariance **out, schuler_error *err);
SCHULER_API void schuler_covariance_free(schuler_covariance *c); /* NULL is fine */

/** The row of a source; NULL when there is none, or c is NULL. */
SCHULER_API const schuler_covariance_row *schuler_covariance_find(const schuler_covariance *c,
                                                                  const char *id);

/** By how much the horizontal rms of `runs` Monte Carlo runs differs from that of a row by chance alone: one
 *  sigma, relative, for normal errors; 0 when nothing is drawn. */
SCHULER_API double schuler_covariance_sampling(const schuler_covariance_row *row, int runs);

/* Beyond so many sigma of the sampling, and a hundredth, a row is told to differ: of twenty sources that do
 * agree one is, once in a hundred simulations. */
#define SCHULER_AGREEMENT_SIGMAS 3.5
#define SCHULER_AGREEMENT_LEAST  0.01

typedef struct {
    double relative; /* Monte Carlo over covariance, less 1              */
    double sigmas;   /* in sampling errors; 0 when nothing is drawn       */
    bool differs;    /* never with fewer than SCHULER_VERDICT_RUNS_MIN runs of what is drawn */
} schuler_agreement;

/** A row against the same row of a simulation; all zero when it is not covered, and nothing differs that is less
 *  than a thousandth of the whole.
 *  Given   total_m   horizontal rms of all sources at the end */
SCHULER_API schuler_agreement schuler_covariance_against(const schuler_covariance_row *row,
                                                         const schuler_budget_row *simulated,
                                                         double total_m);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* The engine: lanes = sources x runs over one truth; and what it returns. */
#ifndef SCHULER_SCENARIOS_SIMULATION_H
#define SCHULER_SCENARIOS_SIMULATION_H

#include "core/isa.h"
#include "core/truth.h"
#include "scenarios/scenario.h"
#include <stdint.h>

SCHULER_BEGIN_C

/* Navigator minus truth at one report time, resolved in NED at the truth. */
typedef struct {
    double time_s;
    double r_n[3]; /* north, east, down, m                                        */
    double v_n[3]; /* m/s                                                         */
    double roll_rad, pitch_rad, heading_rad; /* difference of Euler angles, each in its own NED */
} schuler_error_row;

/* What the rows of a budget are. */
typedef enum {
    SCHULER_ROWS_SOURCES, /* each source alone, and what is numerical     */
    SCHULER_ROWS_GROUPS,  /* all of a group: accel, gyro, initial, ...    */
    SCHULER_ROWS_WITHOUT, /* all but one source; its share is what it adds */
    SCHULER_ROWS_NONE,    /* only the joint run and none                   */
    SCHULER_ROWS_KINDS
} schuler_rows;

/* One error source, or one of the sums. */
typedef struct {
    char id[64];            /* "gyro.bias", "all", "none"                                  */
    char group[16];         /* "gyro"; "" for the sums                                     */
    const char *value_text; /* as written: "0.0035 deg/h"; borrowed from the scenario, or "" */
    bool assumed;
    bool drawn;            /* depends on the run; else all runs are the same and one was computed */
    int runs;              /* entries in the arrays below                                 */
    double *end_m, *max_m; /* per run: horizontal error at the end, and its largest       */
    double *slope_mps;     /* per run: least squares through the origin of the radial error */
    double *drift_mps;     /* per run: by the requirement's metric; the slope without one   */
    double *axis_mps[2];   /* the same of north and of east                                 */
    double *v_rms_mps;     /* per run: horizontal velocity error, rms over the report times */
    double rms_end_m, rms_max_m, cep_mps, r95_mps, rms_slope_mps;
    double
        required_mps; /* what the requirement looks at: its metric and statistic; CEP without one */
    double share;     /* of the summed variance at the end; 0 for the sums           */
    double *rms_curve_m; /* rms over the runs at each report time                       */
} schuler_budget_row;

typedef enum {
    SCHULER_VERDICT_NONE,
    SCHULER_VERDICT_PASS,
    SCHULER_VERDICT_FAIL,
    SCHULER_VERDICT_INCONCLUSIVE,
} schuler_verdict;

typedef struct {
    double value_mps, lower_mps, upper_mps; /* upper may be INFINITY: too few runs          */
    double confidence;                      /* 0.95                                        */
    schuler_verdict verdict;
} schuler_judgement;

/* What of a triad's output was cut off at its range, in the joint runs. */
typedef struct {
    int runs;        /* in which it happened                                               */
    int64_t samples; /* of one axis, over all runs; there are runs * steps * 3             */
} schuler_clipping;

typedef struct {
    const schuler_scenario *scenario; /* borrowed */
    int runs;
    double duration_s;
    int64_t steps;
    schuler_rows rows_are;
    size_t row_count;
    schuler_budget_row *rows; /* one per source, in the order of the tables  */
    schuler_budget_row all, none;
    double rss_end_m, rss_max_m; /* root of the summed squares of the rows' rms  */
    size_t time_count;
    double *times_s; /* report times, without 0                     */
    schuler_clipping clipped[SCHULER_INSTRUMENTS];
    schuler_judgement judgement;
    int64_t lane_steps; /* work done                                   */
} schuler_result;

/** The truth of a scenario, for several simulations of it: with a full gravity model it takes half a second.
 *  Errors   as schuler_truth_create */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_scenario_truth(const schuler_scenario *scenario, schuler_truth **out, schuler_error *err);

typedef struct {
    const schuler_truth *truth; /* of this scenario; NULL: made for the simulation */
    int threads;                /* 0 = all processors                          */
    schuler_rows rows;
    int has_isa;
    schuler_isa isa; /* else the best                               */
    /* Called about ten times a second from one thread at a time: fraction done in [0, 1]. */
    void (*progress)(void *user, double fraction);
    /* Called in a fixed order (rows, then all, then none; runs in order) with all report rows of
     * one lane, the one at time 0 first; a non-OK status stops the simulation. NULL = not wanted.
     */
    schuler_status (*errors)(void *user, const char *id, int run, const schuler_error_row *rows,
                             size_t count);
    void *user;
    const volatile int *stop; /* becomes non-zero: finish with SCHULER_ERR_INTERRUPTED */
} schuler_run_options;

/** Simulate a scenario. Results do not depend on threads or instruction set, to the last bit.
 *  Errors   SCHULER_ERR_NUMERIC (a state became non-finite: source, run and time in err),
 *           SCHULER_ERR_GRAVITY_DATA, SCHULER_ERR_MEMORY, SCHULER_ERR_INTERRUPTED, or what errors()
 * said */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_simulate(const schuler_scenario *scenario,
                                                              const schuler_run_options *options,
                                                              schuler_result **out,
                                                              schuler_error *err);
SCHULER_API void schuler_result_free(schuler_result *result);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Navigation over recorded increments: starts from a reference trajectory's first row, mechanizes
 * the increments and compares with the reference at its own times. Streams both files. */
#ifndef SCHULER_SCENARIOS_NAVIGATE_H
#define SCHULER_SCENARIOS_NAVIGATE_H

#include "mechanization/vertical.h"
#include "scenarios/faults.h"
#include "scenarios/trajectory_file.h"
#include <stdint.h>

SCHULER_BEGIN_C

typedef struct {
    const char *imu_file, *reference_file;
    int frame; /* index into schuler_mechanizations()                                    */
    const char *gravity; /* name for schuler_field_open */
    schuler_vertical
        vertical; /* truth: height and down-velocity are put to the reference's at each of
                                  its rows; baro: its height is what a barometer reads there */
    int bridge; /* 1: go on across gaps of up to a minute (filled with the row after it) and rows out
                   of time (left out); 0: an error                                               */
    int coning; /* index of schuler_coning_algorithms; 0 is the default                          */
    /* Called with the navigator's trajectory at each reference time; a non-OK status stops. */
    schuler_status (*row)(void *user, const schuler_trajectory_row *row);
    void (*progress)(void *user, double fraction); /* or NULL; some hundred times in all */
    void *user;
    const volatile int *stop; /* or NULL; becomes non-zero: SCHULER_ERR_INTERRUPTED               */
} schuler_navigate_options;

/* Size of an error over the reference's rows after the first. */
typedef struct {
    double final, max, rms;
} schuler_error_figures;

/* At one row of the reference. */
typedef struct {
    double horizontal_m, height_m, velocity_mps, attitude_rad;
} schuler_navigate_errors;

typedef struct {
    double time_s; /* since the start */
    schuler_navigate_errors errors;
} schuler_navigate_growth;

enum { SCHULER_GROWTH_TIMES_MAX = 24 };

/* Where the time went, by a clock: not part of what is computed. */
typedef struct {
    double reading_s, navigating_s, comparing_s; /* comparing: with writing, which row() does     */
} schuler_navigate_timing;

typedef struct {
    double dt_s, duration_s; /* sample interval; from the first to the last row compared        */
    int64_t steps, rows;     /* increments used; reference rows, with the first                 */
    int64_t rows_read;       /* rows of increments in the file, as far as it was read           */
    int irregular;           /* 1: the times keep no interval; dt_s is their mean               */
    int reference_goes_on;   /* 1: the reference has rows after the last increment              */
    schuler_error_figures horizontal_m; /* distance north-east, axes of the reference's place     */
    schuler_error_figures height_m;     /* difference of ellipsoidal heights; final is signed     */
    schuler_error_figures velocity_mps; /* size of the difference of velocities over ground       */
    schuler_error_figures attitude_rad; /* angle between the two attitudes, each in its own NED   */
    int growth_times; /* errors at the first row at 1, 2, 5, 10, 20, 30 s, min and so on, and at the last */
    schuler_navigate_growth growth[SCHULER_GROWTH_TIMES_MAX];
    schuler_faults faults;
    schuler_navigate_timing timing;
} schuler_navigate_result;

/** Navigate over recorded increments.
 *  Given      increments at a constant interval, the one that most of the first hundred times keep,
 *             from the reference's first time on. Where they keep none to 1e-6 of it, it is the mean of
 *             the whole file, snapped to a whole number of samples a second where that is within 1e-6
 *             of it or within the noise; samples are then taken to be regular and their times to be noisy, and the
 *             reference is compared at the nearest one, moved along the velocity. Otherwise each
 *             time of the reference must be one of the increments'
 *  Returned   out, complete when SCHULER_OK; faults also otherwise
 *  Errors     SCHULER_ERR_INPUT with its place, for times that end the navigation when all increments
 *             have been looked at; SCHULER_ERR_FILE; SCHULER_ERR_GRAVITY_DATA;
 *             SCHULER_ERR_NUMERIC the solution became non-finite or left the heights where gravity
 *             is known; SCHULER_ERR_MEMORY; SCHULER_ERR_INTERRUPTED; what row() said */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_navigate(
    const schuler_navigate_options *options, schuler_navigate_result *out, schuler_error *err);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Navigation over recorded increments: starts from a reference trajectory's first row, mechanizes
 * the increments and compares with the reference at its own times. Streams both files. */
#ifndef SCHULER_SCENARIOS_NAVIGATE_H
#define SCHULER_SCENARIOS_NAVIGATE_H

#include "mechanization/vertical.h"
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

typedef struct {
    double dt_s, duration_s; /* sample interval; from the first to the last row compared        */
    int64_t steps, rows;     /* increments used; reference rows, with the first                 */
    int reference_goes_on;   /* 1: the reference has rows after the last increment              */
    schuler_error_figures horizontal_m; /* distance north-east, axes of the reference's place     */
    schuler_error_figures height_m;     /* difference of ellipsoidal heights; final is signed     */
    schuler_error_figures velocity_mps; /* size of the difference of velocities over ground       */
    schuler_error_figures attitude_rad; /* angle between the two attitudes, each in its own NED   */
} schuler_navigate_result;

/** Navigate over recorded increments.
 *  Given      the increments' interval must be constant to 1e-6 of a step: it is the first one,
 * from the reference's first time; each time of the reference must be one of the increments'
 *  Returned   out, complete when SCHULER_OK
 *  Errors     SCHULER_ERR_INPUT with its place; SCHULER_ERR_FILE; SCHULER_ERR_GRAVITY_DATA;
 *             SCHULER_ERR_NUMERIC the solution became non-finite or left the heights where gravity
 * is known; SCHULER_ERR_MEMORY; SCHULER_ERR_INTERRUPTED; what row() said */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_navigate(
    const schuler_navigate_options *options, schuler_navigate_result *out, schuler_error *err);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Recorded sensor data: a CSV file whose header names the columns, read whole into memory, fast.
 *
 * A column's unit is the end of its name (gx_radps, dtheta_x_rad, ax_g) or given in `columns`; its
 * dimension says what it is: an angle or a speed is an increment over the sample, an angular rate or
 * an acceleration is a rate. */
#ifndef SCHULER_SCENARIOS_RECORDING_H
#define SCHULER_SCENARIOS_RECORDING_H

#include "sensors/model.h"
#include <stdint.h>

SCHULER_BEGIN_C

enum { SCHULER_RECORDING_COLUMNS_MAX = 12, SCHULER_COLUMN_NAME_MAX = 48 };

typedef enum { SCHULER_DATA_ANY, SCHULER_DATA_INCREMENTS, SCHULER_DATA_RATES } schuler_data_kind;

/* Zero-initialised: every column whose name ends with a unit, interval from the column of time. */
typedef struct {
    const char *columns; /* "gx,gy,gz:deg/s,ax:g": names, a unit holds for the names before it   */
    double rate_hz;      /* 0: from the column of time                                           */
    int only_instrument; /* 1: instrument below alone                                            */
    schuler_instrument instrument;
    schuler_data_kind kind; /* what the columns must be                                          */
    int threads;            /* 0: as many as processors; never changes the result                */
    void (*progress)(void *user, double fraction); /* or NULL; from the calling thread           */
    void *user;
    const volatile int *stop; /* or NULL                                                         */
} schuler_recording_options;

typedef struct {
    char name[SCHULER_COLUMN_NAME_MAX];
    schuler_instrument instrument;
    int increments; /* 1: rad or m/s over the sample; 0: rad/s or m/s^2                          */
    double *values; /* n of them, SI; room for one more                                          */
} schuler_recording_column;

typedef struct {
    int64_t n;
    double dt_s;
    int times; /* 1: dt_s comes from a column of time                                            */
    int columns;
    schuler_recording_column column[SCHULER_RECORDING_COLUMNS_MAX];
} schuler_recording;

/** Read a file.
 *  Given      path     borrowed; its name stays in err
 *  Returned   out      owned by the caller: schuler_recording_free
 *  Errors     SCHULER_ERR_INPUT with its place: no header, unknown column or unit, nothing to read,
 *             a field that is no finite number, a wrong number of fields, time that repeats, runs
 *             back or leaves a gap (more than half an interval off), a rate that is not the file's,
 *             fewer than 16 samples; SCHULER_ERR_FILE; SCHULER_ERR_MEMORY; SCHULER_ERR_INTERRUPTED */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_recording_read(schuler_recording **out, const char *path,
                       const schuler_recording_options *options, schuler_error *err);
SCHULER_API void schuler_recording_free(schuler_recording *r); /* NULL is fine */

/** Warn of what is unusual for an IMU at rest: a specific force that is not gravity, by a power of ten
 *  or altogether, a rate that has no earth rate in it or is no rest. Only of three columns of an
 *  instrument. */
SCHULER_API void schuler_recording_doubt(const schuler_recording *r, const char *path,
                                         schuler_diagnostics *d);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* The two halves of reading a recording: what its header says, and its rows. */
#ifndef SCHULER_SCENARIOS_RECORDING_PRIVATE_H
#define SCHULER_SCENARIOS_RECORDING_PRIVATE_H

#include "scenarios/recording.h"
#include <locale.h>
#include <stddef.h>

enum {
    RECORDING_FIELDS_MAX = 256,                     /* in a row, used or not         */
    RECORDING_LINE_MAX = 1 << 16,                   /* bytes of a line               */
    RECORDING_TIME = SCHULER_RECORDING_COLUMNS_MAX, /* slot of the time */
    RECORDING_SLOTS
};

/* Which field of a row goes where. */
typedef struct {
    const char *path;
    int fields;
    signed char slot[RECORDING_FIELDS_MAX]; /* column, RECORDING_TIME, or -1: not used */
    double si[RECORDING_SLOTS];             /* what one unit is, s for the time        */
    char name[RECORDING_SLOTS][SCHULER_COLUMN_NAME_MAX];
    int has_time;
    double interval_s; /* of neighbouring times; 0: not checked yet */
    locale_t c_locale;
} recording_layout;

/** Read the header.
 *  Given      line    NUL-terminated, without its end; number  of the line
 *  Returned   layout  all but c_locale and interval_s;  r  columns without values */
SCHULER_NODISCARD schuler_status recording_header(recording_layout *layout, schuler_recording *r,
                                                  const char *line, int number,
                                                  const schuler_recording_options *options,
                                                  schuler_error *err);

/* Rows of a part of the file, each column in a vector of its own. */
typedef struct {
    double *values[SCHULER_RECORDING_COLUMNS_MAX];
    int64_t n, capacity;
    int lines; /* read */
    double first_s, last_s;
    schuler_status status;
    schuler_error error; /* place.line counts from the part's start */
} recording_rows;

/** Read rows until the end of the file or of the part.
 *  Given      layout  c_locale set;  fd, from, to  the part; from < 0: a stream, read to its end
 *             head    bytes already read from a stream, head_length of them
 *  Returned   rows    status and error say what was wrong; freed by recording_rows_free */
void recording_rows_read(recording_rows *rows, const recording_layout *layout, int fd,
                         const char *head, size_t head_length, int64_t from, int64_t to,
                         const schuler_recording_options *options, int show_progress);
void recording_rows_free(recording_rows *rows);

/** The interval of the first times in a text, its median; 0 when there are not two. */
double recording_interval(const recording_layout *layout, const char *text, size_t length);

/** A time that does not follow the one before as it should. Returns SCHULER_OK when it does. */
schuler_status recording_check_time(const recording_layout *layout, double before_s, double t_s,
                                    const schuler_place *place, schuler_error *err);

#endif

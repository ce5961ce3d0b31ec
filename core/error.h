/* SPDX-License-Identifier: MIT */
/* What a library function says when it cannot do what was asked: a status, and where wanted an
 * error with its place in the input. The library never prints and never exits. */
#ifndef SCHULER_CORE_ERROR_H
#define SCHULER_CORE_ERROR_H

#include "core/api.h"
#include <stddef.h>

SCHULER_BEGIN_C

/* Values are pinned; new ones are appended to their group. */
typedef enum {
    SCHULER_OK = 0,
    SCHULER_ERR_INPUT = 10,        /* a scenario, sensor or data file says something wrong    */
    SCHULER_ERR_GRAVITY_DATA = 20, /* a gravity model's data set is missing or unreadable      */
    SCHULER_ERR_NUMERIC = 30,      /* a value became non-finite, a solution did not converge   */
    SCHULER_ERR_MEMORY = 40,
    SCHULER_ERR_FILE = 41,        /* cannot open, read, write or rename                       */
    SCHULER_ERR_INTERRUPTED = 50, /* the caller asked to stop                                 */
} schuler_status;

/* A place in a text. Line and column are 1-based, 0 = unknown; width in columns. */
typedef struct {
    const char *file; /* name to show, borrowed; NULL = not about a file */
    int line, column, width;
} schuler_place;

enum { SCHULER_MESSAGE_MAX = 400, SCHULER_EXCERPT_MAX = 160 };

typedef struct {
    schuler_status status;
    int is_warning; /* 1: legal but suspicious                             */
    schuler_place place;
    char message[SCHULER_MESSAGE_MAX];
    char excerpt[SCHULER_EXCERPT_MAX]; /* the source line at place, "" when there is none     */
    int excerpt_column; /* place.column within the excerpt, which a long line is cut to */
} schuler_error;

/** Fill *err (may be NULL) and return status, so that a failure is one line at the caller.
 *  Given      status    the failure;  place  where, or NULL;  format  as printf
 *  Returned   err       complete; excerpt is ""
 *  Errors     none */
SCHULER_API schuler_status schuler_fail(schuler_error *err, schuler_status status,
                                        const schuler_place *place, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* All mistakes of an input at once. Zero-initialised = empty. Keeps the first
 * SCHULER_DIAGNOSTICS_MAX and counts the rest, so that a hostile input cannot make it grow without
 * bound. */
enum { SCHULER_DIAGNOSTICS_MAX = 100 };
typedef struct {
    schuler_error *items;
    size_t kept;     /* entries in items, in the order found                                  */
    size_t errors;   /* all errors found, kept or not                                         */
    size_t warnings; /* all warnings found                                                    */
    struct schuler_name *names; /* copies of the file names the items' places show, so that the
                                   items outlive what they are about                          */
} schuler_diagnostics;

/** Append an error or a warning (format as printf). An out-of-memory is counted as an error. Text
 * of the input may go into the message as it is: control characters and broken UTF-8 become '?'. */
SCHULER_API void schuler_diagnose(schuler_diagnostics *d, schuler_status status,
                                  const schuler_place *place, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
SCHULER_API void schuler_warn(schuler_diagnostics *d, const schuler_place *place,
                              const char *format, ...) __attribute__((format(printf, 3, 4)));
/** Append an error as it is. */
SCHULER_API void schuler_diagnose_error(schuler_diagnostics *d, const schuler_error *error);
SCHULER_API void schuler_diagnostics_free(schuler_diagnostics *d);

/** The known name nearest to what was written, for "did you mean".
 *  Given      written;  known  names, count entries
 *  Returned   entry of known, or NULL when none is near (edit distance > 1/3 of the length, min 2)
 */
SCHULER_API const char *schuler_nearest(const char *written, const char *const *known,
                                        size_t count);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Lines of a text file, in place: read in large blocks, each line looked at where it lies. */
#ifndef SCHULER_SCENARIOS_CSV_LINES_H
#define SCHULER_SCENARIOS_CSV_LINES_H

#include "core/error.h"
#include <stddef.h>

typedef struct {
    const char *path; /* borrowed                                       */
    int fd;           /* -1: closed                                     */
    int number;       /* of the line last read, from 1                  */
    char *block;      /* owned                                          */
    size_t begin, end;
    int is_whole;                  /* nothing is left to read from the file          */
    double size_bytes, read_bytes; /* of the file, 0: not known; of the lines so far */
} csv_lines;

/** Open a file.
 *  Given      path   borrowed, must outlive the lines
 *  Returned   lines  csv_lines_close in any case; zero-initialise before
 *  Errors     SCHULER_ERR_FILE, SCHULER_ERR_MEMORY */
SCHULER_NODISCARD schuler_status csv_lines_open(csv_lines *lines, const char *path,
                                                schuler_error *err);
void csv_lines_close(csv_lines *lines);

/** The next line; a last one without its end counts.
 *  Returned   text, length   ends with a NUL in place of its newline (and of the CR before it), valid
 *                            until the next call; bytes of NUL in it are the caller's to refuse.
 *                            Of a line longer than SCHULER_CSV_LINE_MAX only that much and one more.
 *             got            0 at the end of the file
 *  Errors     SCHULER_ERR_FILE */
SCHULER_NODISCARD schuler_status csv_lines_next(csv_lines *lines, char **text, size_t *length,
                                                int *got, schuler_error *err);

#endif

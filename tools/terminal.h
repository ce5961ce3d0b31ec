/* SPDX-License-Identifier: MIT */
/* What the terminal can show, and a progress line. */
#ifndef SCHULER_TOOLS_TERMINAL_H
#define SCHULER_TOOLS_TERMINAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

typedef enum { COLOUR_NONE, COLOUR_BOLD, COLOUR_RED, COLOUR_GREEN, COLOUR_YELLOW } colour;

/** Take the character set from the environment; numbers stay in the C locale. Once, at the start.
 */
void terminal_start(void);
/** true: characters outside ASCII can be shown. */
bool terminal_utf8(void);
/** Escape sequences that start and end a colour on a stream, "" when it is no terminal or NO_COLOR
 * is set. */
const char *terminal_colour(FILE *stream, colour which);
const char *terminal_plain(FILE *stream);
/** Columns that a UTF-8 text takes, and the bytes of it that fit in `columns`. */
int terminal_width(const char *text);
size_t terminal_fit(const char *text, int columns);
/** The text as the terminal can show it: as it is, or with ASCII in place of the rest.
 *  Returned   to be freed; NULL when out of memory */
char *terminal_text(const char *text);

/* Bar, fraction and remaining time on standard error, only when that is a terminal. */
typedef struct {
    bool shown, wanted;
    struct timespec start;
    const char *note; /* shown behind the time; borrowed, NULL or "" for none */
} progress;

progress progress_start(bool quiet);
void progress_show(progress *p, double fraction);
void progress_end(progress *p);

#endif

/* SPDX-License-Identifier: MIT */
/* Text for standard output: collected first, written at once and checked, in what characters the
 * terminal has. */
#ifndef SCHULER_TOOLS_PAGE_H
#define SCHULER_TOOLS_PAGE_H

#include "tools/verbs.h"
#include <stdio.h>

typedef struct {
    FILE *out; /* print here, UTF-8; NULL when out of memory (then page_show says so) */
    char *text;
    size_t length;
} page;

void page_open(page *p);
/** Write it to standard output and free it.
 *  Returned   EXIT_DONE, or EXIT_FAILED: out of memory, or the output cannot be written */
exit_code page_show(page *p);
void page_drop(page *p); /* free without showing */

/** Columns of a table that adapt to their content are printed with this: text, then blanks. A text
 * that is too long is cut and marked. */
void page_cell(FILE *out, const char *text, int columns);
/** Words wrapped to 80 columns, each line indented; the first starts at column `at`. */
void page_wrap(FILE *out, const char *text, int at, int indent);
/** A line across, in two columns of margin. */
void page_rule(FILE *out);
/** h:mm:ss, with as many decimals as the seconds need (at most 3). */
void page_duration(FILE *out, double seconds);

#endif

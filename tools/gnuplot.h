/* SPDX-License-Identifier: MIT */
/* Pictures by gnuplot, where it is installed. */
#ifndef SCHULER_TOOLS_GNUPLOT_H
#define SCHULER_TOOLS_GNUPLOT_H

#include "tools/verbs.h"
#include <argp.h>
#include <stdio.h>

/** A usage error when the file of --plot ends with neither .svg nor .png. */
void gnuplot_check(struct argp_state *state, const char *path);

/** Draw a picture of width x height pixels into a file: what `put` writes are gnuplot's commands.
 *  Says errors. */
exit_code gnuplot_draw(const char *path, int width, int height, void (*put)(FILE *, const void *),
                       const void *what);

/** 'text', for titles: names come from files, so what is special in a quoted text is left out. */
void gnuplot_quote(FILE *out, const char *text);

#endif

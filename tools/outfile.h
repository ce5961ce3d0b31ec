/* SPDX-License-Identifier: MIT */
/* Files and a directory of results that appear complete or not at all: written beside their place
 * under another name, checked, then renamed. */
#ifndef SCHULER_TOOLS_OUTFILE_H
#define SCHULER_TOOLS_OUTFILE_H

#include "tools/verbs.h"
#include <stdbool.h>
#include <stdio.h>

/* Zero-initialised = none; all functions are fine with that. */
typedef struct {
    FILE *file;    /* write here                                                   */
    char *target;  /* owned; where it shall appear                                 */
    char *partial; /* owned; NULL: target is no regular file and is written to directly */
    bool complete;
} outfile;

/** Start a file. Errors are said; EXIT_DONE or EXIT_FAILED. */
exit_code outfile_open(outfile *o, const char *path);
/** All written: flush, close and check, but do not show it yet. Says errors. */
exit_code outfile_complete(outfile *o);
/** Put it in its place, replacing what was there (completes it first when needed). Says errors. */
exit_code outfile_publish(outfile *o);
/** Forget it, remove what was written; after outfile_publish it only frees. */
void outfile_drop(outfile *o);

/** Why an open file could not be written, when that is not known: ENOSPC, else EIO. */
int outfile_reason(const outfile *o);

/** A whole file, - standard output: put writes what it is given. Says errors. */
exit_code outfile_write(const char *path, void (*put)(FILE *, const void *), const void *what);

typedef struct {
    char *target, *partial; /* owned */
} outdir;

/** Start a directory of results. A directory that is there already must be empty or hold the files
 * of an earlier result and nothing else: it is replaced at the end. Says errors: EXIT_INPUT when it
 * holds other things, EXIT_FAILED when it cannot be made. */
exit_code outdir_open(outdir *d, const char *path);
/** Start a file in it: budget.csv, errors.csv, result.json, result.nc or scenario.yaml. */
exit_code outdir_file(const outdir *d, outfile *o, const char *name);
exit_code outdir_publish(outdir *d);
void outdir_drop(outdir *d);

#endif

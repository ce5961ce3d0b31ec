/* SPDX-License-Identifier: MIT */
/* The command line of `schuler characterize`. */
#ifndef SCHULER_TOOLS_CHARACTERIZE_ARGUMENTS_H
#define SCHULER_TOOLS_CHARACTERIZE_ARGUMENTS_H

#include "scenarios/characterize.h"
#include "sensors/plugins.h"
#include <argp.h>
#include <stdbool.h>

enum { CHARACTERIZE_SENSORS_MAX = 64 };

typedef struct {
    const char *sensor[CHARACTERIZE_SENSORS_MAX];
    int count;
    bool has_instrument, quiet;
    schuler_instrument instrument;
    const char *input, *cross, *json, *csv, *series, *allan, *plot;
    char *only, *without; /* as written, cut into names */
    schuler_plugins *plugins;
    schuler_characterize_options options;
} characterize_arguments;

/* Parses into a characterize_arguments; the caller frees only, without and plugins. */
extern const struct argp characterize_argp;

#endif

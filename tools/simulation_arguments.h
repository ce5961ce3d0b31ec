/* SPDX-License-Identifier: MIT */
/* The switches that all verbs share which simulate a scenario. */
#ifndef SCHULER_TOOLS_SIMULATION_ARGUMENTS_H
#define SCHULER_TOOLS_SIMULATION_ARGUMENTS_H

#include "core/isa.h"
#include "core/truth.h"
#include "scenarios/simulation.h"
#include <argp.h>
#include <stdbool.h>

enum { SIMULATION_SET_MAX = 256, SIMULATION_RUNS_MAX = 100000 };

typedef struct {
    const char *file;
    const char *json, *directory, *plot;
    int threads; /* 0 = all processors */
    bool has_isa, quiet, all;
    schuler_rows rows;          /* of the budget */
    const schuler_truth *truth; /* made by the verb, for several simulations; or NULL */
    double until;               /* wanted precision of the drift, relative; 0: the runs are given */
    char note[60];              /* shown in the progress line */
    schuler_isa isa;
    schuler_overrides overrides;
    const char *set[SIMULATION_SET_MAX];
    const char *imus[SIMULATION_SET_MAX]; /* every --imu; the last is the override's */
    size_t count_imus;
    schuler_plugins *plugins;              /* freed by the verb, last          */
    const char *files[SIMULATION_SET_MAX]; /* of the plug-ins, as given         */
    size_t count_files;
} simulation_arguments;

/* For .children of a verb's argp; its input must be a simulation_arguments. */
extern const struct argp simulation_argp;
/* The same without --only, --without, -o and --quiet. */
extern const struct argp simulation_argp_single;

/** The verb's file, one of them; what else there is is a usage error. */
void simulation_take_file(simulation_arguments *arguments, char *file, struct argp_state *state);
/** At the end: a file was given, and no -o to a verb that writes no directory. */
void simulation_need_file(const simulation_arguments *arguments, struct argp_state *state,
                          bool has_directory);

/** The overrides as switches ("--seed 7 --set 'a.b=1 m'"), for provenance; to be freed, NULL when
 * out of memory. */
char *simulation_switches(const simulation_arguments *arguments);

#endif

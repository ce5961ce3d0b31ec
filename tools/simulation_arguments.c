/* SPDX-License-Identifier: MIT */
#include "tools/simulation_arguments.h"
#include "tools/arguments.h"
#include "tools/plugin_argument.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_SEED = 1000,
    KEY_RUNS,
    KEY_THREADS,
    KEY_SET,
    KEY_ONLY,
    KEY_WITHOUT,
    KEY_IMU,
    KEY_JSON,
    KEY_ISA,
    KEY_PLUGIN
};

enum { OF_BUDGETS = 4 }; /* the first ones, for verbs that run any sources and write files */
static const struct argp_option options[] = {
    { "only", KEY_ONLY, "SOURCE,...", 0, "only these error sources or groups", 0 },
    { "without", KEY_WITHOUT, "SOURCE,...", 0, "all but these", 0 },
    { "quiet", 'q', NULL, 0, "only the verdict; no warnings, no progress", 0 },
    { NULL, 'o', "DIR", 0, "result files, with errors over time", 0 },
    { "imu", KEY_IMU, "NAME", 0, "another IMU: catalog name or file", 0 },
    { "runs", KEY_RUNS, "N", 0, "number of Monte Carlo runs", 0 },
    { "seed", KEY_SEED, "N", 0, "seed of all random draws", 0 },
    { "set", KEY_SET, "KEY=VALUE", 0, "change a key, e.g. imu.rate='200 Hz'; repeatable", 0 },
    { "json", KEY_JSON, "FILE", 0, "result as JSON; - is standard output", 0 },
    { "threads", KEY_THREADS, "N", 0, "threads; 0, the default: all processors", 0 },
    { "isa", KEY_ISA, "NAME", 0, "scalar, sse2, avx2 or avx512; same results", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { 0 },
};

static void read_isa(simulation_arguments *a, const char *text, struct argp_state *state)
{
    const char *known[SCHULER_ISA_COUNT + 1];
    for (int i = 0; i < SCHULER_ISA_COUNT; i++) known[i] = schuler_isa_name((schuler_isa)i);
    known[SCHULER_ISA_COUNT] = NULL;
    a->isa = (schuler_isa)arguments_choice(state, "--isa", text, known);
    a->has_isa = true;
    if (!schuler_isa_available(a->isa))
        argp_error(state, "--isa: this processor or this build does not have %s", text);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    simulation_arguments *a = state->input;
    if ((key == KEY_JSON || key == 'o') && !*arg) argp_error(state, "an empty file name");
    switch (key) {
    case KEY_IMU:
        if (a->count_imus == SIMULATION_SET_MAX)
            argp_error(state, "--imu: more than %d of them", SIMULATION_SET_MAX);
        a->overrides.imu = a->imus[a->count_imus++] = arg;
        return 0;
    case KEY_RUNS:
        a->overrides.has_runs = 1;
        a->overrides.runs = (int)arguments_integer(state, "--runs", arg, 1, SIMULATION_RUNS_MAX);
        return 0;
    case KEY_SEED:
        a->overrides.has_seed = 1;
        a->overrides.seed = (uint64_t)arguments_integer(state, "--seed", arg, 0, INT64_MAX);
        return 0;
    case KEY_SET:
        if (!strchr(arg, '=')) argp_error(state, "--set: '%s' is not KEY=VALUE", arg);
        if (a->overrides.count_set == SIMULATION_SET_MAX)
            argp_error(state, "--set: more than %d of them", SIMULATION_SET_MAX);
        a->set[a->overrides.count_set++] = arg;
        return 0;
    case KEY_ONLY:
        if (a->overrides.only || !*arg)
            argp_error(state, "--only: one list, SOURCE,..., not empty");
        a->overrides.only = arg;
        return 0;
    case KEY_WITHOUT:
        if (a->overrides.without || !*arg)
            argp_error(state, "--without: one list, SOURCE,..., not empty");
        a->overrides.without = arg;
        return 0;
    case KEY_JSON:
        a->json = arg;
        return 0;
    case 'o':
        a->directory = arg;
        return 0;
    case KEY_THREADS:
        a->threads = (int)arguments_integer(state, "--threads", arg, 0, 1024);
        return 0;
    case KEY_ISA:
        read_isa(a, arg, state);
        return 0;
    case KEY_PLUGIN:
        if (a->count_files == SIMULATION_SET_MAX)
            argp_error(state, "--plugin: more than %d of them", SIMULATION_SET_MAX);
        plugin_argument(&a->plugins, arg);
        a->files[a->count_files++] = arg;
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_END:
        a->overrides.set = a->set;
        a->overrides.plugins = a->plugins;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void simulation_take_file(simulation_arguments *a, char *file, struct argp_state *state)
{
    if (a->file) argp_error(state, "one scenario file, not also '%s'", file);
    a->file = file;
}

void simulation_need_file(const simulation_arguments *a, struct argp_state *state,
                          bool has_directory)
{
    if (!a->file) argp_error(state, "which scenario file? ('schuler init' lists templates)");
    if (a->directory && !has_directory)
        argp_error(state, "-o DIR belongs to run; this verb writes what its own switches say");
}

const struct argp simulation_argp = { .options = options, .parser = parse };
const struct argp simulation_argp_single = { .options = options + OF_BUDGETS, .parser = parse };

static void put_switch(FILE *out, const char *name, const char *value)
{
    if (!value) return;
    fprintf(out, " --%s '", name);
    for (; *value; value++) fputc(*value == '\n' || *value == '\r' ? ' ' : *value, out);
    fputc('\'', out);
}

char *simulation_switches(const simulation_arguments *a)
{
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    if (!out) return NULL;
    const schuler_overrides *o = &a->overrides;
    if (o->has_seed) fprintf(out, " --seed %llu", (unsigned long long)o->seed);
    if (o->has_runs) fprintf(out, " --runs %d", o->runs);
    put_switch(out, "imu", o->imu);
    put_switch(out, "only", o->only);
    put_switch(out, "without", o->without);
    for (size_t i = 0; i < o->count_set; i++) put_switch(out, "set", o->set[i]);
    for (size_t i = 0; i < a->count_files; i++) put_switch(out, "plugin", a->files[i]);
    if (fclose(out) == EOF) {
        free(text);
        return NULL;
    }
    return text;
}

/* SPDX-License-Identifier: MIT */
#include "tools/characterize_arguments.h"
#include "sensors/catalog.h"
#include "tools/arguments.h"
#include "tools/gnuplot.h"
#include "tools/plugin_argument.h"
#include <stdlib.h>
#include <string.h>

enum {
    KEY_INSTRUMENT = 1000,
    KEY_INPUT,
    KEY_CROSS,
    KEY_UNITS,
    KEY_FOR,
    KEY_RATE,
    KEY_SEED,
    KEY_ONLY,
    KEY_WITHOUT,
    KEY_JSON,
    KEY_CSV,
    KEY_SERIES,
    KEY_ALLAN,
    KEY_PLOT,
    KEY_THREADS,
    KEY_PLUGIN
};

static const struct argp_option options[] = {
    { "instrument", KEY_INSTRUMENT, "WORD", 0,
      "accel or gyro (default: accel where the sensor has one)", 0 },
    { "input", KEY_INPUT, "VALUE", 0, "along the input axis (default 1 g, gyros 10 deg/s)", 0 },
    { "cross", KEY_CROSS, "VALUE", 0, "across it (default: the same as --input's)", 0 },
    { "units", KEY_UNITS, "N", 0, "units drawn of each sensor (default 100)", 0 },
    { "for", KEY_FOR, "TIME", 0, "time of each unit on the stand (default 10 s)", 0 },
    { "rate", KEY_RATE, "RATE", 0,
      "samples a second (default: twice the bandwidth, else the sensor's rate)", 0 },
    { "seed", KEY_SEED, "N", 0, "of all random draws (default 1)", 0 },
    { "only", KEY_ONLY, "SOURCE,...", 0, "only these error sources", 0 },
    { "without", KEY_WITHOUT, "SOURCE,...", 0, "all but these", 0 },
    { "json", KEY_JSON, "FILE", 0, "everything but the series as JSON; - is standard output", 0 },
    { "csv", KEY_CSV, "FILE", 0, "a row for each sensor, SI", 0 },
    { "series", KEY_SERIES, "FILE", 0, "output of the first unit over time, SI", 0 },
    { "allan", KEY_ALLAN, "FILE", 0, "Allan deviations, SI", 0 },
    { "plot", KEY_PLOT, "FILE", 0, "picture, .svg or .png (needs gnuplot)", 0 },
    { "threads", KEY_THREADS, "N", 0, "default: all processors; results do not depend on it", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { "quiet", 'q', NULL, 0, "no tables, no warnings, no progress", 0 },
    { 0 },
};

/* "paper" is the ten accelerometers of the paper, as printed. */
static void add_sensor(characterize_arguments *a, struct argp_state *state, const char *name)
{
    static const char prefix[] = "paper-", corrected[] = "-corrected";
    if (strcmp(name, "paper") != 0) {
        if (a->count == CHARACTERIZE_SENSORS_MAX)
            argp_error(state, "more than %d sensors", CHARACTERIZE_SENSORS_MAX);
        a->sensor[a->count++] = name;
        return;
    }
    for (const schuler_catalog_entry *e = schuler_catalog; e->name; e++)
        if (strncmp(e->name, prefix, sizeof prefix - 1) == 0 && !strstr(e->name, corrected))
            add_sensor(a, state, e->name);
}

static void once(struct argp_state *state, const char *option, char **list, const char *arg)
{
    if (*list || !*arg) argp_error(state, "%s: one list, SOURCE,..., not empty", option);
    *list = strdup(arg);
    if (!*list) argp_failure(state, EXIT_FAILED, 0, "out of memory");
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    static const char *const instruments[] = { "accel", "gyro", NULL };
    characterize_arguments *a = state->input;
    switch (key) {
    case KEY_INSTRUMENT:
        a->has_instrument = true;
        a->instrument =
            (schuler_instrument)arguments_choice(state, "--instrument", arg, instruments);
        return 0;
    case KEY_INPUT:
        a->input = arg;
        return 0;
    case KEY_CROSS:
        a->cross = arg;
        return 0;
    case KEY_UNITS:
        a->options.units =
            (int)arguments_integer(state, "--units", arg, 1, SCHULER_CHARACTERIZE_UNITS_MAX);
        return 0;
    case KEY_FOR:
        a->options.duration_s =
            arguments_quantity(state, "--for", arg, (schuler_dim)SCHULER_DIM_TIME, 1e-6, 1e9);
        return 0;
    case KEY_RATE:
        a->options.rate_hz =
            arguments_quantity(state, "--rate", arg, (schuler_dim)SCHULER_DIM_FREQUENCY, 1e-6, 1e7);
        return 0;
    case KEY_SEED:
        a->options.seed = (uint64_t)arguments_integer(state, "--seed", arg, 0, INT64_MAX);
        return 0;
    case KEY_ONLY:
        once(state, "--only", &a->only, arg);
        return 0;
    case KEY_WITHOUT:
        once(state, "--without", &a->without, arg);
        return 0;
    case KEY_JSON:
        a->json = arg;
        return 0;
    case KEY_CSV:
        a->csv = arg;
        return 0;
    case KEY_SERIES:
        a->series = arg;
        return 0;
    case KEY_ALLAN:
        a->allan = arg;
        return 0;
    case KEY_PLOT:
        gnuplot_check(state, arg);
        a->plot = arg;
        return 0;
    case KEY_THREADS:
        a->options.threads = (int)arguments_integer(state, "--threads", arg, 1, 64);
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        add_sensor(a, state, arg);
        return 0;
    case ARGP_KEY_END:
        if (a->count == 0) argp_error(state, "which sensor? ('schuler sensors' lists them)");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp characterize_argp = {
    .options = options,
    .parser = parse,
    .args_doc = "SENSOR...",
    .doc =
        "Put sensors on a test stand with a constant input: units are drawn as their data sheet "
        "says, "
        "and the mean output, its spread over the units, the noise, and the Allan deviation are "
        "measured, each beside what the data sheet promises. SENSOR is a name of the catalog or a "
        "sensor file; several stand side by side; 'paper' is the ten accelerometers of the "
        "paper that the datasheet model comes from, as its table prints them."
        "\vExamples:\n"
        "  schuler characterize paper\n"
        "  schuler characterize stim300 --instrument gyro --for 1h --rate 100Hz --units 16\n"
        "  schuler characterize paper-qa750 --only accel.noise_density --plot qa750.svg\n"
        "Sources have the names that 'schuler models' lists." ARGUMENTS_EXIT_STATUS,
};

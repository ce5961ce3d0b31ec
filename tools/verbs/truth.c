/* SPDX-License-Identifier: MIT */
/* schuler truth: exact increments and the true trajectory as data files. */
#include "tools/arguments.h"
#include "tools/messages.h"
#include "tools/plugin_argument.h"
#include "tools/scenario_input.h"
#include "tools/simulation_arguments.h"
#include "tools/truth_files.h"
#include <math.h>
#include <stdlib.h>

enum { KEY_IMU_OUT = 256, KEY_REFERENCE_OUT, KEY_EVERY, KEY_RATES, KEY_SET, KEY_PLUGIN };

typedef struct {
    const char *file, *every;
    truth_files files;
    schuler_plugins *plugins;
    schuler_overrides overrides;
    const char *set[SIMULATION_SET_MAX];
} truth_arguments;

static const struct argp_option options[] = {
    { "imu-out", KEY_IMU_OUT, "I.csv", 0, "write the increments of a perfect IMU", 0 },
    { "reference-out", KEY_REFERENCE_OUT, "R.csv", 0, "write position, velocity and attitude", 0 },
    { "reference-every", KEY_EVERY, "TIME", 0,
      "interval of the reference's rows, such as '1 s' (default: each sample)", 0 },
    { "rates", KEY_RATES, NULL, 0,
      "rate (rad/s) and specific force (m/s^2) at each row's time instead of increments, from the "
      "start on",
      0 },
    { "set", KEY_SET, "PATH=VALUE", 0, "change a value of the scenario; may be repeated", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { "quiet", 'q', NULL, 0, "no progress and no warnings", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    truth_arguments *a = state->input;
    switch (key) {
    case KEY_IMU_OUT:
        a->files.imu = arg;
        return 0;
    case KEY_REFERENCE_OUT:
        a->files.reference = arg;
        return 0;
    case KEY_EVERY:
        a->every = arg;
        return 0;
    case KEY_RATES:
        a->files.rates = true;
        return 0;
    case KEY_SET:
        if (a->overrides.count_set == SIMULATION_SET_MAX) argp_error(state, "too many --set");
        a->set[a->overrides.count_set++] = arg;
        a->overrides.set = a->set;
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        a->overrides.plugins = a->plugins;
        return 0;
    case 'q':
        a->files.quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (a->file) argp_error(state, "one scenario file, not also '%s'", arg);
        a->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->file) argp_error(state, "which scenario file?");
        if (!a->files.imu && !a->files.reference)
            argp_error(state, "nothing to write: give --imu-out, --reference-out or both");
        if (a->files.rates && !a->files.imu)
            argp_error(state, "--rates is about --imu-out, which is not given");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "FILE",
    .doc = "Write what a perfect IMU would deliver on the mission of a scenario, and the motion "
           "itself. "
           "Increments are exact integrals of inertial rate and specific force, body axes "
           "forward-right-down; numbers have 17 significant digits. A file whose name ends with "
           ".nc is "
           "written as NetCDF-4, with units, names and the scenario in it."
           "\vExamples:\n"
           "  schuler truth flight.yaml --imu-out imu.csv --reference-out reference.csv\n"
           "  schuler truth flight.yaml --reference-out track.csv --reference-every '10 s'\n"
           "  schuler truth flight.yaml --imu-out imu.nc --rates --reference-out reference.nc\n"
           "  schuler navigate --imu imu.csv --reference reference.csv --out "
           "solution.csv\n" ARGUMENTS_EXIT_STATUS,
};

static exit_code write_truth(const schuler_scenario *s, truth_arguments *a)
{
    schuler_error error = { 0 };
    double every_s = 0.0;
    if (a->every && schuler_quantity_parse(a->every, (schuler_dim)SCHULER_DIM_TIME, &every_s,
                                           &error) != SCHULER_OK)
        return say_bad_input("--reference-every: %s", error.message);
    if (a->every && !(every_s > 0.0))
        return say_bad_input("--reference-every: a time above zero is needed");
    const double samples = every_s * s->imu.rate_hz;
    const int64_t every = a->files.every =
        samples < 1.0 ? 1 : (int64_t)llround(fmin(samples, 1e15));
    if (a->every && fabs(samples - (double)every) > 1e-6 * (double)every)
        return say_bad_input("--reference-every: %g s is no whole number of samples at %g Hz",
                             every_s, s->imu.rate_hz);
    schuler_truth *truth = NULL;
    const schuler_status status = schuler_truth_create(&truth, &s->path, 1.0 / s->imu.rate_hz,
                                                       s->truth_gravity, s->nav_gravity, &error);
    if (status != SCHULER_OK) {
        say_error(&error);
        return exit_of(status);
    }
    const exit_code code = truth_files_write(truth, s, &a->files);
    schuler_truth_free(truth);
    return code;
}

exit_code verb_truth(int argc, char **argv)
{
    truth_arguments a = { 0 };
    char *const command = truth_files_command(argc, argv);
    if (!command) return say_failure("out of memory");
    a.files.command = command;
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *s;
    exit_code code = scenario_input(a.file, &a.overrides, a.files.quiet, &s);
    if (code == EXIT_DONE) code = write_truth(s, &a);
    schuler_scenario_free(s);
    schuler_plugins_free(a.plugins);
    free(command);
    return code;
}

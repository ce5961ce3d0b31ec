/* SPDX-License-Identifier: MIT */
/* schuler truth: exact increments and the true trajectory as data files. */
#include "core/truth.h"
#include "scenarios/scenario.h"
#include "scenarios/trajectory_file.h"
#include "tools/arguments.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/plugin_argument.h"
#include "tools/scenario_input.h"
#include "tools/simulation_arguments.h"
#include "tools/stop.h"
#include "tools/terminal.h"
#include <math.h>

enum { KEY_IMU_OUT = 256, KEY_REFERENCE_OUT, KEY_EVERY, KEY_SET, KEY_PLUGIN };

typedef struct {
    const char *file, *imu, *reference, *every;
    bool quiet;
    schuler_plugins *plugins;
    schuler_overrides overrides;
    const char *set[SIMULATION_SET_MAX];
} truth_arguments;

static const struct argp_option options[] = {
    { "imu-out", KEY_IMU_OUT, "I.csv", 0, "write the increments of a perfect IMU", 0 },
    { "reference-out", KEY_REFERENCE_OUT, "R.csv", 0, "write position, velocity and attitude", 0 },
    { "reference-every", KEY_EVERY, "TIME", 0,
      "interval of the reference's rows, such as '1 s' (default: each sample)", 0 },
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
        a->imu = arg;
        return 0;
    case KEY_REFERENCE_OUT:
        a->reference = arg;
        return 0;
    case KEY_EVERY:
        a->every = arg;
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
        a->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (a->file) argp_error(state, "one scenario file, not also '%s'", arg);
        a->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->file) argp_error(state, "which scenario file?");
        if (!a->imu && !a->reference)
            argp_error(state, "nothing to write: give --imu-out, --reference-out or both");
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
           "forward-right-down; numbers have 17 significant digits."
           "\vExamples:\n"
           "  schuler truth flight.yaml --imu-out imu.csv --reference-out reference.csv\n"
           "  schuler truth flight.yaml --reference-out track.csv --reference-every '10 s'\n"
           "  schuler navigate --imu imu.csv --reference reference.csv --out "
           "solution.csv\n" ARGUMENTS_EXIT_STATUS,
};

static void put_reference(FILE *out, const schuler_truth *truth, double t_s)
{
    schuler_truth_state state;
    schuler_truth_at(truth, t_s, &state);
    const schuler_trajectory_row row = {
        t_s, state.llh, state.v_n, state.roll_rad, state.pitch_rad, state.heading_rad
    };
    char line[SCHULER_TRAJECTORY_LINE_MAX];
    fwrite(line, 1, schuler_trajectory_line(line, &row), out);
}

/* Either file may be NULL. every: steps between the reference's rows; the last step has one too. */
static exit_code put_rows(const schuler_truth *truth, int64_t every, FILE *imu, FILE *reference,
                          progress *bar)
{
    const int64_t steps = schuler_truth_steps(truth);
    const double dt_s = schuler_truth_dt(truth);
    if (imu) fputs(SCHULER_IMU_HEADER "\n", imu);
    if (reference) {
        fputs(SCHULER_TRAJECTORY_HEADER "\n", reference);
        put_reference(reference, truth, 0.0);
    }
    for (int64_t first = 0; first < steps; first += SCHULER_BLOCK) {
        schuler_truth_block block;
        const int n = steps - first < SCHULER_BLOCK ? (int)(steps - first) : SCHULER_BLOCK;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, n, &block);
        for (int k = 0; k < n; k++) {
            const int64_t step = first + k + 1;
            const double t_s = (double)step * dt_s;
            if (imu) {
                const double dtheta[3] = { block.dtheta_ib_b[0][k], block.dtheta_ib_b[1][k],
                                           block.dtheta_ib_b[2][k] };
                const double dv[3] = { block.dv_ib_b[0][k], block.dv_ib_b[1][k],
                                       block.dv_ib_b[2][k] };
                char line[SCHULER_IMU_LINE_MAX];
                fwrite(line, 1, schuler_imu_line(line, t_s, dtheta, dv), imu);
            }
            if (reference && (step % every == 0 || step == steps))
                put_reference(reference, truth, t_s);
        }
        if (*stop_flag()) {
            progress_end(bar);
            fputs("schuler: interrupted; nothing was written\n", stderr);
            return EXIT_INTERRUPTED;
        }
        if ((imu && ferror(imu)) || (reference && ferror(reference)))
            return EXIT_DONE; /* said at the end */
        if (first / SCHULER_BLOCK % 512 == 0) progress_show(bar, (double)first / (double)steps);
    }
    return EXIT_DONE;
}

static exit_code write_files(const schuler_truth *truth, int64_t every, const truth_arguments *a)
{
    outfile imu = { 0 }, reference = { 0 };
    progress bar = progress_start(a->quiet);
    exit_code code = a->imu ? outfile_open(&imu, a->imu) : EXIT_DONE;
    if (code == EXIT_DONE && a->reference) code = outfile_open(&reference, a->reference);
    if (code == EXIT_DONE) {
        code = put_rows(truth, every, imu.file, reference.file, &bar);
    }
    progress_end(&bar);
    /* Neither appears unless both are whole. */
    if (code == EXIT_DONE && a->imu) code = outfile_complete(&imu);
    if (code == EXIT_DONE && a->reference) code = outfile_publish(&reference);
    if (code == EXIT_DONE && a->imu) code = outfile_publish(&imu);
    outfile_drop(&imu);
    outfile_drop(&reference);
    return code;
}

static exit_code write_truth(const schuler_scenario *s, const truth_arguments *a)
{
    schuler_error error = { 0 };
    double every_s = 0.0;
    if (a->every && schuler_quantity_parse(a->every, (schuler_dim)SCHULER_DIM_TIME, &every_s,
                                           &error) != SCHULER_OK)
        return say_bad_input("--reference-every: %s", error.message);
    if (a->every && !(every_s > 0.0))
        return say_bad_input("--reference-every: a time above zero is needed");
    const double samples = every_s * s->imu.rate_hz;
    const int64_t every = samples < 1.0 ? 1 : (int64_t)llround(fmin(samples, 1e15));
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
    const exit_code code = write_files(truth, every, a);
    schuler_truth_free(truth);
    return code;
}

exit_code verb_truth(int argc, char **argv)
{
    truth_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *s;
    exit_code code = scenario_input(a.file, &a.overrides, a.quiet, &s);
    if (code == EXIT_DONE) code = write_truth(s, &a);
    schuler_scenario_free(s);
    schuler_plugins_free(a.plugins);
    return code;
}

/* SPDX-License-Identifier: MIT */
/* schuler navigate: mechanize recorded increments, compare with a reference. */
#include "scenarios/navigate.h"
#include "mechanization/mechanization.h"
#include "tools/arguments.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/navigate_report.h"
#include "tools/outfile.h"
#include "tools/stop.h"
#include "tools/terminal.h"
#include <string.h>

enum {
    KEY_IMU = 1000,
    KEY_REFERENCE,
    KEY_OUT,
    KEY_FRAME,
    KEY_GRAVITY,
    KEY_VERTICAL,
    KEY_CONING,
    KEY_BRIDGE,
    KEY_JSON
};

typedef struct {
    const char *out, *json;
    bool quiet;
    navigate_names names;
    schuler_navigate_options options;
} navigate_arguments;

static const struct argp_option options[] = {
    { "imu", KEY_IMU, "FILE", 0, "recorded increments, CSV or NetCDF (.nc)", 0 },
    { "reference", KEY_REFERENCE, "FILE", 0,
      "trajectory to start from and compare with, CSV or NetCDF", 0 },
    { "out", KEY_OUT, "FILE", 0, "the navigator's trajectory, at the reference's times", 0 },
    { "frame", KEY_FRAME, "NAME", 0, "navigation frame (default ecef)", 0 },
    { "gravity", KEY_GRAVITY, "NAME", 0, "wgs84 (default), grs80 or an installed data set", 0 },
    { "vertical", KEY_VERTICAL, "MODE", 0,
      "free (default), truth: held to the reference, or baro: steadied by its height", 0 },
    { "coning", KEY_CONING, "NAME", 0, "attitude algorithm (default cubic)", 0 },
    { "bridge", KEY_BRIDGE, NULL, 0,
      "go on across gaps of up to a minute, filled with the row after, and leave out rows out of "
      "time (default: an error)",
      0 },
    { "json", KEY_JSON, "FILE", 0,
      "errors, their growth, faults of the data and timing as JSON; - is standard output", 0 },
    { "quiet", 'q', NULL, 0, "print no errors, no warnings, no progress", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    static const char *const verticals[] = { "truth", "free", "baro", NULL };
    const char *known[NAMES_MAX];
    navigate_arguments *a = state->input;
    switch (key) {
    case KEY_IMU:
        a->options.imu_file = arg;
        return 0;
    case KEY_REFERENCE:
        a->options.reference_file = arg;
        return 0;
    case KEY_OUT:
        a->out = arg;
        return 0;
    case KEY_FRAME:
        names_of_frames(known);
        a->options.frame = arguments_choice(state, "--frame", arg, known);
        a->names.frame = arg;
        return 0;
    case KEY_GRAVITY:
        a->options.gravity = arg;
        return 0;
    case KEY_VERTICAL:
        a->options.vertical =
            (schuler_vertical)arguments_choice(state, "--vertical", arg, verticals);
        a->names.vertical = arg;
        return 0;
    case KEY_CONING:
        names_of_coning(known);
        a->options.coning = arguments_choice(state, "--coning", arg, known);
        return 0;
    case KEY_BRIDGE:
        a->options.bridge = 1;
        return 0;
    case KEY_JSON:
        a->json = arg;
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        argp_error(state, "files are given with --imu, --reference, --out, not '%s'", arg);
        return 0;
    case ARGP_KEY_END:
        if (!a->options.imu_file || !a->options.reference_file || !a->out)
            argp_error(state, "--imu, --reference and --out are all needed");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "--imu FILE --reference FILE --out FILE",
    .doc =
        "Navigate over recorded increments: start from the reference's first row, write the "
        "trajectory at the reference's times and print how far it is off. The format is that of "
        "'schuler truth'; each time of the reference must be one of the increments' times. What "
        "is odd in the data is told: gaps, times repeated, backward or off the interval, spikes, "
        "sensors that stand still, a reference that is not covered or does not fit itself."
        "\vExamples:\n"
        "  schuler navigate --imu imu.csv --reference reference.csv --out nav.csv\n"
        "  schuler navigate --imu imu.csv --reference reference.csv --out nav.csv \\\n"
        "      --vertical truth --json -\n" ARGUMENTS_EXIT_STATUS,
};

typedef struct {
    progress bar;
    outfile out;
} sink;

static schuler_status on_row(void *user, const schuler_trajectory_row *row)
{
    sink *s = user;
    char line[SCHULER_TRAJECTORY_LINE_MAX];
    fwrite(line, 1, schuler_trajectory_line(line, row), s->out.file);
    return ferror(s->out.file) ? SCHULER_ERR_FILE : SCHULER_OK;
}

static void on_progress(void *user, double fraction)
{
    sink *s = user;
    progress_show(&s->bar, fraction);
}

static exit_code deliver(const schuler_navigate_result *r, const navigate_arguments *a, sink *s)
{
    exit_code code = outfile_publish(&s->out);
    if (code != EXIT_DONE) return code;
    if (r->rows == 1 && !a->quiet)
        say_warning("nothing to compare: only the reference's first row is left");
    if (a->json) code = json_write(navigate_json(r, &a->options, &a->names), a->json);
    if (code == EXIT_DONE && !a->quiet && !(a->json && strcmp(a->json, "-") == 0))
        code = navigate_print(r, &a->options, &a->names);
    return code;
}

exit_code verb_navigate(int argc, char **argv)
{
    navigate_arguments a = {
        .names = { .frame = "ecef", .vertical = "free" },
        .options = { .gravity = "wgs84", .vertical = SCHULER_VERTICAL_FREE },
    };
    a.options.frame = schuler_mechanization_find(a.names.frame);
    arguments_parse(&argp, argc, argv, &a);
    sink s = { .bar = progress_start(a.quiet) };
    exit_code code = outfile_open(&s.out, a.out);
    if (code != EXIT_DONE) return code;
    fputs(SCHULER_TRAJECTORY_HEADER "\n", s.out.file);
    a.options.row = on_row;
    a.options.progress = on_progress;
    a.options.user = &s;
    a.options.stop = stop_flag();
    stop_catch();
    schuler_navigate_result result = { 0 };
    schuler_error error = { 0 };
    const schuler_status status = schuler_navigate(&a.options, &result, &error);
    progress_end(&s.bar);
    code = exit_of(status);
    if (!a.quiet) navigate_warn(&result, &a.options);
    if (status == SCHULER_OK)
        code = deliver(&result, &a, &s);
    else if (status == SCHULER_ERR_INTERRUPTED)
        fputs("schuler: interrupted; nothing was written\n", stderr);
    else if (status == SCHULER_ERR_FILE && ferror(s.out.file))
        code = outfile_complete(&s.out); /* says why */
    else {
        say_error(&error);
        /* The only files the library reads here are input. */
        if (status == SCHULER_ERR_FILE) code = EXIT_INPUT;
    }
    outfile_drop(&s.out);
    return code;
}

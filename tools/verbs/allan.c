/* SPDX-License-Identifier: MIT */
/* schuler allan: Allan deviation, noise coefficients and a sensor file from recorded data. */
#include "tools/allan_report.h"
#include "tools/arguments.h"
#include "tools/gnuplot.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/stop.h"
#include "tools/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_COLUMNS = 1000,
    KEY_RATE,
    KEY_INSTRUMENT,
    KEY_INCREMENTS,
    KEY_RATES,
    KEY_PSD,
    KEY_PSD_CSV,
    KEY_SEGMENT,
    KEY_TERMS,
    KEY_FLICKER,
    KEY_CONFIDENCE,
    KEY_JSON,
    KEY_CSV,
    KEY_OUT,
    KEY_NAME,
    KEY_PLOT,
    KEY_THREADS
};

typedef struct {
    const char *file, *json, *csv, *psd_csv, *out, *name, *plot;
    bool quiet, psd;
    schuler_recording_options recording;
    schuler_identify_options identify;
    progress bar;
} allan_arguments;

static const struct argp_option options[] = {
    { "columns", KEY_COLUMNS, "NAMES", 0,
      "columns to analyse, with their unit: gx,gy,gz:deg/s,ax:g (default: all whose names end with "
      "a unit, such as gx_degps)",
      0 },
    { "rate", KEY_RATE, "RATE", 0, "samples a second, 200Hz (default: from the column of time)",
      0 },
    { "instrument", KEY_INSTRUMENT, "WORD", 0, "gyro or accel: only these columns", 0 },
    { "increments", KEY_INCREMENTS, NULL, 0, "only columns of angles and speeds", 0 },
    { "rates", KEY_RATES, NULL, 0, "only columns of angular rates and accelerations", 0 },
    { "terms", KEY_TERMS, "LETTERS", 0, "what to fit, of Q,N,B,K,R (default: all)", 0 },
    { "flicker", KEY_FLICKER, "WORD", 0,
      "shape of the bias instability: bank (default), that of the simulator, or ideal", 0 },
    { "confidence", KEY_CONFIDENCE, "LEVEL", 0, "of the limits (default 0.95)", 0 },
    { "psd", KEY_PSD, NULL, 0, "print the spectral density too", 0 },
    { "psd-csv", KEY_PSD_CSV, "FILE", 0, "spectral density at every frequency, two-sided, SI", 0 },
    { "segment", KEY_SEGMENT, "N", 0, "samples in a segment of the spectrum, even", 0 },
    { "json", KEY_JSON, "FILE", 0, "everything as JSON; - is standard output", 0 },
    { "csv", KEY_CSV, "FILE", 0, "deviations, limits and fit, SI", 0 },
    { "out", KEY_OUT, "FILE", 0, "write a sensor file", 0 },
    { "name", KEY_NAME, "NAME", 0, "of the sensor (default: from the file's name)", 0 },
    { "plot", KEY_PLOT, "FILE", 0, "draw the deviations, .svg or .png (needs gnuplot)", 0 },
    { "threads", KEY_THREADS, "N", 0, "default: all processors; results do not depend on it", 0 },
    { "quiet", 'q', NULL, 0, "no tables, no warnings, no progress", 0 },
    { 0 },
};

static unsigned parse_terms(struct argp_state *state, const char *text)
{
    static const char letters[] = "QNBKR";
    unsigned terms = 0;
    for (const char *p = text; *p; p++) {
        const char *const at = strchr(letters, *p);
        if (*p == ',' || *p == ' ') continue;
        if (!at) argp_error(state, "--terms: '%c' is not one of Q, N, B, K, R", *p);
        terms |= 1u << (at - letters);
    }
    if (!terms) argp_error(state, "--terms: at least one of Q, N, B, K, R is needed");
    return terms;
}

static double parse_level(struct argp_state *state, const char *text)
{
    char *end;
    const double level = strtod(text, &end);
    if (end == text || *end || !(level >= 0.5 && level <= 0.9999))
        argp_error(state, "--confidence: '%s' is not a number from 0.5 to 0.9999", text);
    return level;
}

static void set_kind(struct argp_state *state, allan_arguments *a, schuler_data_kind kind)
{
    if (a->recording.kind != SCHULER_DATA_ANY && a->recording.kind != kind)
        argp_error(state, "--increments and --rates exclude each other");
    a->recording.kind = kind;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    static const char *const instruments[] = { "accel", "gyro", NULL };
    static const char *const shapes[] = { "bank", "ideal", NULL };
    allan_arguments *a = state->input;
    switch (key) {
    case KEY_COLUMNS:
        a->recording.columns = arg;
        return 0;
    case KEY_RATE:
        a->recording.rate_hz =
            arguments_quantity(state, "--rate", arg, (schuler_dim)SCHULER_DIM_FREQUENCY, 1e-6, 1e9);
        return 0;
    case KEY_INSTRUMENT:
        a->recording.only_instrument = 1;
        a->recording.instrument =
            (schuler_instrument)arguments_choice(state, "--instrument", arg, instruments);
        return 0;
    case KEY_INCREMENTS:
        set_kind(state, a, SCHULER_DATA_INCREMENTS);
        return 0;
    case KEY_RATES:
        set_kind(state, a, SCHULER_DATA_RATES);
        return 0;
    case KEY_PSD:
        a->psd = true;
        return 0;
    case KEY_PSD_CSV:
        a->psd_csv = arg;
        return 0;
    case KEY_SEGMENT:
        a->identify.segment = (int)arguments_integer(state, "--segment", arg, SCHULER_SEGMENT_MIN,
                                                     SCHULER_SEGMENT_MAX);
        return 0;
    case KEY_TERMS:
        a->identify.terms = parse_terms(state, arg);
        return 0;
    case KEY_FLICKER:
        a->identify.ideal_flicker = arguments_choice(state, "--flicker", arg, shapes);
        return 0;
    case KEY_CONFIDENCE:
        a->identify.level = parse_level(state, arg);
        return 0;
    case KEY_JSON:
        a->json = arg;
        return 0;
    case KEY_CSV:
        a->csv = arg;
        return 0;
    case KEY_OUT:
        a->out = arg;
        return 0;
    case KEY_NAME:
        a->name = arg;
        return 0;
    case KEY_PLOT:
        gnuplot_check(state, arg);
        a->plot = arg;
        return 0;
    case KEY_THREADS:
        a->identify.threads = (int)arguments_integer(state, "--threads", arg, 1, 256);
        a->recording.threads = a->identify.threads;
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (a->file) argp_error(state, "one file of data, not also '%s'", arg);
        a->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->file) argp_error(state, "which file of data?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "DATA",
    .doc =
        "Allan deviation of recorded data of a sensor at rest, and the noise coefficients in it "
        "with "
        "their limits: quantization Q, random walk N, bias instability B, rate random walk K, ramp "
        "R, conventions of IEEE Std 952. DATA is a CSV file with a header; a column's unit is the "
        "end of its name (_radps, _degps, _degph, _mps2, _g, _rad, _mps; the time _s) or given."
        "\vExamples:\n"
        "  schuler allan imu.csv --out imu.sensor.yaml\n"
        "  schuler allan static.csv --rate 200Hz --columns gx,gy,gz:deg/s\n"
        "  schuler run flight.yaml --imu imu.sensor.yaml\n" ARGUMENTS_EXIT_STATUS,
};

/* "data/static.csv" is "static". */
static const char *default_name(const char *file, char *text, size_t size)
{
    const char *const slash = strrchr(file, '/');
    snprintf(text, size, "%s", slash ? slash + 1 : file);
    char *const dot = strrchr(text, '.');
    if (dot && dot != text) *dot = '\0';
    return text;
}

static exit_code write_sensor(const allan_report *r, const allan_arguments *a)
{
    outfile file = { 0 };
    char name[64];
    exit_code code = outfile_open(&file, a->out);
    if (code == EXIT_DONE)
        code = allan_put_sensor(file.file, r,
                                a->name ? a->name : default_name(a->file, name, sizeof name));
    if (code == EXIT_DONE) code = outfile_publish(&file);
    outfile_drop(&file);
    return code;
}

/* What the five terms cannot explain. */
static void doubt_fit(const allan_report *r)
{
    for (int i = 0; i < r->found->columns; i++) {
        const schuler_allan_fit *const fit = &r->found->column[i].fit;
        if (fit->worst <= 5.0) continue;
        char tau[32];
        allan_time(tau, sizeof tau, fit->worst_tau_s);
        say_warning("%s: '%s' has something near %s that the fit does not explain (%.0f standard "
                    "deviations): a vibration, a filter, temperature? the limits do not cover it",
                    r->file, r->recording->column[i].name, tau, fit->worst);
    }
}

static exit_code deliver(const allan_report *r, const allan_arguments *a)
{
    exit_code code = EXIT_DONE;
    if (!a->quiet) doubt_fit(r);
    if (a->out) code = write_sensor(r, a);
    if (code == EXIT_DONE && a->csv) code = outfile_write(a->csv, allan_put_deviations, r);
    if (code == EXIT_DONE && a->psd_csv) code = outfile_write(a->psd_csv, allan_put_spectrum, r);
    if (code == EXIT_DONE && a->plot) code = allan_plot(r, a->plot);
    if (code == EXIT_DONE && a->json) code = json_write(allan_json(r), a->json);
    if (code == EXIT_DONE && !a->quiet && !(a->json && strcmp(a->json, "-") == 0))
        code = allan_print(r, a->psd);
    if (code == EXIT_DONE && a->out && !a->quiet)
        fprintf(stderr, "wrote %s (use it: schuler run SCENARIO --imu %s)\n", a->out, a->out);
    return code;
}

static exit_code refuse(schuler_status status, const schuler_error *error, bool reading)
{
    if (status == SCHULER_ERR_INTERRUPTED) {
        fputs("schuler: interrupted; nothing was written\n", stderr);
        return EXIT_INTERRUPTED;
    }
    say_error(error);
    /* The only file the library reads here is input. */
    return reading && status == SCHULER_ERR_FILE ? EXIT_INPUT : exit_of(status);
}

static void on_progress(void *user, double fraction)
{
    allan_arguments *const a = user;
    progress_show(&a->bar, fraction);
}

exit_code verb_allan(int argc, char **argv)
{
    allan_arguments a = { .identify = { .terms = (1u << SCHULER_ALLAN_TERMS) - 1, .level = 0.95 } };
    arguments_parse(&argp, argc, argv, &a);
    if (a.identify.segment == 0 && (a.psd || a.psd_csv)) a.identify.segment = -1;
    stop_catch();
    a.bar = progress_start(a.quiet);
    a.recording.progress = on_progress;
    a.recording.user = &a;
    a.recording.stop = a.identify.stop = stop_flag();
    schuler_recording *recording;
    schuler_identified *found = NULL;
    schuler_error error = { 0 };
    schuler_status status = schuler_recording_read(&recording, a.file, &a.recording, &error);
    progress_end(&a.bar);
    if (status != SCHULER_OK) return refuse(status, &error, true);
    if (!a.quiet) {
        schuler_diagnostics doubts = { 0 };
        schuler_recording_doubt(recording, a.file, &doubts);
        say_diagnostics(&doubts, true);
        schuler_diagnostics_free(&doubts);
    }
    status = schuler_identify(&found, recording, &a.identify, &error);
    exit_code code;
    if (status == SCHULER_OK) {
        const allan_report report = { a.file, recording, found, a.identify.level,
                                      a.identify.terms };
        code = deliver(&report, &a);
    } else {
        code = refuse(status, &error, false);
    }
    schuler_identified_free(found);
    schuler_recording_free(recording);
    return code;
}

/* SPDX-License-Identifier: MIT */
/* schuler export: a result as CSV of its runs, or as KML of its track. */
#include "tools/export.h"
#include "scenarios/result_netcdf.h"
#include "tools/arguments.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { KEY_CSV = 256, KEY_KML };

typedef struct {
    const char *result, *csv, *kml;
} export_arguments;

static const struct argp_option options[] = {
    { "csv", KEY_CSV, "FILE", 0, "each run of each source: end, largest, drift, velocity", 0 },
    { "kml", KEY_KML, "FILE", 0,
      "true track, and the circles around its end that hold 50 % and 95 % of the navigators", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    export_arguments *a = state->input;
    if ((key == KEY_CSV || key == KEY_KML) && !*arg) argp_error(state, "an empty file name");
    switch (key) {
    case KEY_CSV:
        a->csv = arg;
        return 0;
    case KEY_KML:
        a->kml = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (a->result) argp_error(state, "one result, not also '%s'", arg);
        a->result = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->result) argp_error(state, "which result? (a directory of 'schuler run -o')");
        if (!a->csv && !a->kml) argp_error(state, "nothing to write: give --csv, --kml or both");
        if (a->csv && a->kml && strcmp(a->csv, a->kml) == 0)
            argp_error(state, "--csv and --kml both go to '%s'", a->csv);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "RESULT",
    .doc = "Write a result in the formats of other programs. RESULT is a directory that 'schuler "
           "run -o' made, or the result.nc in it; - is standard output."
           "\vExamples:\n"
           "  schuler export result --csv runs.csv\n"
           "  schuler export result/result.nc --kml track.kml\n" ARGUMENTS_EXIT_STATUS,
};

/* The NetCDF file of a result; to be freed. */
static char *path_of(const char *result)
{
    struct stat info;
    char *path;
    const bool directory = stat(result, &info) == 0 && S_ISDIR(info.st_mode);
    return asprintf(&path, directory ? "%s/result.nc" : "%s", result) < 0 ? NULL : path;
}

static exit_code read_result(schuler_result_file *out, const char *path)
{
    schuler_error error = { 0 };
    const schuler_status status = schuler_result_file_read(out, path, &error);
    if (status != SCHULER_OK) say_error(&error);
    return exit_of(status);
}

/* The result itself would be gone. */
static exit_code check_target(const char *target, const char *path)
{
    struct stat to, from;
    if (!target || stat(target, &to) != 0 || stat(path, &from) != 0) return EXIT_DONE;
    if (to.st_dev != from.st_dev || to.st_ino != from.st_ino) return EXIT_DONE;
    return say_bad_input("%s: this is the result, which would be replaced", target);
}

typedef schuler_status format_put(FILE *out, const schuler_result_file *result);

/* A file complete beside its place; standard output at once. NULL and "-" are passed over when not their
 * turn. */
static exit_code write_file(outfile *file, const char *path, format_put *put,
                            const schuler_result_file *result)
{
    if (!path || strcmp(path, "-") == 0) return EXIT_DONE;
    const exit_code code = outfile_open(file, path);
    if (code != EXIT_DONE) return code;
    if (put(file->file, result) != SCHULER_OK) return say_failure("out of memory");
    return outfile_complete(file);
}

static exit_code show(const char *path, format_put *put, const schuler_result_file *result)
{
    if (!path || strcmp(path, "-") != 0) return EXIT_DONE;
    page p;
    page_open(&p);
    if (p.out && put(p.out, result) != SCHULER_OK) {
        page_drop(&p);
        return say_failure("out of memory");
    }
    return page_show(&p);
}

static exit_code write_all(const export_arguments *a, const schuler_result_file *result)
{
    outfile csv = { 0 }, kml = { 0 };
    exit_code code = write_file(&csv, a->csv, export_csv, result);
    if (code == EXIT_DONE) code = write_file(&kml, a->kml, export_kml, result);
    if (code == EXIT_DONE) code = outfile_publish(&csv);
    if (code == EXIT_DONE) code = outfile_publish(&kml);
    if (code == EXIT_DONE) code = show(a->csv, export_csv, result);
    if (code == EXIT_DONE) code = show(a->kml, export_kml, result);
    outfile_drop(&csv);
    outfile_drop(&kml);
    return code;
}

exit_code verb_export(int argc, char **argv)
{
    export_arguments a = { 0 };
    schuler_result_file result = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    char *const path = path_of(a.result);
    if (!path) return say_failure("out of memory");
    exit_code code = check_target(a.csv, path);
    if (code == EXIT_DONE) code = check_target(a.kml, path);
    if (code == EXIT_DONE) code = read_result(&result, path);
    if (code == EXIT_DONE) code = write_all(&a, &result);
    schuler_result_file_free(&result);
    free(path);
    return code;
}

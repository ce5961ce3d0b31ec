/* SPDX-License-Identifier: MIT */
/* schuler report: one HTML page of a result directory. */
#include "tools/report.h"
#include "tools/arguments.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

typedef struct {
    const char *directory, *output;
} report_arguments;

static const struct argp_option options[] = {
    { "output", 'o', "FILE", 0, "write here instead of DIR.html; - is standard output", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    report_arguments *a = state->input;
    switch (key) {
    case 'o':
        if (!*arg) argp_error(state, "-o: a file name is missing");
        a->output = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (a->directory) argp_error(state, "one result directory, not also '%s'", arg);
        a->directory = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->directory)
            argp_error(state, "which result? ('schuler run FILE -o DIR' writes one)");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "DIR",
    .doc = "One HTML page of the result that 'schuler run FILE -o DIR' wrote: verdict, error over "
           "time, the error budget with its sources to tick off, end points, provenance. The page "
           "is one file, needs no network, and stays small however many the runs."
           "\vExamples:\n"
           "  schuler run scenarios/atlantic.yaml -o result && schuler report result\n"
           "  schuler report result -o page.html\n" ARGUMENTS_EXIT_STATUS,
};

/* DIR.html beside the directory; report.html here where that has no name of its own. */
static char *default_output(const char *directory)
{
    size_t length = strlen(directory);
    while (length > 0 && directory[length - 1] == '/') length--;
    char *path = NULL;
    if (length == 0 || directory[length - 1] == '.') return strdup("report.html");
    return asprintf(&path, "%.*s.html", (int)length, directory) < 0 ? NULL : path;
}

static exit_code put_page(const report_parts *parts, const char *path)
{
    if (strcmp(path, "-") == 0) {
        page p;
        page_open(&p);
        if (!p.out || report_page_put(p.out, parts)) return page_show(&p);
        page_drop(&p);
        return say_failure("out of memory");
    }
    outfile file = { 0 };
    exit_code code = outfile_open(&file, path);
    if (code == EXIT_DONE && !report_page_put(file.file, parts))
        code = say_failure("out of memory");
    if (code == EXIT_DONE) code = outfile_publish(&file);
    outfile_drop(&file);
    if (code != EXIT_DONE) return code;
    page p;
    page_open(&p);
    if (p.out) fprintf(p.out, "Report: %s\n", path);
    return page_show(&p);
}

static exit_code write_page(const json_t *result, const report_curves *curves, const char *scenario,
                            const char *path)
{
    json_t *const json = report_curves_json(curves);
    const report_parts parts = { .result = result, .curves = json, .scenario = scenario };
    const exit_code code = json ? put_page(&parts, path) : say_failure("out of memory");
    json_decref(json);
    return code;
}

static exit_code report(const report_arguments *a, const char *output)
{
    char *paths[3] = { NULL }, *scenario = NULL;
    static const char *const names[] = { "result.json", "scenario.yaml", "errors.csv" };
    json_t *result = NULL;
    report_curves curves = { 0 };
    exit_code code = EXIT_DONE;
    for (int i = 0; i < 3 && code == EXIT_DONE; i++)
        if (asprintf(&paths[i], "%s/%s", a->directory, names[i]) < 0) {
            paths[i] = NULL;
            code = say_failure("out of memory");
        }
    if (code == EXIT_DONE) code = report_result_read(paths[0], &result);
    if (code == EXIT_DONE) code = report_scenario_read(paths[1], result, &scenario);
    if (code == EXIT_DONE) code = report_curves_read(paths[2], result, &curves);
    if (code == EXIT_DONE) code = write_page(result, &curves, scenario, output);
    report_curves_free(&curves);
    json_decref(result);
    free(scenario);
    for (int i = 0; i < 3; i++) free(paths[i]);
    return code;
}

exit_code verb_report(int argc, char **argv)
{
    report_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    struct stat info;
    if (stat(a.directory, &info) != 0 || !S_ISDIR(info.st_mode))
        return say_bad_input("%s: no such directory; 'schuler run FILE -o %s' makes one",
                             a.directory, a.directory);
    char *chosen = a.output ? strdup(a.output) : default_output(a.directory);
    const exit_code code = chosen ? report(&a, chosen) : say_failure("out of memory");
    free(chosen);
    return code;
}

/* SPDX-License-Identifier: MIT */
/* schuler check: validate scenario files without running them. */
#include "core/geographic.h"
#include "scenarios/source_count.h"
#include "tools/arguments.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/page.h"
#include "tools/plugin_argument.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { KEY_PLUGIN = 256 };

typedef struct {
    const char *json;
    bool quiet;
    schuler_plugins *plugins;
    const char **files; /* argv's own, count of them */
    int count;
} check_arguments;

static const struct argp_option options[] = {
    { "json", 'j', "FILE", 0, "what was found as JSON; - is standard output", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { "quiet", 'q', NULL, 0, "errors only: no warnings, no \"ok\"", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    check_arguments *a = state->input;
    switch (key) {
    case 'j':
        a->json = arg;
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        return 0;
    case 'q':
        a->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        a->files[a->count++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->count) argp_error(state, "which scenario file?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "FILE...",
    .doc =
        "Validate scenario files without running them: every mistake of every file at once, each "
        "with file:line:column, what is wrong and what was meant."
        "\vExamples:\n"
        "  schuler check flight.yaml\n"
        "  schuler check scenarios/*.yaml --json -\n"
        "\nExit status: 0 all files are good, 2 a mistake in one of them or on the command line, "
        "3 failed while running.",
};

/* A gravity model that is not installed is known only when it is opened. */
static void check_gravity(const char *name, const char *key, const schuler_scenario *s,
                          schuler_diagnostics *d)
{
    schuler_field_model *field = NULL;
    schuler_error error = { 0 };
    const schuler_place place = { s->file, 0, 0, 0 };
    const schuler_status status = schuler_field_open(&field, name, &error);
    if (status != SCHULER_OK) schuler_diagnose(d, status, &place, "%s: %s", key, error.message);
    schuler_field_close(field);
}

static json_t *report(const char *file, const schuler_diagnostics *d)
{
    json_t *list = json_array();
    for (size_t i = 0; list && i < d->kept; i++)
        json_array_append_new(list, json_of_error(&d->items[i]));
    return json_pack("{s:o, s:b, s:I, s:I, s:o}", "file", json_of_text(file), "ok", d->errors == 0,
                     "errors", (json_int_t)d->errors, "warnings", (json_int_t)d->warnings,
                     "diagnostics", list);
}

/* One file; adds to the page and to the list, both of which may be NULL. */
static exit_code check_file(const char *file, const check_arguments *a, FILE *out, json_t *list)
{
    schuler_scenario *s = NULL;
    schuler_diagnostics d = { 0 };
    const schuler_overrides overrides = { .plugins = a->plugins };
    const schuler_status status = schuler_scenario_load(&s, file, &overrides, &d);
    if (s) {
        check_gravity(s->truth_gravity, "truth.gravity", s, &d);
        if (strcmp(s->truth_gravity, s->nav_gravity) != 0)
            check_gravity(s->nav_gravity, "navigation.gravity", s, &d);
    }
    say_diagnostics(&d, !a->quiet);
    if (s && d.errors == 0 && out && !a->quiet) {
        fprintf(out, "%s: ok, %d error sources, ", file, schuler_scenario_source_count(s));
        page_duration(out, s->path.duration_s);
        fputc('\n', out);
    }
    if (list) json_array_append_new(list, report(file, &d));
    exit_code code = d.errors || status != SCHULER_OK ? EXIT_INPUT : EXIT_DONE;
    if (status == SCHULER_ERR_MEMORY) code = EXIT_FAILED;
    schuler_diagnostics_free(&d);
    schuler_scenario_free(s);
    return code;
}

exit_code verb_check(int argc, char **argv)
{
    check_arguments a = { .files = calloc((size_t)argc + 1, sizeof(char *)) };
    if (!a.files) return say_failure("out of memory");
    arguments_parse(&argp, argc, argv, &a);
    const bool json_on_stdout = a.json && strcmp(a.json, "-") == 0;
    exit_code worst = EXIT_DONE;
    json_t *list = a.json ? json_array() : NULL;
    page p;
    page_open(&p);
    for (int i = 0; i < a.count; i++) {
        const exit_code code = check_file(a.files[i], &a, json_on_stdout ? NULL : p.out, list);
        if (code > worst) worst = code;
    }
    free(a.files);
    schuler_plugins_free(a.plugins);
    exit_code code = page_show(&p);
    if (a.json) {
        json_t *root = json_pack("{s:s, s:s, s:o}", "format", "schuler-check-1", "version",
                                 SCHULER_VERSION, "files", list);
        const exit_code written = json_write(root, a.json);
        if (code == EXIT_DONE) code = written;
    }
    return code == EXIT_DONE ? worst : code;
}

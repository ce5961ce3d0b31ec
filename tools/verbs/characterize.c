/* SPDX-License-Identifier: MIT */
/* schuler characterize: sensors on a test stand. */
#include "core/earth.h"
#include "core/units.h"
#include "scenarios/scenario.h"
#include "tools/arguments.h"
#include "tools/characterize_arguments.h"
#include "tools/characterize_report.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/outfile.h"
#include "tools/stop.h"
#include "tools/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SOURCES_NAMED_MAX = 64 };

/* Cuts "a,b" into a list of names, each a source of the triad. */
static exit_code read_list(char *written, const char *option, const schuler_part *part,
                           schuler_instrument instrument, const char **names,
                           schuler_text_list *list)
{
    const char *const group = schuler_instrument_name(instrument);
    const schuler_param *const params = part->imu.triad[instrument].params;
    static char ids[SCHULER_PARAMS_MAX][64];
    const char *known[SCHULER_PARAMS_MAX + 1];
    int count = 0;
    list->items = names;
    list->count = 0;
    if (!written) return EXIT_DONE;
    for (int k = 0; params[k].key; k++) {
        if (params[k].number == 0) continue;
        snprintf(ids[count], sizeof ids[count], "%s.%s", group, params[k].key);
        known[count] = ids[count];
        count++;
    }
    known[count] = NULL;
    char *rest = NULL, *copy = written;
    for (char *name = strtok_r(copy, ", ", &rest); name; name = strtok_r(NULL, ", ", &rest)) {
        bool found = strcmp(name, group) == 0;
        for (int k = 0; k < count; k++) found |= strcmp(known[k], name) == 0;
        if (!found) {
            char hint[NAMES_HINT_MAX];
            names_hint(hint, name, known);
            return say_bad_input("%s: %s has no source '%.60s'%s", option, part->imu.name, name,
                                 hint);
        }
        if (list->count == SOURCES_NAMED_MAX)
            return say_bad_input("%s: more than %d sources", option, SOURCES_NAMED_MAX);
        names[list->count++] = name;
    }
    return EXIT_DONE;
}

static exit_code load(const characterize_arguments *a, schuler_part *part[])
{
    for (int i = 0; i < a->count; i++) {
        schuler_diagnostics d = { 0 };
        const schuler_status status =
            schuler_part_load_with(&part[i], a->sensor[i], a->plugins, &d);
        say_diagnostics(&d, !a->quiet);
        schuler_diagnostics_free(&d);
        if (status == SCHULER_ERR_MEMORY) return EXIT_FAILED;
        if (status != SCHULER_OK) return EXIT_INPUT;
    }
    return EXIT_DONE;
}

/* The one that all sensors have. */
static exit_code choose_instrument(characterize_arguments *a, schuler_part *const part[])
{
    if (!a->has_instrument)
        a->instrument = part[0]->imu.triad[SCHULER_ACCEL].model ? SCHULER_ACCEL : SCHULER_GYRO;
    for (int i = 0; i < a->count; i++)
        if (!part[i]->imu.triad[a->instrument].model)
            return say_bad_input("'%s' has no %s", part[i]->imu.name,
                                 a->instrument == SCHULER_GYRO ? "gyro" : "accelerometer");
    return EXIT_DONE;
}

static exit_code read_input(characterize_arguments *a)
{
    const bool gyro = a->instrument == SCHULER_GYRO;
    const schuler_dim dim = gyro ? (schuler_dim)SCHULER_DIM_RATE : (schuler_dim)SCHULER_DIM_ACCEL;
    const double usual = gyro ? 10.0 * SCHULER_RAD_PER_DEG : SCHULER_G0_MPS2;
    const char *const text[2] = { a->input, a->cross ? a->cross : a->input };
    static const char *const option[2] = { "--input", "--cross" };
    double si[2] = { usual, usual };
    for (int k = 0; k < 2; k++) {
        schuler_error error = { 0 };
        if (!text[k]) continue;
        if (schuler_quantity_parse(text[k], dim, &si[k], &error) != SCHULER_OK)
            return say_bad_input("%s: %s", option[k], error.message);
        if (!(fabs(si[k]) <= 1e5))
            return say_bad_input("%s: '%s' is out of range", option[k], text[k]);
    }
    a->options.along = si[0];
    a->options.across = si[1];
    return EXIT_DONE;
}

typedef struct {
    progress bar;
    int ready, count; /* sensors */
} shown_progress;

static void on_progress(void *user, double fraction)
{
    shown_progress *const p = user;
    progress_show(&p->bar, (p->ready + fraction) / p->count);
}

static exit_code measure(characterize_arguments *a, schuler_part *const part[],
                         characterize_report *r, shown_progress *shown)
{
    static const char *only[SOURCES_NAMED_MAX], *without[SOURCES_NAMED_MAX];
    schuler_characterize_options *const o = &a->options;
    for (int i = 0; i < a->count; i++) {
        /* The lists are checked against every sensor; each keeps them as written. */
        char *only_text = a->only ? strdup(a->only) : NULL;
        char *without_text = a->without ? strdup(a->without) : NULL;
        schuler_error error = { 0 };
        schuler_status status = SCHULER_OK;
        exit_code code = read_list(only_text, "--only", part[i], a->instrument, only, &o->only);
        if (code == EXIT_DONE)
            code =
                read_list(without_text, "--without", part[i], a->instrument, without, &o->without);
        if (code == EXIT_DONE)
            status =
                schuler_characterize(&r->sensor[i].found, &part[i]->imu, a->instrument, o, &error);
        free(only_text);
        free(without_text);
        o->only = o->without = (schuler_text_list){ 0 };
        if (code != EXIT_DONE) return code;
        if (status == SCHULER_ERR_INTERRUPTED) return EXIT_INTERRUPTED;
        if (status != SCHULER_OK) {
            progress_end(&shown->bar);
            say_bad_input("%s: %s", part[i]->imu.name, error.message);
            return exit_of(status);
        }
        shown->ready++;
    }
    return EXIT_DONE;
}

static exit_code deliver(const characterize_report *r, const characterize_arguments *a)
{
    exit_code code = EXIT_DONE;
    if (a->csv) code = outfile_write(a->csv, characterize_put_table, r);
    if (code == EXIT_DONE && a->series) code = outfile_write(a->series, characterize_put_series, r);
    if (code == EXIT_DONE && a->allan) code = outfile_write(a->allan, characterize_put_allan, r);
    if (code == EXIT_DONE && a->plot) code = characterize_plot(r, a->plot);
    if (code == EXIT_DONE && a->json) code = json_write(characterize_json(r), a->json);
    if (code == EXIT_DONE && !a->quiet && !(a->json && strcmp(a->json, "-") == 0))
        code = characterize_print(r);
    return code;
}

exit_code verb_characterize(int argc, char **argv)
{
    characterize_arguments a = { .options = { .units = 100, .duration_s = 10.0, .seed = 1 } };
    schuler_part *part[CHARACTERIZE_SENSORS_MAX] = { NULL };
    characterize_sensor sensor[CHARACTERIZE_SENSORS_MAX] = { { NULL, NULL } };
    arguments_parse(&characterize_argp, argc, argv, &a);
    stop_catch();
    a.options.stop = stop_flag();
    a.options.progress = on_progress;
    shown_progress shown = { .count = a.count };
    a.options.user = &shown;
    exit_code code = load(&a, part);
    if (code == EXIT_DONE) code = choose_instrument(&a, part);
    if (code == EXIT_DONE) code = read_input(&a);
    characterize_report report = { sensor, a.count, a.instrument, &a.options };
    if (code == EXIT_DONE) {
        for (int i = 0; i < a.count; i++) sensor[i].imu = &part[i]->imu;
        shown.bar = progress_start(a.quiet);
        code = measure(&a, part, &report, &shown);
        progress_end(&shown.bar);
        if (code == EXIT_INTERRUPTED) fputs("schuler: interrupted; nothing was written\n", stderr);
    }
    if (code == EXIT_DONE) code = deliver(&report, &a);
    for (int i = 0; i < a.count; i++) {
        schuler_characterized_free(sensor[i].found);
        schuler_part_free(part[i]);
    }
    free(a.only);
    free(a.without);
    schuler_plugins_free(a.plugins);
    return code;
}

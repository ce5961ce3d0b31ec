/* SPDX-License-Identifier: MIT */
/* schuler sensors: the catalog of real parts. */
#include "scenarios/scenario.h"
#include "sensors/catalog.h"
#include "tools/arguments.h"
#include "tools/list_show.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/page.h"
#include "tools/plugin_argument.h"
#include "tools/terminal.h"
#include <string.h>

enum { KEY_PLUGIN = 256 };

typedef struct {
    list_show_arguments list_show; /* first: the rest of the command line is its parser's */
    schuler_plugins *plugins;
} sensors_arguments;

static const struct argp_option options[] = { PLUGIN_OPTION(KEY_PLUGIN), { 0 } };

static error_t parse(int key, char *arg, struct argp_state *state)
{
    sensors_arguments *a = state->input;
    if (key != KEY_PLUGIN) return list_show_parse(key, arg, state);
    plugin_argument(&a->plugins, arg);
    return 0;
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "[list]\nshow NAME",
    .doc =
        "The catalog of real inertial measurement units. 'show' takes a catalog name or a sensor "
        "file and prints every figure with its meaning and where it comes from."
        "\vExamples:\n"
        "  schuler sensors\n"
        "  schuler sensors show hg9900\n"
        "  schuler sensors show my-imu.yaml\n" ARGUMENTS_EXIT_STATUS,
};

/* As written, with a mark when it is assumed; "-" when the part has no such figure. */
static const char *figure(const schuler_imu *imu, schuler_instrument instrument, const char *key)
{
    const schuler_triad *triad = &imu->triad[instrument];
    const schuler_param *params = triad->params;
    for (int i = 0; params && params[i].key; i++)
        if (strcmp(params[i].key, key) == 0 && triad->values[i].given) return triad->values[i].text;
    return "-";
}

static void list_row(FILE *out, const char *name, const char *grade, const char *gyro_bias,
                     const char *arw, const char *accel_bias, const char *title)
{
    enum { NAME = 8, GRADE = 10, GYRO_BIAS = 15, ARW = 20, ACCEL_BIAS = 10 };
    fputs("  ", out);
    page_cell(out, name, NAME);
    fputc(' ', out);
    page_cell(out, grade, GRADE);
    fputc(' ', out);
    page_cell(out, gyro_bias, GYRO_BIAS);
    fputc(' ', out);
    page_cell(out, arw, ARW);
    fputc(' ', out);
    page_cell(out, accel_bias, ACCEL_BIAS);
    fprintf(out, " %s\n", title);
}

static exit_code list(FILE *out)
{
    list_row(out, "name", "grade", "gyro bias", "gyro ARW", "accel bias", "title");
    fputs("  -----------------------------------------------------------------------------\n", out);
    exit_code code = EXIT_DONE;
    for (int i = 0; schuler_catalog[i].name; i++) {
        schuler_part *part = NULL;
        schuler_diagnostics d = { 0 };
        if (schuler_part_load(&part, schuler_catalog[i].name, &d) == SCHULER_OK) {
            const schuler_imu *imu = &part->imu;
            list_row(out, schuler_catalog[i].name, part->grade ? part->grade : "-",
                     figure(imu, SCHULER_GYRO, "bias"),
                     figure(imu, SCHULER_GYRO, "angle_random_walk"),
                     figure(imu, SCHULER_ACCEL, "bias"), imu->title ? imu->title : "");
        } else {
            say_diagnostics(&d, false);
            code = EXIT_FAILED; /* the catalog is ours: this is not the user's mistake */
        }
        schuler_diagnostics_free(&d);
        schuler_part_free(part);
    }
    fputs("\n'schuler sensors show NAME' shows every figure with its source.\n", out);
    return code;
}

static void put_labelled(FILE *out, const char *label, const char *text)
{
    enum { LABEL = 12 };
    if (!text || !*text) return;
    fprintf(out, "  %-*s", LABEL, label);
    page_wrap(out, text, 2 + LABEL, 2 + LABEL);
}

static void put_parameter(FILE *out, const schuler_param *p, const schuler_value *v)
{
    enum { KEY = 24, INDENT = 8 };
    fprintf(out, "    %-*s %s%s\n", KEY, p->key, v->text ? v->text : "", v->assumed ? " *" : "");
    if (p->doc) {
        fprintf(out, "%*s", INDENT, "");
        page_wrap(out, p->doc, INDENT, INDENT);
    }
    if (v->source) fprintf(out, "%*ssource: %s\n", INDENT, "", v->source);
    if (v->note) {
        fprintf(out, "%*snote: ", INDENT, "");
        page_wrap(out, v->note, INDENT + 6, INDENT + 6);
    }
}

static void put_triad(FILE *out, const schuler_imu *imu, schuler_instrument instrument,
                      int *assumed)
{
    const schuler_triad *triad = &imu->triad[instrument];
    if (!triad->model) return;
    fprintf(out, "\n  %s, model %s\n", schuler_instrument_name(instrument), triad->model->name);
    const schuler_param *params = triad->params;
    for (int i = 0; params && params[i].key; i++) {
        if (!triad->values[i].given) continue;
        put_parameter(out, &params[i], &triad->values[i]);
        *assumed |= triad->values[i].assumed;
    }
}

static void show(FILE *out, const schuler_part *part)
{
    int assumed = 0;
    fprintf(out, "%s: %s\n", part->imu.name, part->imu.title ? part->imu.title : "");
    put_labelled(out, "maker", part->maker);
    put_labelled(out, "grade", part->grade);
    put_labelled(out, "technology", part->technology);
    fprintf(out, "  %-12s%g Hz\n", "rate", part->imu.rate_hz);
    put_triad(out, &part->imu, SCHULER_GYRO, &assumed);
    put_triad(out, &part->imu, SCHULER_ACCEL, &assumed);
    if (assumed) fputs("\n  * assumed: not a published figure of this part\n", out);
    if (part->source_count > 0) fputs("\nSources\n", out);
    for (size_t i = 0; i < part->source_count; i++) {
        const schuler_source_text *s = &part->sources[i];
        fprintf(out, "  %s: ", s->key);
        page_wrap(out, s->text, terminal_width(s->key) + 4, 6);
    }
    if (part->notes) {
        fputs("\nNotes\n  ", out);
        page_wrap(out, part->notes, 2, 2);
    }
}

/* A name that is neither in the catalog nor looks like a file gets a hint instead of "no such
 * file". */
static bool looks_like_file(const char *name)
{
    return strpbrk(name, "/.") != NULL;
}

static exit_code show_named(FILE *out, const char *name, const schuler_plugins *plugins)
{
    const char *known[NAMES_MAX];
    names_of_sensors(known);
    bool found = looks_like_file(name);
    for (int i = 0; known[i]; i++) found |= strcmp(known[i], name) == 0;
    if (!found) {
        char hint[NAMES_HINT_MAX];
        names_hint(hint, name, known);
        return say_bad_input("unknown part '%.60s'%s", name, hint);
    }
    schuler_part *part = NULL;
    schuler_diagnostics d = { 0 };
    const schuler_status status = schuler_part_load_with(&part, name, plugins, &d);
    say_diagnostics(&d, true);
    schuler_diagnostics_free(&d);
    if (status == SCHULER_OK) show(out, part);
    schuler_part_free(part);
    if (status == SCHULER_OK) return EXIT_DONE;
    return status == SCHULER_ERR_MEMORY ? EXIT_FAILED : EXIT_INPUT;
}

exit_code verb_sensors(int argc, char **argv)
{
    sensors_arguments a = { .list_show = { .what = "part" } };
    arguments_parse(&argp, argc, argv, &a);
    page p;
    page_open(&p);
    exit_code code = EXIT_DONE;
    const char *const name = a.list_show.name;
    if (p.out) code = name ? show_named(p.out, name, a.plugins) : list(p.out);
    schuler_plugins_free(a.plugins);
    const exit_code shown = page_show(&p);
    return code == EXIT_DONE ? shown : code;
}

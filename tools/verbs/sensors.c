/* SPDX-License-Identifier: MIT */
/* schuler sensors: the catalog of real parts. */
#include "tools/arguments.h"
#include "tools/page.h"
#include "tools/plugin_argument.h"
#include "tools/sensor_part.h"
#include <string.h>

enum { KEY_PLUGIN = 256, KEY_KIND, KEY_GRADE, KEY_TECHNOLOGY, KEY_MAKER, KEY_CSV, KEY_JSON };
enum { ACTION_LIST, ACTION_SHOW, ACTION_DIFF };
static const char *const actions[] = { "list", "show", "diff", NULL };

typedef struct {
    int action, names; /* -1: not said yet */
    const char *name[2], *csv, *json;
    sensor_filter filter;
    schuler_plugins *plugins;
} sensors_arguments;

static const struct argp_option options[] = {
    { "kind", KEY_KIND, "WORD", 0, "list: only imu, accelerometer or gyro", 0 },
    { "grade", KEY_GRADE, "WORD", 0,
      "list: only consumer, industrial, tactical, navigation or strategic", 0 },
    { "technology", KEY_TECHNOLOGY, "TEXT", 0, "list: only where the technology has this text", 0 },
    { "maker", KEY_MAKER, "TEXT", 0, "list: only where the maker has this text", 0 },
    { "csv", KEY_CSV, "FILE", 0, "list: the table as CSV; - is standard output", 0 },
    { "json", KEY_JSON, "FILE", 0, "list: the table as JSON; - is standard output", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { 0 },
};

static void take_argument(sensors_arguments *a, char *arg, struct argp_state *state)
{
    static const int wanted[] = { 0, 1, 2 };
    if (a->action < 0)
        a->action = arguments_choice(state, "the action", arg, actions);
    else if (a->names < wanted[a->action])
        a->name[a->names++] = arg;
    else
        argp_error(state, "too many arguments: '%s'", arg);
}

static void check(sensors_arguments *a, struct argp_state *state)
{
    const sensor_filter *const f = &a->filter;
    if (a->action < 0) a->action = ACTION_LIST;
    if (a->action == ACTION_SHOW && a->names < 1)
        argp_error(state, "show which part? '%s list' lists them", state->name);
    if (a->action == ACTION_DIFF && a->names < 2)
        argp_error(state, "the difference of which two parts? '%s list' lists them", state->name);
    if (a->action != ACTION_LIST &&
        (f->kind || f->grade || f->technology || f->maker || a->csv || a->json))
        argp_error(state, "filters and files are for the list");
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    sensors_arguments *a = state->input;
    switch (key) {
    case KEY_KIND:
        a->filter.kind = sensor_kinds[arguments_choice(state, "--kind", arg, sensor_kinds)];
        return 0;
    case KEY_GRADE:
        a->filter.grade = sensor_grades[arguments_choice(state, "--grade", arg, sensor_grades)];
        return 0;
    case KEY_TECHNOLOGY:
        a->filter.technology = arg;
        return 0;
    case KEY_MAKER:
        a->filter.maker = arg;
        return 0;
    case KEY_CSV:
        a->csv = arg;
        return 0;
    case KEY_JSON:
        a->json = arg;
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        return 0;
    case ARGP_KEY_ARG:
        take_argument(a, arg, state);
        return 0;
    case ARGP_KEY_END:
        check(a, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "[list]\nshow NAME\ndiff NAME NAME",
    .doc =
        "The catalog of real inertial measurement units, accelerometers and gyros. A name is one "
        "of the catalog or a sensor file; 'show' prints every figure with its meaning, where it "
        "comes from, and what is assumed; 'diff' two parts side by side."
        "\vExamples:\n"
        "  schuler sensors --kind imu --grade tactical\n"
        "  schuler sensors show hg9900\n"
        "  schuler sensors diff hg9900 my-imu.yaml\n" ARGUMENTS_EXIT_STATUS,
};

static exit_code answer(const sensors_arguments *a)
{
    schuler_part *part[2] = { NULL, NULL };
    exit_code code = EXIT_DONE;
    for (int i = 0; i < a->names && code == EXIT_DONE; i++)
        code = sensor_part_load(&part[i], a->name[i], a->plugins);
    if (code == EXIT_DONE) {
        page p;
        page_open(&p);
        if (p.out && a->action == ACTION_SHOW) sensor_part_show(p.out, part[0]);
        if (p.out && a->action == ACTION_DIFF) sensor_part_diff(p.out, part[0], part[1]);
        code = page_show(&p);
    }
    for (int i = 0; i < 2; i++) schuler_part_free(part[i]);
    return code;
}

exit_code verb_sensors(int argc, char **argv)
{
    sensors_arguments a = { .action = -1 };
    arguments_parse(&argp, argc, argv, &a);
    const exit_code code =
        a.action == ACTION_LIST ? sensor_list(&a.filter, a.csv, a.json) : answer(&a);
    schuler_plugins_free(a.plugins);
    return code;
}

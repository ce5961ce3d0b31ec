/* SPDX-License-Identifier: MIT */
/* schuler models: everything pluggable, as its own tables describe it. */
#include "tools/arguments.h"
#include "tools/list_show.h"
#include "tools/page.h"
#include "tools/plugin_argument.h"
#include "tools/registry.h"
#include <string.h>

enum { KEY_PLUGIN = 256 };

typedef struct {
    list_show_arguments list_show; /* first: the rest of the command line is its parser's */
    schuler_plugins *plugins;
    const char *json;
} models_arguments;

static const struct argp_option options[] = {
    { "json", 'j', "FILE", 0, "all of it as JSON; - is standard output", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    models_arguments *a = state->input;
    switch (key) {
    case 'j':
        if (!*arg) argp_error(state, "an empty file name");
        a->json = arg;
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        return 0;
    default:
        return list_show_parse(key, arg, state);
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "[list]\nshow NAME",
    .doc =
        "What a scenario can choose from: sensor error models, the stages that follow them, "
        "trajectories, navigation frames and gravity. 'show' prints equation, source and keys of "
        "one, with units, ranges and formulas; NAME may also be the key of a stage."
        "\vExamples:\n"
        "  schuler models\n"
        "  schuler models show linear\n"
        "  schuler models show bias_instability\n" ARGUMENTS_EXIT_STATUS,
};

static exit_code answer(const models_arguments *a)
{
    const char *const name = a->list_show.name;
    page p;
    page_open(&p);
    if (p.out && !name) registry_list(p.out, a->plugins);
    if (p.out && name && !registry_show(p.out, name, a->plugins)) {
        page_drop(&p);
        return registry_unknown(name, a->plugins);
    }
    if (a->json && strcmp(a->json, "-") == 0)
        page_drop(&p);
    else {
        const exit_code shown = page_show(&p);
        if (shown != EXIT_DONE) return shown;
    }
    return a->json ? json_write(registry_json(a->plugins), a->json) : EXIT_DONE;
}

exit_code verb_models(int argc, char **argv)
{
    models_arguments a = { .list_show = { .what = "model" } };
    arguments_parse(&argp, argc, argv, &a);
    const exit_code code = answer(&a);
    schuler_plugins_free(a.plugins);
    return code;
}

/* SPDX-License-Identifier: MIT */
/* schuler explain: what an error source is, how its position error grows, how large it is here. */
#include "scenarios/source_count.h"
#include "tools/arguments.h"
#include "tools/explain_report.h"
#include "tools/messages.h"
#include "tools/page.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include <stdlib.h>
#include <string.h>

enum { KEY_MODEL = 256 };

typedef struct {
    simulation_arguments simulation; /* first: its parser's */
    const char *source, *model;
} explain_arguments;

static const struct argp_option options[] = {
    { "model", KEY_MODEL, "NAME", 0, "as this sensor model has it, if several have", 0 },
    { "quiet", 'q', NULL, 0, "no warnings, no progress", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    explain_arguments *a = state->input;
    const schuler_overrides *const o = &a->simulation.overrides;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->simulation;
        return 0;
    case KEY_MODEL:
        a->model = arg;
        return 0;
    case 'q':
        a->simulation.quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (a->simulation.file) argp_error(state, "one scenario file, not also '%s'", arg);
        if (a->source)
            a->simulation.file = arg;
        else
            a->source = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->source)
            argp_error(state, "which error source? ('schuler models' lists models and keys)");
        if (!a->simulation.file && (o->count_set || o->has_runs || o->has_seed))
            argp_error(state, "--set, --runs and --seed change a scenario: which FILE?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &simulation_argp_single, 0, NULL, 0 }, { 0 } };
static const struct argp argp = {
    .options = options,
    .parser = parse,
    .children = children,
    .args_doc = "SOURCE [FILE]",
    .doc =
        "What an error source is, its formula, and how its position error grows. With a scenario "
        "it is simulated alone, to see how large it is there."
        "\vExamples:\n"
        "  schuler explain gyro.bias\n"
        "  schuler explain accel.K2 --model ieee836\n"
        "  schuler explain gyro.angle_random_walk scenarios/static.yaml --imu "
        "stim300\n" ARGUMENTS_EXIT_STATUS,
};

/* A value as it would be read from a file. */
static bool read_example(const char *text, schuler_dim dim, int components, schuler_arena *arena,
                         schuler_value *out)
{
    schuler_diagnostics d = { 0 };
    schuler_document *doc = NULL;
    const char *const yaml = text ? schuler_arena_printf(arena, "x: %s\n", text) : NULL;
    const schuler_field field = {
        .key = "x", .kind = SCHULER_FIELD_VALUE, .dim = dim, .components = components
    };
    bool good =
        yaml && schuler_document_parse(&doc, "example", yaml, strlen(yaml), &d) == SCHULER_OK;
    const schuler_node *const node =
        good ? schuler_node_find(schuler_document_root(doc), "x") : NULL;
    good = node && schuler_schema_read_value(node, "x", &field, out, arena, &d) == SCHULER_OK;
    schuler_document_free(doc);
    schuler_diagnostics_free(&d);
    if (good) out->text = text;
    return good;
}

/* Errors of the start, in the order of schuler_growth_others. */
static const struct {
    size_t offset;
    schuler_growth_entry entry;
    schuler_dim dim;
} starts[] = {
    { offsetof(schuler_scenario, position), SCHULER_ENTERS_POSITION, SCHULER_DIM_LENGTH },
    { offsetof(schuler_scenario, velocity), SCHULER_ENTERS_VELOCITY, SCHULER_DIM_SPEED },
    { offsetof(schuler_scenario, tilt), SCHULER_ENTERS_TILT, SCHULER_DIM_ANGLE },
    { offsetof(schuler_scenario, heading), SCHULER_ENTERS_HEADING, SCHULER_DIM_ANGLE },
};
enum { STARTS = sizeof starts / sizeof starts[0] };

/* Those of the barometer, in the order of schuler_baro_error, come last. */
static const schuler_dim barometer_dims[SCHULER_BARO_ERRORS] = { SCHULER_DIM_LENGTH,
                                                                 SCHULER_DIM_NONE, SCHULER_DIM_TIME,
                                                                 SCHULER_DIM_HEIGHT_NOISE,
                                                                 SCHULER_DIM_LENGTH };

/* A schuler_baro_error, or -1. */
static int barometer_error(const explain_subject *s)
{
    if (!s->other || strncmp(s->other->id, "baro.", strlen("baro.")) != 0) return -1;
    int left = 0;
    while (s->other[left].id) left++;
    return SCHULER_BARO_ERRORS - left;
}

static void take(explanation *e, const schuler_value *given, const char *example, schuler_dim dim,
                 int components, schuler_arena *arena)
{
    e->has_value = true;
    if (given && given->given && !schuler_value_is_zero(given, components))
        e->value = *given;
    else {
        e->is_example = true;
        e->has_value = read_example(example, dim, components, arena, &e->value);
    }
}

/* The value that counts, or an example, and what grows from it. */
static void take_value(explanation *e, schuler_arena *arena)
{
    const explain_subject *const s = &e->subject;
    const double dt_s = e->imu ? 1.0 / e->imu->rate_hz : 0.01;
    const int error = barometer_error(s);
    if (error >= 0) {
        take(e, e->scenario ? &e->scenario->baro[error] : NULL, s->other->example,
             barometer_dims[error], 1, arena);
        return;
    }
    if (s->other) {
        const ptrdiff_t i = s->other - schuler_growth_others();
        if (i >= STARTS) return;
        const char *const members = (const char *)e->scenario;
        e->has_growth = true;
        e->growth = schuler_growth_of_start(starts[i].entry);
        take(e, members ? (const schuler_value *)(const void *)(members + starts[i].offset) : NULL,
             s->other->example, starts[i].dim, e->growth.components, arena);
        return;
    }
    const schuler_param *const p = &s->params[s->index];
    const schuler_value *const values = s->triad ? s->triad->values : NULL;
    take(e, values ? &values[s->index] : NULL, p->example, p->dim, p->components, arena);
    e->has_growth = schuler_growth_of_param(s->params, s->index, values, s->instrument, &e->rest,
                                            dt_s, &e->growth);
}

static const char *why_absent(const explanation *e, schuler_arena *arena)
{
    const explain_subject *const s = &e->subject;
    const schuler_scenario *const of = e->scenario;
    if (!s->other && !s->triad)
        return schuler_arena_printf(arena, "none: the scenario's %s model is %s",
                                    schuler_instrument_name(s->instrument),
                                    of->imu.triad[s->instrument].model->name);
    if (barometer_error(s) >= 0)
        return of->vertical == SCHULER_VERTICAL_BARO
                   ? "not set in the scenario: zero"
                   : "none: there is no barometer; 'navigation: {vertical: baro}' brings it";
    if (s->other && s->other - schuler_growth_others() >= STARTS)
        return schuler_arena_printf(arena, "none: truth.gravity and navigation.gravity are both %s",
                                    of->nav_gravity);
    return "not set in the scenario: zero";
}

/* Only this source, judged by its CEP without a limit. */
static exit_code simulate_alone(schuler_scenario *scenario, explanation *e,
                                const simulation_arguments *a, schuler_arena *arena,
                                schuler_result **result)
{
    const bool is_numerical = strcmp(e->subject.id, "numerical") == 0;
    scenario->only = (schuler_text_list){ .items = &e->subject.id, .count = 1 };
    scenario->without = (schuler_text_list){ .count = 0 };
    scenario->requirement = (schuler_requirement){ .given = true, .statistic = SCHULER_STAT_CEP };
    if (!is_numerical && schuler_scenario_source_count(scenario) == 0) {
        e->absent = why_absent(e, arena);
        return e->absent ? EXIT_DONE : say_failure("out of memory");
    }
    const exit_code code = simulate(scenario, a, NULL, result);
    if (code != EXIT_DONE) return code;
    e->result = *result;
    e->row = &e->result->rows[0];
    return EXIT_DONE;
}

static exit_code deliver(const explanation *e, const simulation_arguments *a)
{
    if (a->json) {
        const exit_code code = json_write(explain_json(e), a->json);
        if (code != EXIT_DONE || strcmp(a->json, "-") == 0) return code;
    }
    page p;
    page_open(&p);
    if (p.out) explain_print(p.out, e);
    return page_show(&p);
}

static exit_code explain(const explain_arguments *a, schuler_scenario *scenario,
                         const schuler_imu *imu, schuler_arena *arena)
{
    const simulation_arguments *const sim = &a->simulation;
    explanation e = { .plugins = sim->plugins, .imu = imu, .scenario = scenario };
    exit_code code = explain_subject_find(&e.subject, a->source, a->model, imu, sim->plugins);
    if (code != EXIT_DONE) return code;
    schuler_error error = { 0 };
    const schuler_mat3 level = schuler_mat3_from_euler(0.0, 0.0, 0.0);
    e.duration_s = scenario ? scenario->path.duration_s : 3600.0;
    const schuler_status status =
        scenario ? schuler_rest_of(&e.rest, scenario, &error)
                 : schuler_rest_make(&e.rest, 45.0 * SCHULER_RAD_PER_DEG, 0.0, &level, &error);
    if (status != SCHULER_OK) {
        say_error(&error);
        return exit_of(status);
    }
    take_value(&e, arena);
    schuler_result *result = NULL;
    if (scenario) code = simulate_alone(scenario, &e, sim, arena, &result);
    if (code == EXIT_DONE) code = deliver(&e, sim);
    schuler_result_free(result);
    return code;
}

/* The IMU that --imu names, when there is no scenario. */
static exit_code load_part(const simulation_arguments *a, schuler_part **out)
{
    if (!a->overrides.imu) return EXIT_DONE;
    schuler_diagnostics d = { 0 };
    const schuler_status status = schuler_part_load_with(out, a->overrides.imu, a->plugins, &d);
    say_diagnostics(&d, !a->quiet);
    schuler_diagnostics_free(&d);
    if (status == SCHULER_OK) return EXIT_DONE;
    return status == SCHULER_ERR_MEMORY ? EXIT_FAILED : EXIT_INPUT;
}

exit_code verb_explain(int argc, char **argv)
{
    explain_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    const simulation_arguments *const sim = &a.simulation;
    schuler_scenario *scenario = NULL;
    schuler_part *part = NULL;
    schuler_arena *arena = schuler_arena_create();
    exit_code code = arena ? EXIT_DONE : say_failure("out of memory");
    if (code == EXIT_DONE)
        code = sim->file ? scenario_input(sim->file, &sim->overrides, sim->quiet, &scenario)
                         : load_part(sim, &part);
    if (code == EXIT_DONE)
        code = explain(&a, scenario, scenario ? &scenario->imu : part ? &part->imu : NULL, arena);
    schuler_part_free(part);
    schuler_scenario_free(scenario);
    schuler_arena_free(arena);
    schuler_plugins_free(sim->plugins);
    return code;
}

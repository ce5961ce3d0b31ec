/* SPDX-License-Identifier: MIT */
/* schuler verify: requirements with confidence, as exit status. */
#include "scenarios/metrics.h"
#include "tools/arguments.h"
#include "tools/budget_table.h"
#include "tools/json.h"
#include "tools/junit.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include "tools/result_units.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include "tools/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { KEY_CONFIDENCE = 2000, KEY_PRESET, KEY_JUNIT, FILES_MAX = 1000 };

/* Requirements that documents state: nmi/h of the slope through the origin of the radial error; RNP 10, the
 * error across and along the track at the end. */
static const struct {
    const char *name, *requirement;
} presets[] = {
    { "mil_1nmi", "requirement={drift: 1 nmi/h, statistic: CEP}" },
    { "mil_0p8", "requirement={drift: 0.8 nmi/h, statistic: CEP}" },
    { "civil_2nmi", "requirement={drift: 2 nmi/h, statistic: R95}" },
    { "rnp10", "requirement={position: 10 nmi, statistic: one_axis}" },
    { NULL, NULL },
};

typedef struct {
    simulation_arguments simulation;
    const char *files[FILES_MAX], *junit;
    size_t count;
    double confidence;
} verify_arguments;

static const struct argp_option options[] = {
    { "confidence", KEY_CONFIDENCE, "P", 0, "of the verdict, for example '99 %'; default 95 %", 0 },
    { "preset", KEY_PRESET, "NAME", 0,
      "this requirement: mil_1nmi (1 nmi/h CEP), mil_0p8 (0.8 nmi/h CEP), civil_2nmi (2 nmi/h "
      "R95), "
      "rnp10 (10 nmi at the end, north and east, 95 %)",
      0 },
    { "junit", KEY_JUNIT, "FILE", 0, "verdicts as JUnit XML; - is standard output", 0 },
    { 0 },
};

static void take_preset(simulation_arguments *s, const char *name, struct argp_state *state)
{
    const char *words[sizeof presets / sizeof presets[0]];
    for (size_t i = 0; i < sizeof presets / sizeof presets[0]; i++) words[i] = presets[i].name;
    const int i = arguments_choice(state, "--preset", name, words);
    if (s->overrides.count_set == SIMULATION_SET_MAX) argp_error(state, "too many --set");
    s->set[s->overrides.count_set++] = presets[i].requirement;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    verify_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->simulation;
        return 0;
    case KEY_CONFIDENCE:
        a->confidence = arguments_quantity(state, "--confidence", arg,
                                           (schuler_dim)SCHULER_DIM_NONE, 0.5, 0.9999);
        return 0;
    case KEY_PRESET:
        take_preset(&a->simulation, arg, state);
        return 0;
    case KEY_JUNIT:
        if (!*arg) argp_error(state, "an empty file name");
        a->junit = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (a->count == FILES_MAX) argp_error(state, "more than %d files", FILES_MAX);
        a->files[a->count++] = arg;
        return 0;
    case ARGP_KEY_END:
        a->simulation.file = a->files[0];
        simulation_need_file(&a->simulation, state, false);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = { { &simulation_argp, 0, NULL, 0 }, { 0 } };
static const struct argp argp = {
    .options = options,
    .parser = parse,
    .children = children,
    .args_doc = "FILE...",
    .doc =
        "Simulate the joint runs of scenarios and judge their requirements. PASS: the whole "
        "confidence "
        "interval lies within the limit; FAIL: it lies beyond; else more runs are needed, and it "
        "says "
        "about how many."
        "\vExamples:\n"
        "  schuler verify scenarios/atlantic.yaml\n"
        "  schuler verify flights/*.yaml --confidence '99 %' --junit verdicts.xml\n"
        "  schuler verify flight.yaml --preset civil_2nmi --runs 400\n"
        "\nExit status: 0 all met, 1 one is not met, 2 bad command line or input, 3 failed while "
        "running, 4 too few runs to tell of one, and none fails, 130 interrupted.",
};

static void describe(verified *v, const schuler_scenario *s, const schuler_result *result)
{
    const schuler_judgement *const j = &result->judgement;
    const char *const statistic = statistic_name(s->requirement.statistic);
    char limits[80] = "every run is the same";
    if (j->lower_mps != j->upper_mps)
        snprintf(limits, sizeof limits,
                 isfinite(j->upper_mps) && j->lower_mps > 0.0 ? "%g %% limits %.3g to %.3g"
                                                              : "too few runs for %g %% limits",
                 100.0 * j->confidence, nmi_per_h(j->lower_mps), nmi_per_h(j->upper_mps));
    size_t used = (size_t)snprintf(v->message, sizeof v->message,
                                   "drift %.3g nmi/h %s (%s), limit %g nmi/h, %d runs",
                                   nmi_per_h(j->value_mps), statistic, limits,
                                   nmi_per_h(s->requirement.drift_mps), result->runs);
    if (j->verdict != SCHULER_VERDICT_INCONCLUSIVE || used >= sizeof v->message) return;
    const double runs = schuler_runs_to_decide(j, s->requirement.drift_mps, result->runs);
    snprintf(v->message + used, sizeof v->message - used,
             runs <= 1e6 ? "; about %.0f would tell" : "; too close to the limit to be told", runs);
}

static exit_code verify_one(const verify_arguments *a, const char *file,
                            schuler_scenario **scenario, verified *v)
{
    *v = (verified){ .file = file };
    snprintf(v->message, sizeof v->message, "it could not be simulated");
    exit_code code = scenario_input(file, &a->simulation.overrides, a->simulation.quiet, scenario);
    if (code != EXIT_DONE) return code;
    schuler_scenario *const s = *scenario;
    if (!s->requirement.given)
        return say_bad_input("%s states no requirement; add one, or say --preset", file);
    s->requirement.confidence = a->confidence;
    struct timespec begin, end;
    schuler_result *result = NULL;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    code = simulate(s, &a->simulation, NULL, &result);
    clock_gettime(CLOCK_MONOTONIC, &end);
    v->seconds = (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
    if (code == EXIT_DONE) {
        v->name = s->name;
        v->judgement = result->judgement;
        describe(v, s, result);
    }
    schuler_result_free(result);
    return code;
}

static json_t *to_json(const verification *all)
{
    json_t *const list = json_array();
    for (size_t i = 0; i < all->count; i++) {
        const verified *const v = &all->items[i];
        const schuler_judgement *const j = &v->judgement;
        json_array_append_new(
            list, json_pack("{s:o, s:o, s:s, s:o, s:o, s:o, s:o}", "file", json_of_text(v->file),
                            "scenario", json_of_text(v->name), "verdict", verdict_name(j->verdict),
                            "value_nmi_per_h", json_of_number(nmi_per_h(j->value_mps)), "lower",
                            json_of_number(nmi_per_h(j->lower_mps)), "upper",
                            json_of_number(nmi_per_h(j->upper_mps)), "confidence",
                            json_of_number(j->confidence)));
    }
    return json_pack("{s:s, s:s, s:o}", "format", "schuler-verify-1", "version", SCHULER_VERSION,
                     "verdicts", list);
}

static exit_code print(const verification *all)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    for (size_t i = 0; i < all->count; i++) {
        const verified *const v = &all->items[i];
        const schuler_verdict verdict = v->judgement.verdict;
        const colour shade = verdict == SCHULER_VERDICT_PASS   ? COLOUR_GREEN
                             : verdict == SCHULER_VERDICT_FAIL ? COLOUR_RED
                                                               : COLOUR_YELLOW;
        fprintf(p.out, "%s%-9s%s %s\n          %s\n", terminal_colour(stdout, shade),
                verdict == SCHULER_VERDICT_INCONCLUSIVE ? "UNDECIDED" : verdict_name(verdict),
                terminal_plain(stdout), v->file, v->message);
    }
    return page_show(&p);
}

static exit_code status_of(const verification *all)
{
    exit_code code = EXIT_DONE;
    for (size_t i = 0; i < all->count; i++) {
        if (all->items[i].judgement.verdict == SCHULER_VERDICT_FAIL) return EXIT_NOT_MET;
        if (all->items[i].judgement.verdict == SCHULER_VERDICT_INCONCLUSIVE)
            code = EXIT_INCONCLUSIVE;
    }
    return code;
}

exit_code verb_verify(int argc, char **argv)
{
    verify_arguments a = { .simulation = { .rows = SCHULER_ROWS_NONE } };
    arguments_parse(&argp, argc, argv, &a);
    verification all = { .count = a.count, .items = calloc(a.count, sizeof *all.items) };
    schuler_scenario **const scenarios = calloc(a.count, sizeof(schuler_scenario *));
    exit_code code = all.items && scenarios ? EXIT_DONE : say_failure("out of memory");
    for (size_t i = 0; i < a.count && code == EXIT_DONE; i++)
        code = verify_one(&a, a.files[i], &scenarios[i], &all.items[i]);
    const char *const json = a.simulation.json;
    if (code == EXIT_DONE && a.junit) code = outfile_write(a.junit, junit_put, &all);
    if (code == EXIT_DONE && json) code = json_write(to_json(&all), json);
    const bool is_taken =
        (json && strcmp(json, "-") == 0) || (a.junit && strcmp(a.junit, "-") == 0);
    if (code == EXIT_DONE && !is_taken) code = print(&all);
    if (code == EXIT_DONE) code = status_of(&all);
    for (size_t i = 0; scenarios && i < a.count; i++) schuler_scenario_free(scenarios[i]);
    free(scenarios);
    free(all.items);
    schuler_plugins_free(a.simulation.plugins);
    return code;
}

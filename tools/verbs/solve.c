/* SPDX-License-Identifier: MIT */
/* schuler solve: how large a source may be for the requirement to be just met. */
#include "scenarios/solve.h"
#include "tools/arguments.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/page.h"
#include "tools/result_units.h"
#include "tools/scaled_text.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { KEY_FOR = 2000, SOURCES = 64, VALUE_MAX = 160 };

typedef struct {
    simulation_arguments simulation;
    char *list; /* --for, cut into ids */
    const char *ids[SOURCES];
    size_t count;
} solve_arguments;

static const struct argp_option options[] = {
    { "for", KEY_FOR, "SOURCE,...", 0, "each by itself, and all of them by one factor", 0 },
    { 0 },
};

static void cut_list(solve_arguments *a, const char *text, struct argp_state *state)
{
    if (a->list || !*text) argp_error(state, "--for: one list, SOURCE,..., not empty");
    a->list = strdup(text);
    if (!a->list) argp_failure(state, EXIT_FAILED, 0, "out of memory");
    for (char *id = strtok(a->list, ","); id; id = strtok(NULL, ",")) {
        if (a->count == SOURCES) argp_error(state, "--for: more than %d of them", SOURCES);
        a->ids[a->count++] = id;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    solve_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->simulation;
        return 0;
    case KEY_FOR:
        cut_list(a, arg, state);
        return 0;
    case ARGP_KEY_ARG:
        simulation_take_file(&a->simulation, arg, state);
        return 0;
    case ARGP_KEY_END:
        simulation_need_file(&a->simulation, state, false);
        if (a->count == 0) argp_error(state, "for which source? --for SOURCE,...");
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
    .args_doc = "FILE --for SOURCE,...",
    .doc = "How large a source may be for the requirement to be just met, the others held and the "
           "draws "
           "the same. Its values are multiplied by one factor, components, sigma and limits alike. "
           "With "
           "several sources also the factor that all of them may have together."
           "\vExamples:\n"
           "  schuler solve scenarios/atlantic.yaml --for gyro.bias\n"
           "  schuler solve flight.yaml --for gyro.bias,gyro.angle_random_walk --runs 400\n"
           "\nThe drift is that of these runs, not its upper limit: verify the "
           "result.\n" ARGUMENTS_EXIT_STATUS,
};

/* One row: a source, or all of them. */
typedef struct {
    const char *name, *value; /* value NULL: several */
    schuler_solution solution;
} answer;

static const char *value_of(const schuler_result *result, const char *id)
{
    for (size_t i = 0; i < result->row_count; i++)
        if (strcmp(result->rows[i].id, id) == 0) return result->rows[i].value_text;
    return "";
}

static void put_answer(FILE *out, const answer *a)
{
    char value[VALUE_MAX];
    fputs("  ", out);
    page_cell(out, a->name, 26);
    page_cell(out, a->value ? a->value : "", 22);
    if (a->solution.factor < 0.0) {
        fprintf(out, "no value suffices: %.3g nmi/h without\n", nmi_per_h(a->solution.without_mps));
        return;
    }
    if (!isfinite(a->solution.factor)) {
        fputs("any value does\n", out);
        return;
    }
    if (a->value) {
        scaled_text(a->value, a->solution.factor, value, sizeof value);
        page_cell(out, value, 20);
    } else {
        page_cell(out, "", 20);
    }
    fprintf(out, "x %.3g\n", a->solution.factor);
}

static exit_code print(const schuler_scenario *s, const answer *answers, size_t count,
                       const schuler_result *now)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    fprintf(p.out, "%s\n  %d runs, seed %llu: drift %.3g nmi/h %s, limit %g nmi/h\n\n  ", s->name,
            now->runs, (unsigned long long)s->seed, nmi_per_h(now->judgement.value_mps),
            statistic_name(s->requirement.statistic), nmi_per_h(s->requirement.drift_mps));
    page_cell(p.out, "source, the others held", 26);
    page_cell(p.out, "now", 22);
    fputs("may be\n", p.out);
    page_rule(p.out);
    for (size_t i = 0; i < count; i++) put_answer(p.out, &answers[i]);
    return page_show(&p);
}

static json_t *to_json(const schuler_scenario *s, const answer *answers, size_t count,
                       const solve_arguments *a, const schuler_result *now)
{
    json_t *const list = json_array();
    for (size_t i = 0; i < count; i++) {
        const schuler_solution *const x = &answers[i].solution;
        json_t *const sources = json_array();
        if (answers[i].value)
            json_array_append_new(sources, json_of_text(answers[i].name));
        else
            for (size_t k = 0; k < a->count; k++)
                json_array_append_new(sources, json_of_text(a->ids[k]));
        char value[VALUE_MAX] = "";
        const bool is_bound = x->factor >= 0.0 && isfinite(x->factor);
        if (answers[i].value && is_bound)
            scaled_text(answers[i].value, x->factor, value, sizeof value);
        json_array_append_new(
            list, json_pack("{s:o, s:o, s:b, s:o, s:o, s:o, s:i}", "sources", sources, "factor",
                            json_of_number(is_bound ? x->factor : (double)NAN), "suffices",
                            x->factor >= 0.0, "value", json_of_text(value[0] ? value : NULL),
                            "drift_nmi_per_h", json_of_number(nmi_per_h(x->drift_mps)),
                            "drift_without_nmi_per_h", json_of_number(nmi_per_h(x->without_mps)),
                            "simulations", x->simulations));
    }
    return json_pack("{s:s, s:s, s:{s:o, s:s}, s:I, s:i, s:s, s:o, s:o, s:o}", "format",
                     "schuler-solve-1", "version", SCHULER_VERSION, "scenario", "name",
                     json_of_text(s->name), "sha256", s->sha256, "seed", (json_int_t)s->seed,
                     "runs", now->runs, "statistic", statistic_name(s->requirement.statistic),
                     "limit_nmi_per_h", json_of_number(nmi_per_h(s->requirement.drift_mps)),
                     "drift_nmi_per_h", json_of_number(nmi_per_h(now->judgement.value_mps)),
                     "solutions", list);
}

static exit_code work(schuler_scenario *s, const solve_arguments *a, answer *answers,
                      const schuler_result *now)
{
    const schuler_run_options wanted = simulation_options(&a->simulation);
    const size_t count = a->count > 1 ? a->count + 1 : 1;
    for (size_t i = 0; i < count; i++) {
        const bool is_all = i == a->count;
        schuler_error error = { 0 };
        answers[i].name = is_all ? "all of these together" : a->ids[i];
        answers[i].value = is_all ? NULL : value_of(now, a->ids[i]);
        const exit_code code =
            simulation_status(schuler_solve(s, &wanted, is_all ? a->ids : &a->ids[i],
                                            is_all ? a->count : 1, &answers[i].solution, &error),
                              &error);
        if (code != EXIT_DONE) return code;
    }
    const char *const json = a->simulation.json;
    exit_code code = EXIT_DONE;
    if (json) code = json_write(to_json(s, answers, count, a, now), json);
    if (code != EXIT_DONE || (json && strcmp(json, "-") == 0)) return code;
    return print(s, answers, count, now);
}

exit_code verb_solve(int argc, char **argv)
{
    solve_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *s;
    schuler_result *now = NULL;
    answer *const answers = calloc(a.count + 1, sizeof *answers);
    exit_code code =
        scenario_input(a.simulation.file, &a.simulation.overrides, a.simulation.quiet, &s);
    if (code == EXIT_DONE && !answers) code = say_failure("out of memory");
    if (code == EXIT_DONE && !s->requirement.given)
        code = say_bad_input("%s states no requirement; add one, or say --set 'requirement.drift=1 "
                             "nmi/h' --set requirement.statistic=CEP",
                             a.simulation.file);
    schuler_truth *truth = NULL;
    if (code == EXIT_DONE) code = simulation_truth(s, &a.simulation, &truth);
    if (code == EXIT_DONE) code = simulate(s, &a.simulation, NULL, &now);
    if (code == EXIT_DONE) code = work(s, &a, answers, now);
    schuler_result_free(now);
    schuler_truth_free(truth);
    free(answers);
    free(a.list);
    schuler_scenario_free(s);
    schuler_plugins_free(a.simulation.plugins);
    return code;
}

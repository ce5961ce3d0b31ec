/* SPDX-License-Identifier: MIT */
/* schuler compare: several IMUs on one mission, with the same draws. */
#include "scenarios/metrics.h"
#include "tools/arguments.h"
#include "tools/budget_table.h"
#include "tools/comparison.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include <stdlib.h>
#include <string.h>

enum { KEY_CSV = 2000 };

typedef struct {
    simulation_arguments simulation;
    const char *csv;
} compare_arguments;

static const struct argp_option options[] = {
    { "all", 'a', NULL, 0, "show every source, however small", 0 },
    { "csv", KEY_CSV, "FILE", 0, "the budgets as CSV; - is standard output", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    compare_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->simulation;
        return 0;
    case 'a':
        a->simulation.all = true;
        return 0;
    case KEY_CSV:
        if (!*arg) argp_error(state, "an empty file name");
        a->csv = arg;
        return 0;
    case ARGP_KEY_ARG:
        simulation_take_file(&a->simulation, arg, state);
        return 0;
    case ARGP_KEY_END:
        simulation_need_file(&a->simulation, state, false);
        if (a->simulation.count_imus < 2)
            argp_error(state, "two IMUs or more are compared: --imu A --imu B");
        if (a->csv && a->simulation.json && strcmp(a->csv, "-") == 0 &&
            strcmp(a->simulation.json, "-") == 0)
            argp_error(state, "--csv and --json cannot both go to standard output");
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
    .args_doc = "FILE --imu A --imu B...",
    .doc = "The same mission with several IMUs and the same draws for all: ranking, how many times "
           "one drifts as the best, budgets side by side. An IMU is a catalog name or a file, or "
           "ACCEL+GYRO: the accelerometers of one part and the gyros of another."
           "\vExamples:\n"
           "  schuler compare scenarios/atlantic.yaml --imu hg9900 --imu ln200\n"
           "  schuler compare flight.yaml --imu hg9900 --imu sd1521-025+hg9900 --json -\n"
           "\nExit status: 0 at least one meets the requirement, or none is stated; 1 all fail; 2 "
           "bad command line or input; 3 failed while running; 4 none surely meets it, and not all "
           "fail; 130 interrupted.",
};

/* A+B: two more --set. The texts live as long as the scenario is read. */
static exit_code load(const compare_arguments *a, const char *imu, bool quiet,
                      schuler_scenario **out)
{
    schuler_overrides o = a->simulation.overrides;
    const char *const plus = strchr(imu, '+');
    o.imu = imu;
    if (!plus || strchr(imu, '/')) return scenario_input(a->simulation.file, &o, quiet, out);
    const char **const set = malloc((o.count_set + 2) * sizeof *set);
    char *const text = malloc(2 * strlen(imu) + 64);
    exit_code code = EXIT_FAILED;
    if (set && text) {
        char *const gyro = text + sprintf(text, "imu.accel.use=%.*s", (int)(plus - imu), imu) + 1;
        sprintf(gyro, "imu.gyro.use=%s", plus + 1);
        for (size_t i = 0; i < o.count_set; i++) set[i] = o.set[i];
        set[o.count_set++] = text;
        set[o.count_set++] = gyro;
        o.set = set;
        o.imu = NULL;
        code = scenario_input(a->simulation.file, &o, quiet, out);
    } else {
        say_failure("out of memory");
    }
    free(set);
    free(text);
    return code;
}

/* With no requirement the limits are those of the CEP. */
static exit_code judge(compared *item)
{
    const schuler_requirement cep = { .given = true, .drift_mps = HUGE_VAL };
    item->judgement = item->result->judgement;
    if (item->scenario->requirement.given) return EXIT_DONE;
    if (schuler_judge(&cep, &item->result->all, &item->judgement) != SCHULER_OK)
        return say_failure("out of memory");
    item->judgement.verdict = SCHULER_VERDICT_NONE;
    return EXIT_DONE;
}

static exit_code rank(comparison *c)
{
    for (size_t i = 1; i < c->count; i++) /* insertion sort: equals keep their order */
        for (size_t j = i;
             j > 0 && comparison_drift(&c->items[j]) < comparison_drift(&c->items[j - 1]); j--) {
            const compared swap = c->items[j];
            c->items[j] = c->items[j - 1];
            c->items[j - 1] = swap;
        }
    for (size_t i = 0; i < c->count; i++)
        if (schuler_compare_paired(c->statistic, &c->items[i].result->all, &c->items[0].result->all,
                                   &c->items[i].against_best) != SCHULER_OK)
            return say_failure("out of memory");
    return EXIT_DONE;
}

static exit_code status_of(const comparison *c)
{
    bool all_fail = true;
    for (size_t i = 0; i < c->count; i++) {
        const schuler_verdict verdict = c->items[i].judgement.verdict;
        if (verdict == SCHULER_VERDICT_PASS || verdict == SCHULER_VERDICT_NONE) return EXIT_DONE;
        all_fail &= verdict == SCHULER_VERDICT_FAIL;
    }
    return all_fail ? EXIT_NOT_MET : EXIT_INCONCLUSIVE;
}

static exit_code deliver(const comparison *c, const compare_arguments *a)
{
    const char *const json = a->simulation.json;
    exit_code code = EXIT_DONE;
    if (a->csv) code = outfile_write(a->csv, comparison_csv, c);
    if (code == EXIT_DONE && json) code = json_write(comparison_json(c), json);
    if (code != EXIT_DONE || (json && strcmp(json, "-") == 0) ||
        (a->csv && strcmp(a->csv, "-") == 0))
        return code;
    page p;
    page_open(&p);
    if (p.out && comparison_text(p.out, c, a->simulation.all)) return page_show(&p);
    page_drop(&p);
    return say_failure("out of memory");
}

exit_code verb_compare(int argc, char **argv)
{
    compare_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    comparison c = { .count = a.simulation.count_imus };
    c.items = calloc(c.count, sizeof *c.items);
    exit_code code = c.items ? EXIT_DONE : say_failure("out of memory");
    /* All of them are read before the first is simulated. */
    for (size_t i = 0; i < c.count && code == EXIT_DONE; i++) {
        c.items[i].name = a.simulation.imus[i];
        code = load(&a, a.simulation.imus[i], a.simulation.quiet || i > 0, &c.items[i].scenario);
    }
    for (size_t i = 0; i < c.count && code == EXIT_DONE; i++) {
        code = simulate(c.items[i].scenario, &a.simulation, NULL, &c.items[i].result);
        if (code == EXIT_DONE) code = judge(&c.items[i]);
    }
    if (code == EXIT_DONE) {
        const schuler_requirement *const required = &c.items[0].scenario->requirement;
        c.required = required->given;
        c.statistic = required->given ? required->statistic : SCHULER_STAT_CEP;
        code = rank(&c);
    }
    if (code == EXIT_DONE) code = deliver(&c, &a);
    if (code == EXIT_DONE) code = status_of(&c);
    for (size_t i = 0; c.items && i < c.count; i++) {
        schuler_result_free(c.items[i].result);
        schuler_scenario_free(c.items[i].scenario);
    }
    free(c.items);
    schuler_plugins_free(a.simulation.plugins);
    return code;
}

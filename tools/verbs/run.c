/* SPDX-License-Identifier: MIT */
/* schuler run: simulate a scenario, print its error budget and verdict. */
#include "tools/arguments.h"
#include "tools/budget_plot.h"
#include "tools/gnuplot.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include "tools/result_directory.h"
#include "tools/result_json.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include "tools/until.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { KEY_UNTIL = 256, KEY_ROWS, KEY_PLOT };

/* As schuler_rows. */
static const char *const row_words[] = { "sources", "groups", "without", NULL };

static const struct argp_option options[] = {
    { "all", 'a', NULL, 0, "show every source, however small", 0 },
    { "until", KEY_UNTIL, "PERCENT", 0, "more runs until the drift's 95% limits are within it", 0 },
    { "rows", KEY_ROWS, "WHAT", 0,
      "budget of sources (each alone), of groups, or of all without each source", 0 },
    { "plot", KEY_PLOT, "FILE", 0, "draw the budget over time, .svg or .png (needs gnuplot)", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    simulation_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = a;
        return 0;
    case 'a':
        a->all = true;
        return 0;
    case KEY_ROWS:
        a->rows = (schuler_rows)arguments_choice(state, "--rows", arg, row_words);
        return 0;
    case KEY_PLOT:
        gnuplot_check(state, arg);
        a->plot = arg;
        return 0;
    case KEY_UNTIL:
        if (schuler_quantity_parse(arg, (schuler_dim)SCHULER_DIM_NONE, &a->until, NULL) !=
                SCHULER_OK ||
            !(a->until >= 1e-5 && a->until <= 0.5))
            argp_error(state, "--until: '%s' is not a percentage from 0.001%% to 50%%", arg);
        return 0;
    case ARGP_KEY_ARG:
        simulation_take_file(a, arg, state);
        return 0;
    case ARGP_KEY_END:
        simulation_need_file(a, state, true);
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
    .args_doc = "FILE",
    .doc = "Simulate a scenario: error budget per source, drift, verdict."
           "\vExamples:\n"
           "  schuler run scenarios/atlantic.yaml\n"
           "  schuler run flight.yaml --imu stim300 --runs 400 --json -\n"
           "  schuler run flight.yaml --until 2%\n"
           "  schuler run flight.yaml --set 'imu.gyro.bias=0.01 deg/h' -o "
           "result\n" ARGUMENTS_VERDICT_STATUS,
};

static exit_code print_result(const schuler_result *result, const schuler_covariance *linear,
                              const simulation_arguments *a, bool netcdf)
{
    page p;
    page_open(&p);
    bool complete = p.out != NULL;
    if (complete && !a->quiet) {
        budget_header(p.out, result);
        complete = budget_table(p.out, result, linear, a->all);
        fputc('\n', p.out);
    }
    if (complete && (!a->quiet || result->scenario->requirement.given))
        budget_verdict(p.out, result);
    if (complete && a->directory && !a->quiet)
        fprintf(p.out, "\nResult files in %s: budget.csv errors.csv result.json%s scenario.yaml\n",
                a->directory, netcdf ? " result.nc" : "");
    if (complete) return page_show(&p);
    page_drop(&p);
    return say_failure("out of memory");
}

static exit_code deliver(const schuler_result *result, const schuler_covariance *linear,
                         const simulation_arguments *a, outdir *dir, outfile *errors)
{
    exit_code code = EXIT_DONE;
    const bool json_on_stdout = a->json && strcmp(a->json, "-") == 0;
    bool netcdf = false;
    if (a->directory) code = result_directory_write(dir, errors, result, linear, a, &netcdf);
    if (code == EXIT_DONE && a->json) code = json_write(result_json(result, linear), a->json);
    if (code == EXIT_DONE && a->plot) code = budget_plot(a->plot, result, linear);
    if (code == EXIT_DONE && !json_on_stdout) code = print_result(result, linear, a, netcdf);
    return code == EXIT_DONE ? budget_exit(result) : code;
}

/* On a terminal the answer of the covariance is there at once, while the simulation goes on. */
static void announce(const schuler_covariance *linear)
{
    const schuler_covariance_row *most = NULL;
    for (size_t i = 0; i < linear->row_count; i++)
        if (!most || linear->rows[i].end_m > most->end_m) most = &linear->rows[i];
    if (!most || !(most->end_m > 0.0) || !isatty(STDERR_FILENO)) return;
    const double share = most->end_m * most->end_m / (linear->total.end_m * linear->total.end_m);
    fprintf(stderr, "By linear covariance: %.4g m rms at the end, %s %.0f %% of the variance.\n",
            linear->total.end_m, most->id, 100.0 * fmin(share, 1.0));
}

static exit_code run(schuler_scenario *scenario, simulation_arguments *a)
{
    outdir dir = { 0 };
    outfile errors = { 0 };
    schuler_result *result = NULL;
    exit_code code = EXIT_DONE;
    if (a->directory) code = outdir_open(&dir, a->directory);
    if (code == EXIT_DONE && a->directory) code = outdir_file(&dir, &errors, "errors.csv");
    schuler_covariance *linear = NULL;
    schuler_truth *truth = NULL;
    if (code == EXIT_DONE) code = simulation_truth(scenario, a, &truth);
    const bool is_shown =
        (!a->quiet || a->json || a->directory || a->plot) && a->rows == SCHULER_ROWS_SOURCES;
    if (code == EXIT_DONE && is_shown) code = simulate_linear(scenario, a, &linear);
    if (code == EXIT_DONE && linear && !a->quiet) announce(linear);
    if (code == EXIT_DONE && a->until > 0.0) code = until_runs(scenario, a);
    if (code == EXIT_DONE) code = simulate(scenario, a, &errors, &result);
    if (code == EXIT_DONE) code = deliver(result, linear, a, &dir, &errors);
    schuler_result_free(result);
    schuler_covariance_free(linear);
    schuler_truth_free(truth);
    outfile_drop(&errors);
    outdir_drop(&dir);
    return code;
}

exit_code verb_run(int argc, char **argv)
{
    simulation_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *scenario;
    exit_code code = scenario_input(a.file, &a.overrides, a.quiet, &scenario);
    if (code == EXIT_DONE) code = run(scenario, &a);
    schuler_scenario_free(scenario);
    schuler_plugins_free(a.plugins);
    return code;
}

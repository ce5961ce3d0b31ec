/* SPDX-License-Identifier: MIT */
/* schuler bench: how fast this machine computes, and what the vectors bring. */
#include "scenarios/bench.h"
#include "tools/arguments.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/page.h"
#include "tools/plugin_argument.h"
#include "tools/scenario_input.h"
#include "tools/stop.h"
#include <stdbool.h>
#include <string.h>

enum { KEY_PLUGIN = 256 };

typedef struct {
    const char *file, *json;
    int rounds;
    schuler_plugins *plugins;
} bench_arguments;

static const struct argp_option options[] = {
    { "rounds", 'n', "N", 0, "interleaved repetitions of each measurement (default 9)", 0 },
    PLUGIN_OPTION(KEY_PLUGIN),
    { "json", 'j', "FILE", 0, "all figures as JSON; - is standard output", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    bench_arguments *a = state->input;
    switch (key) {
    case 'n':
        a->rounds = (int)arguments_integer(state, "rounds", arg, 1, 99);
        return 0;
    case KEY_PLUGIN:
        plugin_argument(&a->plugins, arg);
        return 0;
    case 'j':
        a->json = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (a->file) argp_error(state, "one scenario file at a time");
        a->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->file) argp_error(state, "which scenario file?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {
    .options = options,
    .parser = parse,
    .args_doc = "FILE",
    .doc =
        "Measure the speed of the whole chain (truth, sensors, mechanization, gravity, "
        "comparison) on the "
        "trajectory of a scenario, for every instruction set this processor has: linear sensors "
        "with 0, 6 and 18 random numbers a step, accelerometers ieee1293 with all their terms, and "
        "the heaviest models on both triads; "
        "the truth alone; and two threads against one. Medians of interleaved "
        "runs: compare "
        "ratios, single times depend on what else the machine does."
        "\vExamples:\n"
        "  schuler bench scenarios/manoeuvres.yaml\n"
        "  schuler bench scenarios/atlantic.yaml --rounds 21 --json "
        "bench.json\n" ARGUMENTS_EXIT_STATUS,
};

static void print_table(FILE *out, const schuler_bench *b)
{
    fprintf(
        out,
        "One thread, million lane-steps a second (and times the scalar build), medians of %d\n\n",
        b->rounds);
    fprintf(out, "  %-6s", "");
    for (int k = 0; k < SCHULER_BENCH_KINDS; k++) fprintf(out, "  %16s", schuler_bench_names[k]);
    fprintf(out, "  truth, ns\n");
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
        if (!b->has[isa]) continue;
        fprintf(out, "  %-6s", schuler_isa_name((schuler_isa)isa));
        for (int k = 0; k < SCHULER_BENCH_KINDS; k++)
            fprintf(out, "  %6.1f (%5.2f x)", 1e3 / b->chain_ns[isa][k].median,
                    b->over_scalar[isa][k].median);
        fprintf(out, "  %9.1f\n", b->truth_ns[isa].median);
    }
    fprintf(out, "\nTwo threads against one: %.2f x (%.2f to %.2f)\n", b->two_threads.median,
            b->two_threads.min, b->two_threads.max);
}

static json_t *spread(const schuler_spread *s)
{
    return json_pack("{s:f, s:f, s:f}", "min", s->min, "median", s->median, "max", s->max);
}

static json_t *as_json(const schuler_bench *b)
{
    json_t *isas = json_array();
    for (int isa = 0; isas && isa < SCHULER_ISA_COUNT; isa++) {
        if (!b->has[isa]) continue;
        json_t *kinds = json_array();
        for (int k = 0; kinds && k < SCHULER_BENCH_KINDS; k++)
            json_array_append_new(kinds,
                                  json_pack("{s:s, s:o, s:o}", "sensors", schuler_bench_names[k],
                                            "ns_per_lane_step", spread(&b->chain_ns[isa][k]),
                                            "over_scalar", spread(&b->over_scalar[isa][k])));
        json_array_append_new(isas, json_pack("{s:s, s:o, s:o}", "isa",
                                              schuler_isa_name((schuler_isa)isa), "chain", kinds,
                                              "truth_ns_per_step", spread(&b->truth_ns[isa])));
    }
    return json_pack("{s:s, s:s, s:i, s:o, s:o}", "format", "schuler-bench-1", "version",
                     SCHULER_VERSION, "rounds", b->rounds, "isas", isas, "two_threads",
                     spread(&b->two_threads));
}

exit_code verb_bench(int argc, char **argv)
{
    bench_arguments a = { .rounds = 9 };
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *s;
    const schuler_overrides overrides = { .plugins = a.plugins };
    exit_code code = scenario_input(a.file, &overrides, false, &s);
    if (code != EXIT_DONE) {
        schuler_plugins_free(a.plugins);
        return code;
    }
    schuler_bench bench;
    schuler_error error = { 0 };
    const schuler_status status = schuler_bench_run(s, a.rounds, stop_flag(), &bench, &error);
    schuler_scenario_free(s);
    schuler_plugins_free(a.plugins);
    if (status != SCHULER_OK) {
        say_error(&error);
        return exit_of(status);
    }
    if (!a.json || strcmp(a.json, "-") != 0) {
        page p;
        page_open(&p);
        print_table(p.out, &bench);
        code = page_show(&p);
    }
    if (!a.json) return code;
    const exit_code written = json_write(as_json(&bench), a.json);
    return code == EXIT_DONE ? written : code;
}

/* SPDX-License-Identifier: MIT */
/* schuler sweep: drift against the size of one or two sources. */
#include "scenarios/metrics.h"
#include "scenarios/source_size.h"
#include "tools/arguments.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include "tools/result_units.h"
#include "tools/scenario_input.h"
#include "tools/simulate.h"
#include "tools/sweep_axis.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { KEY_POINTS = 2000, KEY_EVEN, KEY_CSV, AXES = 2 };

typedef struct {
    simulation_arguments simulation;
    const char *axes[AXES], *csv;
    int axis_count, points;
    bool even;
} sweep_arguments;

static const struct argp_option options[] = {
    { "points", KEY_POINTS, "N", 0, "values of each source, from 2 to 200; default 9", 0 },
    { "even", KEY_EVEN, NULL, 0, "steps of equal length; else of equal ratio", 0 },
    { "csv", KEY_CSV, "FILE", 0, "the table as CSV; - is standard output", 0 },
    { 0 },
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    sweep_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->simulation;
        return 0;
    case KEY_POINTS:
        a->points = (int)arguments_integer(state, "--points", arg, 2, SWEEP_POINTS_MAX);
        return 0;
    case KEY_EVEN:
        a->even = true;
        return 0;
    case KEY_CSV:
        if (!*arg) argp_error(state, "an empty file name");
        a->csv = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (!a->simulation.file)
            a->simulation.file = arg;
        else if (a->axis_count < AXES)
            a->axes[a->axis_count++] = arg;
        else
            argp_error(state, "two sources at most, not also '%s'", arg);
        return 0;
    case ARGP_KEY_END:
        simulation_need_file(&a->simulation, state, false);
        if (a->axis_count == 0)
            argp_error(state, "which source? For example gyro.bias='0.001..0.1 deg/h'");
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
    .args_doc = "FILE SOURCE=FROM..TO [SOURCE=FROM..TO]",
    .doc = "Drift of all sources together while one or two of them take other sizes, with the same "
           "draws. "
           "A size is the sigma, the half range or the value of a source, of its largest component."
           "\vExamples:\n"
           "  schuler sweep scenarios/atlantic.yaml 'gyro.bias=0.001..0.1 deg/h'\n"
           "  schuler sweep flight.yaml 'gyro.bias=0..0.02 deg/h' 'accel.bias=10..100 ug' --even "
           "--csv -\n" ARGUMENTS_EXIT_STATUS,
};

/* What a point of the grid gave. */
typedef struct {
    double drift_mps, cep_mps, r95_mps, end_m;
    schuler_judgement judgement;
} point;

typedef struct {
    const schuler_scenario *scenario;
    sweep_axis axis[AXES];
    int axis_count, runs;
    point *points; /* [first][second] */
    schuler_statistic statistic;
} sweep;

static int second_points(const sweep *w)
{
    return w->axis_count > 1 ? w->axis[1].points : 1;
}

static const point *at(const sweep *w, int i, int k)
{
    return &w->points[i * second_points(w) + k];
}

static exit_code simulate_point(const sweep *w, schuler_scenario *s, const sweep_arguments *a,
                                int i, int k, point *out)
{
    const schuler_scenario original = *s;
    const int place[AXES] = { i, k };
    schuler_error error = { 0 };
    schuler_status status = SCHULER_OK;
    for (int x = 0; x < w->axis_count && status == SCHULER_OK; x++)
        status = schuler_source_scale(s, w->axis[x].id, w->axis[x].factor[place[x]], &error);
    schuler_result *result = NULL;
    exit_code code = simulation_status(status, &error);
    if (code == EXIT_DONE) code = simulate(s, &a->simulation, NULL, &result);
    if (code == EXIT_DONE) {
        const schuler_requirement cep = { .given = true, .drift_mps = HUGE_VAL };
        *out = (point){ .drift_mps = result->all.required_mps,
                        .cep_mps = result->all.cep_mps,
                        .r95_mps = result->all.r95_mps,
                        .end_m = result->all.rms_end_m,
                        .judgement = result->judgement };
        if (!s->requirement.given) {
            if (schuler_judge(&cep, &result->all, &out->judgement) != SCHULER_OK)
                code = say_failure("out of memory");
            out->judgement.verdict = SCHULER_VERDICT_NONE;
        }
    }
    schuler_result_free(result);
    *s = original;
    return code;
}

static void put_size(FILE *out, const sweep_axis *axis, int i)
{
    fprintf(out, "%12.4g", axis->size[i] / axis->unit_si);
}

static void put_curve(FILE *out, const sweep *w)
{
    const sweep_axis *const axis = &w->axis[0];
    fprintf(out, "  %12s  %12s  %22s\n", axis->unit, "nmi/h", "95 % limits");
    for (int i = 0; i < axis->points; i++) {
        const point *const p = at(w, i, 0);
        fputs("  ", out);
        put_size(out, axis, i);
        fprintf(out, "  %12.4g", nmi_per_h(p->drift_mps));
        if (isfinite(p->judgement.upper_mps) && p->judgement.lower_mps > 0.0)
            fprintf(out, "  %9.4g to %9.4g", nmi_per_h(p->judgement.lower_mps),
                    nmi_per_h(p->judgement.upper_mps));
        if (p->judgement.verdict != SCHULER_VERDICT_NONE)
            fprintf(out, "  %s", verdict_name(p->judgement.verdict));
        fputc('\n', out);
    }
}

/* The first source down, the second across, six columns at a time. */
static void put_grid(FILE *out, const sweep *w)
{
    enum { COLUMNS = 6, WIDTH = 10 };
    for (int first = 0; first < w->axis[1].points; first += COLUMNS) {
        const int end = first + COLUMNS < w->axis[1].points ? first + COLUMNS : w->axis[1].points;
        fprintf(out, "  %12s  %s, %s\n  %12s", w->axis[0].unit, w->axis[1].id, w->axis[1].unit, "");
        for (int k = first; k < end; k++)
            fprintf(out, " %*.3g ", WIDTH - 2, w->axis[1].size[k] / w->axis[1].unit_si);
        fputc('\n', out);
        for (int i = 0; i < w->axis[0].points; i++) {
            fputs("  ", out);
            put_size(out, &w->axis[0], i);
            for (int k = first; k < end; k++) {
                const point *const p = at(w, i, k);
                const char mark = p->judgement.verdict == SCHULER_VERDICT_FAIL           ? '!'
                                  : p->judgement.verdict == SCHULER_VERDICT_INCONCLUSIVE ? '?'
                                                                                         : ' ';
                fprintf(out, " %*.3g%c", WIDTH - 2, nmi_per_h(p->drift_mps), mark);
            }
            fputc('\n', out);
        }
        fputc('\n', out);
    }
    if (w->scenario->requirement.given)
        fprintf(out, "  ! beyond %g nmi/h, ? not told by these runs\n",
                nmi_per_h(w->scenario->requirement.drift_mps));
}

static exit_code print(const sweep *w)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    fprintf(p.out, "%s\n  %d runs, seed %llu; drift %s against %s%s%s\n\n", w->scenario->name,
            w->runs, (unsigned long long)w->scenario->seed, statistic_name(w->statistic),
            w->axis[0].id, w->axis_count > 1 ? " and " : "",
            w->axis_count > 1 ? w->axis[1].id : "");
    if (w->axis_count > 1)
        put_grid(p.out, w);
    else
        put_curve(p.out, w);
    return page_show(&p);
}

static void put_csv(FILE *out, const void *what)
{
    const sweep *const w = what;
    for (int x = 0; x < w->axis_count; x++)
        fprintf(out, "%s (%s),", w->axis[x].id, w->axis[x].unit);
    fputs("drift_cep_nmi_per_h,drift_r95_nmi_per_h,horizontal_rms_end_m,lower_nmi_per_h,upper_nmi_"
          "per_h,"
          "verdict\n",
          out);
    for (int i = 0; i < w->axis[0].points; i++)
        for (int k = 0; k < second_points(w); k++) {
            const point *const p = at(w, i, k);
            fprintf(out, "%.17g,", w->axis[0].size[i] / w->axis[0].unit_si);
            if (w->axis_count > 1) fprintf(out, "%.17g,", w->axis[1].size[k] / w->axis[1].unit_si);
            fprintf(out, "%.17g,%.17g,%.17g,%.17g,", nmi_per_h(p->cep_mps), nmi_per_h(p->r95_mps),
                    p->end_m, nmi_per_h(p->judgement.lower_mps));
            if (isfinite(p->judgement.upper_mps))
                fprintf(out, "%.17g", nmi_per_h(p->judgement.upper_mps));
            fprintf(out, ",%s\n",
                    p->judgement.verdict == SCHULER_VERDICT_NONE
                        ? ""
                        : verdict_name(p->judgement.verdict));
        }
}

static json_t *axis_json(const sweep_axis *axis)
{
    json_t *const sizes = json_array();
    for (int i = 0; i < axis->points; i++)
        json_array_append_new(sizes, json_of_number(axis->size[i] / axis->unit_si));
    return json_pack("{s:s, s:o, s:o}", "source", axis->id, "unit", json_of_text(axis->unit),
                     "sizes", sizes);
}

static json_t *to_json(const sweep *w)
{
    json_t *const axes = json_array(), *const rows = json_array();
    for (int x = 0; x < w->axis_count; x++) json_array_append_new(axes, axis_json(&w->axis[x]));
    for (int i = 0; i < w->axis[0].points; i++)
        for (int k = 0; k < second_points(w); k++) {
            const point *const p = at(w, i, k);
            json_array_append_new(
                rows, json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "drift_cep_nmi_per_h",
                                json_of_number(nmi_per_h(p->cep_mps)), "drift_r95_nmi_per_h",
                                json_of_number(nmi_per_h(p->r95_mps)), "horizontal_rms_end_m",
                                json_of_number(p->end_m), "lower",
                                json_of_number(nmi_per_h(p->judgement.lower_mps)), "upper",
                                json_of_number(nmi_per_h(p->judgement.upper_mps)), "verdict",
                                p->judgement.verdict == SCHULER_VERDICT_NONE
                                    ? json_null()
                                    : json_of_text(verdict_name(p->judgement.verdict))));
        }
    return json_pack("{s:s, s:s, s:{s:o, s:s}, s:I, s:i, s:s, s:o, s:o}", "format",
                     "schuler-sweep-1", "version", SCHULER_VERSION, "scenario", "name",
                     json_of_text(w->scenario->name), "sha256", w->scenario->sha256, "seed",
                     (json_int_t)w->scenario->seed, "runs", w->runs, "statistic",
                     statistic_name(w->statistic), "axes", axes, "points", rows);
}

static exit_code work(sweep *w, schuler_scenario *s, const sweep_arguments *a)
{
    exit_code code = EXIT_DONE;
    for (int x = 0; x < a->axis_count && code == EXIT_DONE; x++)
        code = sweep_axis_read(&w->axis[x], s, a->axes[x], a->points ? a->points : 9, a->even);
    if (code != EXIT_DONE) return code;
    w->axis_count = a->axis_count;
    if (w->axis_count > 1 && strcmp(w->axis[0].id, w->axis[1].id) == 0)
        return say_bad_input("'%s' stands there twice", w->axis[0].id);
    w->points = calloc((size_t)w->axis[0].points * (size_t)second_points(w), sizeof *w->points);
    if (!w->points) return say_failure("out of memory");
    for (int i = 0; i < w->axis[0].points && code == EXIT_DONE; i++)
        for (int k = 0; k < second_points(w) && code == EXIT_DONE; k++)
            code = simulate_point(w, s, a, i, k, &w->points[i * second_points(w) + k]);
    const char *const json = a->simulation.json;
    if (code == EXIT_DONE && a->csv) code = outfile_write(a->csv, put_csv, w);
    if (code == EXIT_DONE && json) code = json_write(to_json(w), json);
    const bool is_taken = (json && strcmp(json, "-") == 0) || (a->csv && strcmp(a->csv, "-") == 0);
    return code == EXIT_DONE && !is_taken ? print(w) : code;
}

exit_code verb_sweep(int argc, char **argv)
{
    sweep_arguments a = { .simulation = { .rows = SCHULER_ROWS_NONE } };
    arguments_parse(&argp, argc, argv, &a);
    schuler_scenario *s;
    exit_code code =
        scenario_input(a.simulation.file, &a.simulation.overrides, a.simulation.quiet, &s);
    if (code == EXIT_DONE) {
        sweep w = { .scenario = s,
                    .runs = s->runs,
                    .statistic =
                        s->requirement.given ? s->requirement.statistic : SCHULER_STAT_CEP };
        schuler_truth *truth = NULL;
        code = simulation_truth(s, &a.simulation, &truth);
        if (code == EXIT_DONE) code = work(&w, s, &a);
        schuler_truth_free(truth);
        free(w.points);
    }
    schuler_scenario_free(s);
    schuler_plugins_free(a.simulation.plugins);
    return code;
}

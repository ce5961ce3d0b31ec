/* SPDX-License-Identifier: MIT */
#include "scenarios/metrics.h"
#include "tools/messages.h"
#include "tools/report.h"
#include "tools/report_lanes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The horizontal errors of the joint runs at the times kept, run by run, as long as they are read. */
typedef struct {
    double *h_m;
    int room;
} joint_runs;

/* The budget's row of the i-th source that has lanes of its own; NULL after the last. The numerical
 * residue has not: it is the lane `none`. */
static const json_t *source_row(const json_t *result, size_t i)
{
    const json_t *const budget = json_object_get(result, "budget");
    for (size_t k = 0; k < json_array_size(budget); k++) {
        const json_t *const row = json_array_get(budget, k);
        if (strcmp(json_string_value(json_object_get(row, "source")), "numerical") == 0) continue;
        if (i-- == 0) return row;
    }
    return NULL;
}

static const char *curve_id(const json_t *result, size_t i)
{
    const json_t *const row = source_row(result, i);
    if (row) return json_string_value(json_object_get(row, "source"));
    return i == 0 || source_row(result, i - 1) ? "all" : "none";
}

static exit_code allocate(report_curves *c)
{
    const size_t n = c->time_count;
    c->times_s = calloc(4 * n, sizeof(double));
    c->curves = calloc(c->curve_count, sizeof(*c->curves));
    if (!c->times_s || !c->curves) return say_failure("out of memory");
    c->low_m = c->times_s + n;
    c->median_m = c->low_m + n;
    c->high_m = c->median_m + n;
    for (size_t i = 0; i < c->curve_count; i++)
        if (!(c->curves[i].rms_m = calloc(n, sizeof(double)))) return say_failure("out of memory");
    return EXIT_DONE;
}

static bool grow(joint_runs *joint, report_curves *c)
{
    if (c->joint_runs < joint->room) return true;
    const int room = joint->room ? 2 * joint->room : 64;
    double *h = reallocarray(joint->h_m, (size_t)room * c->time_count, sizeof(double));
    if (h) joint->h_m = h;
    double *north = reallocarray(c->north_m, (size_t)room, sizeof(double));
    if (north) c->north_m = north;
    double *east = reallocarray(c->east_m, (size_t)room, sizeof(double));
    if (east) c->east_m = east;
    if (!h || !north || !east) return false;
    joint->room = room;
    return true;
}

static exit_code add_joint(joint_runs *joint, report_curves *c, const double *north_m,
                           const double *east_m)
{
    if (!grow(joint, c)) return say_failure("out of memory");
    double *const h = joint->h_m + (size_t)c->joint_runs * c->time_count;
    for (size_t k = 0; k < c->time_count; k++) h[k] = hypot(north_m[k], east_m[k]);
    c->north_m[c->joint_runs] = north_m[c->time_count - 1];
    c->east_m[c->joint_runs] = east_m[c->time_count - 1];
    c->joint_runs++;
    return EXIT_DONE;
}

/* One source, all its runs: as many as the result has, or one when nothing of it is drawn. */
static exit_code read_curve(report_lanes *l, const char *id, int runs, const size_t *keep,
                            report_curves *c, report_curve *curve, joint_runs *joint)
{
    double north[REPORT_TIMES], east[REPORT_TIMES];
    do {
        exit_code code = report_lanes_read(l, id, curve->runs, keep, c->time_count, north, east);
        if (code == EXIT_DONE && joint) code = add_joint(joint, c, north, east);
        if (code != EXIT_DONE) return code;
        for (size_t k = 0; k < c->time_count; k++)
            curve->rms_m[k] += north[k] * north[k] + east[k] * east[k];
        curve->runs++;
    } while (curve->runs < runs && report_lanes_next_is(l, id, curve->runs));
    if (curve->runs != runs && curve->runs != 1)
        return say_bad_input("%s:%zu: %d runs of %.64s, and result.json has %d", l->path, l->line,
                             curve->runs, id, runs);
    for (size_t k = 0; k < c->time_count; k++)
        curve->rms_m[k] = sqrt(curve->rms_m[k] / curve->runs);
    return EXIT_DONE;
}

static exit_code summarise(report_curves *c, const joint_runs *joint)
{
    const int n = c->joint_runs;
    double *values = calloc(2 * (size_t)n, sizeof(double)), *const scratch = values + n;
    if (!values) return say_failure("out of memory");
    for (size_t k = 0; k < c->time_count; k++) {
        for (int i = 0; i < n; i++) values[i] = joint->h_m[(size_t)i * c->time_count + k];
        c->low_m[k] = schuler_percentile(values, n, 0.05, scratch);
        c->median_m[k] = schuler_percentile(values, n, 0.5, scratch);
        c->high_m[k] = schuler_percentile(values, n, 0.95, scratch);
    }
    c->r50_m = c->median_m[c->time_count - 1];
    c->r95_m = c->high_m[c->time_count - 1];
    free(values);
    return EXIT_DONE;
}

/* The last row is the end: what it gives must be what result.json says, but for the last digits. */
static exit_code compare_ends(const report_curves *c, const char *path, const json_t *result)
{
    for (size_t i = 0; i < c->curve_count; i++) {
        const char *const id = curve_id(result, i);
        const json_t *const source = source_row(result, i);
        const json_t *const row = source ? source : json_object_get(result, id);
        const double said =
            json_number_value(json_object_get(json_object_get(row, "horizontal_rms_m"), "at_end"));
        const double found = c->curves[i].rms_m[c->time_count - 1];
        if (fabs(found - said) > 1e-6 * fabs(said) + 1e-9)
            return say_bad_input("%s: the rms error of %.64s at the end is %.9g m, and %.9g m in "
                                 "result.json: not of the same result",
                                 path, id, found, said);
    }
    return EXIT_DONE;
}

static exit_code read_all(report_lanes *l, const json_t *result, report_curves *c,
                          joint_runs *joint)
{
    const int runs = (int)json_integer_value(json_object_get(result, "runs"));
    size_t keep[REPORT_TIMES];
    for (c->curve_count = 2; source_row(result, c->curve_count - 2); c->curve_count++) {
    }
    c->row_count = l->row_count;
    c->time_count = l->row_count < REPORT_TIMES ? l->row_count : REPORT_TIMES;
    exit_code code = allocate(c);
    for (size_t k = 0; code == EXIT_DONE && k < c->time_count; k++) {
        keep[k] = k * (l->row_count - 1) / (c->time_count - 1);
        c->times_s[k] = strtod(l->times[keep[k]], NULL);
    }
    for (size_t i = 0; code == EXIT_DONE && i < c->curve_count; i++)
        code = read_curve(l, curve_id(result, i), runs, keep, c, &c->curves[i],
                          i + 2 == c->curve_count ? joint : NULL);
    if (code == EXIT_DONE) code = report_lanes_end(l);
    if (code == EXIT_DONE) code = compare_ends(c, l->path, result);
    return code == EXIT_DONE ? summarise(c, joint) : code;
}

exit_code report_curves_read(const char *path, const json_t *result, report_curves *out)
{
    *out = (report_curves){ 0 };
    report_lanes l = { 0 };
    joint_runs joint = { 0 };
    exit_code code = report_lanes_open(&l, path, curve_id(result, 0));
    if (code == EXIT_DONE) code = read_all(&l, result, out, &joint);
    free(joint.h_m);
    report_lanes_close(&l);
    if (code != EXIT_DONE) report_curves_free(out);
    return code;
}

void report_curves_free(report_curves *c)
{
    for (size_t i = 0; c->curves && i < c->curve_count; i++) free(c->curves[i].rms_m);
    free(c->curves);
    free(c->times_s);
    free(c->north_m);
    free(c->east_m);
    *c = (report_curves){ 0 };
}

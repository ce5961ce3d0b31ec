/* SPDX-License-Identifier: MIT */
#include "scenarios/solve.h"
#include "scenarios/source_size.h"
#include <math.h>

enum { SIMULATIONS_MAX = 40 };
static const double largest_factor = 1e6;

typedef struct {
    schuler_scenario *scenario;
    const schuler_scenario *original;
    const schuler_run_options *options;
    const char *const *ids;
    size_t count;
    int simulations;
} search;

/* The drift with the values times k. */
static schuler_status drift_at(search *s, double k, double *drift_mps, schuler_error *err)
{
    schuler_run_options options = *s->options;
    options.rows = SCHULER_ROWS_NONE;
    options.errors = NULL;
    *s->scenario = *s->original;
    schuler_status status = SCHULER_OK;
    for (size_t i = 0; i < s->count && status == SCHULER_OK; i++)
        status = schuler_source_scale(s->scenario, s->ids[i], k, err);
    schuler_result *result = NULL;
    if (status == SCHULER_OK) status = schuler_simulate(s->scenario, &options, &result, err);
    if (status == SCHULER_OK) *drift_mps = result->judgement.value_mps;
    schuler_result_free(result);
    s->simulations++;
    return status;
}

/* In x = k^2 the square of the drift is nearly a line, so false position (Illinois) takes few steps. low and
 * high enclose the solution. */
static schuler_status close_in(search *s, double limit_mps, double x[2], double f[2],
                               schuler_solution *out, schuler_error *err)
{
    int side = -1;
    for (;;) {
        const double at = (x[0] * f[1] - x[1] * f[0]) / (f[1] - f[0]);
        out->factor = sqrt(at);
        const schuler_status status = drift_at(s, out->factor, &out->drift_mps, err);
        if (status != SCHULER_OK) return status;
        const double missed = out->drift_mps / limit_mps - 1.0;
        if (fabs(missed) <= SCHULER_SOLVE_TOLERANCE || s->simulations >= SIMULATIONS_MAX)
            return SCHULER_OK;
        const int end = missed > 0.0;
        x[end] = at;
        f[end] = out->drift_mps * out->drift_mps - limit_mps * limit_mps;
        if (side == end) f[!end] *= 0.5;
        side = end;
    }
}

static schuler_status solve(search *s, double limit_mps, schuler_solution *out, schuler_error *err)
{
    double x[2] = { 0.0, 1.0 }, f[2], drift_mps = 0.0;
    schuler_status status = drift_at(s, 0.0, &out->without_mps, err);
    if (status != SCHULER_OK) return status;
    out->drift_mps = out->without_mps;
    out->factor = -1.0;
    if (out->without_mps > limit_mps) return SCHULER_OK;
    f[0] = out->without_mps * out->without_mps - limit_mps * limit_mps;
    for (;;) {
        status = drift_at(s, sqrt(x[1]), &drift_mps, err);
        if (status != SCHULER_OK) return status;
        f[1] = drift_mps * drift_mps - limit_mps * limit_mps;
        if (f[1] > 0.0) break;
        out->factor = (double)INFINITY;
        if (sqrt(x[1]) >= largest_factor || s->simulations >= SIMULATIONS_MAX) return SCHULER_OK;
        /* Where the line through both reaches the limit, and twice beyond. */
        const double rise = f[1] - f[0], gained = rise > 0.0 ? -f[1] / rise * (x[1] - x[0]) : 0.0;
        const double next = rise > 0.0 ? x[1] + 2.0 * gained : 100.0 * x[1];
        x[0] = x[1];
        f[0] = f[1];
        x[1] = fmin(fmax(next, 1.5 * x[1]), largest_factor * largest_factor);
    }
    return close_in(s, limit_mps, x, f, out, err);
}

schuler_status schuler_solve(schuler_scenario *scenario, const schuler_run_options *options,
                             const char *const *ids, size_t count, schuler_solution *out,
                             schuler_error *err)
{
    if (!scenario->requirement.given)
        return schuler_fail(err, SCHULER_ERR_INPUT, NULL,
                            "the scenario states no requirement to be met");
    const schuler_scenario original = *scenario;
    search s = { scenario, &original, options, ids, count, 0 };
    schuler_solution found = { 0 };
    const schuler_status status = solve(&s, scenario->requirement.drift_mps, &found, err);
    *scenario = original;
    found.simulations = s.simulations;
    if (status == SCHULER_OK) *out = found;
    return status;
}

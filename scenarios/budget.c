/* SPDX-License-Identifier: MIT */
#include "scenarios/budget.h"
#include "scenarios/metrics.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int row_allocate(schuler_budget_row *row, int runs, size_t reports)
{
    row->runs = runs;
    double **arrays[] = { &row->end_m,     &row->max_m,       &row->slope_mps,  &row->v_rms_mps,
                          &row->drift_mps, &row->axis_mps[0], &row->axis_mps[1] };
    for (size_t i = 0; i < sizeof(arrays) / sizeof(arrays[0]); i++) {
        *arrays[i] = calloc((size_t)runs, sizeof(double));
        if (!*arrays[i]) return 0;
    }
    row->rms_curve_m = calloc(reports, sizeof(double));
    return row->rms_curve_m != NULL;
}

static void row_release(schuler_budget_row *row)
{
    free(row->end_m);
    free(row->max_m);
    free(row->slope_mps);
    free(row->v_rms_mps);
    free(row->drift_mps);
    for (int i = 0; i < 2; i++) free(row->axis_mps[i]);
    free(row->rms_curve_m);
}

schuler_budget_row *schuler_budget_row_at(schuler_result *result, const simulation_plan *plan,
                                          int row)
{
    if (row < plan->rows) return &result->rows[row];
    return row == plan_row_all(plan) ? &result->all : &result->none;
}

/* Perfect sensors are a source like any other: what is left is the navigator's own error. */
static const char numerical_id[] = "numerical";

static bool numerical_wanted(const simulation_plan *plan)
{
    return plan->rows_are == SCHULER_ROWS_SOURCES &&
           schuler_source_selected(plan->scenario, numerical_id, numerical_id);
}

schuler_result *schuler_budget_create(const simulation_plan *plan)
{
    schuler_result *r = calloc(1, sizeof(*r));
    if (!r) return NULL;
    r->scenario = plan->scenario;
    r->runs = plan->scenario->runs;
    r->steps = plan->steps;
    r->rows_are = plan->rows_are;
    r->duration_s = (double)plan->steps / plan->scenario->imu.rate_hz;
    r->time_count = plan->reports;
    r->row_count = (size_t)plan->rows + (numerical_wanted(plan) ? 1 : 0);
    r->rows = calloc(r->row_count + 1, sizeof(*r->rows));
    r->times_s = calloc(r->time_count, sizeof(double));
    int good = r->rows && r->times_s;
    for (int row = 0; good && row <= plan_row_none(plan); row++) {
        schuler_budget_row *b = schuler_budget_row_at(r, plan, row);
        b->drawn = schuler_plan_row_drawn(plan, row);
        b->value_text = "";
        schuler_plan_row_id(plan, row, b->id);
        good = row_allocate(b, b->drawn ? r->runs : 1, r->time_count);
        if (row >= plan->rows) continue;
        const error_source *s = schuler_plan_row_source(plan, row);
        snprintf(b->group, sizeof(b->group), "%s", s->group);
        if (s->value && plan->rows_are != SCHULER_ROWS_GROUPS) {
            b->value_text = s->value->text ? s->value->text : "";
            b->assumed = s->value->assumed;
        }
    }
    if (good && r->row_count > (size_t)plan->rows) {
        schuler_budget_row *b = &r->rows[plan->rows];
        snprintf(b->id, sizeof(b->id), "%s", numerical_id);
        snprintf(b->group, sizeof(b->group), "%s", numerical_id);
        b->value_text = "";
        good = row_allocate(b, 1, r->time_count);
    }
    if (!good) {
        schuler_result_free(r);
        return NULL;
    }
    for (size_t i = 0; i < r->time_count; i++) {
        const int64_t step = (int64_t)(i + 1) * plan->report_steps;
        r->times_s[i] =
            (double)(step < plan->steps ? step : plan->steps) / plan->scenario->imu.rate_hz;
    }
    return r;
}

void schuler_result_free(schuler_result *r)
{
    if (!r) return;
    for (size_t i = 0; r->rows && i < r->row_count; i++) row_release(&r->rows[i]);
    row_release(&r->all);
    row_release(&r->none);
    free(r->rows);
    free(r->times_s);
    free(r);
}

static void copy_row(schuler_budget_row *to, const schuler_budget_row *from, size_t reports)
{
    const size_t bytes = (size_t)from->runs * sizeof(double);
    memcpy(to->end_m, from->end_m, bytes);
    memcpy(to->max_m, from->max_m, bytes);
    memcpy(to->slope_mps, from->slope_mps, bytes);
    memcpy(to->v_rms_mps, from->v_rms_mps, bytes);
    memcpy(to->drift_mps, from->drift_mps, bytes);
    for (int i = 0; i < 2; i++) memcpy(to->axis_mps[i], from->axis_mps[i], bytes);
    memcpy(to->rms_curve_m, from->rms_curve_m, reports * sizeof(double));
}

/* Of the summed variance; of rows that leave one source out, what that adds to the others, and no sum. */
static void take_shares(schuler_result *r, double end2, double max2)
{
    const bool adds = r->rows_are == SCHULER_ROWS_WITHOUT;
    const double all2 = adds ? r->all.rms_end_m * r->all.rms_end_m : end2;
    r->rss_end_m = adds ? 0.0 : sqrt(end2);
    r->rss_max_m = adds ? 0.0 : sqrt(max2);
    for (size_t i = 0; i < r->row_count; i++) {
        const double row2 = r->rows[i].rms_end_m * r->rows[i].rms_end_m;
        r->rows[i].share = !(all2 > 0.0) ? 0.0 : adds ? 1.0 - row2 / all2 : row2 / all2;
    }
}

static schuler_status summarise(schuler_budget_row *row, const schuler_requirement *required)
{
    const schuler_status status = schuler_row_summarise(row);
    return status == SCHULER_OK ? schuler_row_required(row, required) : status;
}

schuler_status schuler_budget_finish(schuler_result *r, const simulation_plan *plan,
                                     const double *chunk_curves_m2)
{
    for (size_t c = 0; c < plan->chunk_count; c++) {
        schuler_budget_row *row = schuler_budget_row_at(r, plan, plan->chunks[c].row);
        for (size_t i = 0; i < r->time_count; i++)
            row->rms_curve_m[i] += chunk_curves_m2[c * r->time_count + i];
    }
    for (int row = 0; row <= plan_row_none(plan); row++) {
        schuler_budget_row *b = schuler_budget_row_at(r, plan, row);
        for (size_t i = 0; i < r->time_count; i++)
            b->rms_curve_m[i] = sqrt(b->rms_curve_m[i] / b->runs);
    }
    if (r->row_count > (size_t)plan->rows) copy_row(&r->rows[plan->rows], &r->none, r->time_count);

    double end2 = 0.0, max2 = 0.0;
    const schuler_requirement *const required = &plan->scenario->requirement;
    schuler_status status = summarise(&r->all, required);
    if (status == SCHULER_OK) status = summarise(&r->none, required);
    for (size_t i = 0; i < r->row_count && status == SCHULER_OK; i++) {
        schuler_budget_row *b = &r->rows[i];
        status = summarise(b, required);
        end2 += b->rms_end_m * b->rms_end_m;
        max2 += b->rms_max_m * b->rms_max_m;
    }
    if (status != SCHULER_OK) return status;
    take_shares(r, end2, max2);
    if (!plan->scenario->requirement.given) return SCHULER_OK;
    return schuler_judge(&plan->scenario->requirement, &r->all, &r->judgement);
}

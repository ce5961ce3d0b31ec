/* SPDX-License-Identifier: MIT */
#include "scenarios/covariance.h"
#include "scenarios/align.h"
#include "scenarios/covariance_parts.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Over so long the truth counts as uniform: what turns or accelerates within it is seen by its mean. */
static const double stretch_s = 1.0;

static schuler_status set_up(covariance_run *c, schuler_error *err)
{
    const schuler_scenario *const s = c->plan.scenario;
    const size_t count = (size_t)c->plan.count + 1, most = count * (SCHULER_COMPONENTS_MAX + 1);
    c->vectors = calloc(most, sizeof *c->vectors);
    c->lanes = calloc(most, sizeof *c->lanes);
    c->noises = calloc(count, sizeof *c->noises);
    schuler_covariance *const r = calloc(1, sizeof *r);
    c->result = r;
    if (r) {
        r->row_count = (size_t)c->plan.count;
        r->rows = calloc(count, sizeof *r->rows);
        r->time_count = c->plan.reports;
        r->times_s = calloc(r->time_count, sizeof(double));
        r->total.rms_curve_m = calloc(r->time_count, sizeof(double));
        snprintf(r->total.id, sizeof r->total.id, "all");
    }
    bool complete =
        c->vectors && c->lanes && c->noises && r && r->rows && r->times_s && r->total.rms_curve_m;
    for (int i = 0; complete && i < c->plan.count; i++) {
        memcpy(r->rows[i].id, c->plan.sources[i].id, sizeof r->rows[i].id);
        r->rows[i].uncovered = covariance_add_source(c, i);
        r->rows[i].rms_curve_m = calloc(r->time_count, sizeof(double));
        complete = r->rows[i].rms_curve_m != NULL;
    }
    if (!complete) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    c->navigator = (linear_navigator){ .vertical = s->vertical,
                                       .gravity = schuler_truth_nav_gravity(c->truth),
                                       .hold_s = schuler_hold_interval(&c->plan) *
                                                 schuler_truth_dt(c->truth) };
    schuler_truth_state start;
    schuler_truth_at(c->truth, 0.0, &start);
    c->start_h_m = start.llh.h_m;
    c->navigator.gains = schuler_baro_gains_of(
        s->baro_time_s, schuler_vec3_norm(schuler_gravity_at(c->navigator.gravity, start.r_e)),
        start.llh.lat_rad);
    return sensor_bench_create(&c->bench, &c->plan, c->lanes, c->lane_count, err);
}

/* What the barometer's bias, scale and lag are over a stretch, for a vector that holds one sigma of them. */
static double baro_error_m(const covariance_run *c, const error_vector *v,
                           const linear_stretch *stretch)
{
    const error_source *const s = &c->plan.sources[v->source];
    double mean, sigma;
    covariance_moments(s, 0, c->plan.scenario->seed, &mean, &sigma);
    const double value = v->is_mean ? mean : sigma;
    const schuler_vec3 up = linear_up(&c->navigator, stretch->r_e);
    switch (s->param) {
    case SCHULER_BARO_SCALE_FACTOR:
        return value * (schuler_gravity_height(c->navigator.gravity, stretch->r_e) - c->start_h_m);
    case SCHULER_BARO_LAG:
        return -value * schuler_vec3_dot(stretch->v_e, up);
    default:
        return value;
    }
}

/* What the body turns within samples that are added up counts by its square over 24 when it is steady, and as
 * it is when the force swings with it (sculling): so only where it hardly turns. */
static int cut_block(const covariance_run *c, const schuler_truth_block *truth, double end_s,
                     turned_samples parts[SCHULER_BLOCK])
{
    enum { TOGETHER = 8 };
    const double still_rad = 2e-3;
    int count = 0;
    for (int from = 0; from < truth->n; from += TOGETHER) {
        const int n = truth->n - from < TOGETHER ? truth->n - from : TOGETHER;
        double turned_rad = 0.0;
        for (int k = from; k < from + n; k++)
            for (int i = 0; i < 3; i++) turned_rad += fabs(truth->dtheta_ib_b[i][k]);
        const int each = turned_rad < still_rad ? n : 1;
        for (int k = from; k < from + n; k += each) {
            const double middle_s = ((double)(truth->first + k) + 0.5 * each) * truth->dt_s;
            const schuler_quat q_b_e = schuler_path_at(&c->plan.scenario->path, middle_s).q_b_e;
            parts[count++] =
                (turned_samples){ k, each, schuler_mat3_from_quat(q_b_e), end_s - middle_s };
        }
    }
    return count;
}

/* One block of the truth: forces, mean attitude, inputs of the vectors. */
static void take_block(covariance_run *c, int64_t first, int n, double end_s, schuler_vec3 *dv_e,
                       schuler_mat3 *C_sum)
{
    schuler_truth_block truth;
    schuler_truth_block_compute(c->truth, c->plan.isa, first, n, &truth);
    turned_samples parts[SCHULER_BLOCK];
    const int count = cut_block(c, &truth, end_s, parts);
    for (int p = 0; p < count; p++) {
        const schuler_mat3 *const C = &parts[p].C_b_e;
        schuler_vec3 dv_b = { { 0 } };
        for (int k = parts[p].from; k < parts[p].from + parts[p].n; k++)
            for (int i = 0; i < 3; i++) dv_b.v[i] += truth.dv_ib_b[i][k];
        *dv_e = schuler_vec3_add(*dv_e, schuler_mat3_apply(C, dv_b));
        for (int i = 0; i < 9; i++) C_sum->m[i / 3][i % 3] += parts[p].n * C->m[i / 3][i % 3];
    }
    sensor_bench_take(c->bench, &truth, parts, count, c->vectors);
    if (!truth.has_dg) return;
    for (int v = 0; v < c->vector_count; v++) {
        if (c->plan.sources[c->vectors[v].source].kind != SOURCE_GRAVITY) continue;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < n; k++) {
                const double dv_mps = -truth.dg_truth_e[i][k] * truth.dt_s;
                c->vectors[v].u[LINEAR_DV + i] += dv_mps;
                c->vectors[v].later[LINEAR_DV + i] +=
                    dv_mps * (end_s - ((double)(first + k) + 0.5) * truth.dt_s);
            }
    }
}

/* The matrices take an input for constant over the stretch. One that swings may have no integral and yet leave
 * a velocity's worth of position behind, and an angle's of velocity. */
static void add_unevenness(const covariance_run *c, const linear_stretch *s, const error_vector *v,
                           double *x)
{
    schuler_vec3 dr_e, psi_s;
    for (int i = 0; i < 3; i++) {
        dr_e.v[i] = v->later[LINEAR_DV + i] - 0.5 * s->T_s * v->u[LINEAR_DV + i];
        psi_s.v[i] = v->later[LINEAR_PSI + i] - 0.5 * s->T_s * v->u[LINEAR_PSI + i];
    }
    schuler_vec3 dv_e = schuler_vec3_cross(s->f_e, psi_s);
    if (c->navigator.vertical == SCHULER_VERTICAL_TRUTH) {
        const schuler_vec3 up = linear_up(&c->navigator, s->end_r_e);
        dr_e = schuler_vec3_sub(dr_e, schuler_vec3_scale(schuler_vec3_dot(dr_e, up), up));
        dv_e = schuler_vec3_sub(dv_e, schuler_vec3_scale(schuler_vec3_dot(dv_e, up), up));
    }
    for (int i = 0; i < 3; i++) {
        x[LINEAR_DR + i] += dr_e.v[i];
        x[LINEAR_DV + i] += dv_e.v[i];
    }
}

/* Steps first+1 .. last. */
static void take_stretch(covariance_run *c, int64_t first, int64_t last)
{
    const double dt_s = schuler_truth_dt(c->truth);
    const schuler_path *const path = &c->plan.scenario->path;
    schuler_vec3 dv_e = { { 0 } };
    schuler_mat3 C_b_e = { { { 0 } } };
    for (int64_t k = first; k < last; k += SCHULER_BLOCK)
        take_block(c, k, last - k < SCHULER_BLOCK ? (int)(last - k) : SCHULER_BLOCK,
                   (double)last * dt_s, &dv_e, &C_b_e);
    const schuler_motion middle = schuler_path_at(path, 0.5 * (double)(first + last) * dt_s),
                         end = schuler_path_at(path, (double)last * dt_s);
    const double T_s = (double)(last - first) * dt_s;
    const linear_stretch stretch = { .T_s = T_s,
                                     .f_e = schuler_vec3_scale(1.0 / T_s, dv_e),
                                     .r_e = middle.r_e,
                                     .v_e = middle.v_e,
                                     .end_r_e = end.r_e,
                                     .end_v_e = end.v_e };
    for (int i = 0; i < 9; i++) C_b_e.m[i / 3][i % 3] /= (double)(last - first);
    linear_matrix transition, drive;
    linear_stretch_matrices(&stretch, &c->navigator, &transition, &drive);
    for (int q = 0; q < c->vector_count; q++) {
        error_vector *const v = &c->vectors[q];
        if (c->plan.sources[v->source].kind == SOURCE_BARO)
            v->u[LINEAR_A] = T_s * baro_error_m(c, v, &stretch);
        double next[LINEAR_STATES];
        for (int i = 0; i < LINEAR_STATES; i++) {
            next[i] = 0.0;
            for (int j = 0; j < LINEAR_STATES; j++)
                next[i] += transition.m[i][j] * v->x[j] + drive.m[i][j] * v->u[j];
        }
        add_unevenness(c, &stretch, v, next);
        memcpy(v->x, next, sizeof next);
        memset(v->u, 0, sizeof v->u);
        memset(v->later, 0, sizeof v->later);
    }
    for (int q = 0; q < c->noise_count; q++)
        noise_source_step(&c->noises[q], T_s, &C_b_e, &transition, &drive);
}

static void level(const schuler_mat3 *C_n_e, const double *x, double out[2])
{
    for (int i = 0; i < 2; i++)
        out[i] = C_n_e->m[0][i] * x[0] + C_n_e->m[1][i] * x[1] + C_n_e->m[2][i] * x[2];
}

static void close_row(schuler_covariance_row *row, size_t report)
{
    row->end_m = sqrt(row->P_n_m2[0] + row->P_n_m2[2] + row->mean_n_m[0] * row->mean_n_m[0] +
                      row->mean_n_m[1] * row->mean_n_m[1]);
    row->rms_curve_m[report] = row->end_m;
}

static void report(covariance_run *c, int64_t step, size_t index)
{
    schuler_covariance *const r = c->result;
    schuler_truth_state at;
    schuler_truth_at(c->truth, (double)step * schuler_truth_dt(c->truth), &at);
    r->times_s[index] = at.t_s;
    for (size_t i = 0; i < r->row_count; i++) {
        memset(r->rows[i].mean_n_m, 0, sizeof r->rows[i].mean_n_m);
        memset(r->rows[i].P_n_m2, 0, sizeof r->rows[i].P_n_m2);
    }
    for (int q = 0; q < c->vector_count; q++) {
        schuler_covariance_row *const row = &r->rows[c->vectors[q].source];
        double x[2];
        level(&at.C_n_e, &c->vectors[q].x[LINEAR_DR], x);
        if (c->vectors[q].is_mean) {
            for (int i = 0; i < 2; i++) row->mean_n_m[i] += x[i];
            continue;
        }
        row->P_n_m2[0] += x[0] * x[0];
        row->P_n_m2[1] += x[0] * x[1];
        row->P_n_m2[2] += x[1] * x[1];
    }
    for (int q = 0; q < c->noise_count; q++) {
        const noise_source *const n = &c->noises[q];
        schuler_covariance_row *const row = &r->rows[n->source];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int k = 0; k < 3; k++) /* NN, NE, EE */
                    row->P_n_m2[k] += at.C_n_e.m[i][k / 2] * n->P[LINEAR_DR + i][LINEAR_DR + j] *
                                      at.C_n_e.m[j][(k + 1) / 2];
    }
    memset(r->total.mean_n_m, 0, sizeof r->total.mean_n_m);
    memset(r->total.P_n_m2, 0, sizeof r->total.P_n_m2);
    for (size_t i = 0; i < r->row_count; i++) {
        schuler_covariance_row *const row = &r->rows[i];
        for (int k = 0; k < 2; k++) r->total.mean_n_m[k] += row->mean_n_m[k];
        for (int k = 0; k < 3; k++) r->total.P_n_m2[k] += row->P_n_m2[k];
        close_row(row, index);
    }
    close_row(&r->total, index);
}

static schuler_status propagate(covariance_run *c, const volatile int *stop)
{
    const simulation_plan *const p = &c->plan;
    const double rate_hz = p->scenario->imu.rate_hz;
    const int64_t longest = (int64_t)fmax(1.0, round(stretch_s * rate_hz));
    size_t index = 0;
    for (int64_t step = 0; step < p->steps;) {
        if (stop && *stop) return SCHULER_ERR_INTERRUPTED;
        const int64_t next_report = (step / p->report_steps + 1) * p->report_steps;
        int64_t end = next_report < p->steps ? next_report : p->steps;
        /* equal parts, so that no sliver is left before a report */
        const int64_t parts = (end - step + longest - 1) / longest;
        const int64_t last = step + (end - step) / parts;
        take_stretch(c, step, last);
        step = last;
        if (step == end) report(c, step, index++);
    }
    return SCHULER_OK;
}

schuler_status schuler_covariance_run(const schuler_scenario *scenario,
                                      const schuler_run_options *options, schuler_covariance **out,
                                      schuler_error *err)
{
    covariance_run c = { .plan = { .scenario = scenario,
                                   .isa = options->has_isa ? options->isa : schuler_isa_best() } };
    schuler_truth *own_truth = NULL;
    schuler_status status =
        options->truth ? SCHULER_OK : schuler_scenario_truth(scenario, &own_truth, err);
    if (status != SCHULER_OK) return status;
    c.truth = c.plan.truth = options->truth ? options->truth : own_truth;
    c.plan.count = schuler_sources_list(scenario, c.plan.sources);
    status = schuler_plan_times(&c.plan, err);
    schuler_truth *align_truth = NULL;
    if (status == SCHULER_OK) status = schuler_align_plan(&c.plan, &align_truth, err);
    if (status == SCHULER_OK) status = set_up(&c, err);
    if (status == SCHULER_OK) status = covariance_align(&c, err);
    if (status == SCHULER_OK) status = propagate(&c, options->stop);
    if (status == SCHULER_OK)
        *out = c.result;
    else
        schuler_covariance_free(c.result);
    sensor_bench_free(c.bench);
    free(c.vectors);
    free(c.lanes);
    free(c.noises);
    schuler_truth_free(align_truth);
    schuler_path_free(&c.plan.align_path);
    schuler_truth_free(own_truth);
    return status;
}

void schuler_covariance_free(schuler_covariance *c)
{
    if (!c) return;
    for (size_t i = 0; c->rows && i < c->row_count; i++) free(c->rows[i].rms_curve_m);
    free(c->rows);
    free(c->times_s);
    free(c->total.rms_curve_m);
    free(c);
}

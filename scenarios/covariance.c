/* SPDX-License-Identifier: MIT */
#include "scenarios/covariance.h"
#include "scenarios/covariance_parts.h"
#include "scenarios/start.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Over so long the truth counts as uniform: what turns or accelerates within it is seen by its mean. */
static const double stretch_s = 1.0;

typedef struct {
    simulation_plan plan;
    schuler_truth *truth;
    linear_navigator navigator;
    schuler_covariance *result;
    error_vector *vectors;
    sensor_lane *lanes;
    noise_source *noises;
    int vector_count, lane_count, noise_count;
    sensor_bench *bench;
    double start_h_m;
} covariance_run;

/* Mean and one sigma of a component over the runs. */
static void moments(const error_source *s, int component, uint64_t seed, double *mean,
                    double *sigma)
{
    const schuler_value *const v = s->value;
    *mean = *sigma = 0.0;
    if (v->per_unit && s->unit >= 0)
        *mean = schuler_source_draw(s, component, seed, 0);
    else if (v->draw == SCHULER_DRAW_NORMAL)
        *sigma = v->a[component];
    else if (v->draw == SCHULER_DRAW_UNIFORM) {
        *mean = 0.5 * (v->a[component] + v->b[component]);
        *sigma = (v->b[component] - v->a[component]) / sqrt(12.0);
    } else {
        *mean = v->a[component];
    }
}

static error_vector *add_vector(covariance_run *c, int source, bool is_mean)
{
    error_vector *const v = &c->vectors[c->vector_count++];
    *v = (error_vector){ .source = source, .is_mean = is_mean };
    return v;
}

/* What a value of a source is to a vector: the start it gives, or the lane that drives it. */
static void give(covariance_run *c, int source, error_vector *vector, const double *value)
{
    const error_source *const s = &c->plan.sources[source];
    if (s->kind == SOURCE_BARO) return; /* its input is put in stretch by stretch */
    if (s->kind == SOURCE_SENSOR) {
        sensor_lane *const lane = &c->lanes[c->lane_count++];
        lane->vector = (int)(vector - c->vectors);
        lane->instrument = s->instrument;
        schuler_lane_spec_start(&c->plan.scenario->imu.triad[s->instrument], 0, &lane->spec);
        for (int k = 0; k < s->components; k++) lane->spec.value[s->param][k] = value[k];
        return;
    }
    schuler_truth_state truth;
    schuler_truth_at(c->truth, 0.0, &truth);
    schuler_vec3 e[3] = { { { 0 } } }; /* dr, dv, phi */
    if (s->kind == SOURCE_POSITION) memcpy(e[0].v, value, sizeof e[0].v);
    if (s->kind == SOURCE_VELOCITY) memcpy(e[1].v, value, sizeof e[1].v);
    if (s->kind == SOURCE_TILT) memcpy(e[2].v, value, 2 * sizeof(double));
    if (s->kind == SOURCE_HEADING) e[2].v[2] = -value[0];
    const schuler_nav_state start = schuler_start_with(&truth, e[0], e[1], e[2]);
    const schuler_vec3 minus_psi =
        schuler_quat_to_rotvec(schuler_quat_mul(start.q_b_e, schuler_quat_conj(truth.q_b_e)));
    for (int i = 0; i < 3; i++) {
        vector->x[LINEAR_DR + i] = start.r_e.v[i] - truth.r_e.v[i];
        vector->x[LINEAR_DV + i] = start.v_e.v[i] - truth.v_e.v[i];
        vector->x[LINEAR_PSI + i] = -minus_psi.v[i];
    }
}

/* Vectors of a source: its mean, and a sigma of each component. Returned: why not. */
static const char *add_vectors(covariance_run *c, int source)
{
    const error_source *const s = &c->plan.sources[source];
    const uint64_t seed = c->plan.scenario->seed;
    double mean[SCHULER_COMPONENTS_MAX] = { 0 }, sigma[SCHULER_COMPONENTS_MAX] = { 0 };
    bool has_mean = false, is_drawn = false;
    for (int k = 0; k < s->components; k++) {
        moments(s, k, seed, &mean[k], &sigma[k]);
        has_mean |= mean[k] != 0.0;
        is_drawn |= sigma[k] != 0.0;
    }
    if (s->kind == SOURCE_SENSOR && is_drawn) {
        const schuler_acts acts = c->plan.scenario->imu.triad[s->instrument].params[s->param].acts;
        if (acts == SCHULER_ACTS_RESPONSE || acts == SCHULER_ACTS_COUNTS)
            return "it is not linear in its value";
    }
    if (has_mean) give(c, source, add_vector(c, source, true), mean);
    for (int k = 0; k < s->components; k++) {
        if (sigma[k] == 0.0) continue;
        double one[SCHULER_COMPONENTS_MAX] = { 0 };
        one[k] = sigma[k];
        give(c, source, add_vector(c, source, false), one);
    }
    return NULL;
}

static const char *add_source(covariance_run *c, int source)
{
    const error_source *const s = &c->plan.sources[source];
    if (c->plan.scenario->align.given) return "the start is self-aligned";
    if (s->kind == SOURCE_GRAVITY) {
        add_vector(c, source, true);
        return NULL;
    }
    if (s->kind == SOURCE_SENSOR) {
        const schuler_param *const p = &c->plan.scenario->imu.triad[s->instrument].params[s->param];
        if (p->acts == SCHULER_ACTS_PERIODIC) return "its phase is drawn";
        if (p->noisy != 0) {
            const char *const why = noise_source_of(&c->noises[c->noise_count], &c->plan, source);
            if (!why) c->noise_count++;
            return why;
        }
    }
    if (s->kind == SOURCE_BARO &&
        (s->param == SCHULER_BARO_NOISE || s->param == SCHULER_BARO_GAUSS_MARKOV)) {
        (void)noise_source_of(&c->noises[c->noise_count++], &c->plan, source);
        return NULL;
    }
    return add_vectors(c, source);
}

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
        r->steps = c->plan.steps;
        snprintf(r->total.id, sizeof r->total.id, "all");
    }
    bool complete =
        c->vectors && c->lanes && c->noises && r && r->rows && r->times_s && r->total.rms_curve_m;
    for (int i = 0; complete && i < c->plan.count; i++) {
        memcpy(r->rows[i].id, c->plan.sources[i].id, sizeof r->rows[i].id);
        r->rows[i].uncovered = add_source(c, i);
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
    moments(s, 0, c->plan.scenario->seed, &mean, &sigma);
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

/* One block of the truth: forces, mean attitude, inputs of the vectors. */
static void take_block(covariance_run *c, int64_t first, int n, schuler_vec3 *dv_e,
                       schuler_mat3 *C_sum)
{
    schuler_truth_block truth;
    schuler_truth_block_compute(c->truth, c->plan.isa, first, n, &truth);
    schuler_mat3 C_b_e[TURNS_MAX];
    for (int from = 0; from < n; from += TURNED_TOGETHER) {
        const int some = n - from < TURNED_TOGETHER ? n - from : TURNED_TOGETHER;
        const double middle_s = ((double)(first + from) + 0.5 * some) * truth.dt_s;
        schuler_mat3 *const C = &C_b_e[from / TURNED_TOGETHER];
        *C = schuler_mat3_from_quat(schuler_path_at(&c->plan.scenario->path, middle_s).q_b_e);
        schuler_vec3 dv_b = { { 0 } };
        for (int k = from; k < from + some; k++)
            for (int i = 0; i < 3; i++) dv_b.v[i] += truth.dv_ib_b[i][k];
        *dv_e = schuler_vec3_add(*dv_e, schuler_mat3_apply(C, dv_b));
        for (int i = 0; i < 9; i++) C_sum->m[i / 3][i % 3] += some * C->m[i / 3][i % 3];
    }
    sensor_bench_take(c->bench, &truth, C_b_e, c->vectors);
    if (!truth.has_dg) return;
    for (int v = 0; v < c->vector_count; v++) {
        if (c->plan.sources[c->vectors[v].source].kind != SOURCE_GRAVITY) continue;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < n; k++)
                c->vectors[v].u[LINEAR_DV + i] -= truth.dg_truth_e[i][k] * truth.dt_s;
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
        take_block(c, k, last - k < SCHULER_BLOCK ? (int)(last - k) : SCHULER_BLOCK, &dv_e, &C_b_e);
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
        memcpy(v->x, next, sizeof next);
        memset(v->u, 0, sizeof v->u);
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

static void propagate(covariance_run *c)
{
    const simulation_plan *const p = &c->plan;
    const double rate_hz = p->scenario->imu.rate_hz;
    const int64_t longest = (int64_t)fmax(1.0, round(stretch_s * rate_hz));
    size_t index = 0;
    for (int64_t step = 0; step < p->steps;) {
        const int64_t next_report = (step / p->report_steps + 1) * p->report_steps;
        int64_t end = next_report < p->steps ? next_report : p->steps;
        /* equal parts, so that no sliver is left before a report */
        const int64_t parts = (end - step + longest - 1) / longest;
        const int64_t last = step + (end - step) / parts;
        take_stretch(c, step, last);
        step = last;
        if (step == end) report(c, step, index++);
    }
}

schuler_status schuler_covariance_run(const schuler_scenario *scenario, schuler_isa isa,
                                      schuler_covariance **out, schuler_error *err)
{
    covariance_run c = { .plan = { .scenario = scenario, .isa = isa } };
    schuler_status status =
        schuler_truth_create(&c.truth, &scenario->path, 1.0 / scenario->imu.rate_hz,
                             scenario->truth_gravity, scenario->nav_gravity, err);
    if (status != SCHULER_OK) return status;
    c.plan.truth = c.truth;
    c.plan.count = schuler_sources_list(scenario, c.plan.sources);
    status = schuler_plan_times(&c.plan, err);
    if (status == SCHULER_OK) status = set_up(&c, err);
    if (status == SCHULER_OK) {
        propagate(&c);
        *out = c.result;
    } else {
        schuler_covariance_free(c.result);
    }
    sensor_bench_free(c.bench);
    free(c.vectors);
    free(c.lanes);
    free(c.noises);
    schuler_truth_free(c.truth);
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

/* Of r^2 = |mean + x|^2 the variance is 2 tr(P^2) + 4 mean' P mean; half of its root, over <r^2>. */
double schuler_covariance_sampling(const schuler_covariance_row *row, int runs)
{
    const double nn = row->P_n_m2[0], ne = row->P_n_m2[1], ee = row->P_n_m2[2];
    const double n = row->mean_n_m[0], e = row->mean_n_m[1];
    const double variance = 2.0 * (nn * nn + 2.0 * ne * ne + ee * ee) +
                            4.0 * (n * n * nn + 2.0 * n * e * ne + e * e * ee);
    const double mean2 = nn + ee + n * n + e * e;
    return mean2 > 0.0 && runs > 0 ? 0.5 * sqrt(variance / runs) / mean2 : 0.0;
}

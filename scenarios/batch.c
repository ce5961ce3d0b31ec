/* SPDX-License-Identifier: MIT */
#include "scenarios/batch.h"
#include "scenarios/lane_spec.h"
#include "scenarios/start.h"
#include <stdlib.h>
#include <string.h>

enum { LANES_MAX = 8, STATE_ALIGN = 64 };

static int by_kind(const void *a, const void *b)
{
    const batch_lane *x = a, *y = b;
    if (x->normals != y->normals) return x->normals < y->normals ? -1 : 1;
    return (x->result > y->result) - (x->result < y->result);
}

static int list_lanes(lane_batch_state *b, const lane_batch *work)
{
    const simulation_plan *p = b->plan;
    b->count = work->lanes;
    b->group_count = (b->count + b->width - 1) / b->width;
    b->lanes = calloc((size_t)b->count, sizeof(*b->lanes));
    if (!b->lanes) return 0;
    int n = 0;
    for (size_t c = 0; c < work->chunks; c++) {
        const lane_chunk *chunk = &p->chunks[work->first_chunk + c];
        int normals = 0;
        for (int i = 0; i < p->count; i++)
            if (plan_enabled(p, chunk->row, i)) normals += p->sources[i].normals;
        for (int k = 0; k < chunk->runs; k++, n++)
            b->lanes[n] = (batch_lane){ (int)c, chunk->row, chunk->first_run + k, normals, n };
    }
    qsort(b->lanes, (size_t)b->count, sizeof(*b->lanes), by_kind);
    return 1;
}

static int allocate(lane_batch_state *b)
{
    const size_t sizes[3] = { schuler_chain_state_size(b->chain[SCHULER_ACCEL]),
                              schuler_chain_state_size(b->chain[SCHULER_GYRO]),
                              schuler_mechanization_size(b->frame, b->plan->scenario->coning) };
    const size_t each = sizes[0] + sizes[1] + sizes[2];
    const size_t samples = (size_t)3 * SCHULER_BLOCK * LANES_MAX * sizeof(double);
    b->groups = calloc((size_t)b->group_count, sizeof(*b->groups));
    b->memory = aligned_alloc(STATE_ALIGN, each * (size_t)b->group_count + 2 * samples);
    if (b->needs_nodes) b->nodes = calloc(1, sizeof *b->nodes);
    if (!b->groups || !b->memory || (b->needs_nodes && !b->nodes)) return 0;
    if (b->plan->scenario->vertical == SCHULER_VERTICAL_BARO) {
        const size_t places = (size_t)b->group_count * (size_t)b->width;
        b->vertical_lanes = calloc(places, sizeof *b->vertical_lanes);
        if (!b->vertical_lanes) return 0;
    }
    for (int g = 0; g < b->group_count; g++) {
        if (b->vertical_lanes) b->groups[g].vertical = &b->vertical_lanes[g * b->width];
        char *at = b->memory + 2 * samples + each * (size_t)g;
        b->groups[g].triad[SCHULER_ACCEL] = at;
        b->groups[g].triad[SCHULER_GYRO] = at + sizes[0];
        b->groups[g].nav = at + sizes[0] + sizes[1];
    }
    b->measured[SCHULER_ACCEL] = (double *)(void *)b->memory;
    b->measured[SCHULER_GYRO] = (double *)(void *)(b->memory + samples);
    return 1;
}

/* Lane `place` of group g; a place beyond the last lane repeats it, and is never looked at. */
static const batch_lane *lane_at(const lane_batch_state *b, int g, int place)
{
    const int i = g * b->width + place;
    return &b->lanes[i < b->count ? i : b->count - 1];
}

static void fill_spec(const lane_batch_state *b, const batch_lane *l, schuler_instrument instrument,
                      schuler_lane_spec *spec)
{
    const simulation_plan *p = b->plan;
    schuler_lane_spec_start(&p->scenario->imu.triad[instrument], (uint64_t)l->run, spec);
    for (int i = 0; i < p->count; i++) {
        const error_source *s = &p->sources[i];
        if (s->kind == SOURCE_SENSOR && s->instrument == instrument && plan_enabled(p, l->row, i))
            schuler_lane_spec_draw(s, p->scenario->seed, spec);
    }
}

/* The true start with this lane's initial errors on it. */
static schuler_nav_state start_of(const simulation_plan *p, const batch_lane *l,
                                  const schuler_truth_state *truth, double *knows_dg)
{
    schuler_vec3 dr_n = { { 0 } }, dv_n = { { 0 } }, phi_n = { { 0 } };
    *knows_dg = 1.0;
    for (int i = 0; i < p->count; i++) {
        const error_source *s = &p->sources[i];
        const bool is_of_start = s->kind != SOURCE_SENSOR && s->kind != SOURCE_BARO;
        if (!plan_enabled(p, l->row, i) || !is_of_start) continue;
        double x[3] = { 0 };
        for (int c = 0; c < s->components; c++)
            x[c] = schuler_source_draw(s, c, p->scenario->seed, (uint64_t)l->run);
        switch (s->kind) {
        case SOURCE_POSITION:
            memcpy(dr_n.v, x, sizeof(x));
            break;
        case SOURCE_VELOCITY:
            memcpy(dv_n.v, x, sizeof(x));
            break;
        case SOURCE_TILT:
            phi_n.v[0] = x[0], phi_n.v[1] = x[1];
            break;
        case SOURCE_HEADING:
            phi_n.v[2] = -x[0];
            break; /* computed minus true heading = -phi_D */
        case SOURCE_GRAVITY:
            *knows_dg = 0.0;
            break;
        case SOURCE_SENSOR:
        case SOURCE_BARO:
            break;
        }
    }
    return schuler_start_with(truth, dr_n, dv_n, phi_n);
}

static void start_barometer(const lane_batch_state *b, const batch_lane *l, double height_m,
                            barometer *out)
{
    const simulation_plan *p = b->plan;
    double x[SCHULER_BARO_ERRORS] = { 0 };
    for (int i = 0; i < p->count; i++) {
        const error_source *s = &p->sources[i];
        if (s->kind == SOURCE_BARO && plan_enabled(p, l->row, i))
            x[s->param] = schuler_source_draw(s, 0, p->scenario->seed, (uint64_t)l->run);
    }
    const barometer_errors errors = { .bias_m = x[SCHULER_BARO_BIAS],
                                      .scale_factor = x[SCHULER_BARO_SCALE_FACTOR],
                                      .lag_s = x[SCHULER_BARO_LAG],
                                      .noise_m_rts = x[SCHULER_BARO_NOISE],
                                      .gauss_markov_m = x[SCHULER_BARO_GAUSS_MARKOV] };
    const barometer_setup setup = { .seed = p->scenario->seed,
                                    .run = (uint64_t)l->run,
                                    .interval_s = b->vertical.interval_s,
                                    .gauss_markov_time_s = p->scenario->gauss_markov_time_s };
    schuler_barometer_start(out, &setup, &errors, height_m);
}

/* The loop's gains are those of the place of the start: 2g/R changes by 1 % over the earth, and is a
 * hundredth of k2. */
static void set_up_vertical(lane_batch_state *b, const schuler_truth_state *truth)
{
    const schuler_scenario *s = b->plan->scenario;
    const schuler_gravity_table *gravity = schuler_truth_nav_gravity(b->plan->truth);
    const double g_mps2 = schuler_vec3_norm(schuler_gravity_at(gravity, truth->r_e));
    const int samples = schuler_vertical_interval(s->imu.rate_hz, s->samples_per_update);
    b->vertical = (vertical_setup){
        .gains = schuler_baro_gains_of(s->baro_time_s, g_mps2, truth->llh.lat_rad),
        .interval_s = samples * schuler_truth_dt(b->plan->truth),
        .width = b->width,
    };
}

static void start_sensors(const lane_batch_state *b, int g)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        schuler_lane_spec specs[LANES_MAX];
        for (int k = 0; k < b->width; k++)
            fill_spec(b, lane_at(b, g, k), (schuler_instrument)i, &specs[k]);
        schuler_chain_start(b->chain[i], b->groups[g].triad[i], specs);
    }
}

static void start_navigators(const lane_batch_state *b, int g, const schuler_truth_state *truth,
                             const schuler_truth_block *before, const schuler_quat *q_b_e)
{
    const schuler_scenario *s = b->plan->scenario;
    const double dt_s = schuler_truth_dt(b->plan->truth);
    schuler_nav_state start[LANES_MAX];
    double knows_dg[LANES_MAX];
    for (int k = 0; k < b->width; k++) {
        const batch_lane *const l = lane_at(b, g, k);
        start[k] = start_of(b->plan, l, truth, &knows_dg[k]);
        if (q_b_e) start[k].q_b_e = q_b_e[l - b->lanes];
    }
    schuler_nav_setup nav = {
        .dt_s = dt_s,
        .samples_per_update = s->samples_per_update,
        .order = s->order,
        .algorithm = s->coning,
        .gravity = schuler_truth_nav_gravity(b->plan->truth),
        .lanes = b->width,
        .start = start,
        .dg_coefficient = knows_dg,
    };
    for (int k = 0; k < SCHULER_PRIME; k++)
        for (int i = 0; i < 3; i++) {
            nav.prime_dtheta[k][i] = before->dtheta_ib_b[i][SCHULER_PRIME - 1 - k];
            nav.prime_dv[k][i] = before->dv_ib_b[i][SCHULER_PRIME - 1 - k];
        }
    b->frame->init(b->groups[g].nav, &nav);
    vertical_lane *const vertical = b->groups[g].vertical;
    for (int k = 0; vertical && k < b->width; k++)
        start_barometer(b, lane_at(b, g, k), truth->llh.h_m, &vertical[k].sensor);
    if (vertical)
        schuler_vertical_start(&b->vertical, b->frame, b->groups[g].nav, vertical, truth->llh.h_m);
}

static schuler_status make_chain(lane_batch_state *b, schuler_instrument instrument,
                                 schuler_error *err)
{
    const schuler_scenario *s = b->plan->scenario;
    chain_parts parts;
    const double dt_s = schuler_truth_dt(b->plan->truth);
    schuler_chain_setup setup =
        schuler_chain_setup_of(&s->imu, instrument, b->plan->isa, dt_s, s->seed, &parts);
    setup.start_s = -(double)b->plan->align_steps * dt_s;
    const schuler_status status = schuler_chain_create(&b->chain[instrument], &setup, err);
    if (status == SCHULER_OK) b->needs_nodes |= schuler_chain_needs_nodes(b->chain[instrument]);
    return status;
}

schuler_status schuler_batch_state_make(lane_batch_state *b, const simulation_plan *plan,
                                        size_t index, schuler_error *err)
{
    const schuler_scenario *s = plan->scenario;
    *b = (lane_batch_state){ .plan = plan, .width = schuler_isa_lanes(plan->isa) };
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_status status = make_chain(b, (schuler_instrument)i, err);
        if (status != SCHULER_OK) return status;
    }
    b->frame = schuler_mechanizations(plan->isa)[s->frame];
    if (!list_lanes(b, &plan->batches[index]) || !allocate(b))
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");

    for (int g = 0; g < b->group_count; g++) start_sensors(b, g);
    if (!plan->align_truth) schuler_batch_navigators(b, NULL);
    return SCHULER_OK;
}

void schuler_batch_navigators(lane_batch_state *b, const schuler_quat *q_b_e)
{
    const simulation_plan *const p = b->plan;
    schuler_truth_state start;
    schuler_truth_block before;
    schuler_truth_at(p->truth, 0.0, &start);
    schuler_truth_block_compute(p->truth, p->isa, -SCHULER_PRIME, SCHULER_PRIME, &before);
    if (p->scenario->vertical == SCHULER_VERTICAL_BARO) set_up_vertical(b, &start);
    for (int g = 0; g < b->group_count; g++) start_navigators(b, g, &start, &before, q_b_e);
}

schuler_vec3 schuler_batch_place(const lane_batch_state *b, int i, double *knows_dg)
{
    schuler_truth_state start;
    schuler_truth_at(b->plan->truth, 0.0, &start);
    return start_of(b->plan, &b->lanes[i], &start, knows_dg).r_e;
}

void schuler_batch_state_free(lane_batch_state *b)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) schuler_chain_free(b->chain[i]);
    free(b->nodes);
    free(b->lanes);
    free(b->groups);
    free(b->vertical_lanes);
    free(b->memory);
}

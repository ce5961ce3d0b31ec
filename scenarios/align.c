/* SPDX-License-Identifier: MIT */
#include "scenarios/align.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A record about once a second, on a block's end; the whole is a number of them. */
static void choose_steps(simulation_plan *p)
{
    const schuler_scenario *const s = p->scenario;
    const double blocks = s->imu.rate_hz / SCHULER_BLOCK;
    p->record_steps = (blocks < 1.0 ? 1 : (int)lround(blocks)) * SCHULER_BLOCK;
    const int64_t records = (int64_t)ceil(s->align.for_s * s->imu.rate_hz / p->record_steps);
    p->align_steps = (records < 8 ? 8 : records) * p->record_steps;
}

schuler_status schuler_align_plan(simulation_plan *p, schuler_truth **truth, schuler_error *err)
{
    const schuler_scenario *const s = p->scenario;
    schuler_truth_state start;
    *truth = NULL;
    if (!s->align.given) return SCHULER_OK;
    choose_steps(p);
    const double dt_s = schuler_truth_dt(p->truth);
    schuler_truth_at(p->truth, 0.0, &start);
    schuler_status status = schuler_path_mooring(&p->align_path, start.r_e, start.q_b_e,
                                                 (double)p->align_steps * dt_s, &s->align.sway);
    if (status != SCHULER_OK)
        return schuler_fail(err, status, NULL, "the motion of the alignment cannot be computed");
    status =
        schuler_truth_create(truth, &p->align_path, dt_s, s->truth_gravity, s->nav_gravity, err);
    p->align_truth = *truth;
    return status;
}

/* The figures of the IMU's own noise, as far as it has them; else those of good sensors. */
static double noise_of(const schuler_imu *imu, schuler_instrument instrument, const char *key,
                       double least)
{
    const schuler_triad *const t = &imu->triad[instrument];
    for (int k = 0; t->params[k].key; k++)
        if (strcmp(t->params[k].key, key) == 0 && t->values[k].given)
            return fmax(schuler_value_rms(&t->values[k], 0), least);
    return least;
}

schuler_alignment_setup schuler_align_setup(const simulation_plan *p)
{
    /* 0.0003 deg/sqrt(h) and 1 ug/sqrt(Hz): below, rounding and sway count more. */
    const schuler_imu *const imu = &p->scenario->imu;
    return (schuler_alignment_setup){
        .interval_s = p->record_steps * schuler_truth_dt(p->truth),
        .intervals = (size_t)(p->align_steps / p->record_steps),
        .gyro_noise = noise_of(imu, SCHULER_GYRO, "angle_random_walk", 8.7e-8),
        .accel_noise = noise_of(imu, SCHULER_ACCEL, "velocity_random_walk", 1e-5),
        .fine = p->scenario->align.fine,
    };
}

typedef struct {
    const schuler_aligner *lanes;
    char *states;
    size_t state_size;
    schuler_vec3 *v_b0; /* [lane][record] */
    size_t records;     /* one more than intervals */
} alignment_run;

static void keep(const lane_batch_state *b, const alignment_run *a, size_t record)
{
    schuler_quat q_b_b0;
    for (int i = 0; i < b->count; i++)
        a->lanes->get(a->states + (size_t)(i / b->width) * a->state_size, i % b->width, &q_b_b0,
                      &a->v_b0[(size_t)i * a->records + record]);
}

static schuler_status observe(const lane_batch_state *b, alignment_run *a, batch_tick tick,
                              void *user, schuler_error *err)
{
    const simulation_plan *const p = b->plan;
    keep(b, a, 0);
    for (int64_t first = 0; first < p->align_steps; first += SCHULER_BLOCK) {
        schuler_truth_block truth;
        schuler_truth_block_compute(p->align_truth, p->isa, first, SCHULER_BLOCK, &truth);
        if (b->needs_nodes)
            schuler_truth_nodes_compute(p->align_truth, p->isa, first, SCHULER_BLOCK, b->nodes);
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            schuler_chain_observe(b->chain[i], &truth, b->nodes);
        for (int g = 0; g < b->group_count; g++) {
            for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
                schuler_chain_apply(b->chain[i], b->groups[g].triad[i], b->measured[i]);
            const schuler_nav_block block = { .n = SCHULER_BLOCK,
                                              .stride = SCHULER_BLOCK,
                                              .dtheta = b->measured[SCHULER_GYRO],
                                              .dv = b->measured[SCHULER_ACCEL] };
            a->lanes->advance(a->states + (size_t)g * a->state_size, &block);
        }
        if ((first + SCHULER_BLOCK) % p->record_steps == 0)
            keep(b, a, (size_t)((first + SCHULER_BLOCK) / p->record_steps));
        if (tick(user, (int64_t)SCHULER_BLOCK * b->count))
            return schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
    }
    return SCHULER_OK;
}

/* Gravity as a lane knows it, where it believes to be. */
static schuler_vec3 gravity_of(const lane_batch_state *b, int i, const schuler_truth_block *start)
{
    double knows_dg;
    const schuler_vec3 r_e = schuler_batch_place(b, i, &knows_dg);
    schuler_vec3 g_e = schuler_gravity_at(schuler_truth_nav_gravity(b->plan->truth), r_e);
    for (int k = 0; k < 3 && start->has_dg; k++)
        g_e.v[k] += start->dg_nav_e[k][0] + knows_dg * start->dg_truth_e[k][0];
    return g_e;
}

static schuler_status solve(lane_batch_state *b, const alignment_run *a, schuler_error *err)
{
    const schuler_alignment_setup setup = schuler_align_setup(b->plan);
    schuler_truth_block start;
    schuler_truth_block_compute(b->plan->truth, b->plan->isa, 0, 1, &start);
    schuler_quat *const q_b_e = calloc((size_t)b->count, sizeof *q_b_e);
    schuler_alignment *alignment = NULL;
    schuler_status status =
        q_b_e ? schuler_alignment_create(&alignment, &setup, gravity_of(b, 0, &start))
              : SCHULER_ERR_MEMORY;
    for (int i = 0; i < b->count && status == SCHULER_OK; i++) {
        schuler_quat q_b_b0;
        schuler_vec3 v_b0;
        a->lanes->get(a->states + (size_t)(i / b->width) * a->state_size, i % b->width, &q_b_b0,
                      &v_b0);
        q_b_e[i] = schuler_alignment_solve(alignment, gravity_of(b, i, &start),
                                           &a->v_b0[(size_t)i * a->records], q_b_b0);
        if (!isfinite(q_b_e[i].w + q_b_e[i].x + q_b_e[i].y + q_b_e[i].z))
            status = SCHULER_ERR_NUMERIC;
    }
    if (status == SCHULER_OK) schuler_batch_navigators(b, q_b_e);
    schuler_alignment_free(alignment);
    free(q_b_e);
    if (status == SCHULER_OK) return status;
    return schuler_fail(err, status, NULL, "%s",
                        status == SCHULER_ERR_MEMORY ? "out of memory"
                                                     : "the self-alignment finds no attitude");
}

schuler_status schuler_batch_align(lane_batch_state *b, batch_tick tick, void *user,
                                   schuler_error *err)
{
    enum { ALIGN = 64 };
    const simulation_plan *const p = b->plan;
    alignment_run a = { .lanes = schuler_aligner_for(p->isa),
                        .records = (size_t)(p->align_steps / p->record_steps) + 1 };
    a.state_size = (a.lanes->state_size + ALIGN - 1) / ALIGN * ALIGN;
    a.states = aligned_alloc(ALIGN, (size_t)b->group_count * a.state_size);
    a.v_b0 = malloc((size_t)b->count * a.records * sizeof *a.v_b0);
    schuler_status status = SCHULER_OK;
    if (!a.states || !a.v_b0) status = schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    for (int g = 0; g < b->group_count && status == SCHULER_OK; g++)
        a.lanes->init(a.states + (size_t)g * a.state_size);
    if (status == SCHULER_OK) status = observe(b, &a, tick, user, err);
    if (status == SCHULER_OK) status = solve(b, &a, err);
    free(a.states);
    free(a.v_b0);
    return status;
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/covariance_parts.h"
#include <stdlib.h>
#include <string.h>

enum {
    LANES_MAX = 8,
    STATE_ALIGN = 64,
};

static schuler_status make_triad(sensor_bench *b, schuler_instrument instrument,
                                 const sensor_lane *lanes, int count, schuler_error *err)
{
    const simulation_plan *const p = b->plan;
    triad_bench *const t = &b->triad[instrument];
    for (int i = 0; i < count; i++) t->count += lanes[i].instrument == instrument;
    if (t->count == 0) return SCHULER_OK;
    chain_parts parts;
    schuler_chain_setup setup =
        schuler_chain_setup_of(&p->scenario->imu, instrument, p->isa, schuler_truth_dt(p->truth),
                               p->scenario->seed, &parts);
    setup.start_s = -(double)p->align_steps * schuler_truth_dt(p->truth);
    const schuler_status status = schuler_chain_create(&t->chain, &setup, err);
    if (status != SCHULER_OK) return status;
    const int groups = (t->count + b->width - 1) / b->width;
    t->state_size = schuler_chain_state_size(t->chain);
    t->vector = calloc((size_t)groups * (size_t)b->width, sizeof *t->vector);
    t->states = aligned_alloc(STATE_ALIGN, t->state_size * (size_t)groups);
    if (!b->nodes && schuler_chain_needs_nodes(t->chain)) b->nodes = calloc(1, sizeof *b->nodes);
    if (!t->vector || !t->states || (schuler_chain_needs_nodes(t->chain) && !b->nodes))
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    int at = 0, last = 0;
    schuler_lane_spec specs[LANES_MAX];
    for (int g = 0; g < groups; g++) {
        for (int k = 0; k < b->width; k++) {
            while (at < count && lanes[at].instrument != instrument) at++;
            if (at < count)
                last = at++; /* places beyond the last lane repeat it, and are not looked at */
            specs[k] = lanes[last].spec;
            t->vector[g * b->width + k] = lanes[last].vector;
        }
        schuler_chain_start(t->chain, t->states + t->state_size * (size_t)g, specs);
    }
    return SCHULER_OK;
}

schuler_status sensor_bench_create(sensor_bench **out, const simulation_plan *plan,
                                   const sensor_lane *lanes, int count, schuler_error *err)
{
    sensor_bench *const b = calloc(1, sizeof *b);
    schuler_status status = SCHULER_ERR_MEMORY;
    if (b) {
        b->plan = plan;
        b->width = schuler_isa_lanes(plan->isa);
        b->measured = aligned_alloc(STATE_ALIGN, 3 * SCHULER_BLOCK * LANES_MAX * sizeof(double));
        status = b->measured ? SCHULER_OK : SCHULER_ERR_MEMORY;
        if (!b->measured) schuler_fail(err, status, NULL, "out of memory");
        for (int i = 0; i < SCHULER_INSTRUMENTS && status == SCHULER_OK; i++)
            status = make_triad(b, (schuler_instrument)i, lanes, count, err);
    }
    if (status != SCHULER_OK) {
        sensor_bench_free(b);
        return status;
    }
    *out = b;
    return SCHULER_OK;
}

void sensor_bench_free(sensor_bench *b)
{
    if (!b) return;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        schuler_chain_free(b->triad[i].chain);
        free(b->triad[i].vector);
        free(b->triad[i].states);
    }
    free(b->nodes);
    free(b->measured);
    free(b);
}

/* Sum of the errors of some steps, turned into ECEF. */
static void add_errors(const sensor_bench *b, schuler_instrument instrument, int group,
                       const double *own, const turned_samples *part, error_vector *vectors)
{
    const triad_bench *const t = &b->triad[instrument];
    const int input = instrument == SCHULER_ACCEL ? LINEAR_DV : LINEAR_PSI;
    const double sign = instrument == SCHULER_ACCEL ? 1.0 : -1.0;
    for (int k = 0; k < b->width && group * b->width + k < t->count; k++) {
        schuler_vec3 sum = { { 0 } };
        for (int axis = 0; axis < 3; axis++)
            for (int i = part->from; i < part->from + part->n; i++)
                sum.v[axis] += b->measured[(axis * SCHULER_BLOCK + i) * b->width + k] -
                               own[axis * SCHULER_BLOCK + i];
        const schuler_vec3 sum_e = schuler_mat3_apply(&part->C_b_e, sum);
        error_vector *const v = &vectors[t->vector[group * b->width + k]];
        for (int axis = 0; axis < 3; axis++) {
            v->u[input + axis] += sign * sum_e.v[axis];
            v->later[input + axis] += sign * part->left_s * sum_e.v[axis];
        }
    }
}

void sensor_bench_take(sensor_bench *b, const schuler_truth_block *truth,
                       const turned_samples *parts, int count, error_vector *vectors)
{
    const simulation_plan *const p = b->plan;
    if (b->nodes) schuler_truth_nodes_compute(p->truth, p->isa, truth->first, truth->n, b->nodes);
    schuler_truth_block sensed = *truth;
    sensed.first += p->align_steps; /* the sensors have been on since then */
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const triad_bench *const t = &b->triad[i];
        if (t->count == 0) continue;
        const double *const own =
            i == SCHULER_ACCEL ? &truth->dv_ib_b[0][0] : &truth->dtheta_ib_b[0][0];
        schuler_chain_observe(t->chain, &sensed, b->nodes);
        for (int g = 0; g * b->width < t->count; g++) {
            schuler_chain_apply(t->chain, t->states + t->state_size * (size_t)g, b->measured);
            for (int k = 0; k < count; k++)
                add_errors(b, (schuler_instrument)i, g, own, &parts[k], vectors);
        }
    }
}

/* SPDX-License-Identifier: MIT */
/* What a self-alignment makes of the sensors' errors: the same aligner as in the simulation, one lane for each
 * error that is a vector. For random ones it answers to impulses at all times, put into the records of a
 * perfect lane. */
#include "scenarios/align.h"
#include "scenarios/covariance_parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LANES_MAX = 8, STATE_ALIGN = 64, SAMPLES = 3 * SCHULER_BLOCK * LANES_MAX };

typedef struct {
    covariance_run *c;
    const schuler_aligner *code;
    int width, groups, first_group[SCHULER_INSTRUMENTS + 1]; /* accel, gyro, perfect */
    size_t state_size, records;
    char *states;
    schuler_vec3 *v_b0;                 /* [lane][record] */
    schuler_quat *q_b_b0;               /* [record] of the perfect lane */
    double *still[SCHULER_INSTRUMENTS]; /* true increments in all lanes */
    double *memory;
} aligning;

static int groups_of(int lanes, int width)
{
    return (lanes + width - 1) / width;
}

static void *state(const aligning *a, int group)
{
    return a->states + (size_t)group * a->state_size;
}

static bool allocate(aligning *a)
{
    const sensor_bench *const b = a->c->bench;
    const simulation_plan *const p = &a->c->plan;
    a->code = schuler_aligner_for(p->isa);
    a->width = schuler_isa_lanes(p->isa);
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        a->first_group[i] = a->groups;
        a->groups += groups_of(b->triad[i].count, a->width);
    }
    a->first_group[SCHULER_INSTRUMENTS] = a->groups;
    a->groups++;
    a->records = (size_t)(p->align_steps / p->record_steps) + 1;
    a->state_size = (a->code->state_size + STATE_ALIGN - 1) / STATE_ALIGN * STATE_ALIGN;
    a->states = aligned_alloc(STATE_ALIGN, (size_t)a->groups * a->state_size);
    a->v_b0 = calloc((size_t)(a->groups * a->width) * a->records, sizeof *a->v_b0);
    a->q_b_b0 = calloc(a->records, sizeof *a->q_b_b0);
    a->memory = aligned_alloc(STATE_ALIGN, 2 * SAMPLES * sizeof(double));
    if (!a->states || !a->v_b0 || !a->q_b_b0 || !a->memory) return false;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) a->still[i] = a->memory + i * SAMPLES;
    for (int g = 0; g < a->groups; g++) a->code->init(state(a, g));
    return true;
}

static void spread(const aligning *a, const schuler_truth_block *truth)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < SCHULER_BLOCK; k++) {
                const double own =
                    i == SCHULER_ACCEL ? truth->dv_ib_b[axis][k] : truth->dtheta_ib_b[axis][k];
                for (int l = 0; l < a->width; l++)
                    a->still[i][(axis * SCHULER_BLOCK + k) * a->width + l] = own;
            }
}

static void advance(const aligning *a, int group, const double *dtheta, const double *dv)
{
    const schuler_nav_block block = {
        .n = SCHULER_BLOCK, .stride = SCHULER_BLOCK, .dtheta = dtheta, .dv = dv
    };
    a->code->advance(state(a, group), &block);
}

static void keep(const aligning *a, size_t record)
{
    schuler_quat unused;
    const int perfect = a->first_group[SCHULER_INSTRUMENTS] * a->width;
    for (int lane = 0; lane < a->groups * a->width; lane++)
        a->code->get(state(a, lane / a->width), lane % a->width,
                     lane == perfect ? &a->q_b_b0[record] : &unused,
                     &a->v_b0[(size_t)lane * a->records + record]);
}

static void observe(const aligning *a)
{
    const simulation_plan *const p = &a->c->plan;
    sensor_bench *const b = a->c->bench;
    keep(a, 0);
    for (int64_t first = 0; first < p->align_steps; first += SCHULER_BLOCK) {
        schuler_truth_block truth;
        schuler_truth_block_compute(p->align_truth, p->isa, first, SCHULER_BLOCK, &truth);
        if (b->nodes)
            schuler_truth_nodes_compute(p->align_truth, p->isa, first, SCHULER_BLOCK, b->nodes);
        spread(a, &truth);
        advance(a, a->first_group[SCHULER_INSTRUMENTS], a->still[SCHULER_GYRO],
                a->still[SCHULER_ACCEL]);
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            const triad_bench *const t = &b->triad[i];
            if (t->count == 0) continue;
            schuler_chain_observe(t->chain, &truth, b->nodes);
            for (int g = 0; g < groups_of(t->count, a->width); g++) {
                schuler_chain_apply(t->chain, t->states + t->state_size * (size_t)g, b->measured);
                advance(a, a->first_group[i] + g,
                        i == SCHULER_GYRO ? b->measured : a->still[SCHULER_GYRO],
                        i == SCHULER_ACCEL ? b->measured : a->still[SCHULER_ACCEL]);
            }
        }
        if ((first + SCHULER_BLOCK) % p->record_steps == 0)
            keep(a, (size_t)((first + SCHULER_BLOCK) / p->record_steps));
    }
}

/* psi of what records say with a gravity, against a perfect attitude. */
static schuler_vec3 psi_of_records(const schuler_alignment *alignment, schuler_vec3 g_e,
                                   const schuler_vec3 *v_b0, schuler_quat q_b_b0,
                                   schuler_quat perfect)
{
    const schuler_quat q_b_e = schuler_alignment_solve(alignment, g_e, v_b0, q_b_b0);
    return schuler_vec3_scale(
        -1.0, schuler_quat_to_rotvec(schuler_quat_mul(q_b_e, schuler_quat_conj(perfect))));
}

static schuler_vec3 psi_of(const aligning *a, const schuler_alignment *alignment, int lane,
                           schuler_vec3 g_e, schuler_quat perfect)
{
    schuler_quat q_b_b0;
    schuler_vec3 v_b0;
    a->code->get(state(a, lane / a->width), lane % a->width, &q_b_b0, &v_b0);
    return psi_of_records(alignment, g_e, &a->v_b0[(size_t)lane * a->records], q_b_b0, perfect);
}

/* psi of an error of a unit integral of one axis between two records: the velocity of an accelerometer, the
 * angle of a gyro, which turns all that is measured after it. */
static schuler_vec3 answer(const aligning *a, const schuler_alignment *alignment, schuler_vec3 g_e,
                           schuler_quat perfect, int input, int axis, size_t from, size_t to,
                           schuler_vec3 *v_b0)
{
    const double size = input == LINEAR_DV ? 1e-3 : 1e-6; /* m/s, rad: linear, and above rounding */
    const size_t last = a->records - 1;
    const schuler_vec3 *const v =
        &a->v_b0[(size_t)(a->first_group[SCHULER_INSTRUMENTS] * a->width) * a->records];
    const schuler_mat3 C = schuler_mat3_from_quat(a->q_b_b0[(from + to) / 2]);
    const schuler_vec3 error = { { C.m[0][axis] * size, C.m[1][axis] * size,
                                   C.m[2][axis] * size } };
    schuler_vec3 off = { { 0.0, 0.0, 0.0 } };
    for (size_t k = 0; k <= last; k++) {
        const double come = k <= from ? 0.0
                            : k >= to ? 1.0
                                      : (double)(k - from) / (double)(to - from);
        if (input == LINEAR_DV) {
            off = schuler_vec3_scale(come, error);
        } else if (k > 0) {
            const double before = k - 1 <= from ? 0.0
                                  : k - 1 >= to ? 1.0
                                                : (double)(k - 1 - from) / (double)(to - from);
            off = schuler_vec3_add(
                off, schuler_vec3_cross(schuler_vec3_scale(0.5 * (before + come), error),
                                        schuler_vec3_sub(v[k], v[k - 1])));
        }
        v_b0[k] = schuler_vec3_add(v[k], off);
    }
    schuler_quat q_b_b0 = a->q_b_b0[last];
    if (input == LINEAR_PSI) q_b_b0 = schuler_quat_mul(schuler_quat_from_rotvec(error), q_b_b0);
    return schuler_vec3_scale(1.0 / size, psi_of_records(alignment, g_e, v_b0, q_b_b0, perfect));
}

/* The processes go through the alignment, from one group of records to the next: single ones at both ends,
 * where the gains change within seconds, longer groups between. */
static bool start_noises(const aligning *a, const schuler_alignment *alignment, schuler_vec3 g_e,
                         schuler_quat perfect)
{
    const covariance_run *const c = a->c;
    const size_t last = a->records - 1;
    const double record_s = c->plan.record_steps * schuler_truth_dt(c->truth);
    schuler_vec3 *const v_b0 = malloc(a->records * sizeof *v_b0);
    if (!v_b0) return false;
    for (size_t from = 0, to; from < last; from = to) {
        const size_t left = last - from, near = left < from ? left : from;
        const size_t group = near / 32 > 1 ? near / 32 : 1;
        to = from + group;
        for (int input = LINEAR_DV; input <= LINEAR_PSI; input += LINEAR_PSI - LINEAR_DV) {
            double G[3][LINEAR_STATES] = { { 0 } };
            for (int axis = 0; axis < 3; axis++) {
                const schuler_vec3 psi =
                    answer(a, alignment, g_e, perfect, input, axis, from, to, v_b0);
                memcpy(&G[axis][LINEAR_PSI], psi.v, sizeof psi.v);
            }
            for (int q = 0; q < c->noise_count; q++)
                if (c->noises[q].input == input)
                    noise_source_inject(&c->noises[q], (double)group * record_s, G);
        }
    }
    free(v_b0);
    return true;
}

static schuler_status solve(const aligning *a, schuler_error *err)
{
    covariance_run *const c = a->c;
    const sensor_bench *const b = c->bench;
    schuler_truth_state start;
    schuler_truth_block block;
    schuler_truth_at(c->truth, 0.0, &start);
    schuler_truth_block_compute(c->truth, c->plan.isa, 0, 1, &block);
    schuler_vec3 nav_dg_e = { { 0 } }, real_dg_e = { { 0 } };
    for (int i = 0; i < 3 && block.has_dg; i++) {
        nav_dg_e.v[i] = block.dg_nav_e[i][0];
        real_dg_e.v[i] = block.dg_truth_e[i][0];
    }
    const schuler_vec3 table_e = schuler_gravity_at(c->navigator.gravity, start.r_e);
    const schuler_vec3 known_e = schuler_vec3_add(table_e, nav_dg_e);
    const schuler_vec3 g_e = schuler_vec3_add(known_e, real_dg_e);
    const schuler_alignment_setup setup = schuler_align_setup(&c->plan);
    schuler_alignment *alignment = NULL;
    const schuler_status status = schuler_alignment_create(&alignment, &setup, g_e);
    if (status != SCHULER_OK)
        return schuler_fail(err, status, NULL, "the self-alignment finds no attitude");
    const int perfect_lane = a->first_group[SCHULER_INSTRUMENTS] * a->width;
    const schuler_quat none = { 1.0, 0.0, 0.0, 0.0 };
    const schuler_quat perfect = schuler_quat_from_rotvec(
        schuler_vec3_scale(-1.0, psi_of(a, alignment, perfect_lane, g_e, none)));

    for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
        for (int k = 0; k < b->triad[i].count; k++) {
            const schuler_vec3 psi =
                psi_of(a, alignment, a->first_group[i] * a->width + k, g_e, perfect);
            memcpy(&c->vectors[b->triad[i].vector[k]].x[LINEAR_PSI], psi.v, sizeof psi.v);
        }
    for (int q = 0; q < c->vector_count; q++) {
        error_vector *const v = &c->vectors[q];
        const source_kind kind = c->plan.sources[v->source].kind;
        schuler_vec3 believed_e = g_e;
        if (kind == SOURCE_GRAVITY) {
            believed_e = known_e;
        } else if (kind == SOURCE_POSITION) {
            const schuler_vec3 r_e = { { start.r_e.v[0] + v->x[0], start.r_e.v[1] + v->x[1],
                                         start.r_e.v[2] + v->x[2] } };
            believed_e = schuler_vec3_add(
                g_e, schuler_vec3_sub(schuler_gravity_at(c->navigator.gravity, r_e), table_e));
        } else {
            continue;
        }
        const schuler_vec3 psi = psi_of(a, alignment, perfect_lane, believed_e, perfect);
        memcpy(&v->x[LINEAR_PSI], psi.v, sizeof psi.v);
    }
    const bool complete = c->noise_count == 0 || start_noises(a, alignment, g_e, perfect);
    schuler_alignment_free(alignment);
    return complete ? SCHULER_OK : schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
}

schuler_status covariance_align(covariance_run *c, schuler_error *err)
{
    if (!c->plan.align_truth) return SCHULER_OK;
    aligning a = { .c = c };
    schuler_status status = SCHULER_OK;
    if (allocate(&a)) {
        observe(&a);
        status = solve(&a, err);
    } else {
        status = schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    }
    free(a.states);
    free(a.v_b0);
    free(a.q_b_b0);
    free(a.memory);
    return status;
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/worker.h"
#include "scenarios/align.h"
#include <math.h>
#include <stdlib.h>

/* An instant within the current block where something happens: after `cut` of its samples. */
typedef struct {
    int cut;
    bool is_report, is_hold; /* held, or steadied by the barometer */
    uint64_t update;         /* of the barometer, from 1 on        */
    size_t index;            /* of the report; 0 is the start */
    schuler_truth_state truth;
} block_event;

/* Samples from .. from+n of the block that was measured last. */
static void navigate(const lane_batch_state *b, const lane_group *group,
                     const schuler_truth_block *truth, int from, int n)
{
    const schuler_nav_block block = {
        .n = n,
        .stride = SCHULER_BLOCK,
        .dtheta = b->measured[SCHULER_GYRO] + from * b->width,
        .dv = b->measured[SCHULER_ACCEL] + from * b->width,
        .dg_nav_e = truth->has_dg ? &truth->dg_nav_e[0][from] : NULL,
        .dg_truth_e = truth->has_dg ? &truth->dg_truth_e[0][from] : NULL,
    };
    b->frame->advance(group->nav, &block);
}

static void steady(const lane_batch_state *b, const lane_group *group, const block_event *e)
{
    if (group->vertical)
        schuler_vertical_update(&b->vertical, b->frame, group->nav, group->vertical, e->update,
                                e->truth.llh.h_m);
    else
        b->frame->hold_vertical(group->nav, e->truth.llh.h_m, -e->truth.v_n.v[2]);
}

/* Errors of one group's lanes. Groups come in order and lanes of a chunk are in run order, so the
 * sums over runs are taken in run order, whatever the width of a vector. */
static schuler_status compare_group(const lane_batch_state *b, int g, const block_event *at,
                                    batch_result *out, schuler_error *err)
{
    const size_t reports = b->plan->reports;
    for (int place = 0; place < b->width; place++) {
        const int i = g * b->width + place;
        if (i >= b->count) break;
        const batch_lane *l = &b->lanes[i];
        char id[64];
        schuler_plan_row_id(b->plan, l->row, id);
        schuler_nav_state nav;
        b->frame->get(b->groups[g].nav, place, &nav);
        schuler_error_row row = schuler_compare(&nav, &at->truth);
        if (out->rows) schuler_compare_attitude(&nav, &at->truth, &row);
        double sum = nav.q_b_e.w + nav.q_b_e.x + nav.q_b_e.y + nav.q_b_e.z;
        for (int k = 0; k < 3; k++) sum += row.r_n[k] + row.v_n[k];
        if (!isfinite(sum))
            return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                                "the navigator of '%s', run %d, was no longer finite at %.10g s",
                                id, l->run, at->truth.t_s);
        if (schuler_mechanization_ends(b->frame, nav.r_e))
            return schuler_fail(
                err, SCHULER_ERR_NUMERIC, NULL,
                "the navigator of '%s', run %d, came to a latitude of %.3f deg at %.10g s; frame "
                "'%s' ends at %g deg: use wander or ecef",
                id, l->run, schuler_llh_from_ecef(nav.r_e).lat_rad / SCHULER_RAD_PER_DEG,
                at->truth.t_s, b->frame->name, b->frame->latitude_max_rad / SCHULER_RAD_PER_DEG);
        /* Held to the truth the height needs no look; free, it runs away. */
        const double h_m = b->plan->scenario->vertical != SCHULER_VERTICAL_TRUTH
                               ? schuler_llh_from_ecef(nav.r_e).h_m
                               : 0.0;
        if (h_m < COMPARATOR_HEIGHT_MIN_M || h_m > COMPARATOR_HEIGHT_MAX_M)
            return schuler_fail(
                err, SCHULER_ERR_NUMERIC, NULL,
                "the navigator of '%s', run %d, was at a height of %.4g km at %.10g s, where "
                "gravity is not known",
                id, l->run, 1e-3 * h_m, at->truth.t_s);
        if (at->index == 0)
            schuler_metrics_start(&out->metrics[l->result], &row);
        else
            out->curve_m2[(size_t)l->chunk * reports + at->index - 1] +=
                schuler_metrics_take(&out->metrics[l->result], &row);
        if (out->rows) out->rows[(size_t)l->result * (reports + 1) + at->index] = row;
    }
    return SCHULER_OK;
}

/* The events within samples first+1 .. first+n; out has room for SCHULER_BLOCK of them. */
static int events_in(const simulation_plan *p, int64_t first, int n, block_event *out)
{
    const schuler_scenario *s = p->scenario;
    const bool holding = s->vertical == SCHULER_VERTICAL_TRUTH,
               has_baro = s->vertical == SCHULER_VERTICAL_BARO;
    const int interval = has_baro ? schuler_vertical_interval(s->imu.rate_hz, s->samples_per_update)
                                  : schuler_hold_interval(p);
    int count = 0;
    for (int cut = 1; cut <= n; cut++) {
        const int64_t step = first + cut;
        block_event *e = &out[count];
        e->is_report = step % p->report_steps == 0 || step == p->steps;
        e->is_hold = holding && (e->is_report || cut % interval == 0 || cut == n);
        if (has_baro) e->is_hold = cut % interval == 0;
        e->update = (uint64_t)(step / interval);
        if (!e->is_report && !e->is_hold) continue;
        e->cut = cut;
        e->index = step == p->steps ? p->reports : (size_t)(step / p->report_steps);
        schuler_truth_at(p->truth, (double)step * schuler_truth_dt(p->truth), &e->truth);
        count++;
    }
    return count;
}

static schuler_status fly(const lane_batch_state *b, batch_tick tick, void *user, batch_result *out,
                          schuler_error *err)
{
    const simulation_plan *p = b->plan;
    block_event events[SCHULER_BLOCK];
    events[0].index = 0;
    schuler_truth_at(p->truth, 0.0, &events[0].truth);
    schuler_status status = SCHULER_OK;
    for (int g = 0; g < b->group_count && status == SCHULER_OK; g++)
        status = compare_group(b, g, &events[0], out, err);

    for (int64_t first = 0; first < p->steps && status == SCHULER_OK; first += SCHULER_BLOCK) {
        const int64_t left = p->steps - first;
        const int n = left < SCHULER_BLOCK ? (int)left : SCHULER_BLOCK;
        const int count = events_in(p, first, n, events);
        schuler_truth_block truth;
        schuler_truth_block_compute(p->truth, p->isa, first, n, &truth);
        if (b->needs_nodes) schuler_truth_nodes_compute(p->truth, p->isa, first, n, b->nodes);
        truth.first += p->align_steps; /* the sensors have been on since then */
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            schuler_chain_observe(b->chain[i], &truth, b->nodes);

        for (int g = 0; g < b->group_count && status == SCHULER_OK; g++) {
            const lane_group *group = &b->groups[g];
            for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
                schuler_chain_apply(b->chain[i], group->triad[i], b->measured[i]);
            int from = 0;
            for (int i = 0; i < count && status == SCHULER_OK; i++) {
                const block_event *e = &events[i];
                navigate(b, group, &truth, from, e->cut - from);
                from = e->cut;
                if (e->is_hold) steady(b, group, e);
                if (e->is_report) status = compare_group(b, g, e, out, err);
            }
            if (from < n) navigate(b, group, &truth, from, n - from);
        }
        if (status == SCHULER_OK && tick(user, (int64_t)n * b->count))
            status = schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
    }
    return status;
}

static void count_clipped(const lane_batch_state *b, batch_result *out)
{
    for (int k = 0; k < b->count; k++)
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            out->metrics[b->lanes[k].result].clipped[i] =
                schuler_chain_events(b->chain[i], b->groups[k / b->width].triad[i], k % b->width);
}

schuler_status schuler_batch_run(const simulation_plan *plan, size_t index, bool rows_wanted,
                                 batch_tick tick, void *user, batch_result *out, schuler_error *err)
{
    const lane_batch *work = &plan->batches[index];
    const size_t lanes = (size_t)work->lanes;
    lane_batch_state b;
    schuler_status status = schuler_batch_state_make(&b, plan, index, err);
    *out = (batch_result){
        .metrics = calloc(lanes, sizeof(lane_metrics)),
        .curve_m2 = calloc(work->chunks * plan->reports, sizeof(double)),
    };
    if (rows_wanted) out->rows = calloc(lanes * (plan->reports + 1), sizeof(*out->rows));
    if (status == SCHULER_OK && (!out->metrics || !out->curve_m2 || (rows_wanted && !out->rows)))
        status = schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    if (status == SCHULER_OK && plan->align_truth)
        status = schuler_batch_align(&b, tick, user, err);
    if (status == SCHULER_OK) status = fly(&b, tick, user, out, err);
    if (status == SCHULER_OK) count_clipped(&b, out);
    if (status != SCHULER_OK) {
        schuler_batch_free(out);
        *out = (batch_result){ 0 };
    }
    schuler_batch_state_free(&b);
    return status;
}

void schuler_batch_free(batch_result *result)
{
    free(result->metrics);
    free(result->curve_m2);
    free(result->rows);
}

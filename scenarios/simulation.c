/* SPDX-License-Identifier: MIT */
/* Threads over batches, and the gathering of what they yield. */
#include "scenarios/simulation.h"
#include "scenarios/align.h"
#include "scenarios/budget.h"
#include "scenarios/worker.h"
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

typedef struct {
    const simulation_plan *plan;
    const schuler_run_options *options;
    schuler_result *result;
    double *chunk_curves_m2;  /* [chunk][report]: each written by one batch */
    atomic_size_t next;       /* batch to take next                          */
    atomic_int_fast64_t done; /* lane-steps                                  */
    atomic_int stopped;       /* something failed: all stop                  */
    double total;             /* lane-steps in all                           */

    pthread_mutex_t lock; /* of what follows */
    pthread_cond_t turn_changed;
    size_t turn;         /* batch whose rows are to be handed out next  */
    size_t failed_batch; /* the failure reported is that of the first batch that failed */
    schuler_status status;
    schuler_error error;
    struct timespec last_progress;
} gathering;

static void fail(gathering *g, size_t batch, schuler_status status, const schuler_error *error)
{
    pthread_mutex_lock(&g->lock);
    /* A batch that only heard of it ends as interrupted: that never hides the reason. */
    const int better = g->status == SCHULER_ERR_INTERRUPTED || batch < g->failed_batch;
    if (g->status == SCHULER_OK || (status != SCHULER_ERR_INTERRUPTED && better)) {
        g->status = status;
        g->error = *error;
        g->failed_batch = batch;
    }
    atomic_store(&g->stopped, 1);
    pthread_cond_broadcast(&g->turn_changed);
    pthread_mutex_unlock(&g->lock);
}

static int tick(void *user, int64_t lane_steps)
{
    gathering *g = user;
    const schuler_run_options *o = g->options;
    const double done = (double)(atomic_fetch_add(&g->done, lane_steps) + lane_steps);
    if (o->progress && pthread_mutex_trylock(&g->lock) == 0) {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        const double since_s = (double)(now.tv_sec - g->last_progress.tv_sec) +
                               1e-9 * (double)(now.tv_nsec - g->last_progress.tv_nsec);
        if (since_s > 0.1) {
            g->last_progress = now;
            o->progress(o->user, done / g->total);
        }
        pthread_mutex_unlock(&g->lock);
    }
    return atomic_load(&g->stopped) || (o->stop && *o->stop);
}

/* Whole numbers: the order of the batches does not matter. */
static void add_clipped(gathering *g, const lane_metrics *m)
{
    pthread_mutex_lock(&g->lock);
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        g->result->clipped[i].runs += m->clipped[i] > 0.0;
        g->result->clipped[i].samples += (int64_t)m->clipped[i];
    }
    pthread_mutex_unlock(&g->lock);
}

static void store(gathering *g, const lane_batch *work, const batch_result *from)
{
    const simulation_plan *p = g->plan;
    memcpy(g->chunk_curves_m2 + work->first_chunk * p->reports, from->curve_m2,
           work->chunks * p->reports * sizeof(double));
    size_t lane = 0;
    for (size_t c = 0; c < work->chunks; c++) {
        const lane_chunk *chunk = &p->chunks[work->first_chunk + c];
        schuler_budget_row *row = schuler_budget_row_at(g->result, p, chunk->row);
        for (int k = 0; k < chunk->runs; k++, lane++) {
            const lane_metrics *m = &from->metrics[lane];
            const int run = chunk->first_run + k;
            row->end_m[run] = m->end_m;
            row->max_m[run] = m->max_m;
            row->slope_mps[run] = m->sum_tr / m->sum_tt;
            row->v_rms_mps[run] = sqrt(m->sum_v2 / m->count);
            const schuler_metric metric = p->scenario->requirement.metric;
            row->drift_mps[run] = schuler_metrics_drift(m, metric, -1);
            for (int i = 0; i < 2; i++) row->axis_mps[i][run] = schuler_metrics_drift(m, metric, i);
            if (chunk->row == plan_row_all(p)) add_clipped(g, m);
        }
    }
}

/* Error rows leave in the order of the batches, which is the order in which they are taken. */
static schuler_status hand_out(gathering *g, size_t batch, const batch_result *from)
{
    const simulation_plan *p = g->plan;
    const lane_batch *work = &p->batches[batch];
    pthread_mutex_lock(&g->lock);
    while (g->turn != batch && !atomic_load(&g->stopped))
        pthread_cond_wait(&g->turn_changed, &g->lock);
    const int ours = g->turn == batch;
    pthread_mutex_unlock(&g->lock);
    schuler_status status = ours ? SCHULER_OK : SCHULER_ERR_INTERRUPTED;
    size_t lane = 0;
    for (size_t c = 0; c < work->chunks; c++) {
        const lane_chunk *chunk = &p->chunks[work->first_chunk + c];
        char id[64];
        schuler_plan_row_id(p, chunk->row, id);
        for (int k = 0; k < chunk->runs && status == SCHULER_OK; k++, lane++)
            status = g->options->errors(g->options->user, id, chunk->first_run + k,
                                        from->rows + lane * (p->reports + 1), p->reports + 1);
    }
    pthread_mutex_lock(&g->lock);
    if (status != SCHULER_OK) atomic_store(&g->stopped, 1); /* before the next one's turn */
    if (ours) g->turn++;
    pthread_cond_broadcast(&g->turn_changed);
    pthread_mutex_unlock(&g->lock);
    return status;
}

static void *work(void *user)
{
    gathering *g = user;
    const bool rows_wanted = g->options->errors != NULL;
    for (;;) {
        const size_t batch = atomic_fetch_add(&g->next, 1);
        if (batch >= g->plan->batch_count || atomic_load(&g->stopped)) return NULL;
        batch_result result;
        schuler_error error = { 0 };
        schuler_status status =
            schuler_batch_run(g->plan, batch, rows_wanted, tick, g, &result, &error);
        if (status == SCHULER_OK) {
            store(g, &g->plan->batches[batch], &result);
            if (rows_wanted) status = hand_out(g, batch, &result);
            if (status != SCHULER_OK)
                schuler_fail(&error, status, NULL, "the error rows could not be delivered");
            schuler_batch_free(&result);
        }
        if (status != SCHULER_OK) fail(g, batch, status, &error);
    }
}

static int thread_count(const schuler_run_options *options)
{
    long n = options->threads > 0 ? options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 256 ? 256 : (int)n;
}

static void run_threads(gathering *g, int threads)
{
    pthread_t others[256];
    int started = 0;
    /* This thread works too; one that cannot be started is done without. */
    while (started < threads - 1 && pthread_create(&others[started], NULL, work, g) == 0) started++;
    work(g);
    for (int i = 0; i < started; i++) pthread_join(others[i], NULL);
}

schuler_status schuler_scenario_truth(const schuler_scenario *scenario, schuler_truth **out,
                                      schuler_error *err)
{
    return schuler_truth_create(out, &scenario->path, 1.0 / scenario->imu.rate_hz,
                                scenario->truth_gravity, scenario->nav_gravity, err);
}

schuler_status schuler_simulate(const schuler_scenario *scenario,
                                const schuler_run_options *options, schuler_result **out,
                                schuler_error *err)
{
    const int threads = thread_count(options);
    schuler_truth *own_truth = NULL, *align_truth = NULL;
    schuler_status status =
        options->truth ? SCHULER_OK : schuler_scenario_truth(scenario, &own_truth, err);
    if (status != SCHULER_OK) return status;

    simulation_plan plan = {
        .scenario = scenario,
        .truth = options->truth ? options->truth : own_truth,
        .isa = options->has_isa ? options->isa : schuler_isa_best(),
    };
    gathering g = { .plan = &plan, .options = options };
    pthread_mutex_init(&g.lock, NULL);
    pthread_cond_init(&g.turn_changed, NULL);
    plan.count = schuler_sources_list(scenario, plan.sources);
    schuler_plan_rows(&plan, options->rows);
    for (int i = 0; i < plan.count; i++) plan.drawn |= plan.sources[i].drawn;
    status = schuler_plan_times(&plan, err);
    if (status == SCHULER_OK) status = schuler_align_plan(&plan, &align_truth, err);
    if (status != SCHULER_OK) goto done;
    status = schuler_plan_make(&plan, threads, options->errors != NULL);
    if (status == SCHULER_OK)
        g.chunk_curves_m2 = calloc(plan.chunk_count * plan.reports, sizeof(double));
    g.result = schuler_budget_create(&plan);
    if (status != SCHULER_OK || !g.chunk_curves_m2 || !g.result) {
        status = schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
        goto done;
    }
    for (size_t c = 0; c < plan.chunk_count; c++)
        g.total += (double)plan.chunks[c].runs * (double)(plan.steps + plan.align_steps);
    run_threads(&g, threads);
    status = g.status;
    if (status != SCHULER_OK) {
        if (err) *err = g.error;
        goto done;
    }
    g.result->lane_steps = (int64_t)g.total;
    status = schuler_budget_finish(g.result, &plan, g.chunk_curves_m2);
    if (status != SCHULER_OK) schuler_fail(err, status, NULL, "out of memory");
done:
    if (status == SCHULER_OK)
        *out = g.result;
    else
        schuler_result_free(g.result);
    free(g.chunk_curves_m2);
    schuler_plan_free(&plan);
    schuler_truth_free(own_truth);
    schuler_truth_free(align_truth);
    pthread_cond_destroy(&g.turn_changed);
    pthread_mutex_destroy(&g.lock);
    return status;
}

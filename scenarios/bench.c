/* SPDX-License-Identifier: MIT */
#include "scenarios/bench.h"
#include "scenarios/worker.h"
#include "sensors/chain.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS_MAX = 99, TRUTH_STEPS = 200000 };

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static schuler_spread spread_of(const double *values, int n)
{
    double sorted[ROUNDS_MAX];
    memcpy(sorted, values, (size_t)n * sizeof(double));
    qsort(sorted, (size_t)n, sizeof(double), ascending);
    return (schuler_spread){ sorted[0], 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]),
                             sorted[n - 1] };
}

static int param_index(const schuler_scenario *s, schuler_instrument i, const char *key)
{
    const schuler_param *params = s->imu.triad[i].params;
    for (int k = 0; params[k].key; k++)
        if (strcmp(params[k].key, key) == 0) return k;
    return -1;
}

enum { BENCH_QUIET, BENCH_WHITE, BENCH_DRIFTING, BENCH_IEEE1293, BENCH_HEAVIEST };

static void give(schuler_value *v, double value)
{
    *v = (schuler_value){ .given = true, .draw = SCHULER_DRAW_FIXED, .text = "" };
    for (int c = 0; c < SCHULER_VALUE_MAX; c++) v->a[c] = value;
}

static void set(schuler_scenario *s, schuler_instrument i, const char *key, double value)
{
    give(&s->imu.triad[i].values[param_index(s, i, key)], value);
}

/* A thousand-millionth of what it may be: only the time matters. */
static void set_all_terms(schuler_triad *triad, schuler_instrument i)
{
    const schuler_param *const own = triad->model->params[i];
    for (int k = 0; own[k].key; k++)
        if (own[k].number != 0) give(&triad->values[k], 1e-9 * own[k].max);
}

static void set_processes(schuler_scenario *s, schuler_instrument i, double bias)
{
    set(s, i, "bias_instability", bias);
    set(s, i, "bias_random_walk", 1e-3 * bias);
    set(s, i, "quantization", i == SCHULER_ACCEL ? 1e-5 : 5e-8);
    set(s, i, "bandwidth", 0.2 * s->imu.rate_hz);
}

/* The scenario's mission with navigation-grade sensors of a kind. params: room for the tables. */
static schuler_scenario sensors_for(const schuler_scenario *base, int kind,
                                    schuler_param params[][SCHULER_PARAMS_MAX + 1])
{
    static const char *const heavy_model[SCHULER_INSTRUMENTS] = { "ieee1293", "spinning_mass" };
    static const double bias[SCHULER_INSTRUMENTS] = { 2.5e-4, 1.7e-8 };
    schuler_scenario s = *base;
    s.samples_per_update = 1;
    s.only = s.without = (schuler_text_list){ 0 };
    s.requirement = (schuler_requirement){ 0 };
    s.truth_gravity = s.nav_gravity = "wgs84";
    s.runs = SCHULER_BENCH_LANES;
    s.report_s = 1.0;
    s.imu.has_temperature = false;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_instrument instrument = (schuler_instrument)i;
        const char *const walk = i == SCHULER_ACCEL ? "velocity_random_walk" : "angle_random_walk";
        const bool heavy =
            kind == BENCH_HEAVIEST || (kind == BENCH_IEEE1293 && instrument == SCHULER_ACCEL);
        schuler_triad *triad = &s.imu.triad[i];
        triad->model_index = schuler_sensor_model_find(heavy ? heavy_model[i] : "linear");
        triad->model = schuler_sensor_models(SCHULER_ISA_SCALAR)[triad->model_index];
        (void)schuler_chain_params(triad->model, instrument, params[i]);
        triad->params = params[i];
        memset(triad->values, 0, sizeof(triad->values));
        for (int k = 0; params[i][k].key; k++)
            for (int c = 0; params[i][k].number == 0 && c < params[i][k].components; c++)
                triad->values[k].a[c] = params[i][k].def;
        if (heavy) {
            set_all_terms(triad, instrument);
            set_processes(&s, instrument, bias[i]);
        } else {
            set(&s, instrument, "bias", bias[i]);
            set(&s, instrument, "scale_factor", i == SCHULER_ACCEL ? 1e-4 : 5e-6);
            set(&s, instrument, "misalignment", 3e-5);
        }
        if (kind != BENCH_QUIET && kind != BENCH_IEEE1293)
            set(&s, instrument, walk, i == SCHULER_ACCEL ? 1.5e-5 : 5.8e-7);
        if (kind == BENCH_DRIFTING) {
            set(&s, instrument, "gauss_markov", i == SCHULER_ACCEL ? 1e-4 : 1e-8);
            set(&s, instrument, "gauss_markov_time", 100.0);
            set(&s, instrument, "bias_random_walk", 1e-3 * bias[i]);
        }
    }
    return s;
}

static int no_tick(void *user, int64_t lane_steps)
{
    const volatile int *stop = user;
    (void)lane_steps;
    return stop && *stop;
}

/* One batch of joint lanes. */
static schuler_status chain(const schuler_scenario *s, const schuler_truth *truth, schuler_isa isa,
                            const volatile int *stop, schuler_error *err)
{
    lane_chunk chunks[SCHULER_BENCH_LANES / CHUNK_LANES];
    lane_batch batch = { 0, sizeof(chunks) / sizeof(chunks[0]), SCHULER_BENCH_LANES };
    simulation_plan plan = { .scenario = s, .truth = truth, .isa = isa };
    plan.count = schuler_sources_list(s, plan.sources);
    schuler_plan_rows(&plan, SCHULER_ROWS_SOURCES);
    for (size_t c = 0; c < batch.chunks; c++)
        chunks[c] = (lane_chunk){ plan_row_all(&plan), (int)c * CHUNK_LANES, CHUNK_LANES };
    plan.chunks = chunks;
    plan.batches = &batch;
    plan.chunk_count = batch.chunks;
    plan.batch_count = 1;
    plan.report_steps = (int64_t)(s->imu.rate_hz + 0.5);
    plan.steps = SCHULER_BENCH_SECONDS * plan.report_steps;
    if (plan.steps > schuler_truth_steps(truth)) plan.steps = schuler_truth_steps(truth);
    plan.reports = (size_t)((plan.steps + plan.report_steps - 1) / plan.report_steps);
    batch_result result;
    const schuler_status status =
        schuler_batch_run(&plan, 0, false, no_tick, (void *)(uintptr_t)stop, &result, err);
    if (status == SCHULER_OK) schuler_batch_free(&result);
    return status;
}

static double truth_ns(const schuler_truth *truth, schuler_isa isa)
{
    int64_t steps = schuler_truth_steps(truth);
    if (steps > TRUTH_STEPS) steps = TRUTH_STEPS;
    const double start_s = seconds(CLOCK_THREAD_CPUTIME_ID);
    schuler_truth_block block;
    for (int64_t first = 0; first < steps; first += SCHULER_BLOCK)
        schuler_truth_block_compute(
            truth, isa, first, steps - first < SCHULER_BLOCK ? (int)(steps - first) : SCHULER_BLOCK,
            &block);
    return (seconds(CLOCK_THREAD_CPUTIME_ID) - start_s) / (double)steps * 1e9;
}

typedef struct {
    const schuler_scenario *scenario;
    const schuler_truth *truth;
    const volatile int *stop;
    int batches;
    schuler_status status;
    schuler_error error;
} share;

static void *do_share(void *user)
{
    share *s = user;
    for (int i = 0; i < s->batches && s->status == SCHULER_OK; i++)
        s->status = chain(s->scenario, s->truth, schuler_isa_best(), s->stop, &s->error);
    return NULL;
}

/* Wall time of two shares one after the other, over that of both at once. */
static schuler_status two_threads(const share *work, double *ratio, schuler_error *err)
{
    share one = *work, other = *work;
    const double start_s = seconds(CLOCK_MONOTONIC);
    do_share(&one);
    do_share(&other);
    const double middle_s = seconds(CLOCK_MONOTONIC);
    pthread_t thread;
    if (pthread_create(&thread, NULL, do_share, &other) != 0)
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "cannot start a thread");
    do_share(&one);
    pthread_join(thread, NULL);
    *ratio = (middle_s - start_s) / (seconds(CLOCK_MONOTONIC) - middle_s);
    const share *worse = one.status != SCHULER_OK ? &one : &other;
    if (err && worse->status != SCHULER_OK) *err = worse->error;
    return worse->status;
}

schuler_status schuler_bench_run(const schuler_scenario *scenario, int rounds,
                                 const volatile int *stop, schuler_bench *out, schuler_error *err)
{
    schuler_scenario sensors[SCHULER_BENCH_KINDS];
    schuler_param params[SCHULER_BENCH_KINDS][SCHULER_INSTRUMENTS][SCHULER_PARAMS_MAX + 1];
    for (int k = 0; k < SCHULER_BENCH_KINDS; k++) sensors[k] = sensors_for(scenario, k, params[k]);
    schuler_truth *truth;
    schuler_status status = schuler_truth_create(
        &truth, &scenario->path, 1.0 / scenario->imu.rate_hz, "wgs84", "wgs84", err);
    if (status != SCHULER_OK) return status;

    double lane_steps = (double)schuler_truth_steps(truth);
    if (lane_steps > SCHULER_BENCH_SECONDS * scenario->imu.rate_hz)
        lane_steps = SCHULER_BENCH_SECONDS * scenario->imu.rate_hz;
    lane_steps *= SCHULER_BENCH_LANES;
    rounds = rounds < 1 ? 1 : rounds > ROUNDS_MAX ? ROUNDS_MAX : rounds;
    *out = (schuler_bench){ .rounds = rounds };

    static const int kinds = SCHULER_BENCH_KINDS;
    double times[SCHULER_ISA_COUNT][SCHULER_BENCH_KINDS][ROUNDS_MAX];
    double truths[SCHULER_ISA_COUNT][ROUNDS_MAX], ratios[ROUNDS_MAX], pairs[ROUNDS_MAX];
    for (int r = 0; r < rounds && status == SCHULER_OK; r++) {
        for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
            if (!(out->has[isa] = schuler_isa_available((schuler_isa)isa))) continue;
            truths[isa][r] = truth_ns(truth, (schuler_isa)isa);
            for (int k = 0; k < kinds && status == SCHULER_OK; k++) {
                const double start_s = seconds(CLOCK_THREAD_CPUTIME_ID);
                status = chain(&sensors[k], truth, (schuler_isa)isa, stop, err);
                times[isa][k][r] = (seconds(CLOCK_THREAD_CPUTIME_ID) - start_s) / lane_steps * 1e9;
            }
        }
        const share work = { &sensors[1], truth, stop, 2, SCHULER_OK, { 0 } };
        if (status == SCHULER_OK) status = two_threads(&work, &pairs[r], err);
    }
    schuler_truth_free(truth);
    if (status != SCHULER_OK) return status;
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
        if (!out->has[isa]) continue;
        out->truth_ns[isa] = spread_of(truths[isa], rounds);
        for (int k = 0; k < kinds; k++) {
            out->chain_ns[isa][k] = spread_of(times[isa][k], rounds);
            for (int r = 0; r < rounds; r++)
                ratios[r] = times[SCHULER_ISA_SCALAR][k][r] / times[isa][k][r];
            out->over_scalar[isa][k] = spread_of(ratios, rounds);
        }
    }
    out->two_threads = spread_of(pairs, rounds);
    return SCHULER_OK;
}

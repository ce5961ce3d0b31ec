/* SPDX-License-Identifier: MIT */
#include "scenarios/characterize.h"
#include "core/earth.h"
#include "scenarios/lane_spec.h"
#include "sensors/stand.h"
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TOGETHER = 8, THREADS_MAX = 64, PER_DECADE = 5 };

typedef struct {
    schuler_imu imu; /* that of the caller, with another specimen in each run */
    const schuler_characterize_options *options;
    schuler_characterized *result;
    error_source sources[SOURCES_MAX];
    int source_count;
    double *sigma2; /* [unit][point] */
    int64_t m[SCHULER_ALLAN_POINTS_MAX];
    atomic_int next, done; /* first unit that nobody has taken; units that are ready */
    atomic_int failed;     /* a schuler_status: no more units are taken               */
    pthread_t first;       /* the only one that shows progress                        */
} job;

double schuler_characterize_rate(const schuler_imu *imu, schuler_instrument instrument)
{
    const schuler_triad *const triad = &imu->triad[instrument];
    for (int k = 0; triad->params[k].key; k++)
        if (strcmp(triad->params[k].key, "bandwidth") == 0 && triad->values[k].given &&
            triad->values[k].a[0] > 0.0)
            return 2.0 * triad->values[k].a[0];
    return imu->rate_hz;
}

static void input(void *user, double t_s, double f_ib_b[3], double omega_ib_b[3])
{
    const job *const j = user;
    const double x[3] = { j->options->along, j->options->across, 0.0 };
    const double up[3] = { 0.0, 0.0, -SCHULER_G0_MPS2 }, none[3] = { 0.0, 0.0, 0.0 };
    const int gyro = j->result->instrument == SCHULER_GYRO;
    (void)t_s;
    memcpy(f_ib_b, gyro ? up : x, sizeof x);
    memcpy(omega_ib_b, gyro ? x : none, sizeof x);
}

static schuler_status create_stand(job *j, int first, int units, schuler_stand **out)
{
    const schuler_instrument instrument = j->result->instrument;
    const uint64_t seed = j->options->seed;
    chain_parts parts;
    schuler_lane_spec *const specs = malloc(TOGETHER * sizeof *specs);
    if (!specs) return SCHULER_ERR_MEMORY;
    for (int u = 0; u < units; u++) {
        schuler_lane_spec_start(&j->imu.triad[instrument], (uint64_t)(first + u), &specs[u]);
        for (int i = 0; i < j->source_count; i++)
            if (j->sources[i].instrument == instrument)
                schuler_lane_spec_draw(&j->sources[i], seed, &specs[u]);
    }
    const schuler_stand_setup setup = {
        .chain = schuler_chain_setup_of(&j->imu, instrument, schuler_isa_best(), j->result->dt_s,
                                        seed, &parts),
        .specs = specs,
        .specimens = (size_t)units,
        .input = input,
        .user = j,
    };
    const schuler_status status = schuler_stand_create(out, &setup, NULL);
    free(specs);
    return status;
}

/* The rates of `units` units, n of each one after the other. */
static schuler_status measure(job *j, int first, int units, double *rate)
{
    const int64_t n = j->result->n;
    const double dt_s = j->result->dt_s;
    static _Thread_local double block[TOGETHER][3][SCHULER_BLOCK];
    schuler_stand *stand = NULL;
    schuler_status status = create_stand(j, first, units, &stand);
    for (int64_t k = 0; status == SCHULER_OK && k < n; k += SCHULER_BLOCK) {
        const int some = n - k < SCHULER_BLOCK ? (int)(n - k) : SCHULER_BLOCK;
        schuler_stand_next(stand, some, block[0][0]);
        for (int u = 0; u < units; u++)
            for (int i = 0; i < some; i++) rate[u * n + k + i] = block[u][0][i] / dt_s;
        if (j->options->stop && *j->options->stop) status = SCHULER_ERR_INTERRUPTED;
    }
    schuler_stand_free(stand);
    return status;
}

/* Mean and noise of one unit, and its Allan variances; rate becomes the phase. */
static schuler_status analyse(job *j, int unit, double *rate, double *phase)
{
    schuler_characterized *const r = j->result;
    double sum = 0.0, squares = 0.0;
    for (int64_t k = 0; k < r->n; k++) sum += rate[k];
    const double mean = sum / (double)r->n;
    for (int64_t k = 0; k < r->n; k++) squares += (rate[k] - mean) * (rate[k] - mean);
    if (!isfinite(squares)) return SCHULER_ERR_NUMERIC;
    r->unit_mean[unit] = mean;
    r->unit_noise[unit] = sqrt(squares / (double)(r->n - 1));
    if (unit == 0) memcpy(r->series, rate, (size_t)r->n * sizeof *rate);
    schuler_allan_phase(rate, r->n, r->dt_s, phase);
    return schuler_allan_overlapping(phase, r->n, r->dt_s, j->m, r->points,
                                     &j->sigma2[(size_t)unit * (size_t)r->points],
                                     j->options->stop);
}

static schuler_status work_through(job *j, double *rate, double *phase)
{
    const int units = j->result->units;
    for (int first; (first = atomic_fetch_add(&j->next, TOGETHER)) < units;) {
        const int some = units - first < TOGETHER ? units - first : TOGETHER;
        if (atomic_load(&j->failed) != SCHULER_OK) return SCHULER_OK;
        schuler_status status = measure(j, first, some, rate);
        for (int u = 0; u < some && status == SCHULER_OK; u++)
            status = analyse(j, first + u, &rate[u * j->result->n], phase);
        if (status != SCHULER_OK) return status;
        const int done = atomic_fetch_add(&j->done, some) + some;
        if (j->options->progress && pthread_equal(pthread_self(), j->first))
            j->options->progress(j->options->user, (double)done / units);
    }
    return SCHULER_OK;
}

/* Units are dealt by eights; each is computed by one thread, so no result depends on how many. */
static void *work(void *argument)
{
    job *const j = argument;
    const size_t n = (size_t)j->result->n;
    double *const rate = malloc(TOGETHER * n * sizeof *rate);
    double *const phase = malloc((n + 1) * sizeof *phase);
    const schuler_status status = rate && phase ? work_through(j, rate, phase) : SCHULER_ERR_MEMORY;
    if (status != SCHULER_OK) atomic_store(&j->failed, status);
    free(rate);
    free(phase);
    return NULL;
}

static schuler_status run(job *j)
{
    pthread_t thread[THREADS_MAX];
    const long processors =
        j->options->threads > 0 ? j->options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    const int packs = (j->result->units + TOGETHER - 1) / TOGETHER;
    int helpers = 0;
    j->first = pthread_self();
    while (helpers + 1 < processors && helpers + 1 < packs && helpers < THREADS_MAX &&
           pthread_create(&thread[helpers], NULL, work, j) == 0)
        helpers++;
    work(j);
    for (int i = 0; i < helpers; i++) pthread_join(thread[i], NULL);
    return (schuler_status)atomic_load(&j->failed);
}

/* n numbers, stride apart. The variance of a sample variance is (m4 - s^4)/n, m4 the fourth central
 * moment; of its root, a fourth of that over s^2. */
static schuler_over_units over_units(const double *x, int n, size_t stride)
{
    double sum = 0.0, m2 = 0.0, m4 = 0.0;
    schuler_over_units o = { .least = x[0], .most = x[0] };
    for (int i = 0; i < n; i++) {
        const double v = x[(size_t)i * stride];
        sum += v;
        o.least = fmin(o.least, v);
        o.most = fmax(o.most, v);
    }
    o.mean = sum / n;
    for (int i = 0; i < n; i++) {
        const double d = x[(size_t)i * stride] - o.mean;
        m2 += d * d / n;
        m4 += d * d * d * d / n;
    }
    if (n < 2) return o;
    o.spread = sqrt(m2 * n / (n - 1));
    o.mean_error = o.spread / sqrt(n);
    if (o.spread > 0.0) o.spread_error = sqrt(fmax(m4 - m2 * m2, 0.0) / n) / (2.0 * o.spread);
    return o;
}

static void summarise(const job *j)
{
    schuler_characterized *const r = j->result;
    r->output = over_units(r->unit_mean, r->units, 1);
    r->noise = over_units(r->unit_noise, r->units, 1);
    for (int p = 0; p < r->points; p++) {
        const schuler_over_units o = over_units(&j->sigma2[p], r->units, (size_t)r->points);
        r->tau_s[p] = (double)j->m[p] * r->dt_s;
        r->sigma2[p] = o.mean;
        r->sigma2_error[p] = o.mean_error;
        r->promised[p] =
            schuler_promised_allan(&j->imu, r->instrument, j->options, r->tau_s[p], r->dt_s);
    }
}

static schuler_status check(const schuler_characterize_options *o, double rate_hz,
                            schuler_error *err)
{
    if (!(o->units >= 1 && o->units <= SCHULER_CHARACTERIZE_UNITS_MAX))
        return schuler_fail(err, SCHULER_ERR_INPUT, NULL, "%d units: 1 to %d are possible",
                            o->units, SCHULER_CHARACTERIZE_UNITS_MAX);
    const double n = floor(o->duration_s * rate_hz * (1.0 + 1e-12));
    if (!(n >= 3.0 && n <= SCHULER_CHARACTERIZE_SAMPLES_MAX))
        return schuler_fail(err, SCHULER_ERR_INPUT, NULL,
                            "%.6g s at %.6g Hz are %.0f samples of a unit: 3 to %d are possible",
                            o->duration_s, rate_hz, n, SCHULER_CHARACTERIZE_SAMPLES_MAX);
    return SCHULER_OK;
}

static schuler_status allocate(job *j)
{
    schuler_characterized *const r = j->result;
    r->points = schuler_allan_factors(r->n, PER_DECADE, j->m, SCHULER_ALLAN_POINTS_MAX);
    r->unit_mean = malloc((size_t)r->units * sizeof(double));
    r->unit_noise = malloc((size_t)r->units * sizeof(double));
    r->series = malloc((size_t)r->n * sizeof(double));
    j->sigma2 = malloc((size_t)r->units * (size_t)r->points * sizeof(double));
    return r->unit_mean && r->unit_noise && r->series && j->sigma2 ? SCHULER_OK
                                                                   : SCHULER_ERR_MEMORY;
}

schuler_status schuler_characterize(schuler_characterized **out, const schuler_imu *imu,
                                    schuler_instrument instrument,
                                    const schuler_characterize_options *o, schuler_error *err)
{
    *out = NULL;
    const double rate_hz =
        o->rate_hz > 0.0 ? o->rate_hz : schuler_characterize_rate(imu, instrument);
    schuler_status status = check(o, rate_hz, err);
    if (status != SCHULER_OK) return status;
    job *const j = calloc(1, sizeof *j);
    schuler_characterized *const r = calloc(1, sizeof *r);
    if (j && r) {
        *j = (job){ .imu = *imu, .options = o, .result = r };
        j->imu.unit = -1;
        r->instrument = instrument;
        r->dt_s = 1.0 / rate_hz;
        r->n = (int64_t)floor(o->duration_s * rate_hz * (1.0 + 1e-12));
        r->units = o->units;
        j->source_count = schuler_sources_of_imu(&j->imu, &o->only, &o->without, j->sources);
        status = allocate(j);
        if (status == SCHULER_OK) status = run(j);
        if (status == SCHULER_OK) summarise(j);
        free(j->sigma2);
    } else {
        status = SCHULER_ERR_MEMORY;
    }
    free(j);
    if (status == SCHULER_OK) {
        *out = r;
        return SCHULER_OK;
    }
    schuler_characterized_free(r);
    return schuler_fail(err, status, NULL, "%s",
                        status == SCHULER_ERR_MEMORY        ? "out of memory"
                        : status == SCHULER_ERR_INTERRUPTED ? "interrupted"
                                                            : "an output is not finite");
}

void schuler_characterized_free(schuler_characterized *c)
{
    if (!c) return;
    free(c->unit_mean);
    free(c->unit_noise);
    free(c->series);
    free(c);
}

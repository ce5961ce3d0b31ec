/* SPDX-License-Identifier: MIT */
#include "scenarios/identify.h"
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

typedef struct {
    schuler_identified *result;
    schuler_recording *r;
    const schuler_identify_options *options;
    const schuler_allan_design *design;
    atomic_int next; /* column that nobody has taken yet */
    schuler_status status[SCHULER_RECORDING_COLUMNS_MAX];
} job;

static schuler_status spectrum_of(const job *j, const schuler_recording_column *in,
                                  schuler_identified_column *out)
{
    const int segment = j->result->segment;
    const double scale = in->increments ? 1.0 / j->r->dt_s : 1.0;
    if (segment == 0) return SCHULER_OK;
    out->density = malloc(((size_t)segment / 2 + 1) * sizeof(double));
    if (!out->density) return SCHULER_ERR_MEMORY;
    return schuler_spectrum_welch(in->values, j->r->n, j->r->dt_s, scale, segment, out->density,
                                  j->options->stop);
}

/* The kind of noise from the slope across each tau. */
static void limit(const schuler_identified *result, double level, schuler_identified_column *c)
{
    for (int i = 0; i < result->points; i++) {
        const int a = i > 0 ? i - 1 : 0, b = i + 1 < result->points ? i + 1 : i;
        const double rise = log(c->sigma2[b] / c->sigma2[a]);
        const double slope = b > a ? rise / log(result->tau_s[b] / result->tau_s[a]) : -1.0;
        const schuler_noise_kind kind =
            isfinite(slope) ? schuler_noise_of_slope(slope) : SCHULER_NOISE_WHITE;
        schuler_allan_limits(c->sigma2[i], schuler_allan_dof(kind, result->n + 1, result->m[i]),
                             level, c->limits[i]);
    }
}

static schuler_status analyse(const job *j, const schuler_recording_column *in,
                              schuler_identified_column *out)
{
    const schuler_identified *const result = j->result;
    const double dt_s = result->dt_s;
    schuler_status status = spectrum_of(j, in, out);
    if (status != SCHULER_OK) return status;
    out->mean =
        schuler_allan_phase(in->values, result->n, in->increments ? 1.0 : dt_s, in->values) / dt_s;
    status = schuler_allan_overlapping(in->values, result->n, dt_s, result->m, result->points,
                                       out->sigma2, j->options->stop);
    if (status != SCHULER_OK) return status;
    status = schuler_allan_fit_terms(j->design, out->sigma2, j->options->terms, j->options->level,
                                     &out->fit);
    if (status != SCHULER_OK) return status;
    for (int i = 0; i < result->points; i++)
        out->model[i] = schuler_allan_fit_at(j->design, &out->fit, i);
    limit(result, j->options->level, out);
    return SCHULER_OK;
}

/* Columns are dealt one by one; each is computed by one thread, so no result depends on how many. */
static void *work(void *argument)
{
    job *const j = argument;
    for (int i; (i = atomic_fetch_add(&j->next, 1)) < j->result->columns;)
        j->status[i] = analyse(j, &j->r->column[i], &j->result->column[i]);
    return NULL;
}

static schuler_status run(job *j)
{
    pthread_t thread[SCHULER_RECORDING_COLUMNS_MAX];
    const long processors =
        j->options->threads > 0 ? j->options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    int helpers = 0;
    atomic_init(&j->next, 0);
    while (helpers + 1 < processors && helpers + 1 < j->result->columns &&
           pthread_create(&thread[helpers], NULL, work, j) == 0)
        helpers++;
    work(j);
    for (int i = 0; i < helpers; i++) pthread_join(thread[i], NULL);
    for (int i = 0; i < j->result->columns; i++)
        if (j->status[i] != SCHULER_OK) return j->status[i];
    return SCHULER_OK;
}

static schuler_status say(schuler_status status, schuler_error *err)
{
    const char *const why = status == SCHULER_ERR_MEMORY        ? "out of memory"
                            : status == SCHULER_ERR_INTERRUPTED ? "interrupted"
                            : status == SCHULER_ERR_NUMERIC     ? "the values are too large"
                                                                : "wrong input";
    return schuler_fail(err, status, NULL, "%s", why);
}

schuler_status schuler_identify(schuler_identified **out, schuler_recording *r,
                                const schuler_identify_options *options, schuler_error *err)
{
    *out = NULL;
    const int segment = options->segment < 0 ? schuler_spectrum_segment(r->n) : options->segment;
    if (segment != 0 && (segment < SCHULER_SEGMENT_MIN || segment > SCHULER_SEGMENT_MAX ||
                         segment % 2 || segment > r->n))
        return schuler_fail(err, SCHULER_ERR_INPUT, NULL,
                            "a segment of %d samples: an even number from %d to %d and no longer "
                            "than the recording, %lld, is needed",
                            segment, SCHULER_SEGMENT_MIN, SCHULER_SEGMENT_MAX, (long long)r->n);
    schuler_identified *const result = calloc(1, sizeof(*result));
    if (!result) return say(SCHULER_ERR_MEMORY, err);
    result->n = r->n;
    result->dt_s = r->dt_s;
    result->columns = r->columns;
    result->segment = segment;
    result->points =
        schuler_allan_factors(r->n, SCHULER_PER_DECADE, result->m, SCHULER_ALLAN_POINTS_MAX);
    for (int i = 0; i < result->points; i++) result->tau_s[i] = (double)result->m[i] * r->dt_s;

    schuler_flicker_bank bank =
        schuler_flicker_bank_of(SCHULER_FLICKER_SHORTEST_S, SCHULER_FLICKER_LONGEST_S, r->dt_s);
    if (options->ideal_flicker) bank.members = 0;
    schuler_allan_design *design;
    schuler_status status =
        schuler_allan_design_create(&design, r->n, r->dt_s, result->m, result->points, &bank);
    if (status == SCHULER_OK) {
        job j = { .result = result, .r = r, .options = options, .design = design };
        status = run(&j);
    }
    schuler_allan_design_free(design);
    if (status == SCHULER_OK) {
        *out = result;
        return SCHULER_OK;
    }
    schuler_identified_free(result);
    return say(status, err);
}

void schuler_identified_free(schuler_identified *i)
{
    if (!i) return;
    for (int c = 0; c < i->columns; c++) free(i->column[c].density);
    free(i);
}

/* SPDX-License-Identifier: MIT */
#include "core/earth.h"
#include "scenarios/recording_private.h"
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SAMPLES_MIN = 16, PARTS_MAX = 8 };
static const int64_t PART_BYTES = 1 << 22; /* not worth a thread below */

typedef struct {
    recording_layout layout;
    int fd;
    int64_t size;   /* of the file; -1: a stream */
    int64_t header; /* bytes of it               */
    char *head;     /* first bytes of the file   */
    size_t head_length;
    const schuler_recording_options *options;
    schuler_recording *r;
    schuler_error *err;
} opened;

static schuler_status no_memory(schuler_error *err)
{
    return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
}

/* The first bytes, with room for a NUL. */
static schuler_status read_head(opened *o)
{
    const schuler_place place = { o->layout.path, 0, 0, 0 };
    o->head = malloc(RECORDING_LINE_MAX + 1);
    if (!o->head) return no_memory(o->err);
    while (o->head_length < RECORDING_LINE_MAX) {
        const ssize_t got =
            read(o->fd, o->head + o->head_length, RECORDING_LINE_MAX - o->head_length);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            return schuler_fail(o->err, SCHULER_ERR_FILE, &place, "cannot be read: %s",
                                strerror(errno));
        if (got == 0) break;
        o->head_length += (size_t)got;
    }
    o->head[o->head_length] = '\0';
    if (o->head_length == 0) return schuler_fail(o->err, SCHULER_ERR_INPUT, &place, "empty");
    char *const end = memchr(o->head, '\n', o->head_length);
    const schuler_place first = { o->layout.path, 1, 0, 0 };
    if (!end && o->head_length == RECORDING_LINE_MAX)
        return schuler_fail(o->err, SCHULER_ERR_INPUT, &first, "a line longer than %d bytes",
                            RECORDING_LINE_MAX);
    const size_t length = end ? (size_t)(end - o->head) : o->head_length;
    if (memchr(o->head, '\0', length))
        return schuler_fail(o->err, SCHULER_ERR_INPUT, &first,
                            "a NUL byte: this is not a text file");
    o->header = (int64_t)length + (end ? 1 : 0);
    char *const line = strndup(o->head, length);
    if (!line) return no_memory(o->err);
    if (length > 0 && line[length - 1] == '\r') line[length - 1] = '\0';
    const schuler_status status = recording_header(&o->layout, o->r, line, 1, o->options, o->err);
    free(line);
    return status;
}

static schuler_status open_file(opened *o, const char *path)
{
    const schuler_place place = { path, 0, 0, 0 };
    struct stat info;
    o->fd = open(path, O_RDONLY | O_CLOEXEC);
    if (o->fd < 0 || fstat(o->fd, &info) != 0)
        return schuler_fail(o->err, SCHULER_ERR_FILE, &place, "cannot be opened: %s",
                            strerror(errno));
    if (S_ISDIR(info.st_mode))
        return schuler_fail(o->err, SCHULER_ERR_FILE, &place, "cannot be read: it is a folder");
    o->size = S_ISREG(info.st_mode) ? (int64_t)info.st_size : -1;
    return read_head(o);
}

/* The start of the first line at or after a place in the file. */
static int64_t line_at(const opened *o, int64_t at)
{
    char text[4096];
    for (ssize_t got; at < o->size; at += got) {
        got = pread(o->fd, text, sizeof text, (off_t)at);
        if (got <= 0) break;
        const char *const end = memchr(text, '\n', (size_t)got);
        if (end) return at + (end - text) + 1;
    }
    return o->size;
}

typedef struct {
    const opened *o;
    int64_t from, to;
    recording_rows rows;
    pthread_t thread;
    int started;
} part;

static void *read_part(void *argument)
{
    part *const p = argument;
    recording_rows_read(&p->rows, &p->o->layout, p->o->fd, NULL, 0, p->from, p->to, p->o->options,
                        0);
    return NULL;
}

static int part_count(const opened *o)
{
    const long processors =
        o->options->threads > 0 ? o->options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    int64_t count = (o->size - o->header) / PART_BYTES;
    if (count > processors) count = processors;
    return count < 1 ? 1 : count > PARTS_MAX ? PARTS_MAX : (int)count;
}

static void read_parts(opened *o, part *parts, int count)
{
    if (o->size < 0) { /* a stream cannot be divided */
        recording_rows_read(&parts[0].rows, &o->layout, o->fd, o->head + o->header,
                            o->head_length - (size_t)o->header, -1, 0, o->options, 0);
        return;
    }
    int64_t from = o->header;
    for (int i = 0; i < count; i++) {
        const int64_t share = o->header + (o->size - o->header) / count * (i + 1);
        int64_t to = i + 1 < count ? line_at(o, share) : o->size;
        if (to < from) to = from;
        parts[i].o = o;
        parts[i].from = from;
        parts[i].to = from = to;
    }
    for (int i = 1; i < count; i++)
        parts[i].started = pthread_create(&parts[i].thread, NULL, read_part, &parts[i]) == 0;
    recording_rows_read(&parts[0].rows, &o->layout, o->fd, NULL, 0, parts[0].from, parts[0].to,
                        o->options, 1);
    for (int i = 1; i < count; i++) {
        if (parts[i].started)
            pthread_join(parts[i].thread, NULL);
        else
            read_part(&parts[i]);
    }
}

/* The first thing that is wrong, in the order of the file. */
static schuler_status check_parts(const opened *o, const part *parts, int count)
{
    int lines = 1;
    const recording_rows *before = NULL;
    for (int i = 0; i < count; i++) {
        const recording_rows *const rows = &parts[i].rows;
        const schuler_place place = { o->layout.path, lines + 1, 0, 0 };
        if (before && rows->n > 0 && o->layout.has_time &&
            recording_check_time(&o->layout, before->last_s, rows->first_s, &place, o->err) !=
                SCHULER_OK)
            return SCHULER_ERR_INPUT;
        if (rows->status != SCHULER_OK) {
            *o->err = rows->error;
            if (o->err->place.line > 0) o->err->place.line += lines;
            return rows->status;
        }
        lines += rows->lines;
        if (rows->n > 0) before = rows;
    }
    return SCHULER_OK;
}

/* One array for each column; a part's is given back as soon as it is copied. */
static schuler_status join(opened *o, part *parts, int count)
{
    schuler_recording *const r = o->r;
    for (int i = 0; i < count; i++) r->n += parts[i].rows.n;
    for (int c = 0; c < r->columns; c++) {
        int64_t at = parts[0].rows.n;
        double *const values =
            realloc(parts[0].rows.values[c], (size_t)(r->n + 1) * sizeof(double));
        if (!values) return no_memory(o->err);
        parts[0].rows.values[c] = NULL;
        r->column[c].values = values;
        for (int i = 1; i < count; i++) {
            recording_rows *const rows = &parts[i].rows;
            if (rows->n > 0) memcpy(values + at, rows->values[c], (size_t)rows->n * sizeof(double));
            at += rows->n;
            free(rows->values[c]);
            rows->values[c] = NULL;
        }
    }
    return SCHULER_OK;
}

/* The interval from the times, which are rounded: where a whole number of samples a second explains
 * them to a millionth, that is the rate. */
static schuler_status settle_interval(opened *o, double first_s, double last_s)
{
    schuler_recording *const r = o->r;
    const schuler_place place = { o->layout.path, 0, 0, 0 };
    if (r->n < SAMPLES_MIN)
        return schuler_fail(o->err, SCHULER_ERR_INPUT, &place,
                            "%lld samples are too few: %d at least", (long long)r->n, SAMPLES_MIN);
    r->times = o->layout.has_time;
    r->dt_s = o->options->rate_hz > 0.0 ? 1.0 / o->options->rate_hz : 0.0;
    if (!r->times) return SCHULER_OK;
    const double interval_s = (last_s - first_s) / (double)(r->n - 1);
    const double rate_hz = nearbyint(1.0 / interval_s);
    const double rounded =
        rate_hz >= 1.0 && fabs(rate_hz * interval_s - 1.0) < 1e-6 ? 1.0 / rate_hz : interval_s;
    if (r->dt_s > 0.0 && fabs(interval_s / r->dt_s - 1.0) > 1e-3)
        return schuler_fail(o->err, SCHULER_ERR_INPUT, &place,
                            "the column of time says %.6g Hz, not %.6g Hz", 1.0 / rounded,
                            o->options->rate_hz);
    r->dt_s = rounded;
    return SCHULER_OK;
}

static schuler_status read_rows(opened *o)
{
    part parts[PARTS_MAX];
    memset(parts, 0, sizeof parts);
    const size_t head = (size_t)o->header;
    if (o->layout.has_time) {
        o->layout.interval_s =
            recording_interval(&o->layout, o->head + head, o->head_length - head);
        if (!(o->layout.interval_s > 0.0)) o->layout.interval_s = 1.0; /* what is wrong is found */
    }
    const int count = o->size < 0 ? 1 : part_count(o);
    read_parts(o, parts, count);
    schuler_status status = check_parts(o, parts, count);
    const recording_rows *last = &parts[0].rows;
    for (int i = 1; i < count; i++)
        if (parts[i].rows.n > 0) last = &parts[i].rows;
    const double first_s = parts[0].rows.first_s, last_s = last->last_s;
    if (status == SCHULER_OK) status = join(o, parts, count);
    if (status == SCHULER_OK) status = settle_interval(o, first_s, last_s);
    for (int i = 0; i < count; i++) recording_rows_free(&parts[i].rows);
    return status;
}

schuler_status schuler_recording_read(schuler_recording **out, const char *path,
                                      const schuler_recording_options *options, schuler_error *err)
{
    schuler_error unheard;
    opened o = { .fd = -1, .options = options, .err = err ? err : &unheard };
    schuler_status status = SCHULER_ERR_MEMORY;
    *out = NULL;
    o.layout.path = path;
    o.layout.c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    o.r = calloc(1, sizeof(*o.r));
    if (!o.layout.c_locale || !o.r) {
        no_memory(o.err);
    } else {
        status = open_file(&o, path);
        if (status == SCHULER_OK) status = read_rows(&o);
    }
    if (o.fd >= 0) close(o.fd);
    free(o.head);
    if (o.layout.c_locale) freelocale(o.layout.c_locale);
    if (status == SCHULER_OK)
        *out = o.r;
    else
        schuler_recording_free(o.r);
    return status;
}

void schuler_recording_free(schuler_recording *r)
{
    if (!r) return;
    for (int i = 0; i < r->columns; i++) free(r->column[i].values);
    free(r);
}

/* Length of the mean vector of an instrument's three columns, rad/s or m/s^2; NAN without three. */
static double mean_size(const schuler_recording *r, schuler_instrument instrument)
{
    double sum = 0.0;
    int found = 0;
    for (int i = 0; i < r->columns; i++) {
        const schuler_recording_column *const c = &r->column[i];
        if (c->instrument != instrument) continue;
        double mean = 0.0;
        for (int64_t k = 0; k < r->n; k++) mean += c->values[k];
        mean /= (double)r->n * (c->increments ? r->dt_s : 1.0);
        sum += mean * mean;
        found++;
    }
    return found == 3 ? sqrt(sum) : nan("");
}

void schuler_recording_doubt(const schuler_recording *r, const char *path, schuler_diagnostics *d)
{
    const schuler_place place = { path, 0, 0, 0 };
    const double f_mps2 = mean_size(r, SCHULER_ACCEL), omega_radps = mean_size(r, SCHULER_GYRO);
    if (f_mps2 < 0.01)
        schuler_warn(d, &place, "no gravity in the specific force: its mean is %.3g m/s^2", f_mps2);
    else if (f_mps2 < 0.8 * SCHULER_G0_MPS2 || f_mps2 > 1.2 * SCHULER_G0_MPS2)
        schuler_warn(
            d, &place,
            "the mean specific force is %.4g m/s^2, %.3g times gravity: is the unit right?", f_mps2,
            f_mps2 / SCHULER_G0_MPS2);
    if (omega_radps < 0.2 * SCHULER_OMEGA_IE_RADPS)
        schuler_warn(d, &place,
                     "no earth rate in the angular rate: its mean is %.3g rad/s, the earth's is "
                     "7.29e-05",
                     omega_radps);
    else if (omega_radps > 0.1)
        schuler_warn(d, &place,
                     "the mean angular rate is %.3g rad/s: is the unit right, was it at rest?",
                     omega_radps);
}

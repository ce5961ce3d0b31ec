/* SPDX-License-Identifier: MIT */
/* The rows of a recording. A file of many hours has gigabytes of text, so this is written for speed:
 * every byte is looked at once, and parts of a file are read side by side. */
#include "scenarios/decimal.h"
#include "scenarios/recording_private.h"
#include "scenarios/sampling.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BUFFER = 1 << 20 };

typedef struct {
    recording_rows *rows;
    const recording_layout *layout;
} reader;

/* at: the byte that is wrong, in the line that starts at line. */
static schuler_status refuse(const reader *r, const char *line, const char *at, int width,
                             const char *format, const char *name)
{
    schuler_error *const err = &r->rows->error;
    const schuler_place place = { r->layout->path, r->rows->lines, (int)(at - line) + 1, width };
    schuler_fail(err, SCHULER_ERR_INPUT, &place, format, width < 40 ? width : 40, at, name);
    const int length = (int)strcspn(line, "\r\n");
    snprintf(err->excerpt, sizeof err->excerpt, "%.*s",
             length < SCHULER_EXCERPT_MAX ? length : SCHULER_EXCERPT_MAX - 1, line);
    return SCHULER_ERR_INPUT;
}

static schuler_status grow(recording_rows *rows, int columns)
{
    const int64_t capacity = rows->capacity > 0 ? rows->capacity + rows->capacity / 2 : 1 << 16;
    for (int i = 0; i < columns; i++) {
        double *const values = realloc(rows->values[i], (size_t)capacity * sizeof(double));
        if (!values) return schuler_fail(&rows->error, SCHULER_ERR_MEMORY, NULL, "out of memory");
        rows->values[i] = values;
    }
    rows->capacity = capacity;
    return SCHULER_OK;
}

static const char *skip_blanks(const char *p)
{
    while (*p == ' ' || *p == '\t') p++;
    return p;
}

/* A line of one row into values, by slot. Returns SCHULER_OK. */
static schuler_status read_row(const reader *r, const char *line, double *values, const char **next)
{
    const recording_layout *const layout = r->layout;
    const char *p = line;
    for (int i = 0; i < layout->fields; i++) {
        const int slot = layout->slot[i];
        const char *const start = p;
        if (slot >= 0) {
            p = skip_blanks(p);
            const char *const end = schuler_decimal_read(p, layout->c_locale, &values[slot]);
            const char *after = end ? skip_blanks(end) : p;
            if (*after == '\r' && after[1] == '\n') after++;
            if (!end || (*after != ',' && *after != '\n') || !isfinite(values[slot])) {
                const int width = (int)strcspn(p, ", \t\r\n");
                if (*line == '\n' || *line == '\r')
                    return refuse(r, line, line, 0, "%.*san empty line%s", "");
                if (width == 0)
                    return refuse(r, line, p, 0, "%.*s'%s' has no value here", layout->name[slot]);
                return refuse(r, line, p, width, "'%.*s' is not a finite number, for '%s'",
                              layout->name[slot]);
            }
            p = after;
        } else {
            p += strcspn(p, ",\n");
        }
        const int last = i == layout->fields - 1;
        if (*p != (last ? '\n' : ','))
            return refuse(r, line, last ? p : start, 1,
                          last ? "%.*smore fields than the header has%s"
                               : "%.*sfewer fields than the header has%s",
                          "");
        p++;
    }
    *next = p;
    return SCHULER_OK;
}

schuler_status recording_check_time(const recording_layout *layout, double before_s, double t_s,
                                    const schuler_place *place, schuler_error *err)
{
    char text[SCHULER_MESSAGE_MAX];
    const sampling_step step = sampling_step_of(before_s, t_s, layout->interval_s);
    if (step == SAMPLING_NEXT) return SCHULER_OK;
    sampling_describe(text, sizeof text, step, before_s, t_s, layout->interval_s);
    return schuler_fail(err, SCHULER_ERR_INPUT, place, "%s%s", text,
                        step == SAMPLING_GAP ? "; analyse the parts on their own" : "");
}

static schuler_status take_row(const reader *r, const char *line, const double *values, int columns)
{
    recording_rows *const rows = r->rows;
    const recording_layout *const layout = r->layout;
    if (layout->has_time) {
        const double t_s = values[RECORDING_TIME] * layout->si[RECORDING_TIME];
        const schuler_place place = { layout->path, rows->lines, 0, 0 };
        if (rows->n == 0)
            rows->first_s = t_s;
        else if (recording_check_time(layout, rows->last_s, t_s, &place, &rows->error) !=
                 SCHULER_OK) {
            snprintf(rows->error.excerpt, sizeof rows->error.excerpt, "%.*s",
                     (int)(strcspn(line, "\r\n") < 150 ? strcspn(line, "\r\n") : 150), line);
            return SCHULER_ERR_INPUT;
        }
        rows->last_s = t_s;
    }
    if (rows->n == rows->capacity) {
        const schuler_status status = grow(rows, columns);
        if (status != SCHULER_OK) return status;
    }
    for (int i = 0; i < columns; i++) rows->values[i][rows->n] = values[i] * layout->si[i];
    rows->n++;
    return SCHULER_OK;
}

/* All whole lines of a text that ends with one. */
static schuler_status read_lines(const reader *r, const char *text, const char *end)
{
    int columns = 0;
    for (int i = 0; i < r->layout->fields; i++)
        if (r->layout->slot[i] >= 0 && r->layout->slot[i] != RECORDING_TIME) columns++;
    for (const char *next; text < end; text = next) {
        double values[RECORDING_SLOTS];
        r->rows->lines++;
        schuler_status status = read_row(r, text, values, &next);
        if (status == SCHULER_OK) status = take_row(r, text, values, columns);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

double recording_interval(const recording_layout *layout, const char *text, size_t length)
{
    enum { TIMES = 101 };
    double step[TIMES], before = 0.0;
    int count = -1;
    recording_rows none = { .n = 0 };
    const reader r = { &none, layout };
    const char *const end = text + length;
    for (const char *next; count < TIMES && text < end && memchr(text, '\n', (size_t)(end - text));
         text = next) {
        double values[RECORDING_SLOTS];
        if (read_row(&r, text, values, &next) != SCHULER_OK) break;
        const double t_s = values[RECORDING_TIME] * layout->si[RECORDING_TIME];
        if (count >= 0) step[count] = t_s - before;
        before = t_s;
        count++;
    }
    return count > 0 ? sampling_median(step, count) : 0.0;
}

/* Reads on; the bytes got, 0 at the end, -1 with rows->error. */
static ssize_t fetch(const reader *r, int fd, char *to, size_t room, int64_t from, int64_t end)
{
    ssize_t got;
    if (from >= 0 && (int64_t)room > end - from) room = (size_t)(end - from);
    do {
        got = from >= 0 ? pread(fd, to, room, (off_t)from) : read(fd, to, room);
    } while (got < 0 && errno == EINTR);
    if (got < 0) {
        const schuler_place place = { r->layout->path, 0, 0, 0 };
        schuler_fail(&r->rows->error, SCHULER_ERR_FILE, &place, "cannot be read: %s",
                     strerror(errno));
    }
    return got;
}

void recording_rows_read(recording_rows *rows, const recording_layout *layout, int fd,
                         const char *head, size_t head_length, int64_t from, int64_t to,
                         const schuler_recording_options *options, int show_progress)
{
    const reader r = { rows, layout };
    const int64_t start = from;
    char *const buffer = malloc(BUFFER + RECORDING_LINE_MAX + 2);
    size_t held = head_length;
    rows->status = SCHULER_ERR_MEMORY;
    if (!buffer) {
        schuler_fail(&rows->error, SCHULER_ERR_MEMORY, NULL, "out of memory");
        return;
    }
    if (held) memcpy(buffer, head, held);
    for (rows->status = SCHULER_OK; rows->status == SCHULER_OK;) {
        const ssize_t got = fetch(&r, fd, buffer + held, BUFFER, from, to);
        if (got < 0) rows->status = SCHULER_ERR_FILE;
        if (options->stop && *options->stop)
            rows->status = schuler_fail(&rows->error, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
        if (rows->status != SCHULER_OK) break;
        if (from >= 0) from += got;
        held += (size_t)got;
        if (got == 0 && held > 0 && buffer[held - 1] != '\n')
            buffer[held++] = '\n'; /* a last line without its end */
        const char *const last = memrchr(buffer, '\n', held);
        const size_t whole = last ? (size_t)(last - buffer) + 1 : 0;
        rows->status = read_lines(&r, buffer, buffer + whole);
        held -= whole;
        if (rows->status == SCHULER_OK && held > RECORDING_LINE_MAX) {
            const schuler_place place = { layout->path, rows->lines + 1, 0, 0 };
            rows->status = schuler_fail(&rows->error, SCHULER_ERR_INPUT, &place,
                                        "a line longer than %d bytes", RECORDING_LINE_MAX);
        }
        memmove(buffer, buffer + whole, held);
        if (got == 0) break;
        if (show_progress && options->progress && to > start)
            options->progress(options->user, (double)(from - start) / (double)(to - start));
    }
    free(buffer);
}

void recording_rows_free(recording_rows *rows)
{
    for (int i = 0; i < SCHULER_RECORDING_COLUMNS_MAX; i++) free(rows->values[i]);
    *rows = (recording_rows){ .n = 0 };
}

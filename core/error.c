/* SPDX-License-Identifier: MIT */
#include "core/error.h"
#include "core/utf8.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct schuler_name {
    struct schuler_name *next;
    char text[];
};

/* Messages quote the input, which may hold anything: keep the terminal safe from it. A message that
 * was cut by snprintf may end inside a character. */
static void clean(char *text)
{
    const size_t n = strlen(text);
    for (size_t i = 0; i < n;) {
        const size_t length = schuler_utf8_length(text + i, n - i);
        const unsigned point = length > 0 ? schuler_utf8_point(text + i, length) : 0;
        const int control = point < 0x20 || (point >= 0x7f && point < 0xa0);
        if (control) memset(text + i, point == '\t' || point == '\n' ? ' ' : '?', 1 + (length > 1));
        i += length > 0 ? length : 1;
    }
}

static void fill(schuler_error *err, schuler_status status, const schuler_place *place,
                 const char *format, va_list args)
{
    memset(err, 0, sizeof *err);
    err->status = status;
    if (place) err->place = *place;
    const int n = vsnprintf(err->message, sizeof err->message, format, args);
    if (n >= (int)sizeof err->message) memcpy(err->message + sizeof err->message - 4, "...", 4);
    clean(err->message);
}

schuler_status schuler_fail(schuler_error *err, schuler_status status, const schuler_place *place,
                            const char *format, ...)
{
    if (!err) return status;
    va_list args;
    va_start(args, format);
    fill(err, status, place, format, args);
    va_end(args);
    return status;
}

/* A copy of the name that lives as long as the diagnostics; NULL when there is none or no memory.
 */
static const char *keep_name(schuler_diagnostics *d, const char *file)
{
    if (!file) return NULL;
    for (const struct schuler_name *name = d->names; name; name = name->next)
        if (strcmp(name->text, file) == 0) return name->text;
    const size_t size = strlen(file) + 1;
    struct schuler_name *name = malloc(sizeof *name + size);
    if (!name) return NULL;
    memcpy(name->text, file, size);
    name->next = d->names;
    d->names = name;
    return name->text;
}

/* The next free entry, or NULL when the list is full or memory is out. */
static schuler_error *append(schuler_diagnostics *d)
{
    if (d->kept >= SCHULER_DIAGNOSTICS_MAX) return NULL;
    if ((d->kept & (d->kept - 1)) == 0) { /* 0, 1, 2, 4, ...: full, so double */
        const size_t capacity = d->kept > 0 ? 2 * d->kept : 1;
        schuler_error *items = realloc(d->items, capacity * sizeof *items);
        if (!items) return NULL;
        d->items = items;
    }
    return &d->items[d->kept++];
}

static void add(schuler_diagnostics *d, schuler_status status, const schuler_place *place,
                const char *format, va_list args)
{
    schuler_error *item = append(d);
    if (!item) return;
    fill(item, status, place, format, args);
    item->place.file = keep_name(d, item->place.file);
}

void schuler_diagnose(schuler_diagnostics *d, schuler_status status, const schuler_place *place,
                      const char *format, ...)
{
    va_list args;
    va_start(args, format);
    add(d, status, place, format, args);
    va_end(args);
    d->errors++;
}

void schuler_warn(schuler_diagnostics *d, const schuler_place *place, const char *format, ...)
{
    const size_t kept = d->kept;
    va_list args;
    va_start(args, format);
    add(d, SCHULER_OK, place, format, args);
    va_end(args);
    if (d->kept > kept) d->items[kept].is_warning = 1;
    d->warnings++;
}

void schuler_diagnose_error(schuler_diagnostics *d, const schuler_error *error)
{
    schuler_error *const item = append(d);
    d->errors++;
    if (!item) return;
    *item = *error;
    item->place.file = keep_name(d, item->place.file);
}

void schuler_diagnostics_free(schuler_diagnostics *d)
{
    while (d->names) {
        struct schuler_name *next = d->names->next;
        free(d->names);
        d->names = next;
    }
    free(d->items);
    memset(d, 0, sizeof *d);
}

enum { NEAREST_MAX = 64 };

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* Edit distance where swapped neighbours count once (optimal string alignment), the commonest slip
 * of the fingers. Both lengths at most NEAREST_MAX. */
static int distance(const char *a, int a_length, const char *b, int b_length)
{
    int rows[3][NEAREST_MAX + 1];
    int *before = rows[0], *last = rows[1], *row = rows[2];
    for (int j = 0; j <= b_length; j++) last[j] = j;
    for (int i = 1; i <= a_length; i++) {
        row[0] = i;
        for (int j = 1; j <= b_length; j++) {
            row[j] =
                smaller(last[j - 1] + (a[i - 1] != b[j - 1]), smaller(last[j] + 1, row[j - 1] + 1));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = smaller(row[j], before[j - 2] + 1);
        }
        int *free_row = before;
        before = last;
        last = row;
        row = free_row;
    }
    return last[b_length];
}

const char *schuler_nearest(const char *written, const char *const *known, size_t count)
{
    const size_t length = strlen(written);
    if (length == 0 || length > NEAREST_MAX) return NULL;
    const char *best = NULL;
    int best_distance = smaller((int)length - 1, length / 3 > 2 ? (int)length / 3 : 2) + 1;
    for (size_t i = 0; i < count; i++) {
        const size_t known_length = strlen(known[i]);
        if (known_length > NEAREST_MAX) continue;
        const int d = distance(written, (int)length, known[i], (int)known_length);
        if (d >= best_distance) continue;
        best_distance = d;
        best = known[i];
    }
    return best;
}

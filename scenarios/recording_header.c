/* SPDX-License-Identifier: MIT */
/* What the header of a recording and the option of its columns say. */
#include "core/units.h"
#include "scenarios/decimal.h"
#include "scenarios/recording_private.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Units as column names spell them. */
static const struct {
    const char *suffix, *unit;
} suffixes[] = {
    { "radps", "rad/s" },   { "degps", "deg/s" }, { "dps", "deg/s" }, { "degph", "deg/h" },
    { "dph", "deg/h" },     { "mps2", "m/s^2" },  { "g", "g" },       { "mg", "mg" },
    { "ug", "ug" },         { "rad", "rad" },     { "urad", "urad" }, { "deg", "deg" },
    { "arcsec", "arcsec" }, { "mps", "m/s" },     { "s", "s" },       { "ms", "ms" },
    { "us", "us" },         { "ns", "1e-9 s" },
};

typedef struct {
    const char *name; /* trimmed, in text */
    int length, offset;
} field;

/* For messages: %.*s. */
#define SHOWN(f) ((f)->length < 60 ? (f)->length : 60), (f)->name

typedef struct {
    const char *text;
    int line, count;
    field fields[RECORDING_FIELDS_MAX];
    const recording_layout *layout;
} header;

__attribute__((format(printf, 4, 5))) static schuler_status
fail(const header *h, const field *f, schuler_error *err, const char *format, ...)
{
    char message[SCHULER_MESSAGE_MAX];
    const schuler_place place = { h->layout->path, h->line, f ? f->offset + 1 : 0,
                                  f ? f->length : 0 };
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    schuler_fail(err, SCHULER_ERR_INPUT, &place, "%s", message);
    if (err) snprintf(err->excerpt, sizeof err->excerpt, "%.*s", SCHULER_EXCERPT_MAX - 1, h->text);
    return SCHULER_ERR_INPUT;
}

static field trimmed(const char *text, int from, int to)
{
    while (from < to && strchr(" \t\"", text[from])) from++;
    while (to > from && strchr(" \t\"", text[to - 1])) to--;
    return (field){ text + from, to - from, from };
}

static int same(const field *f, const char *name)
{
    return (int)strlen(name) == f->length && strncmp(f->name, name, (size_t)f->length) == 0;
}

static schuler_status split(header *h, schuler_error *err)
{
    const int start = strncmp(h->text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    const int length = (int)strlen(h->text);
    int numbers = 0;
    for (int from = start; from <= length;) {
        const int to = from + (int)strcspn(h->text + from, ",");
        if (h->count == RECORDING_FIELDS_MAX)
            return fail(h, NULL, err, "more than %d columns", RECORDING_FIELDS_MAX);
        field *const f = &h->fields[h->count++];
        *f = trimmed(h->text, from, to);
        double ignored;
        const char *end = schuler_decimal_read(f->name, h->layout->c_locale, &ignored);
        numbers += f->length > 0 && end == f->name + f->length;
        from = to + 1;
    }
    if (numbers == h->count)
        return fail(h, &h->fields[0], err,
                    "'%.*s' is a number: the first line must name the columns, such as "
                    "time_s,gx_radps,gy_radps,gz_radps",
                    SHOWN(&h->fields[0]));
    if (h->count == 1 && strpbrk(h->text, ";\t"))
        return fail(h, NULL, err, "columns must be separated by commas");
    for (int i = 0; i < h->count; i++)
        for (int k = 0; k < i; k++)
            if (h->fields[i].length > 0 && h->fields[i].length == h->fields[k].length &&
                strncmp(h->fields[i].name, h->fields[k].name, (size_t)h->fields[i].length) == 0)
                return fail(h, &h->fields[i], err, "there are two columns '%.*s'",
                            SHOWN(&h->fields[i]));
    return SCHULER_OK;
}

/* The unit at the end of a name, or NULL. */
static const char *unit_of(const field *f)
{
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++) {
        const int n = (int)strlen(suffixes[i].suffix);
        if (f->length > n + 1 && f->name[f->length - n - 1] == '_' &&
            strncmp(f->name + f->length - n, suffixes[i].suffix, (size_t)n) == 0)
            return suffixes[i].unit;
    }
    return NULL;
}

static double seconds_of(const field *f)
{
    static const char *const stems[] = { "time_", "t_", "timestamp_", "tow_" };
    const char *const unit = unit_of(f);
    if (!unit || !strchr("smun1", unit[0]) || unit[strlen(unit) - 1] != 's') return 0.0;
    for (size_t i = 0; i < sizeof stems / sizeof stems[0]; i++) {
        const size_t n = strlen(stems[i]);
        if ((size_t)f->length <= n || strncasecmp(f->name, stems[i], n) != 0) continue;
        if (strchr(f->name, '_') != f->name + n - 1) continue;
        if (memchr(f->name + n, '_', (size_t)f->length - n)) continue;
        return strcmp(unit, "s") == 0 ? 1.0 : unit[0] == 'm' ? 1e-3 : unit[0] == 'u' ? 1e-6 : 1e-9;
    }
    return 0.0;
}

static int dim_is(schuler_dim dim, schuler_dim wanted)
{
    return schuler_dim_equal(dim, wanted);
}

/* Given: unit text. Returned: 1 when it is one of the four dimensions of an IMU. */
static int meaning(schuler_dim dim, schuler_recording_column *c)
{
    const int angle = dim_is(dim, (schuler_dim)SCHULER_DIM_ANGLE);
    const int speed = dim_is(dim, (schuler_dim)SCHULER_DIM_SPEED);
    const int rate = dim_is(dim, (schuler_dim)SCHULER_DIM_RATE);
    c->instrument = angle || rate ? SCHULER_GYRO : SCHULER_ACCEL;
    c->increments = angle || speed;
    return angle || speed || rate || dim_is(dim, (schuler_dim)SCHULER_DIM_ACCEL);
}

static schuler_status wrong_kind(const header *h, const field *f, const char *unit,
                                 const schuler_recording_column *c,
                                 const schuler_recording_options *o, schuler_error *err)
{
    if (o->kind == SCHULER_DATA_INCREMENTS && !c->increments)
        return fail(h, f, err, "'%.*s' is in %s, which is no increment", SHOWN(f), unit);
    if (o->kind == SCHULER_DATA_RATES && c->increments)
        return fail(h, f, err, "'%.*s' is in %s, which is an increment, no rate", SHOWN(f), unit);
    if (o->only_instrument && c->instrument != o->instrument)
        return fail(h, f, err, "'%.*s' is in %s, which is no unit of %s", SHOWN(f), unit,
                    o->instrument == SCHULER_GYRO ? "a gyro" : "an accelerometer");
    return SCHULER_OK;
}

/* Takes a field as the next column. strict: it was asked for by name, so it must fit. */
static schuler_status take(const header *h, int index, const char *unit, int strict,
                           recording_layout *layout, schuler_recording *r,
                           const schuler_recording_options *o, schuler_error *err)
{
    const field *const f = &h->fields[index];
    schuler_dim dim;
    schuler_error wrong = { 0 };
    double si;
    schuler_recording_column column = { .values = NULL };
    if (schuler_unit_parse(unit, &si, &dim, &wrong) != SCHULER_OK) {
        if (!strict) return SCHULER_OK;
        return fail(h, f, err, "'%.*s': %s", SHOWN(f), wrong.message);
    }
    if (!meaning(dim, &column)) {
        if (!strict) return SCHULER_OK;
        return fail(h, f, err,
                    "'%.*s': '%s' is a unit neither of an angle or angular rate nor of a speed or "
                    "acceleration",
                    SHOWN(f), unit);
    }
    schuler_error kind = { 0 };
    const schuler_status status = wrong_kind(h, f, unit, &column, o, strict ? err : &kind);
    if (status != SCHULER_OK) return strict ? status : SCHULER_OK;
    if (layout->slot[index] >= 0) return fail(h, f, err, "'%.*s' is asked for twice", SHOWN(f));
    if (r->columns == SCHULER_RECORDING_COLUMNS_MAX)
        return fail(h, f, err, "'%.*s': more than %d columns of data", SHOWN(f),
                    SCHULER_RECORDING_COLUMNS_MAX);
    snprintf(column.name, sizeof column.name, "%.*s", f->length, f->name);
    layout->slot[index] = (signed char)r->columns;
    layout->si[r->columns] = si;
    memcpy(layout->name[r->columns], column.name, sizeof column.name);
    r->column[r->columns++] = column;
    return SCHULER_OK;
}

/* An unknown name in --columns; the nearest one of the header is told. */
static schuler_status unknown(const header *h, const char *name, schuler_error *err)
{
    char copies[RECORDING_FIELDS_MAX][SCHULER_COLUMN_NAME_MAX];
    const char *known[RECORDING_FIELDS_MAX];
    for (int i = 0; i < h->count; i++) {
        snprintf(copies[i], sizeof copies[i], "%.*s", h->fields[i].length, h->fields[i].name);
        known[i] = copies[i];
    }
    const char *const nearest = schuler_nearest(name, known, (size_t)h->count);
    const schuler_place place = { h->layout->path, h->line, 0, 0 };
    if (nearest)
        schuler_fail(err, SCHULER_ERR_INPUT, &place,
                     "there is no column '%.60s'; did you mean '%s'?", name, nearest);
    else
        schuler_fail(err, SCHULER_ERR_INPUT, &place,
                     "there is no column '%.60s'; the header has %.200s", name, h->text);
    return SCHULER_ERR_INPUT;
}

/* The words of --columns, one by one; a unit is that of the names since the last one. */
static schuler_status take_named(const header *h, recording_layout *layout, schuler_recording *r,
                                 const schuler_recording_options *o, schuler_error *err)
{
    for (const char *p = o->columns; *p;) {
        const size_t length = strcspn(p, ",");
        const char *const colon = memchr(p, ':', length);
        const field word = trimmed(p, 0, (int)(colon ? (size_t)(colon - p) : length));
        /* The unit: here, or behind one of the next words. */
        const char *const ahead = strchr(p, ':');
        char name[128], unit[64] = "";
        if (ahead) snprintf(unit, sizeof unit, "%.*s", (int)strcspn(ahead + 1, ","), ahead + 1);
        snprintf(name, sizeof name, "%.*s", word.length < 127 ? word.length : 127, word.name);
        int index = 0;
        while (index < h->count && !same(&h->fields[index], name)) index++;
        if (index == h->count) return unknown(h, name, err);
        const char *const own = unit_of(&h->fields[index]);
        if (!unit[0] && !own)
            return fail(h, &h->fields[index], err,
                        "'%.*s' needs a unit, such as deg/s or g: --columns NAME:UNIT",
                        SHOWN(&h->fields[index]));
        const schuler_status status = take(h, index, unit[0] ? unit : own, 1, layout, r, o, err);
        if (status != SCHULER_OK) return status;
        p += length + (p[length] == ',');
    }
    return SCHULER_OK;
}

schuler_status recording_header(recording_layout *layout, schuler_recording *r, const char *line,
                                int number, const schuler_recording_options *options,
                                schuler_error *err)
{
    header h = { .text = line, .line = number, .layout = layout };
    schuler_status status = split(&h, err);
    if (status != SCHULER_OK) return status;
    layout->fields = h.count;
    memset(layout->slot, -1, sizeof layout->slot);
    if (options->columns) status = take_named(&h, layout, r, options, err);
    for (int i = 0; i < h.count && status == SCHULER_OK; i++) {
        const double s = layout->slot[i] < 0 ? seconds_of(&h.fields[i]) : 0.0;
        if (s > 0.0 && !layout->has_time) {
            layout->has_time = 1;
            layout->slot[i] = RECORDING_TIME;
            layout->si[RECORDING_TIME] = s;
            snprintf(layout->name[RECORDING_TIME], SCHULER_COLUMN_NAME_MAX, "%.*s",
                     h.fields[i].length, h.fields[i].name);
        } else if (!options->columns && s == 0.0 && unit_of(&h.fields[i])) {
            status = take(&h, i, unit_of(&h.fields[i]), 0, layout, r, options, err);
        }
    }
    if (status != SCHULER_OK) return status;
    if (r->columns == 0)
        return fail(&h, NULL, err,
                    "no column%s: names must end with a unit, such as gx_radps, ax_mps2 or "
                    "dtheta_x_rad, or be given with --columns NAME:UNIT",
                    options->only_instrument || options->kind ? " of that kind" : " of data");
    if (!layout->has_time && !(options->rate_hz > 0.0))
        return fail(&h, NULL, err,
                    "no column of time (such as time_s): the rate is needed, such as --rate 100Hz");
    return SCHULER_OK;
}

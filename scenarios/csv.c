/* SPDX-License-Identifier: MIT */
#include "scenarios/csv.h"
#include "scenarios/csv_lines.h"
#include "scenarios/decimal.h"
#include "scenarios/netcdf.h"
#include "scenarios/netcdf_rows.h"
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct schuler_csv {
    netcdf_rows *netcdf; /* then all below but the header is idle */
    csv_lines lines;
    const char *path, *header;
    locale_t c_locale; /* numbers have a point, whatever the program's locale */
    int columns;
    char *text; /* the line last read, without its end */
    size_t length;
};

/* What the line holds of a column, without blanks around; empty when there are fewer columns. */
static char *field_of(const schuler_csv *csv, int column, int *width)
{
    char *p = csv->text;
    for (int i = 0; i < column; i++) {
        p += strcspn(p, ",");
        if (*p) p++;
    }
    char *end = p + strcspn(p, ",");
    p += strspn(p, " \t");
    while (end > p && (end[-1] == ' ' || end[-1] == '\t')) end--;
    *width = end > p ? (int)(end - p) : 0;
    return p;
}

static schuler_status fail_at(const schuler_csv *csv, int offset, int width, schuler_error *err,
                              const char *format, va_list arguments)
{
    char message[SCHULER_MESSAGE_MAX];
    vsnprintf(message, sizeof(message), format, arguments);
    const schuler_place place = { csv->path, schuler_csv_line(csv), csv->netcdf ? 0 : offset + 1,
                                  width };
    schuler_fail(err, SCHULER_ERR_INPUT, &place, "%s", message);
    if (err && !csv->netcdf)
        snprintf(err->excerpt, sizeof(err->excerpt), "%.*s", SCHULER_EXCERPT_MAX - 1, csv->text);
    return SCHULER_ERR_INPUT;
}

__attribute__((format(printf, 5, 6))) static schuler_status
fail(const schuler_csv *csv, int offset, int width, schuler_error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const schuler_status status = fail_at(csv, offset, width, err, format, arguments);
    va_end(arguments);
    return status;
}

schuler_status schuler_csv_refuse(const schuler_csv *csv, int column, schuler_error *err,
                                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int width = 0;
    const int offset = csv->netcdf ? 0 : (int)(field_of(csv, column, &width) - csv->text);
    const schuler_status status = fail_at(csv, offset, width, err, format, arguments);
    va_end(arguments);
    return status;
}

/* What no line may be; told before anything else that is wrong with it. */
static schuler_status check_line(const schuler_csv *csv, schuler_error *err)
{
    if (memchr(csv->text, '\0', csv->length))
        return fail(csv, 0, 0, err, "a NUL byte: this is not a text file");
    if (csv->length > SCHULER_CSV_LINE_MAX)
        return fail(csv, 0, 0, err, "line longer than %d characters", SCHULER_CSV_LINE_MAX);
    return SCHULER_OK;
}

/* Length of the field that starts at p. */
static int field_length(const char *p)
{
    return (int)strcspn(p, ",");
}

/* Names one by one, so that the message can say which is wrong. */
static schuler_status check_header(schuler_csv *csv, schuler_error *err)
{
    const char *want = csv->header, *have = csv->text;
    if (strncmp(have, "\xEF\xBB\xBF", 3) == 0) have += 3;
    for (csv->columns = 1;; csv->columns++) {
        const int offset = (int)(have - csv->text);
        const int want_length = field_length(want), have_length = field_length(have);
        if (want_length != have_length || strncmp(want, have, (size_t)want_length) != 0)
            return fail(csv, offset, have_length, err,
                        "column %d is '%.*s', but '%.*s' is expected; the header must be %s",
                        csv->columns, have_length < 40 ? have_length : 40, have, want_length, want,
                        csv->header);
        want += want_length;
        have += have_length;
        if (!*want && !*have) return SCHULER_OK;
        if (!*want || !*have)
            return fail(csv, (int)(have - csv->text), 0, err,
                        "too %s columns; the header must be %s", *want ? "few" : "many",
                        csv->header);
        want++;
        have++;
    }
}

schuler_status schuler_csv_open(schuler_csv **out, const char *path, const char *header,
                                schuler_error *err)
{
    const schuler_place place = { path, 0, 0, 0 };
    schuler_status status = SCHULER_ERR_MEMORY;
    schuler_csv *csv = calloc(1, sizeof(*csv));
    if (!csv) goto no_memory;
    csv->lines.fd = -1;
    csv->path = path;
    csv->header = header;
    if (schuler_netcdf_named(path)) {
        status = netcdf_rows_open(&csv->netcdf, path, header, err);
        if (status != SCHULER_OK) goto failed;
        *out = csv;
        return SCHULER_OK;
    }
    csv->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!csv->c_locale) goto no_memory;
    int got;
    status = csv_lines_open(&csv->lines, path, err);
    if (status == SCHULER_OK)
        status = csv_lines_next(&csv->lines, &csv->text, &csv->length, &got, err);
    if (status == SCHULER_OK && !got)
        status = schuler_fail(err, SCHULER_ERR_INPUT, &place, "empty; the first line must be %s",
                              header);
    if (status == SCHULER_OK) status = check_line(csv, err);
    if (status == SCHULER_OK) status = check_header(csv, err);
    if (status != SCHULER_OK) goto failed;
    *out = csv;
    return SCHULER_OK;
no_memory:
    schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
failed:
    schuler_csv_close(csv);
    return status;
}

void schuler_csv_close(schuler_csv *csv)
{
    if (!csv) return;
    netcdf_rows_close(csv->netcdf);
    csv_lines_close(&csv->lines);
    if (csv->c_locale) freelocale(csv->c_locale);
    free(csv);
}

/* A row that is not just numbers and commas: blanks around them are fine, all else is told. */
static schuler_status read_carefully(const schuler_csv *csv, double *values, schuler_error *err)
{
    const schuler_status status = check_line(csv, err);
    if (status != SCHULER_OK) return status;
    const char *p = csv->text;
    for (int i = 0; i < csv->columns; i++) {
        p += field_length(p);
        const int last = i == csv->columns - 1;
        if (last ? *p != '\0' : *p != ',')
            return fail(csv, (int)(p - csv->text), 1, err, "%s than the %d numbers of the header",
                        last ? "more" : "fewer", csv->columns);
        p++;
        int width;
        const char *const text = field_of(csv, i, &width);
        const char *const end = schuler_decimal_read(text, csv->c_locale, &values[i]);
        if (end == text + width && isfinite(values[i])) continue;
        return schuler_csv_refuse(csv, i, err, "'%.*s' is not a %snumber", width < 40 ? width : 40,
                                  text, end == text + width ? "finite " : "");
    }
    return SCHULER_OK;
}

schuler_status schuler_csv_next(schuler_csv *csv, double *values, int *got_row, schuler_error *err)
{
    if (csv->netcdf) return netcdf_rows_next(csv->netcdf, values, got_row, err);
    const schuler_status status =
        csv_lines_next(&csv->lines, &csv->text, &csv->length, got_row, err);
    if (status != SCHULER_OK || !*got_row) return status;
    const char *p = csv->text;
    const char *const end = p + csv->length;
    for (int i = 0;; i++) {
        p = schuler_decimal_read(p, csv->c_locale, &values[i]);
        if (!p || !isfinite(values[i])) break;
        if (i == csv->columns - 1) {
            if (p == end && csv->length <= SCHULER_CSV_LINE_MAX) return SCHULER_OK;
            break;
        }
        if (*p++ != ',') break;
    }
    return read_carefully(csv, values, err);
}

int schuler_csv_line(const schuler_csv *csv)
{
    return csv->netcdf ? netcdf_rows_number(csv->netcdf) : csv->lines.number;
}

double schuler_csv_fraction(const schuler_csv *csv)
{
    if (csv->netcdf) return netcdf_rows_fraction(csv->netcdf);
    if (csv->lines.size_bytes <= 0.0) return 0.0;
    return fmin(csv->lines.read_bytes / csv->lines.size_bytes, 1.0);
}

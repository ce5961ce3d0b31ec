/* SPDX-License-Identifier: MIT */
#include "scenarios/csv.h"
#include "scenarios/decimal.h"
#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { BUFFER = 1 << 18 };

struct schuler_csv {
    FILE *file;
    const char *path, *header;
    locale_t c_locale; /* numbers have a point, whatever the program's locale */
    int columns, line;
    double size_bytes, read_bytes;
    char text[SCHULER_CSV_LINE_MAX + 2];    /* the line last read, without its end      */
    int column_at[SCHULER_CSV_COLUMNS_MAX]; /* offset of each field in it, and its width */
    int column_width[SCHULER_CSV_COLUMNS_MAX];
};

static schuler_status fail_at(const schuler_csv *csv, int offset, int width, schuler_error *err,
                              const char *format, va_list arguments)
{
    char message[SCHULER_MESSAGE_MAX];
    vsnprintf(message, sizeof(message), format, arguments);
    const schuler_place place = { csv->path, csv->line, offset + 1, width };
    schuler_fail(err, SCHULER_ERR_INPUT, &place, "%s", message);
    if (err)
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
    const schuler_status status =
        fail_at(csv, csv->column_at[column], csv->column_width[column], err, format, arguments);
    va_end(arguments);
    return status;
}

/* One line into csv->text; *got = 0 at the end. A last line without its newline counts. */
static schuler_status read_line(schuler_csv *csv, int *got, schuler_error *err)
{
    const schuler_place place = { csv->path, 0, 0, 0 };
    errno = 0;
    csv->text[0] = '\0';
    size_t length = 0;
    int c = EOF;
    while (length < sizeof(csv->text) - 1 && (c = getc_unlocked(csv->file)) != EOF && c != '\n')
        csv->text[length++] = (char)c;
    if (c == EOF && ferror(csv->file))
        return schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be read: %s", strerror(errno));
    *got = length > 0 || c == '\n';
    if (!*got) return SCHULER_OK;
    csv->line++;
    csv->read_bytes += (double)length + 1.0;
    if (length > 0 && csv->text[length - 1] == '\r') length--;
    csv->text[length] = '\0';
    if (memchr(csv->text, '\0', length))
        return fail(csv, 0, 0, err, "a NUL byte: this is not a text file");
    if (length > SCHULER_CSV_LINE_MAX)
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
    csv->path = path;
    csv->header = header;
    csv->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!csv->c_locale) goto no_memory;
    csv->file = fopen(path, "re");
    if (!csv->file) {
        status =
            schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be opened: %s", strerror(errno));
        goto failed;
    }
    setvbuf(csv->file, NULL, _IOFBF, BUFFER);
    struct stat info;
    if (fstat(fileno(csv->file), &info) == 0) csv->size_bytes = (double)info.st_size;
    int got;
    status = read_line(csv, &got, err);
    if (status == SCHULER_OK && !got)
        status = schuler_fail(err, SCHULER_ERR_INPUT, &place, "empty; the first line must be %s",
                              header);
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
    if (csv->file) fclose(csv->file);
    if (csv->c_locale) freelocale(csv->c_locale);
    free(csv);
}

static schuler_status read_number(const schuler_csv *csv, int column, double *value,
                                  schuler_error *err)
{
    const char *text = csv->text + csv->column_at[column];
    const int width = csv->column_width[column];
    const char *const end = schuler_decimal_read(text, csv->c_locale, value);
    if (end == text + width && isfinite(*value)) return SCHULER_OK;
    return schuler_csv_refuse(csv, column, err, "'%.*s' is not a %snumber", width < 40 ? width : 40,
                              text, end == text + width ? "finite " : "");
}

schuler_status schuler_csv_next(schuler_csv *csv, double *values, int *got_row, schuler_error *err)
{
    schuler_status status = read_line(csv, got_row, err);
    if (status != SCHULER_OK || !*got_row) return status;
    const char *p = csv->text;
    for (int i = 0; i < csv->columns; i++) {
        csv->column_at[i] = (int)(p - csv->text) + (int)strspn(p, " \t");
        const char *end = p + field_length(p);
        p = end;
        while (end > csv->text + csv->column_at[i] && (end[-1] == ' ' || end[-1] == '\t')) end--;
        csv->column_width[i] = (int)(end - csv->text) - csv->column_at[i];
        if (csv->column_width[i] < 0) csv->column_width[i] = 0;
        const int last = i == csv->columns - 1;
        if (last ? *p != '\0' : *p != ',')
            return fail(csv, (int)(p - csv->text), 1, err, "%s than the %d numbers of the header",
                        last ? "more" : "fewer", csv->columns);
        p++;
        status = read_number(csv, i, &values[i], err);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

double schuler_csv_fraction(const schuler_csv *csv)
{
    if (csv->size_bytes <= 0.0) return 0.0;
    return fmin(csv->read_bytes / csv->size_bytes, 1.0);
}

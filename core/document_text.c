/* SPDX-License-Identifier: MIT */
/* The text of a document: its bytes, what may be in it, its lines. */
#include "core/document_private.h"
#include "core/utf8.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static schuler_status unreadable(const char *path, schuler_status status, const char *why,
                                 schuler_diagnostics *d)
{
    const schuler_place place = { path, 0, 0, 0 };
    schuler_diagnose(d, status, &place, "cannot read the file: %s", why);
    return status;
}

/* strerror is not thread-safe, so the common reasons are spelled here. */
static const char *reason(int error)
{
    switch (error) {
    case ENOENT:
        return "no such file";
    case EACCES:
        return "permission denied";
    case EISDIR:
        return "it is a directory";
    case ENOTDIR:
        return "a part of its path is not a directory";
    case ENAMETOOLONG:
        return "the name is too long";
    case ELOOP:
        return "too many symbolic links";
    case EMFILE:
    case ENFILE:
        return "too many open files";
    default:
        return "input error";
    }
}

schuler_status schuler_document_read_file(schuler_arena *arena, const char *path, const char **text,
                                          size_t *length, schuler_diagnostics *d)
{
    FILE *file = fopen(path, "rbe");
    if (!file) return unreadable(path, SCHULER_ERR_FILE, reason(errno), d);
    schuler_status rc = SCHULER_OK;
    struct stat status;
    size_t size = 0, room = 0;
    char *bytes = NULL;
    if (fstat(fileno(file), &status) != 0) {
        rc = unreadable(path, SCHULER_ERR_FILE, reason(errno), d);
    } else if (S_ISDIR(status.st_mode)) {
        rc = unreadable(path, SCHULER_ERR_FILE, reason(EISDIR), d);
    } else if (S_ISREG(status.st_mode) && status.st_size > SCHULER_DOCUMENT_BYTES) {
        rc = unreadable(path, SCHULER_ERR_INPUT, "it is larger than 16 MiB", d);
    }
    /* A pipe has no size beforehand, so the memory doubles as it fills. */
    while (rc == SCHULER_OK) {
        if (room - size < 2) {
            const size_t wanted = room > 0 ? 2 * room : 8192;
            char *larger = schuler_arena_alloc(arena, wanted);
            if (!larger) {
                rc = unreadable(path, SCHULER_ERR_MEMORY, "out of memory", d);
                break;
            }
            if (bytes) memcpy(larger, bytes, size);
            bytes = larger;
            room = wanted;
        }
        const size_t got = fread(bytes + size, 1, room - size - 1, file);
        size += got;
        if (size > SCHULER_DOCUMENT_BYTES)
            rc = unreadable(path, SCHULER_ERR_INPUT, "it is larger than 16 MiB", d);
        else if (ferror(file))
            rc = unreadable(path, SCHULER_ERR_FILE, reason(errno), d);
        else if (got == 0)
            break;
    }
    if (fclose(file) != 0 && rc == SCHULER_OK)
        rc = unreadable(path, SCHULER_ERR_FILE, reason(errno), d);
    if (rc != SCHULER_OK) return rc;
    bytes[size] = '\0';
    *text = bytes;
    *length = size;
    return SCHULER_OK;
}

/* Bytes of the line break at text, 0 when there is none: YAML 1.1 knows five kinds. */
static size_t line_break(const char *text, size_t n)
{
    if (n == 0 || (text[0] >= ' ' && text[0] < 0x7f)) return 0;
    if (text[0] == '\r') return n > 1 && text[1] == '\n' ? 2 : 1;
    if (text[0] == '\n') return 1;
    if (n > 1 && memcmp(text, "\xc2\x85", 2) == 0) return 2;
    if (n > 2 && (memcmp(text, "\xe2\x80\xa8", 3) == 0 || memcmp(text, "\xe2\x80\xa9", 3) == 0))
        return 3;
    return 0;
}

const char *schuler_document_line(const char *text, size_t length, int line, size_t *line_length)
{
    size_t start = 0, i = 0;
    for (int number = 1;; number++) {
        while (i < length && line_break(text + i, length - i) == 0) i++;
        if (number == line) {
            *line_length = i - start;
            return text + start;
        }
        if (i >= length) return NULL;
        i += line_break(text + i, length - i);
        start = i;
    }
}

static bool is_allowed(unsigned point)
{
    return point == '\t' || point == '\n' || point == '\r' || point == 0x85 ||
           (point >= 0x20 && point < 0x7f) ||
           (point >= 0xa0 && point != 0xfeff && point != 0xfffe && point != 0xffff);
}

bool schuler_document_text_is_clean(const char *name, const char *text, size_t length,
                                    schuler_diagnostics *d)
{
    schuler_place place = { name, 1, 1, 1 };
    for (size_t i = 0; i < length;) {
        const size_t n = schuler_utf8_length(text + i, length - i);
        const unsigned point = n > 0 ? schuler_utf8_point(text + i, n) : 0;
        if (n == 0) {
            schuler_diagnose(d, SCHULER_ERR_INPUT, &place,
                             "byte 0x%02x is not valid UTF-8; is this a text file?",
                             (unsigned)(unsigned char)text[i]);
            return false;
        }
        if (!is_allowed(point)) {
            schuler_diagnose(d, SCHULER_ERR_INPUT, &place,
                             "control character U+%04X; is this a text file?", point);
            return false;
        }
        const size_t break_length = line_break(text + i, length - i);
        if (break_length > 0) {
            place.line++;
            place.column = 1;
            i += break_length;
        } else {
            place.column++;
            i += n;
        }
    }
    return true;
}

/* Copy a line to fit the excerpt, with the place in sight; returns the column of the place within
 * it. A tab counts as one column, so it is shown as one space. */
static int cut_line(char *out, const char *line, size_t length, int column)
{
    enum { BEFORE = 60 };
    size_t from = 0;
    int shift = 0;
    if (length >= SCHULER_EXCERPT_MAX && column > BEFORE) {
        while (from < length && shift < column - BEFORE) {
            from += schuler_utf8_length(line + from, length - from);
            shift++;
        }
    }
    size_t used = 0;
    while (from < length) {
        const size_t n = schuler_utf8_length(line + from, length - from);
        if (n == 0 || used + n >= SCHULER_EXCERPT_MAX) break;
        memcpy(out + used, line + from, n);
        if (n == 1 && ((unsigned char)out[used] < 0x20 || out[used] == 0x7f)) out[used] = ' ';
        used += n;
        from += n;
    }
    out[used] = '\0';
    return column - shift;
}

void schuler_document_excerpts(const schuler_document *doc, schuler_diagnostics *d)
{
    const size_t mark = doc->length >= 3 && memcmp(doc->text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    for (size_t i = 0; i < d->kept; i++) {
        schuler_error *item = &d->items[i];
        if (item->excerpt[0] != '\0' || item->place.line < 1 || !item->place.file ||
            strcmp(item->place.file, doc->name) != 0)
            continue;
        size_t length;
        const char *line =
            schuler_document_line(doc->text + mark, doc->length - mark, item->place.line, &length);
        if (line) item->excerpt_column = cut_line(item->excerpt, line, length, item->place.column);
    }
}

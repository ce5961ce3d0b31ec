/* SPDX-License-Identifier: MIT */
#include "scenarios/csv_lines.h"
#include "scenarios/csv.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Small enough to stay in the second-level cache, large enough that calls do not count. */
enum { BLOCK = 1 << 18, KEPT_MAX = SCHULER_CSV_LINE_MAX + 2 };

schuler_status csv_lines_open(csv_lines *lines, const char *path, schuler_error *err)
{
    const schuler_place place = { path, 0, 0, 0 };
    *lines = (csv_lines){ .path = path, .fd = -1 };
    lines->block = malloc(KEPT_MAX + BLOCK + 1);
    if (!lines->block) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    lines->fd = open(path, O_RDONLY | O_CLOEXEC);
    if (lines->fd < 0)
        return schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be opened: %s", strerror(errno));
    struct stat info;
    if (fstat(lines->fd, &info) == 0) lines->size_bytes = (double)info.st_size;
    return SCHULER_OK;
}

void csv_lines_close(csv_lines *lines)
{
    if (lines->block && lines->fd >= 0) close(lines->fd);
    free(lines->block);
    *lines = (csv_lines){ .fd = -1 };
}

/* The begun line to the front, and more behind it. */
static schuler_status fetch(csv_lines *lines, schuler_error *err)
{
    const size_t held = lines->end - lines->begin;
    memmove(lines->block, lines->block + lines->begin, held);
    lines->begin = 0;
    lines->end = held;
    ssize_t got;
    do {
        got = read(lines->fd, lines->block + held, BLOCK);
    } while (got < 0 && errno == EINTR);
    if (got < 0) {
        const schuler_place place = { lines->path, 0, 0, 0 };
        return schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be read: %s", strerror(errno));
    }
    lines->end += (size_t)got;
    lines->is_whole = got == 0;
    return SCHULER_OK;
}

schuler_status csv_lines_next(csv_lines *lines, char **text, size_t *length, int *got,
                              schuler_error *err)
{
    size_t searched = 0;
    for (;;) {
        char *const start = lines->block + lines->begin;
        const size_t held = lines->end - lines->begin;
        const char *const newline = memchr(start + searched, '\n', held - searched);
        size_t taken = newline ? (size_t)(newline - start) : held;
        if (newline || lines->is_whole || taken >= KEPT_MAX) {
            *got = newline || taken > 0;
            if (taken > KEPT_MAX - 1) taken = KEPT_MAX - 1;
            *text = start;
            *length = taken;
            if (!*got) return SCHULER_OK;
            lines->number++;
            lines->begin += taken + (newline == start + taken);
            lines->read_bytes += (double)taken + 1.0;
            if (taken > 0 && start[taken - 1] == '\r') --*length;
            start[*length] = '\0';
            return SCHULER_OK;
        }
        searched = held;
        const schuler_status status = fetch(lines, err);
        if (status != SCHULER_OK) return status;
    }
}

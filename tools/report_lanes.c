/* SPDX-License-Identifier: MIT */
#include "tools/report_lanes.h"
#include "tools/messages.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char header[] =
    "source,run,time_s,north_m,east_m,down_m,vn_mps,ve_mps,vd_mps,roll_arcsec,pitch_arcsec,"
    "heading_arcsec\n";
enum { COMMAS = 11 };

static exit_code broken(const report_lanes *l, const char *what)
{
    return say_bad_input("%s:%zu: %s", l->path, l->line, what);
}

/* The next line; text is "" at the end. A line that is not ended was cut off. */
static exit_code next_line(report_lanes *l)
{
    l->line++;
    errno = 0;
    const ssize_t length = getline(&l->text, &l->room, l->file);
    if (length < 0) {
        if (ferror(l->file)) return say_bad_input("cannot read %s: %s", l->path, strerror(errno));
        if (!l->text) return say_bad_input("%s: the file is empty", l->path);
        l->text[0] = '\0';
        return EXIT_DONE;
    }
    if (l->text[length - 1] != '\n') return broken(l, "cut off in the middle of a row");
    return EXIT_DONE;
}

static void set_prefix(report_lanes *l, const char *id, int run)
{
    snprintf(l->prefix, sizeof(l->prefix), "%.64s,%d,", id, run);
}

static const char *after_prefix(const report_lanes *l)
{
    const size_t length = strlen(l->prefix);
    return strncmp(l->text, l->prefix, length) == 0 ? l->text + length : NULL;
}

static exit_code add_time(report_lanes *l, const char *text)
{
    if ((l->row_count & (l->row_count - 1)) == 0) {
        char **const grown =
            reallocarray(l->times, l->row_count ? 2 * l->row_count : 1, sizeof(*grown));
        if (!grown) return say_failure("out of memory");
        l->times = grown;
    }
    l->times[l->row_count] = strndup(text, strcspn(text, ",\n"));
    if (!l->times[l->row_count]) return say_failure("out of memory");
    char *end;
    const double t = strtod(l->times[l->row_count++], &end);
    if (*end || end == l->times[l->row_count - 1] || !isfinite(t))
        return broken(l, "time_s is not a number");
    if (l->row_count > 1 && !(t > strtod(l->times[l->row_count - 2], NULL)))
        return broken(l, "time_s does not increase");
    return EXIT_DONE;
}

exit_code report_lanes_open(report_lanes *l, const char *path, const char *id)
{
    *l = (report_lanes){ .path = path, .file = fopen(path, "re") };
    if (!l->file) return say_bad_input("cannot read %s: %s", path, strerror(errno));
    exit_code code = next_line(l);
    if (code != EXIT_DONE) return code;
    if (strcmp(l->text, header) != 0) return broken(l, "not the head of an errors.csv");
    set_prefix(l, id, 0);
    const char *rest;
    while ((code = next_line(l)) == EXIT_DONE && (rest = after_prefix(l)))
        if ((code = add_time(l, rest)) != EXIT_DONE) break;
    if (code != EXIT_DONE) return code;
    if (l->row_count < 2)
        return say_bad_input("%s:2: rows of %.64s, run 0 were expected", path, id);
    rewind(l->file);
    l->line = 0;
    for (int i = 0; i < 2 && code == EXIT_DONE; i++) code = next_line(l);
    return code;
}

/* north_m and east_m of the row that was read; the others are counted. */
static exit_code take_numbers(const report_lanes *l, const char *p, double *north_m, double *east_m)
{
    int commas = 0;
    for (const char *c = l->text; *c; c++) commas += *c == ',';
    if (commas != COMMAS) return broken(l, "not as many columns as the head has");
    char *end;
    *north_m = strtod(p, &end);
    if (end == p || *end != ',' || !isfinite(*north_m)) return broken(l, "north_m is not a number");
    p = end + 1;
    *east_m = strtod(p, &end);
    if (end == p || *end != ',' || !isfinite(*east_m)) return broken(l, "east_m is not a number");
    return EXIT_DONE;
}

exit_code report_lanes_read(report_lanes *l, const char *id, int run, const size_t *keep,
                            size_t count, double *north_m, double *east_m)
{
    set_prefix(l, id, run);
    size_t kept = 0;
    for (size_t k = 0; k < l->row_count; k++) {
        const char *rest = after_prefix(l);
        if (!rest)
            return say_bad_input("%s:%zu: row %zu of %zu of %.64s, run %d was expected%s", l->path,
                                 l->line, k + 1, l->row_count, id, run,
                                 l->text[0] ? "" : "; the file was cut off");
        const size_t length = strlen(l->times[k]);
        if (strncmp(rest, l->times[k], length) != 0 || rest[length] != ',')
            return broken(l, "time_s is not that of the same row of the first run");
        exit_code code = EXIT_DONE;
        if (kept < count && keep[kept] == k) {
            code = take_numbers(l, rest + length + 1, &north_m[kept], &east_m[kept]);
            kept++;
        }
        if (code == EXIT_DONE) code = next_line(l);
        if (code != EXIT_DONE) return code;
    }
    return EXIT_DONE;
}

int report_lanes_next_is(report_lanes *l, const char *id, int run)
{
    set_prefix(l, id, run);
    return after_prefix(l) != NULL;
}

exit_code report_lanes_end(report_lanes *l)
{
    return l->text[0] ? broken(l, "a row that the budget of result.json has not") : EXIT_DONE;
}

void report_lanes_close(report_lanes *l)
{
    if (l->file) fclose(l->file);
    for (size_t i = 0; i < l->row_count; i++) free(l->times[i]);
    free(l->times);
    free(l->text);
    *l = (report_lanes){ 0 };
}

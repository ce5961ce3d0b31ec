/* SPDX-License-Identifier: MIT */
#include "tools/terminal.h"
#include "core/utf8.h"
#include <langinfo.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void terminal_start(void)
{
    setlocale(LC_CTYPE, "");
}

bool terminal_utf8(void)
{
    return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

static bool coloured(FILE *stream)
{
    const char *no_colour = getenv("NO_COLOR"), *term = getenv("TERM");
    if (no_colour && *no_colour) return false;
    return isatty(fileno(stream)) && term && strcmp(term, "dumb") != 0;
}

const char *terminal_colour(FILE *stream, colour which)
{
    static const char *const codes[] = { "", "\033[1m", "\033[1;31m", "\033[1;32m", "\033[1;33m" };
    return coloured(stream) ? codes[which] : "";
}

const char *terminal_plain(FILE *stream)
{
    return coloured(stream) ? "\033[0m" : "";
}

int terminal_width(const char *text)
{
    return schuler_utf8_count(text, strlen(text));
}

size_t terminal_fit(const char *text, int columns)
{
    const size_t n = strlen(text);
    size_t at = 0;
    while (at < n && columns > 0) {
        const size_t length = schuler_utf8_length(text + at, n - at);
        at += length ? length : 1;
        columns--;
    }
    return at;
}

/* Same number of columns where that is possible, so that tables stay in line. */
static const char *in_ascii(unsigned point)
{
    switch (point) {
    case 0x00b0:
        return "deg"; /* degree sign        */
    case 0x00b1:
        return "+-"; /* plus-minus         */
    case 0x00b2:
        return "^2";
    case 0x00b5: /* micro sign, Greek mu */
    case 0x03bc:
        return "u";
    case 0x00b7:
        return "*";
    case 0x2013: /* dashes             */
    case 0x2014:
    case 0x2212:
        return "-";
    case 0x2018:
    case 0x2019:
        return "'";
    case 0x201c:
    case 0x201d:
        return "\"";
    case 0x2026:
        return ".";
    case 0x2588:
        return "#"; /* full block         */
    case 0x2591:
        return "."; /* light shade        */
    case 0x03c3:
        return "sigma";
    case 0x00d7:
        return "x";
    default:
        return point >= 0x2589 && point <= 0x258f ? "" : "?";
    }
}

char *terminal_text(const char *text)
{
    if (terminal_utf8()) return strdup(text);
    const size_t n = strlen(text);
    char *const out = malloc(3 * n + 1); /* the longest replacement has three bytes for two */
    if (!out) return NULL;
    char *p = out;
    for (size_t at = 0; at < n;) {
        const size_t length = schuler_utf8_length(text + at, n - at);
        if (length <= 1) {
            *p++ = length == 1 ? text[at] : '?';
            at++;
            continue;
        }
        p = stpcpy(p, in_ascii(schuler_utf8_point(text + at, length)));
        at += length;
    }
    *p = '\0';
    return out;
}

static double seconds_since(const struct timespec *start)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - start->tv_sec) + 1e-9 * (double)(now.tv_nsec - start->tv_nsec);
}

progress progress_start(bool quiet)
{
    progress p = { .wanted = !quiet && isatty(STDERR_FILENO) };
    clock_gettime(CLOCK_MONOTONIC, &p.start);
    return p;
}

void progress_show(progress *p, double fraction)
{
    enum { BAR = 24 };
    if (!p->wanted || !(fraction >= 0.0 && fraction <= 1.0)) return;
    const char *full = terminal_utf8() ? "█" : "#", *empty = terminal_utf8() ? "░" : ".";
    const double elapsed_s = seconds_since(&p->start);
    fputs("\r  ", stderr);
    for (int i = 0; i < BAR; i++) fputs(i < (int)(fraction * BAR + 0.5) ? full : empty, stderr);
    fprintf(stderr, "  %3.0f %%", 100.0 * fraction);
    if (fraction > 0.01) {
        const long left_s = (long)(elapsed_s * (1.0 - fraction) / fraction + 0.5);
        if (left_s >= 3600)
            fprintf(stderr, "   %ld:%02ld:%02ld left", left_s / 3600, left_s / 60 % 60,
                    left_s % 60);
        else
            fprintf(stderr, "   %ld:%02ld left", left_s / 60, left_s % 60);
    }
    if (p->note && *p->note) fprintf(stderr, "   %s", p->note);
    fputs("\033[K", stderr);
    fflush(stderr);
    p->shown = true;
}

void progress_end(progress *p)
{
    if (!p->shown) return;
    fputs("\r\033[K", stderr);
    fflush(stderr);
    p->shown = false;
}

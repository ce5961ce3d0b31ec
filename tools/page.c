/* SPDX-License-Identifier: MIT */
#include "tools/page.h"
#include "tools/messages.h"
#include "tools/terminal.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void page_open(page *p)
{
    *p = (page){ 0 };
    p->out = open_memstream(&p->text, &p->length);
}

void page_drop(page *p)
{
    if (p->out) fclose(p->out);
    free(p->text);
    *p = (page){ 0 };
}

exit_code page_show(page *p)
{
    if (!p->out || fflush(p->out) != 0) {
        page_drop(p);
        return say_failure("out of memory");
    }
    char *text = terminal_text(p->text);
    page_drop(p);
    if (!text) return say_failure("out of memory");
    const int failed = fputs(text, stdout) == EOF || fflush(stdout) == EOF;
    const int reason = errno;
    free(text);
    if (!failed) return EXIT_DONE;
    return say_unwritable(reason);
}

void page_cell(FILE *out, const char *text, int columns)
{
    char *shown = terminal_text(text); /* as wide as it will be */
    const int width = shown ? terminal_width(shown) : 0;
    if (width <= columns)
        fprintf(out, "%s%*s", shown ? shown : "", columns - width, "");
    else
        fprintf(out, "%.*s…", (int)terminal_fit(shown, columns - 1), shown);
    free(shown);
}

void page_wrap(FILE *out, const char *text, int at, int indent)
{
    enum { WIDTH = 80 };
    int start_of_line = 1;
    while (*text) {
        text += strspn(text, " \n\t");
        const size_t bytes = strcspn(text, " \n\t");
        if (!bytes) break;
        char *word = strndup(text, bytes);
        if (!word) return;
        const int width = terminal_width(word);
        if (!start_of_line && at + 1 + width > WIDTH) {
            fprintf(out, "\n%*s", indent, "");
            at = indent;
            start_of_line = 1;
        }
        fprintf(out, "%s%s", start_of_line ? "" : " ", word);
        at += width + !start_of_line;
        start_of_line = 0;
        free(word);
        text += bytes;
    }
    fputc('\n', out);
}

void page_rule(FILE *out)
{
    fputs("  ", out);
    for (int i = 0; i < 78; i++) fputc('-', out);
    fputc('\n', out);
}

void page_duration(FILE *out, double seconds)
{
    const double ms = nearbyint(seconds * 1000.0);
    const long long whole_s = (long long)(ms / 1000.0);
    const int rest_ms = (int)(ms - 1000.0 * (double)whole_s);
    fprintf(out, "%lld:%02lld:%02lld", whole_s / 3600, whole_s / 60 % 60, whole_s % 60);
    if (rest_ms) fprintf(out, ".%03d", rest_ms);
}

/* SPDX-License-Identifier: MIT */
#include "tools/messages.h"
#include "tools/terminal.h"
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

exit_code exit_of(schuler_status status)
{
    switch (status) {
    case SCHULER_OK:
        return EXIT_DONE;
    case SCHULER_ERR_INPUT:
    case SCHULER_ERR_GRAVITY_DATA:
        return EXIT_INPUT; /* names a model that is not there */
    case SCHULER_ERR_INTERRUPTED:
        return EXIT_INTERRUPTED;
    case SCHULER_ERR_NUMERIC:
    case SCHULER_ERR_MEMORY:
    case SCHULER_ERR_FILE:
        break;
    }
    return EXIT_FAILED;
}

/* Text from files and the command line, shown without control characters: they could fake output.
 */
static void put_text(const char *text)
{
    char *shown = terminal_text(text);
    for (char *p = shown; p && *p; p++)
        if ((unsigned char)*p < ' ' || *p == 0x7f) *p = *p == '\t' ? ' ' : '?';
    fputs(shown ? shown : "", stderr);
    free(shown);
}

static void put_kind(bool is_warning)
{
    fprintf(stderr, "%s%s:%s ", terminal_colour(stderr, is_warning ? COLOUR_YELLOW : COLOUR_RED),
            is_warning ? "warning" : "error", terminal_plain(stderr));
}

static void put_line(bool is_warning, const char *format, va_list arguments)
{
    char *text = NULL;
    if (vasprintf(&text, format, arguments) < 0) text = NULL;
    fputs("schuler: ", stderr);
    put_kind(is_warning);
    put_text(text ? text : "out of memory");
    fputc('\n', stderr);
    free(text);
}

exit_code say_failure(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put_line(false, format, arguments);
    va_end(arguments);
    return EXIT_FAILED;
}

exit_code say_bad_input(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put_line(false, format, arguments);
    va_end(arguments);
    return EXIT_INPUT;
}

void say_warning(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put_line(true, format, arguments);
    va_end(arguments);
}

static void put_excerpt(const schuler_error *e)
{
    char number[16];
    snprintf(number, sizeof(number), "%d", e->place.line);
    fprintf(stderr, " %4s | ", number);
    put_text(e->excerpt);
    fputc('\n', stderr);
    const int length = terminal_width(e->excerpt);
    const int column = e->excerpt_column > 0 ? e->excerpt_column : e->place.column;
    if (column < 1 || column > length + 1) return; /* beyond what is shown */
    int tildes = e->place.width - 1;
    if (tildes > length - column) tildes = length - column;
    fprintf(stderr, " %*s | %*s%s^", (int)strlen(number) > 4 ? (int)strlen(number) : 4, "",
            column - 1, "", terminal_colour(stderr, COLOUR_GREEN));
    while (tildes-- > 0) fputc('~', stderr);
    fprintf(stderr, "%s\n", terminal_plain(stderr));
}

void say_error(const schuler_error *e)
{
    const schuler_place *at = &e->place;
    fputs(terminal_colour(stderr, COLOUR_BOLD), stderr);
    put_text(at->file ? at->file : "schuler");
    if (at->line > 0) fprintf(stderr, ":%d", at->line);
    if (at->line > 0 && at->column > 0) fprintf(stderr, ":%d", at->column);
    fprintf(stderr, ":%s ", terminal_plain(stderr));
    put_kind(e->is_warning);
    put_text(e->message);
    fputc('\n', stderr);
    if (e->excerpt[0]) put_excerpt(e);
}

void say_diagnostics(const schuler_diagnostics *d, bool warnings)
{
    size_t errors = 0;
    for (size_t i = 0; i < d->kept; i++) {
        if (d->items[i].is_warning && !warnings) continue;
        errors += !d->items[i].is_warning;
        say_error(&d->items[i]);
    }
    if (d->errors > errors)
        fprintf(stderr, "schuler: %zu more errors are not shown\n", d->errors - errors);
}

exit_code say_unwritable(int reason)
{
    /* `| head` and `>&-` are no news to who wrote them. */
    if (reason == EPIPE || reason == EBADF) return EXIT_FAILED;
    return say_failure("cannot write to standard output: %s", strerror(reason));
}

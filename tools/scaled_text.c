/* SPDX-License-Identifier: MIT */
#include "tools/scaled_text.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void scaled_text(const char *text, double factor, char *out, size_t size)
{
    size_t at = 0;
    char before = ' ';
    while (*text && at + 1 < size) {
        char *end = NULL;
        const int may_start = strchr(" [,(±:", before) != NULL || before == ' ' || before < 0;
        const double number =
            may_start && strchr("+-.0123456789", *text) ? strtod(text, &end) : 0.0;
        /* UTF-8 of the letter sigma */
        if (end && end > text && strncmp(end, "\xcf\x83", 2) != 0) {
            at += (size_t)snprintf(out + at, size - at, "%.3g", number * factor);
            if (at >= size) at = size - 1;
            before = '0';
            text = end;
            continue;
        }
        before = *text;
        out[at++] = *text++;
    }
    out[at] = '\0';
}

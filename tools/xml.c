/* SPDX-License-Identifier: MIT */
#include "tools/xml.h"
#include "core/utf8.h"
#include <string.h>

/* Not the control characters but white space, nor the two that Unicode keeps out of texts (XML 1.0, section
 * 2.2). */
static int is_char(unsigned point)
{
    const int is_space = point == '\t' || point == '\n' || point == '\r';
    return is_space || (point >= 0x20 && point != 0x7f && point != 0xfffe && point != 0xffff);
}

void xml_text(FILE *out, const char *text)
{
    size_t left = text ? strlen(text) : 0;
    while (left > 0) {
        size_t length = schuler_utf8_length(text, left);
        switch (*text) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        case '\'':
            fputs("&#39;", out);
            break;
        default:
            if (length > 0 && is_char(schuler_utf8_point(text, length)))
                fwrite(text, 1, length, out);
            else
                fputc('?', out);
        }
        if (length == 0) length = 1;
        text += length;
        left -= length;
    }
}

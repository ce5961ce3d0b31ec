/* SPDX-License-Identifier: MIT */
/* page.html with its {{words}} filled in. */
#include "tools/report.h"
#include "tools/xml.h"
#include <string.h>

static const schuler_embedded *file_of(const char *name, size_t length)
{
    for (const schuler_embedded *f = schuler_report_files; f->name; f++)
        if (strlen(f->name) == length && strncmp(f->name, name, length) == 0) return f;
    return NULL;
}

static bool put_word(FILE *out, const report_parts *p, const char *word, size_t length)
{
    const schuler_embedded *const file = file_of(word, length);
    char name[24];
    snprintf(name, sizeof(name), "%.*s", (int)length, word);
    const json_t *const scenario = json_object_get(p->result, "scenario");
    const json_t *const value = json_object_get(p->result, name);
    if (file)
        fwrite(file->text, 1, file->length, out);
    else if (strcmp(name, "title") == 0)
        xml_text(out, json_string_value(json_object_get(scenario, "name")));
    else if (strcmp(name, "sha256") == 0)
        xml_text(out, json_string_value(json_object_get(scenario, name)));
    else if (strcmp(name, "scenario") == 0)
        xml_text(out, p->scenario);
    else if (strcmp(name, "result") == 0)
        return report_put_json(out, p->result, 17);
    else if (strcmp(name, "curves") == 0)
        return report_put_json(out, p->curves, 7);
    else if (json_is_integer(value)) /* a seed may have more digits than a script's numbers */
        fprintf(out, "%llu", (unsigned long long)json_integer_value(value));
    else
        xml_text(out, json_string_value(value));
    return true;
}

bool report_page_put(FILE *out, const report_parts *parts)
{
    const char *text = file_of("page", strlen("page"))->text;
    for (const char *open; (open = strstr(text, "{{"));) {
        const char *const close = strstr(open, "}}");
        fwrite(text, 1, (size_t)(open - text), out);
        if (!put_word(out, parts, open + 2, (size_t)(close - open - 2))) return false;
        text = close + 2;
    }
    fputs(text, out);
    return true;
}

/* SPDX-License-Identifier: MIT */
#include "tools/json.h"
#include "core/utf8.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

json_t *json_of_number(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

json_t *json_of_text(const char *text)
{
    if (!text) return json_null();
    json_t *value = json_string(text);
    if (value) return value;
    const size_t n = strlen(text);
    char *clean = strdup(text);
    if (!clean) return NULL;
    for (size_t at = 0; at < n;) {
        const size_t length = schuler_utf8_length(clean + at, n - at);
        if (!length) clean[at] = '?';
        at += length ? length : 1;
    }
    value = json_string(clean);
    free(clean);
    return value;
}

json_t *json_of_error(const schuler_error *e)
{
    return json_pack("{s:s, s:o, s:i, s:i, s:i, s:o}", "severity",
                     e->is_warning ? "warning" : "error", "file", json_of_text(e->place.file),
                     "line", e->place.line, "column", e->place.column, "width", e->place.width,
                     "message", json_of_text(e->message));
}

exit_code json_put(json_t *root, FILE *out)
{
    if (!root) return say_failure("out of memory");
    json_dumpf(root, out,
               JSON_INDENT(2) | JSON_REAL_PRECISION(17)); /* the stream remembers errors */
    fputc('\n', out);
    json_decref(root);
    return EXIT_DONE;
}

exit_code json_write(json_t *root, const char *path)
{
    if (strcmp(path, "-") == 0) {
        exit_code code = json_put(root, stdout);
        if (code == EXIT_DONE && (fflush(stdout) == EOF || ferror(stdout)))
            code = say_unwritable(errno);
        return code;
    }
    outfile file;
    exit_code code = outfile_open(&file, path);
    if (code != EXIT_DONE) {
        json_decref(root);
        return code;
    }
    code = json_put(root, file.file);
    if (code == EXIT_DONE) code = outfile_publish(&file);
    outfile_drop(&file);
    return code;
}

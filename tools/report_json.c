/* SPDX-License-Identifier: MIT */
#include "tools/report.h"

/* In a script element nothing may look like markup. Outside strings JSON has none of these, and
 * inside they may be written so; what is not ASCII jansson escapes already. */
static int put_escaped(const char *text, size_t length, void *user)
{
    FILE *const out = user;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '<' || text[i] == '>' || text[i] == '&')
            fprintf(out, "\\u%04x", (unsigned)text[i]);
        else
            fputc(text[i], out);
    }
    return 0;
}

bool report_put_json(FILE *out, const json_t *root, int digits)
{
    return json_dump_callback(root, put_escaped, out,
                              JSON_COMPACT | JSON_ENSURE_ASCII |
                                  (size_t)JSON_REAL_PRECISION(digits)) == 0;
}

/* Every so many-th, so that no more than `most` are left. */
static json_t *numbers(const double *x, size_t n, size_t most)
{
    json_t *const list = json_array();
    const size_t step = (n + most - 1) / most;
    for (size_t i = 0; i < n; i += step) json_array_append_new(list, json_of_number(x[i]));
    return list;
}

json_t *report_curves_json(const report_curves *c)
{
    const size_t n = c->time_count, runs = (size_t)c->joint_runs;
    json_t *const sources = json_array();
    for (size_t i = 0; i + 2 < c->curve_count; i++)
        json_array_append_new(sources, numbers(c->curves[i].rms_m, n, n));
    return json_pack("{s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i, s:o, s:o, s:o, s:o}", "rows",
                     (json_int_t)c->row_count, "times_s", numbers(c->times_s, n, n), "sources",
                     sources, "all", numbers(c->curves[c->curve_count - 2].rms_m, n, n), "none",
                     numbers(c->curves[c->curve_count - 1].rms_m, n, n), "low",
                     numbers(c->low_m, n, n), "median", numbers(c->median_m, n, n), "high",
                     numbers(c->high_m, n, n), "joint_runs", c->joint_runs, "north",
                     numbers(c->north_m, runs, REPORT_ENDS), "east",
                     numbers(c->east_m, runs, REPORT_ENDS), "r50", json_of_number(c->r50_m), "r95",
                     json_of_number(c->r95_m));
}

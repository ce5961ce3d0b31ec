/* SPDX-License-Identifier: MIT */
#include "tools/junit.h"
#include "tools/xml.h"

static int fails(const verified *v)
{
    return v->name && v->judgement.verdict == SCHULER_VERDICT_FAIL;
}

static int is_error(const verified *v)
{
    return !v->name || v->judgement.verdict == SCHULER_VERDICT_INCONCLUSIVE;
}

void junit_put(FILE *out, const void *what)
{
    const verification *const all = what;
    int failures = 0, errors = 0;
    double seconds = 0.0;
    for (size_t i = 0; i < all->count; i++) {
        failures += fails(&all->items[i]);
        errors += is_error(&all->items[i]);
        seconds += all->items[i].seconds;
    }
    fprintf(out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites>\n<testsuite name=\"schuler verify\" tests=\"%zu\" failures=\"%d\" "
            "errors=\"%d\" time=\"%.3f\">\n",
            all->count, failures, errors, seconds);
    for (size_t i = 0; i < all->count; i++) {
        const verified *const v = &all->items[i];
        fputs("<testcase classname=\"", out);
        xml_text(out, v->file);
        fputs("\" name=\"", out);
        xml_text(out, v->name ? v->name : v->file);
        fprintf(out, "\" time=\"%.3f\">", v->seconds);
        if (fails(v) || is_error(v)) {
            fprintf(out, "<%s message=\"", fails(v) ? "failure" : "error");
            xml_text(out, v->message);
            fputs("\"/>", out);
        } else {
            fputs("<system-out>", out);
            xml_text(out, v->message);
            fputs("</system-out>", out);
        }
        fputs("</testcase>\n", out);
    }
    fputs("</testsuite>\n</testsuites>\n", out);
}

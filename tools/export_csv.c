/* SPDX-License-Identifier: MIT */
#include "scenarios/digits.h"
#include "tools/export.h"
#include "tools/result_units.h"
#include <string.h>

/* A name of ours needs no quotes; the file may be another's. */
static void put_name(FILE *out, const char *name)
{
    const int quoted = name[strcspn(name, ",\"\r\n")] != '\0';
    if (quoted) fputc('"', out);
    for (; *name; name++) {
        if (*name == '"') fputc('"', out);
        fputc(*name, out);
    }
    if (quoted) fputc('"', out);
}

schuler_status export_csv(FILE *out, const schuler_result_file *f)
{
    fputs("source,run,end_m,max_m,drift_nmi_per_h,velocity_rms_mps\n", out);
    for (size_t i = 0; i < f->source_count; i++)
        for (size_t run = 0; run < f->run_count; run++) {
            const size_t at = i * f->run_count + run;
            const double numbers[] = { f->end_m[at], f->max_m[at], nmi_per_h(f->slope_mps[at]),
                                       f->velocity_rms_mps[at] };
            put_name(out, f->names[i]);
            fprintf(out, ",%zu", run);
            for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
                char text[SCHULER_DIGITS_MAX];
                schuler_digits(text, numbers[k]);
                fprintf(out, ",%s", text);
            }
            fputc('\n', out);
        }
    return SCHULER_OK;
}

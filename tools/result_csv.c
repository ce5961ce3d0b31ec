/* SPDX-License-Identifier: MIT */
#include "tools/result_csv.h"
#include "scenarios/digits.h"
#include "tools/result_units.h"
#include <string.h>

void errors_csv_header(FILE *out)
{
    fputs("source,run,time_s,north_m,east_m,down_m,vn_mps,ve_mps,vd_mps,roll_arcsec,pitch_arcsec,"
          "heading_arcsec\n",
          out);
}

void errors_csv_rows(FILE *out, const char *id, int run, const schuler_error_row *rows,
                     size_t count)
{
    enum { NUMBERS = 10 };
    char line[128 + NUMBERS * SCHULER_DIGITS_MAX];
    const int start = snprintf(line, 128, "%s,%d,", id, run);
    for (size_t k = 0; k < count; k++) {
        const schuler_error_row *r = &rows[k];
        const double numbers[NUMBERS] = { r->time_s,
                                          r->r_n[0],
                                          r->r_n[1],
                                          r->r_n[2],
                                          r->v_n[0],
                                          r->v_n[1],
                                          r->v_n[2],
                                          r->roll_rad * SCHULER_ARCSEC_PER_RAD,
                                          r->pitch_rad * SCHULER_ARCSEC_PER_RAD,
                                          r->heading_rad * SCHULER_ARCSEC_PER_RAD };
        char *p = line + start;
        for (int i = 0; i < NUMBERS; i++) {
            p += schuler_digits(p, numbers[i]);
            *p++ = i + 1 < NUMBERS ? ',' : '\n';
        }
        fwrite(line, 1, (size_t)(p - line), out);
    }
}

/* Values hold commas ("[1 mg, 0 mg, 0 mg]"). */
static void put_quoted(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"') fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void put_row(FILE *out, const schuler_budget_row *row, const schuler_covariance_row *linear)
{
    const double numbers[] = { row->rms_end_m, row->rms_max_m, nmi_per_h(row->cep_mps),
                               nmi_per_h(row->r95_mps), row->share };
    char text[SCHULER_DIGITS_MAX];
    fprintf(out, "%s,%s,", row->id, row->group);
    put_quoted(out, row->value_text ? row->value_text : "");
    fprintf(out, ",%d", row->assumed);
    for (size_t i = 0; i < sizeof(numbers) / sizeof(numbers[0]); i++) {
        schuler_digits(text, numbers[i]);
        fprintf(out, ",%s", text);
    }
    text[0] = '\0';
    if (linear && !linear->uncovered) schuler_digits(text, linear->end_m);
    fprintf(out, ",%s\n", text);
}

static void put_provenance(FILE *out, const schuler_scenario *s)
{
    fprintf(out, "# schuler %s, scenario sha256 %s, seed %llu, runs %d\n", SCHULER_VERSION,
            s->sha256, (unsigned long long)s->seed, s->runs);
}

void budget_csv(FILE *out, const schuler_result *result, const schuler_covariance *linear)
{
    char text[SCHULER_DIGITS_MAX];
    put_provenance(out, result->scenario);
    fputs(
        "source,group,value,assumed,horizontal_rms_end_m,horizontal_rms_max_m,drift_cep_nmi_per_h,"
        "drift_r95_nmi_per_h,share,covariance_rms_end_m\n",
        out);
    for (size_t i = 0; i < result->row_count; i++)
        put_row(out, &result->rows[i], schuler_covariance_find(linear, result->rows[i].id));
    put_row(out, &result->all, linear ? &linear->total : NULL);
    put_row(out, &result->none, NULL);
    schuler_digits(text, result->rss_end_m);
    fprintf(out, "rss,,\"\",0,%s,", text);
    schuler_digits(text, result->rss_max_m);
    fprintf(out, "%s,,,,\n", text);
}

void scenario_copy(FILE *out, const schuler_scenario *s, const char *switches)
{
    put_provenance(out, s);
    fprintf(out, "# made by: schuler run SCENARIO%s\n", switches);
    fputs("# The sha256 is of the text below these three lines.\n", out);
    size_t length = 0;
    const char *text = s->document_count ? schuler_document_text(s->documents[0], &length) : "";
    fwrite(text, 1, length, out);
}

/* SPDX-License-Identifier: MIT */
#include "tools/budget_table.h"
#include "tools/comparison.h"
#include "tools/page.h"
#include "tools/result_units.h"
#include "tools/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NAME = 17, DRIFT = 9, LIMITS = 17, SOURCE = 24, COLUMN = 13, COLUMNS = 4, ID_MAX = 64 };

double comparison_drift(const compared *item)
{
    return item->result->all.required_mps;
}

static int digits_for(double nmi_h)
{
    const int decimals = decimals_for(10.0 * nmi_h);
    return decimals > 6 ? 6 : decimals;
}

static void put_limits(FILE *out, const schuler_judgement *j, int decimals)
{
    char text[64];
    if (j->lower_mps == j->upper_mps)
        snprintf(text, sizeof text, "fixed");
    else if (!isfinite(j->upper_mps) || j->lower_mps <= 0.0)
        snprintf(text, sizeof text, "too few runs");
    else
        snprintf(text, sizeof text, "%.*f to %.*f", decimals, nmi_per_h(j->lower_mps), decimals,
                 nmi_per_h(j->upper_mps));
    fprintf(out, "%*s", LIMITS, text);
}

static const char *word_of(schuler_verdict verdict)
{
    return verdict == SCHULER_VERDICT_PASS   ? "PASS"
           : verdict == SCHULER_VERDICT_FAIL ? "FAIL"
           : verdict == SCHULER_VERDICT_NONE ? ""
                                             : "open";
}

static void put_ranking(FILE *out, const comparison *c)
{
    fprintf(out, "  %-*s%*s%*s\n", NAME, "", DRIFT, statistic_name(c->statistic), LIMITS,
            "95 % limits");
    fprintf(out, "  %-*s%*s%*s  %-*s%s\n", NAME, "IMU", DRIFT, "nmi/h", LIMITS, "nmi/h", 30,
            "largest source", c->required ? "verdict" : "");
    page_rule(out);
    for (size_t i = 0; i < c->count; i++) {
        const compared *const item = &c->items[i];
        const double drift = nmi_per_h(comparison_drift(item));
        const schuler_budget_row *const row = budget_largest(item->result, NULL);
        char most[ID_MAX + 16] = "";
        if (row && row->share > 0.0)
            snprintf(most, sizeof most, "%s %.0f %%", row->id, 100.0 * row->share);
        fputs("  ", out);
        page_cell(out, item->name, NAME);
        fprintf(out, "%*.*f", DRIFT, digits_for(drift), drift);
        put_limits(out, &item->judgement, digits_for(drift));
        fputs("  ", out);
        page_cell(out, most, 30);
        fprintf(out, "%s\n", word_of(item->judgement.verdict));
    }
}

/* Three digits, without an exponent where there can be none. */
static const char *number(double x, char text[32])
{
    snprintf(text, 32, x >= 100.0 && x < 1e7 ? "%.0f" : "%.3g", x);
    return text;
}

static void put_ratios(FILE *out, const comparison *c)
{
    fputc('\n', out);
    for (size_t i = 1; i < c->count; i++) {
        const schuler_paired *const p = &c->items[i].against_best;
        char ratio[32], lower[32], upper[32];
        fprintf(out, "  %s drifts ", c->items[i].name);
        if (!isfinite(p->ratio))
            fprintf(out, "and %s does not", c->items[0].name);
        else
            fprintf(out, "%s times as much as %s", number(p->ratio, ratio), c->items[0].name);
        if (p->pairs > 0)
            fprintf(out, " (95 %% limits %s to %s, %d pairs)", number(p->lower, lower),
                    number(p->upper, upper), p->pairs);
        fputc('\n', out);
    }
}

/* A source of any of them. */
typedef struct {
    const char *id;
    double largest_mps, share;
} line;

static const schuler_budget_row *row_of(const schuler_result *result, const char *id)
{
    for (size_t i = 0; i < result->row_count; i++)
        if (strcmp(result->rows[i].id, id) == 0) return &result->rows[i];
    return NULL;
}

static int by_size(const void *a, const void *b)
{
    const line *const x = a, *const y = b;
    if (x->largest_mps != y->largest_mps) return x->largest_mps < y->largest_mps ? 1 : -1;
    return strcmp(x->id, y->id);
}

static size_t collect(const comparison *c, line *lines)
{
    size_t count = 0;
    for (size_t i = 0; i < c->count; i++)
        for (size_t k = 0; k < c->items[i].result->row_count; k++) {
            const schuler_budget_row *const row = &c->items[i].result->rows[k];
            size_t at = 0;
            while (at < count && strcmp(lines[at].id, row->id) != 0) at++;
            if (at == count) lines[count++] = (line){ .id = row->id };
            lines[at].largest_mps = fmax(lines[at].largest_mps, row->required_mps);
            lines[at].share = fmax(lines[at].share, row->share);
        }
    qsort(lines, count, sizeof *lines, by_size);
    return count;
}

static void put_budgets(FILE *out, const comparison *c, const line *lines, size_t count,
                        size_t first)
{
    const size_t end = first + COLUMNS < c->count ? first + COLUMNS : c->count;
    fputs("\n  ", out);
    page_cell(out, "source", SOURCE);
    for (size_t i = first; i < end; i++) {
        fputc(' ', out);
        /* right-aligned names, cut on the right */
        char name[COLUMN];
        snprintf(name, sizeof name, "%s", c->items[i].name);
        fprintf(out, "%*s", COLUMN - 1, name);
    }
    fputc('\n', out);
    page_rule(out);
    for (size_t k = 0; k < count; k++) {
        fputs("  ", out);
        page_cell(out, lines[k].id, SOURCE);
        for (size_t i = first; i < end; i++) {
            const schuler_budget_row *const row = row_of(c->items[i].result, lines[k].id);
            const double drift = row ? nmi_per_h(row->required_mps) : 0.0;
            if (row)
                fprintf(out, "%*.*f", COLUMN, digits_for(drift), drift);
            else
                fprintf(out, "%*s", COLUMN, "-");
        }
        fputc('\n', out);
    }
    page_rule(out);
    fputs("  ", out);
    page_cell(out, "joint run", SOURCE);
    for (size_t i = first; i < end; i++) {
        const double drift = nmi_per_h(comparison_drift(&c->items[i]));
        fprintf(out, "%*.*f", COLUMN, digits_for(drift), drift);
    }
    fputc('\n', out);
}

bool comparison_text(FILE *out, const comparison *c, bool all)
{
    size_t total = 0;
    for (size_t i = 0; i < c->count; i++) total += c->items[i].result->row_count;
    line *const lines = calloc(total + 1, sizeof *lines);
    if (!lines) return false;
    const size_t count = collect(c, lines);
    size_t shown = 0;
    for (size_t k = 0; k < count; k++) /* nothing in any of them: not shown, but counted */
        if (all || lines[k].share >= 0.001) lines[shown++] = lines[k];
    const schuler_result *const first = c->items[0].result;
    const schuler_scenario *const s = first->scenario;
    fprintf(out, "%s%s%s\n  ", terminal_colour(stdout, COLOUR_BOLD), s->name,
            terminal_plain(stdout));
    page_duration(out, first->duration_s);
    fprintf(out, "   %d run%s, seed %llu: the same draws for every IMU\n\n", first->runs,
            first->runs == 1 ? "" : "s", (unsigned long long)s->seed);
    put_ranking(out, c);
    put_ratios(out, c);
    fprintf(out, "\nDrift by source, each alone, nmi/h %s\n", statistic_name(c->statistic));
    for (size_t i = 0; i < c->count; i += COLUMNS) put_budgets(out, c, lines, shown, i);
    if (shown < count)
        fprintf(out, "  %zu others below 0.1 %% of the variance in each (--all)\n", count - shown);
    free(lines);
    return true;
}

void comparison_csv(FILE *out, const void *what)
{
    const comparison *const c = what;
    fputs("imu,source,horizontal_rms_end_m,drift_cep_nmi_per_h,drift_r95_nmi_per_h,share\n", out);
    for (size_t i = 0; i < c->count; i++) {
        const schuler_result *const r = c->items[i].result;
        for (size_t k = 0; k <= r->row_count; k++) {
            const schuler_budget_row *const row = k < r->row_count ? &r->rows[k] : &r->all;
            fputc('"', out);
            for (const char *t = c->items[i].name; *t; t++) {
                if (*t == '"') fputc('"', out);
                fputc(*t, out);
            }
            fprintf(out, "\",%s,%.17g,%.17g,%.17g,%.17g\n", row->id, row->rms_end_m,
                    nmi_per_h(row->cep_mps), nmi_per_h(row->r95_mps), row->share);
        }
    }
}

/* SPDX-License-Identifier: MIT */
#include "tools/budget_table.h"
#include "tools/page.h"
#include "tools/result_units.h"
#include "tools/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Columns; the two texts share what the numbers leave of 80. */
enum {
    POSITION = 9,
    DRIFT = 8,
    SHARE = 7,
    BAR = 6,
    TEXTS = 80 - 2 - 1 - POSITION - DRIFT - SHARE - 2 - BAR
};

typedef struct {
    FILE *out;
    int source, value; /* widths of the text columns                                */
    const char *unit;
    double metres; /* in one unit                                               */
    int decimals, drift_decimals;
} layout;

static const char *value_of(const schuler_budget_row *row)
{
    return row->value_text ? row->value_text : "";
}

/* One unit for the whole column, chosen by its largest entry. */
static layout choose_layout(FILE *out, const schuler_result *result,
                            const schuler_budget_row **rows, size_t count)
{
    layout l = { .out = out, .source = (int)strlen("root sum square"), .unit = "m", .metres = 1.0 };
    double largest_m = result->all.rms_end_m, largest_mps = result->all.cep_mps;
    for (size_t i = 0; i < count; i++) {
        largest_m = fmax(largest_m, rows[i]->rms_end_m);
        largest_mps = fmax(largest_mps, rows[i]->cep_mps);
        l.source = (int)fmax(l.source, (double)strlen(rows[i]->id));
    }
    if (largest_m >= 0.1 * SCHULER_NMI_M) {
        l.unit = "nmi";
        l.metres = SCHULER_NMI_M;
    } else if (largest_m < 0.1) {
        l.unit = "mm";
        l.metres = 1e-3;
    }
    l.value = TEXTS - l.source - 2;
    l.decimals = decimals_for(largest_m / l.metres);
    if (l.decimals > 6) l.decimals = 6;
    l.drift_decimals = decimals_for(nmi_per_h(largest_mps));
    if (l.drift_decimals > 5) l.drift_decimals = 5;
    return l;
}

static void put_position(const layout *l, double metres)
{
    fprintf(l->out, "%*.*f", POSITION, l->decimals, metres / l->metres);
}

static void put_drift(const layout *l, double mps)
{
    fprintf(l->out, "%*.*f", DRIFT, l->drift_decimals, nmi_per_h(mps));
}

/* Eighths of a character; on terminals without them only whole ones are left. */
static void put_bar(FILE *out, double share)
{
    static const char *const eighths[] = { "", "▏", "▎", "▍", "▌", "▋", "▊", "▉" };
    const int length = (int)(fmin(fmax(share, 0.0), 1.0) * BAR * 8 + 0.5);
    for (int i = 0; i < length / 8; i++) fputs("█", out);
    fputs(eighths[length % 8], out);
}

static void put_source(const layout *l, const schuler_budget_row *row)
{
    fputs("  ", l->out);
    page_cell(l->out, row->id, l->source);
    fputs("  ", l->out);
    page_cell(l->out, value_of(row), l->value);
    fputc(row->assumed ? '*' : ' ', l->out);
    put_position(l, row->rms_end_m);
    put_drift(l, row->cep_mps);
    const double percent = fabs(row->share) < 5e-4 ? 0.0 : 100.0 * row->share;
    fprintf(l->out, "%*.1f%%  ", SHARE - 1, percent);
    put_bar(l->out, row->share);
    fputc('\n', l->out);
}

/* A line without value and share; no drift when it is negative. */
static void put_sum(const layout *l, const char *name, double metres, double mps)
{
    fputs("  ", l->out);
    page_cell(l->out, name, l->source + 2 + l->value + 1);
    put_position(l, metres);
    if (mps >= 0.0) put_drift(l, mps);
    fputc('\n', l->out);
}

static int by_size(const void *a, const void *b)
{
    const schuler_budget_row *x = *(const schuler_budget_row *const *)a;
    const schuler_budget_row *y = *(const schuler_budget_row *const *)b;
    if (x->share != y->share) return x->share < y->share ? 1 : -1;
    return x < y ? -1 : 1; /* both are in one array: the order of the tables */
}

/* How many of the sorted rows are shown one by one: all with a tenth of a percent of the variance,
 * and a single small one too, as a line of its own says more than "1 other". */
static size_t unfolded(const schuler_budget_row **rows, size_t count, bool all)
{
    size_t shown = count;
    while (!all && shown > 0 && rows[shown - 1]->share < 0.001) shown--;
    return count - shown > 1 ? shown : count;
}

static void put_folded(const layout *l, const schuler_budget_row **rows, size_t count)
{
    double sum_m2 = 0.0, share = 0.0;
    char name[48];
    for (size_t i = 0; i < count; i++) {
        sum_m2 += rows[i]->rms_end_m * rows[i]->rms_end_m;
        share += rows[i]->share;
    }
    snprintf(name, sizeof(name), "%zu others (--all)", count);
    fputs("  ", l->out);
    page_cell(l->out, name, l->source + 2 + l->value + 1);
    put_position(l, sqrt(sum_m2));
    fprintf(l->out, "%*s%*.1f%%\n", DRIFT, "", SHARE - 1, 100.0 * share);
}

/* The sums, and whether the budget is additive. */
static void put_sums(const layout *l, const schuler_result *result,
                     const schuler_covariance *linear)
{
    const double joint_m = result->all.rms_end_m, rss_m = result->rss_end_m;
    put_sum(l, "joint run, all sources at once", joint_m, result->all.cep_mps);
    if (rss_m > 0.0) put_sum(l, "root sum square of the sources", rss_m, -1.0);
    if (linear && linear->total.end_m > 0.0)
        put_sum(l, "linear covariance of the sources", linear->total.end_m, -1.0);
    if (rss_m > 0.0)
        fprintf(l->out, "  %-*s%+*.1f %%\n", l->source + 2 + l->value + 1, "difference",
                POSITION - 2, 100.0 * (joint_m - rss_m) / rss_m);
    const double none_mm = 1e3 * result->none.rms_end_m;
    fprintf(l->out, "  %-*s%*.*f mm\n", l->source + 2 + l->value + 1 + POSITION - 12,
            "numerical residue, no errors", 9, none_mm < 1e5 ? 3 : 0, none_mm);
}

/* A sensor that is driven beyond its range says so, however little of the budget it is. */
static void put_clipped(FILE *out, const schuler_result *result)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_clipping *const c = &result->clipped[i];
        if (c->runs == 0) continue;
        const double all = 3.0 * (double)result->steps * result->all.runs;
        fprintf(out,
                "  %s beyond its range in %d of %d run%s: %.3g %% of the samples were cut off\n",
                schuler_instrument_name((schuler_instrument)i), c->runs, result->all.runs,
                result->all.runs == 1 ? "" : "s", 100.0 * (double)c->samples / all);
    }
}

void budget_header(FILE *out, const schuler_result *result)
{
    const schuler_scenario *s = result->scenario;
    fprintf(out, "%s%s%s\n", terminal_colour(stdout, COLOUR_BOLD), s->name, terminal_plain(stdout));
    fputs("  ", out);
    page_duration(out, result->duration_s);
    fprintf(out, "   %s   %g Hz   %d run%s, seed %llu\n", s->imu.title ? s->imu.title : s->imu.name,
            s->imu.rate_hz, result->runs, result->runs == 1 ? "" : "s",
            (unsigned long long)s->seed);
}

bool budget_table(FILE *out, const schuler_result *result, const schuler_covariance *linear,
                  bool all)
{
    const size_t count = result->row_count;
    const schuler_budget_row **rows = calloc(count + 1, sizeof(schuler_budget_row *));
    if (!rows) return false;
    bool assumed = false;
    for (size_t i = 0; i < count; i++) {
        rows[i] = &result->rows[i];
        assumed |= rows[i]->assumed;
    }
    qsort(rows, count, sizeof(schuler_budget_row *), by_size);
    const size_t shown = unfolded(rows, count, all || result->rows_are == SCHULER_ROWS_WITHOUT);
    const layout l = choose_layout(out, result, rows, shown);

    fputs("\nError budget at ", out);
    page_duration(out, result->duration_s);
    fputs(result->rows_are == SCHULER_ROWS_WITHOUT
              ? ": horizontal rms and drift CEP without each source, the share that it adds\n\n  "
              : ": horizontal rms, drift CEP, share of variance\n\n  ",
          out);
    page_cell(out, "source", l.source);
    fputs("  ", out);
    page_cell(out, "value", l.value);
    fprintf(out, " %*s%*s%*s\n", POSITION, l.unit, DRIFT, "nmi/h", SHARE, "share");
    page_rule(out);
    for (size_t i = 0; i < shown; i++) put_source(&l, rows[i]);
    if (shown < count) put_folded(&l, rows + shown, count - shown);
    if (count == 0) fputs("  no error source is on\n", out);
    page_rule(out);
    put_sums(&l, result, linear);
    if (linear) budget_agreement(out, result, linear);
    put_clipped(out, result);
    if (assumed)
        fputs("\n  * assumed: not a published figure, or not as one (schuler sensors show NAME)\n",
              out);
    free(rows);
    return true;
}

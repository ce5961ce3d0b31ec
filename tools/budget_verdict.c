/* SPDX-License-Identifier: MIT */
#include "scenarios/metrics.h"
#include "scenarios/source_size.h"
#include "tools/budget_table.h"
#include "tools/result_units.h"
#include "tools/scaled_text.h"
#include "tools/terminal.h"
#include <math.h>

exit_code budget_exit(const schuler_result *result)
{
    switch (result->judgement.verdict) {
    case SCHULER_VERDICT_FAIL:
        return EXIT_NOT_MET;
    case SCHULER_VERDICT_INCONCLUSIVE:
        return EXIT_INCONCLUSIVE;
    case SCHULER_VERDICT_NONE:
    case SCHULER_VERDICT_PASS:
        break;
    }
    return EXIT_DONE;
}

static colour colour_of(schuler_verdict verdict)
{
    switch (verdict) {
    case SCHULER_VERDICT_PASS:
        return COLOUR_GREEN;
    case SCHULER_VERDICT_FAIL:
        return COLOUR_RED;
    case SCHULER_VERDICT_INCONCLUSIVE:
        return COLOUR_YELLOW;
    case SCHULER_VERDICT_NONE:
        break;
    }
    return COLOUR_NONE;
}

const schuler_budget_row *budget_largest(const schuler_result *result,
                                         const schuler_budget_row *below)
{
    const schuler_budget_row *found = NULL;
    for (size_t i = 0; i < result->row_count; i++) {
        const schuler_budget_row *row = &result->rows[i];
        if (below && (row == below || row->share > below->share ||
                      (row->share == below->share && row < below)))
            continue;
        if (!found || row->share > found->share) found = row;
    }
    return found;
}

/* What a source may be for the requirement to be met, by the sum of squares; `schuler solve` simulates it. */
static void put_margin(FILE *out, const schuler_result *result, const schuler_budget_row *row,
                       const char *lead)
{
    const double margin = schuler_source_margin(result, row);
    char value[120];
    if (!row->value_text || !row->value_text[0] || !(margin > 0.0) || !isfinite(margin)) return;
    scaled_text(row->value_text, margin, value, sizeof value);
    fprintf(out, "  %s %s %s (schuler solve)\n", lead, row->id, value);
}

/* Sources until three quarters of the variance are explained, at most three. */
static void put_blame(FILE *out, const schuler_result *result)
{
    if (result->rows_are == SCHULER_ROWS_WITHOUT) return;
    const schuler_requirement *required = &result->scenario->requirement;
    const schuler_budget_row *row = budget_largest(result, NULL);
    double explained = 0.0;
    for (int i = 0; row && row->share > 0.0 && i < 3 && explained < 0.75; i++) {
        const double alone = nmi_per_h(row->required_mps);
        const int decimals = decimals_for(10.0 * alone);
        fprintf(out, "  %s  %s: %.1f %% of the variance, alone %.*f nmi/h %s\n",
                i ? "then    " : "to blame", row->id, 100.0 * row->share,
                decimals > 6 ? 6 : decimals, alone, statistic_name(required->statistic));
        put_margin(out, result, row, "          it would be met at about");
        explained += row->share;
        row = budget_largest(result, row);
    }
}

static void put_more_runs(FILE *out, const schuler_result *result)
{
    const schuler_judgement *j = &result->judgement;
    const double runs =
        schuler_runs_to_decide(j, result->scenario->requirement.drift_mps, result->runs);
    if (!isfinite(j->upper_mps) || j->lower_mps <= 0.0)
        fprintf(out, "; try --runs %.0f\n", runs);
    else if (runs <= 100000.0)
        fprintf(out, "\n  about %.0f runs would tell (--runs %.0f)\n", runs, runs);
    else
        fprintf(out, "\n  the drift is too close to the limit to be told from it\n");
}

static void put_limits(FILE *out, const schuler_result *result, int decimals)
{
    const schuler_judgement *j = &result->judgement;
    if (j->lower_mps == j->upper_mps)
        fputs("  nothing is drawn, every run is the same", out);
    else if (!isfinite(j->upper_mps) || j->lower_mps <= 0.0)
        fprintf(out, "  too few runs for %g %% limits: %d", 100.0 * j->confidence, result->runs);
    else
        fprintf(out, "  %g %% limits %.*f to %.*f nmi/h", 100.0 * j->confidence, decimals,
                nmi_per_h(j->lower_mps), decimals, nmi_per_h(j->upper_mps));
}

void budget_verdict(FILE *out, const schuler_result *result)
{
    const schuler_requirement *required = &result->scenario->requirement;
    const schuler_judgement *j = &result->judgement;
    int decimals = decimals_for(nmi_per_h(result->all.cep_mps));
    if (decimals > 6) decimals = 6;
    if (!required->given) {
        fprintf(out, "Drift %.*f nmi/h CEP, %.*f nmi/h R95; no requirement is stated\n", decimals,
                nmi_per_h(result->all.cep_mps), decimals, nmi_per_h(result->all.r95_mps));
        return;
    }
    const double value = nmi_per_h(j->value_mps), limit = nmi_per_h(required->drift_mps);
    const char *statistic = statistic_name(required->statistic);
    decimals = decimals_for(10.0 * value);
    if (decimals > 6) decimals = 6;
    fprintf(out, "%s%s%s  drift %.*f nmi/h %s", terminal_colour(stdout, colour_of(j->verdict)),
            verdict_name(j->verdict), terminal_plain(stdout), decimals, value, statistic);
    fprintf(out, ", limit %g nmi/h %s\n", limit, statistic);
    put_limits(out, result, decimals);
    if (j->verdict == SCHULER_VERDICT_PASS) {
        const schuler_budget_row *row = budget_largest(result, NULL);
        fprintf(out, ", margin %.3g %%\n", 100.0 * (1.0 - value / limit));
        if (row && row->share > 0.0 && result->rows_are != SCHULER_ROWS_WITHOUT)
            fprintf(out, "  largest source: %s with %.1f %% of the variance\n", row->id,
                    100.0 * row->share);
        if (row && result->rows_are == SCHULER_ROWS_SOURCES)
            put_margin(out, result, row, "the limit is reached at about");
    } else if (j->verdict == SCHULER_VERDICT_FAIL) {
        fputc('\n', out);
        put_blame(out, result);
    } else {
        put_more_runs(out, result);
    }
}

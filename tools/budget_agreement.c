/* SPDX-License-Identifier: MIT */
#include "tools/budget_table.h"
#include "tools/page.h"
#include <math.h>

/* Monte Carlo and covariance are two ways to the same figures: where they part, a source is not linear. */
void budget_agreement(FILE *out, const schuler_result *result, const schuler_covariance *linear)
{
    size_t covered = 0, differing = 0;
    for (size_t i = 0; i < linear->row_count; i++) {
        covered += !linear->rows[i].uncovered;
        differing +=
            schuler_covariance_against(&linear->rows[i], &result->rows[i], linear->total.end_m)
                .differs;
    }
    if (linear->row_count == 0) return;
    fputc('\n', out);
    if (covered == 0 && linear->row_count > 1) {
        fprintf(out, "  no covariance beside it: %s\n", linear->rows[0].uncovered);
        return;
    }
    if (covered > 0 && differing == 0)
        fprintf(out, "  simulation and linear covariance agree for %s%zu source%s\n",
                covered > 1 ? "all " : "the ", covered, covered == 1 ? "" : "s");
    for (size_t i = 0; i < linear->row_count; i++) {
        const schuler_covariance_row *const row = &linear->rows[i];
        const schuler_agreement a =
            schuler_covariance_against(row, &result->rows[i], linear->total.end_m);
        if (row->uncovered)
            fprintf(out, "  not in the covariance: %s, as %s\n", row->id, row->uncovered);
        else if (a.differs && a.sigmas != 0.0)
            fprintf(out,
                    "  not linear: %s, simulated %+.1f %% against the covariance (%.1f sigma)\n",
                    row->id, 100.0 * a.relative, fabs(a.sigmas));
        else if (a.differs)
            fprintf(out, "  not linear: %s, simulated %+.1f %% against the covariance\n", row->id,
                    100.0 * a.relative);
    }
}

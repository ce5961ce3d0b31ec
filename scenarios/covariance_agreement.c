/* SPDX-License-Identifier: MIT */
#include "scenarios/covariance.h"
#include "scenarios/metrics.h"
#include <math.h>
#include <string.h>

const schuler_covariance_row *schuler_covariance_find(const schuler_covariance *c, const char *id)
{
    for (size_t i = 0; c && i < c->row_count; i++)
        if (strcmp(c->rows[i].id, id) == 0) return &c->rows[i];
    return NULL;
}

/* Of r^2 = |mean + x|^2 the variance is 2 tr(P^2) + 4 mean' P mean; half of its root, over <r^2>. */
double schuler_covariance_sampling(const schuler_covariance_row *row, int runs)
{
    const double nn = row->P_n_m2[0], ne = row->P_n_m2[1], ee = row->P_n_m2[2];
    const double n = row->mean_n_m[0], e = row->mean_n_m[1];
    const double variance = 2.0 * (nn * nn + 2.0 * ne * ne + ee * ee) +
                            4.0 * (n * n * nn + 2.0 * n * e * ne + e * e * ee);
    const double mean2 = nn + ee + n * n + e * e;
    return mean2 > 0.0 && runs > 0 ? 0.5 * sqrt(variance / runs) / mean2 : 0.0;
}

schuler_agreement schuler_covariance_against(const schuler_covariance_row *row,
                                             const schuler_budget_row *simulated, double total_m)
{
    schuler_agreement a = { 0 };
    if (row->uncovered || !(row->end_m > 0.0)) return a;
    const double sampling = schuler_covariance_sampling(row, simulated->runs);
    a.relative = simulated->rms_end_m / row->end_m - 1.0;
    if (sampling > 0.0) a.sigmas = a.relative / sampling;
    const bool is_told = sampling == 0.0 || simulated->runs >= SCHULER_VERDICT_RUNS_MIN;
    const bool counts = fabs(simulated->rms_end_m - row->end_m) > 1e-3 * total_m;
    a.differs = is_told && counts && fabs(a.relative) > SCHULER_AGREEMENT_LEAST &&
                (sampling == 0.0 || fabs(a.sigmas) > SCHULER_AGREEMENT_SIGMAS);
    return a;
}

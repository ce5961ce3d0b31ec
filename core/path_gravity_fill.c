/* SPDX-License-Identifier: MIT */
#include "core/path_gravity.h"
#include <string.h>

static size_t find(const schuler_path_gravity *g, double t_s)
{
    size_t low = 0, high = g->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (g->intervals[middle].t0_s <= t_s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* All columns of a block, used or not: a number of steps that the compiler knows becomes vectors. */
static void series(const double *c, int terms, const double s[SCHULER_BLOCK],
                   double sum[SCHULER_BLOCK])
{
    for (int i = 0; i < SCHULER_BLOCK; i++) sum[i] = c[terms - 1];
    for (int k = terms - 2; k >= 0; k--)
        for (int i = 0; i < SCHULER_BLOCK; i++) sum[i] = sum[i] * s[i] + c[k];
}

void schuler_path_gravity_fill(const schuler_path_gravity *g, double dt_s, int64_t first, int n,
                               schuler_columns out[SCHULER_PATH_PARTS])
{
    memset(out, 0, SCHULER_PATH_PARTS * sizeof out[0]);
    if (g->count == 0) return;
    size_t at = find(g, ((double)first + 0.5) * dt_s);
    for (int from = 0, to; from < n; from = to, at++) {
        const schuler_path_gravity_interval *const interval = &g->intervals[at];
        const double next_s = at + 1 < g->count ? interval[1].t0_s : HUGE_VAL;
        const double per_s = 2.0 / interval->duration_s;
        double s[SCHULER_BLOCK] = { 0 }, sum[SCHULER_BLOCK];
        for (to = from; to < n; to++) {
            const double t_s = ((double)(first + to) + 0.5) * dt_s;
            if (t_s >= next_s) break;
            s[to] = fmin(fmax((t_s - interval->t0_s) * per_s - 1.0, -1.0), 1.0);
        }
        for (int p = 0; p < SCHULER_PATH_PARTS; p++)
            for (int i = 0; g->has[p] && i < 3; i++) {
                series(interval->dg_e[p][i], interval->terms, s, sum);
                memcpy(&out[p].v[i][from], &sum[from], (size_t)(to - from) * sizeof(double));
            }
    }
}

schuler_vec3 schuler_path_gravity_at(const schuler_path_gravity *g, int part, double t_s)
{
    schuler_vec3 dg_e = { { 0.0, 0.0, 0.0 } };
    if (g->count == 0 || !g->has[part]) return dg_e;
    const schuler_path_gravity_interval *const interval = &g->intervals[find(g, t_s)];
    const double s =
        fmin(fmax((t_s - interval->t0_s) * 2.0 / interval->duration_s - 1.0, -1.0), 1.0);
    for (int i = 0; i < 3; i++)
        for (int k = interval->terms - 1; k >= 0; k--)
            dg_e.v[i] = dg_e.v[i] * s + interval->dg_e[part][i][k];
    return dg_e;
}

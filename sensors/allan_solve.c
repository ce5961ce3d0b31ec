/* SPDX-License-Identifier: MIT */
#include "sensors/allan_solve.h"
#include <math.h>
#include <string.h>

enum { TERMS = SCHULER_ALLAN_TERMS };

void allan_normal_equations(allan_normal *out, const double (*x)[TERMS], const double *s,
                            const double *w, int count)
{
    memset(out, 0, sizeof(*out));
    for (int a = 0; a < TERMS; a++) {
        double norm = 0.0;
        for (int i = 0; i < count; i++) norm += w[i] * x[i][a] * x[i][a];
        if (norm > 0.0 && isfinite(norm)) out->scale[a] = 1.0 / sqrt(norm);
    }
    for (int i = 0; i < count; i++)
        for (int a = 0; a < TERMS; a++) {
            const double weighted = w[i] * x[i][a] * out->scale[a];
            out->b[a] += weighted * s[i];
            for (int b = 0; b < TERMS; b++) out->A[a][b] += weighted * x[i][b] * out->scale[b];
        }
}

/* Cholesky. With diagonals of one, a pivot is the squared sine of the angle between a column and the
 * others: below 1e-9 rounding would decide. */
int allan_solve(const allan_normal *e, const double right[TERMS], unsigned set, double c[TERMS])
{
    double L[TERMS][TERMS] = { { 0 } }, y[TERMS] = { 0 };
    int index[TERMS], count = 0;
    for (int a = 0; a < TERMS; a++)
        if (set >> a & 1) index[count++] = a;
    for (int i = 0; i < count; i++)
        for (int j = 0; j <= i; j++) {
            double sum = e->A[index[i]][index[j]];
            for (int k = 0; k < j; k++) sum -= L[i][k] * L[j][k];
            if (i == j && !(sum > 1e-9)) return 0;
            L[i][j] = i == j ? sqrt(sum) : sum / L[j][j];
        }
    for (int i = 0; i < count; i++) {
        double sum = right[index[i]];
        for (int k = 0; k < i; k++) sum -= L[i][k] * y[k];
        y[i] = sum / L[i][i];
    }
    memset(c, 0, TERMS * sizeof(*c));
    for (int i = count - 1; i >= 0; i--) {
        double sum = y[i];
        for (int k = i + 1; k < count; k++) sum -= L[k][i] * c[index[k]] / e->scale[index[k]];
        c[index[i]] = sum / L[i][i] * e->scale[index[i]];
    }
    return 1;
}

/* Of five unknowns there are 31 choices of which are positive: try all, no search can go wrong. */
unsigned allan_solve_positive(const allan_normal *e, unsigned terms, double c[TERMS])
{
    unsigned best = 0;
    double best_gain = 0.0;
    memset(c, 0, TERMS * sizeof(*c));
    for (unsigned set = 1; set < 1u << TERMS; set++) {
        double trial[TERMS], gain = 0.0;
        int negative = 0;
        if ((set & ~terms) || !allan_solve(e, e->b, set, trial)) continue;
        for (int a = 0; a < TERMS; a++) {
            negative |= trial[a] < 0.0;
            if (set >> a & 1) gain += e->b[a] * trial[a] / e->scale[a]; /* what it explains */
        }
        if (negative || !(gain > best_gain)) continue;
        best = set;
        best_gain = gain;
        memcpy(c, trial, sizeof(trial));
    }
    return best;
}

/* SPDX-License-Identifier: MIT */
#include "sensors/mounting.h"
#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* A vector that is of unit length already stays as it is, bit for bit. */
static void normalize(double a[3])
{
    const double length = sqrt(dot(a, a));
    for (int i = 0; i < 3 && length != 1.0; i++) a[i] /= length;
}

static bool all_zero(const double v[9])
{
    for (int i = 0; i < 9; i++)
        if (v[i] != 0.0) return false;
    return true;
}

void schuler_mounting_axes(const double input[9], const double second[9], double axes[3][3][3])
{
    const bool body = all_zero(input), cyclic = all_zero(second);
    for (int k = 0; k < 3; k++) {
        double *const i = axes[k][0], *const p = axes[k][1], *const o = axes[k][2];
        for (int j = 0; j < 3; j++) {
            i[j] = body ? (j == k) : input[3 * k + j];
            p[j] = cyclic ? (j == (k + 1) % 3) : second[3 * k + j];
        }
        normalize(i);
        const double along = dot(i, p);
        for (int j = 0; j < 3; j++) p[j] -= along * i[j];
        normalize(p);
        cross(i, p, o);
    }
}

bool schuler_mounting_back(double axes[3][3][3], double back[3][3])
{
    double rows[3][3];
    for (int k = 0; k < 3; k++) cross(axes[(k + 1) % 3][0], axes[(k + 2) % 3][0], rows[k]);
    const double volume = dot(axes[0][0], rows[0]);
    double sum = 0.0; /* not finite when a second axis has no part square to its input axis */
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) sum += axes[k][1][j] + axes[k][2][j];
    if (!(fabs(volume) > 1e-3) || !isfinite(sum)) return false;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) back[j][k] = rows[k][j] / volume;
    return true;
}

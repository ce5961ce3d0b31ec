/* SPDX-License-Identifier: MIT */
#include "scenarios/linear_error.h"
#include "core/earth.h"
#include <math.h>
#include <string.h>

enum { N = LINEAR_STATES };

static linear_matrix product(const linear_matrix *a, const linear_matrix *b)
{
    linear_matrix c = { { { 0 } } };
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            const double a_ik = a->m[i][k];
            if (a_ik == 0.0) continue;
            for (int j = 0; j < N; j++) c.m[i][j] += a_ik * b->m[k][j];
        }
    return c;
}

schuler_vec3 linear_up(const linear_navigator *n, schuler_vec3 r_e)
{
    const double k = schuler_gravity_normal_z(n->gravity, r_e);
    const schuler_vec3 along = { { r_e.v[0], r_e.v[1], k * r_e.v[2] } };
    return schuler_vec3_scale(1.0 / schuler_vec3_norm(along), along);
}

/* Gravity is smooth over the radius of the earth: differences over 2 km are good to 1e-8 of it. */
static void put_gradient(const linear_navigator *n, schuler_vec3 r_e, linear_matrix *F)
{
    const double h_m = 1000.0;
    for (int j = 0; j < 3; j++) {
        schuler_vec3 above = r_e, below = r_e;
        above.v[j] += h_m;
        below.v[j] -= h_m;
        const schuler_vec3 g_above = schuler_gravity_at(n->gravity, above),
                           g_below = schuler_gravity_at(n->gravity, below);
        for (int i = 0; i < 3; i++)
            F->m[LINEAR_DV + i][LINEAR_DR + j] = (g_above.v[i] - g_below.v[i]) / (2.0 * h_m);
    }
}

static linear_matrix dynamics(const linear_stretch *s, const linear_navigator *n)
{
    const double W = SCHULER_OMEGA_IE_RADPS;
    linear_matrix F = { { { 0 } } };
    for (int i = 0; i < 3; i++) F.m[LINEAR_DR + i][LINEAR_DV + i] = 1.0;
    put_gradient(n, s->r_e, &F);
    F.m[LINEAR_DV][LINEAR_DV + 1] = 2.0 * W;
    F.m[LINEAR_DV + 1][LINEAR_DV] = -2.0 * W;
    F.m[LINEAR_PSI][LINEAR_PSI + 1] = W;
    F.m[LINEAR_PSI + 1][LINEAR_PSI] = -W;
    for (int i = 0; i < 3; i++) { /* f x psi */
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        F.m[LINEAR_DV + i][LINEAR_PSI + k] = s->f_e.v[j];
        F.m[LINEAR_DV + i][LINEAR_PSI + j] = -s->f_e.v[k];
    }
    if (n->vertical != SCHULER_VERTICAL_BARO) return F;
    const schuler_vec3 up = linear_up(n, s->r_e);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            F.m[LINEAR_DR + i][LINEAR_DR + j] -= n->gains.k1_ps * up.v[i] * up.v[j];
            F.m[LINEAR_DV + i][LINEAR_DR + j] -= n->gains.k2_ps2 * up.v[i] * up.v[j];
        }
        F.m[LINEAR_DV + i][LINEAR_A] = -up.v[i];
        F.m[LINEAR_A][LINEAR_DR + i] = n->gains.k3_ps3 * up.v[i];
    }
    return F;
}

/* Held to the truth: the height is the true one, and so is the velocity along the navigator's own vertical,
 * which leans by the horizontal error over the radius. */
static linear_matrix hold(const linear_stretch *s, const linear_navigator *n)
{
    linear_matrix H = { { { 0 } } };
    const schuler_vec3 up = linear_up(n, s->end_r_e);
    const double radius_m = schuler_vec3_norm(s->end_r_e);
    const double climb = schuler_vec3_dot(s->end_v_e, up);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double level = (i == j) - up.v[i] * up.v[j];
            H.m[LINEAR_DR + i][LINEAR_DR + j] = level;
            H.m[LINEAR_DV + i][LINEAR_DV + j] = level;
            H.m[LINEAR_PSI + i][LINEAR_PSI + j] = i == j;
            H.m[LINEAR_DV + i][LINEAR_DR + j] =
                -up.v[i] * (s->end_v_e.v[j] - climb * up.v[j]) / radius_m;
        }
    H.m[LINEAR_A][LINEAR_A] = 1.0;
    return H;
}

/* Holds come many times in a stretch, and what a vertical force does in between grows with their interval. */
static void damp_vertical_input(const linear_stretch *s, const linear_navigator *n,
                                linear_matrix *drive)
{
    const schuler_vec3 up = linear_up(n, s->r_e);
    const double less = 1.0 - fmin(n->hold_s / s->T_s, 1.0);
    for (int i = 0; i < N; i++) {
        double along = 0.0;
        for (int j = 0; j < 3; j++) along += drive->m[i][LINEAR_DV + j] * up.v[j];
        for (int j = 0; j < 3; j++) drive->m[i][LINEAR_DV + j] -= less * along * up.v[j];
    }
}

void linear_stretch_matrices(const linear_stretch *s, const linear_navigator *n,
                             linear_matrix *transition, linear_matrix *drive)
{
    enum { TERMS = 4 }; /* (F T)^5/5! of a second is 1e-8 */
    const linear_matrix F = dynamics(s, n);
    linear_matrix power = { { { 0 } } }, mean = { { { 0 } } };
    memset(transition, 0, sizeof *transition);
    for (int i = 0; i < N; i++) power.m[i][i] = 1.0;
    double factorial = 1.0; /* T^k/k! in power */
    for (int k = 0; k <= TERMS; k++) {
        factorial = k == 0 ? 1.0 : factorial * s->T_s / k;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                transition->m[i][j] += factorial * power.m[i][j];
                mean.m[i][j] += factorial / (k + 1) * power.m[i][j];
            }
        if (k < TERMS) power = product(&F, &power);
    }
    /* The column of the barometer's error is not the state's own. */
    for (int i = 0; i < N; i++) mean.m[i][LINEAR_A] = 0.0;
    if (n->vertical == SCHULER_VERTICAL_BARO) {
        const schuler_vec3 up = linear_up(n, s->r_e);
        double into[N] = { 0 };
        for (int i = 0; i < 3; i++) {
            into[LINEAR_DR + i] = n->gains.k1_ps * up.v[i];
            into[LINEAR_DV + i] = n->gains.k2_ps2 * up.v[i];
        }
        into[LINEAR_A] = -n->gains.k3_ps3;
        for (int i = 0; i < N; i++) {
            double sum = i == LINEAR_A ? into[LINEAR_A] : 0.0;
            for (int j = 0; j < LINEAR_A; j++) sum += mean.m[i][j] * into[j];
            mean.m[i][LINEAR_A] = sum;
        }
    }
    *drive = mean;
    if (n->vertical == SCHULER_VERTICAL_TRUTH) {
        const linear_matrix H = hold(s, n);
        *transition = product(&H, transition);
        damp_vertical_input(s, n, &mean);
        *drive = product(&H, &mean);
    }
}

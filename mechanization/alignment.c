/* SPDX-License-Identifier: MIT */
#include "mechanization/alignment.h"
#include "mechanization/aligner.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const schuler_aligner *schuler_aligner_for(schuler_isa isa)
{
#define X(name) extern const schuler_aligner schuler_aligner_##name;
#include "schuler_isas.def"
#undef X
    static const schuler_aligner *const all[] = {
#define X(name) &schuler_aligner_##name,
#include "schuler_isas.def"
#undef X
    };
    return all[isa];
}

struct schuler_alignment {
    schuler_alignment_setup setup;
    double (*gain)[3][3]; /* of each interval */
};

/* The integral of f_i over the interval that ends `left_s` before the end, divided by its length. */
static schuler_vec3 mean_force(schuler_vec3 g_e, double left_s, double interval_s)
{
    const double W = SCHULER_OMEGA_IE_RADPS, half = 0.5 * W * interval_s;
    const double angle = -W * (left_s + 0.5 * interval_s);
    const double s = sin(half) / half; /* the mean of a turning vector is shorter */
    return (schuler_vec3){ { -s * (cos(angle) * g_e.v[0] - sin(angle) * g_e.v[1]),
                             -s * (sin(angle) * g_e.v[0] + cos(angle) * g_e.v[1]), -g_e.v[2] } };
}

static schuler_mat3 cross_matrix(schuler_vec3 a)
{
    return (schuler_mat3){
        { { 0.0, -a.v[2], a.v[1] }, { a.v[2], 0.0, -a.v[0] }, { -a.v[1], a.v[0], 0.0 } }
    };
}

/* Inverse of a symmetric positive definite matrix, by cofactors. */
static schuler_mat3 inverse(const schuler_mat3 *S)
{
    schuler_mat3 out;
    double det = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            out.m[j][i] = S->m[a][c] * S->m[b][d] - S->m[a][d] * S->m[b][c];
        }
    for (int j = 0; j < 3; j++) det += S->m[0][j] * out.m[j][0];
    for (int i = 0; i < 9; i++) out.m[i / 3][i % 3] /= det;
    return out;
}

/* Riccati recursion: measured - expected = [f x] phi + noise, phi walks. */
static void make_gains(schuler_alignment *a, schuler_vec3 g_e)
{
    const schuler_alignment_setup *const s = &a->setup;
    const double R = s->accel_noise * s->accel_noise / s->interval_s;
    const double Q = s->gyro_noise * s->gyro_noise * s->interval_s;
    const double unknown = 1.0; /* rad^2: nothing is known at first */
    schuler_mat3 P = { { { unknown, 0, 0 }, { 0, unknown, 0 }, { 0, 0, unknown } } };
    for (size_t k = 0; k < s->intervals; k++) {
        const double left_s = (double)(s->intervals - 1 - k) * s->interval_s;
        const schuler_mat3 H = cross_matrix(mean_force(g_e, left_s, s->interval_s));
        const schuler_mat3 Ht = schuler_mat3_transpose(&H);
        if (k > 0)
            for (int i = 0; i < 3; i++) P.m[i][i] += Q;
        const schuler_mat3 PHt = schuler_mat3_mul(&P, &Ht);
        schuler_mat3 S = schuler_mat3_mul(&H, &PHt);
        for (int i = 0; i < 3; i++) S.m[i][i] += R;
        const schuler_mat3 Si = inverse(&S), K = schuler_mat3_mul(&PHt, &Si);
        /* Joseph's form keeps it symmetric and positive. */
        schuler_mat3 L = schuler_mat3_mul(&K, &H);
        for (int i = 0; i < 9; i++) L.m[i / 3][i % 3] = (i % 4 == 0) - L.m[i / 3][i % 3];
        const schuler_mat3 Lt = schuler_mat3_transpose(&L), LP = schuler_mat3_mul(&L, &P);
        const schuler_mat3 LPL = schuler_mat3_mul(&LP, &Lt), Kt = schuler_mat3_transpose(&K);
        const schuler_mat3 KK = schuler_mat3_mul(&K, &Kt);
        for (int i = 0; i < 9; i++)
            P.m[i / 3][i % 3] = LPL.m[i / 3][i % 3] + R * KK.m[i / 3][i % 3];
        memcpy(a->gain[k], K.m, sizeof K.m);
    }
}

schuler_status schuler_alignment_create(schuler_alignment **out,
                                        const schuler_alignment_setup *setup, schuler_vec3 g_e)
{
    *out = NULL;
    /* Gravity that turns by less than a hundredth of what it does at the equator shows no north. */
    if (hypot(g_e.v[0], g_e.v[1]) < 0.01 * schuler_vec3_norm(g_e)) return SCHULER_ERR_NUMERIC;
    schuler_alignment *const a = calloc(1, sizeof *a);
    if (!a) return SCHULER_ERR_MEMORY;
    a->setup = *setup;
    a->gain = malloc(setup->intervals * sizeof *a->gain);
    if (!a->gain) {
        free(a);
        return SCHULER_ERR_MEMORY;
    }
    make_gains(a, g_e);
    *out = a;
    return SCHULER_OK;
}

void schuler_alignment_free(schuler_alignment *a)
{
    if (!a) return;
    free(a->gain);
    free(a);
}

/* Axes of a triad from two vectors, the first one kept. */
static schuler_mat3 triad(schuler_vec3 first, schuler_vec3 second)
{
    const schuler_vec3 cross = schuler_vec3_cross(first, second);
    const schuler_vec3 a = schuler_vec3_scale(1.0 / schuler_vec3_norm(first), first);
    const double size = schuler_vec3_norm(cross);
    const schuler_vec3 b = schuler_vec3_scale(size > 0.0 ? 1.0 / size : 0.0, cross);
    const schuler_vec3 c = schuler_vec3_cross(a, b);
    schuler_mat3 m;
    for (int i = 0; i < 3; i++) m.m[i][0] = a.v[i], m.m[i][1] = b.v[i], m.m[i][2] = c.v[i];
    return m;
}

static schuler_vec3 sum_force(const schuler_alignment *a, schuler_vec3 g_e, size_t from, size_t to)
{
    const double T = a->setup.interval_s;
    const double left_s = (double)(a->setup.intervals - to) * T;
    return mean_force(g_e, left_s, (double)(to - from) * T);
}

static schuler_quat coarse(const schuler_alignment *a, schuler_vec3 g_e, const schuler_vec3 *v_b0)
{
    const size_t n = a->setup.intervals, half = n / 2;
    const schuler_vec3 whole_b0 = schuler_vec3_sub(v_b0[n], v_b0[0]);
    const schuler_vec3 late_b0 = schuler_vec3_sub(v_b0[n], v_b0[n - half]);
    const schuler_mat3 i = triad(sum_force(a, g_e, 0, n), sum_force(a, g_e, n - half, n));
    const schuler_mat3 b = triad(whole_b0, late_b0), bt = schuler_mat3_transpose(&b);
    const schuler_mat3 C_b0_i = schuler_mat3_mul(&i, &bt);
    return schuler_quat_from_mat3(&C_b0_i);
}

/* The angles of the rest, from all intervals in order. */
static schuler_vec3 filter(const schuler_alignment *a, schuler_vec3 g_e, const schuler_vec3 *v_b0,
                           schuler_quat q_b0_i)
{
    const double T = a->setup.interval_s;
    const schuler_mat3 C_b0_i = schuler_mat3_from_quat(q_b0_i);
    schuler_vec3 phi = { { 0.0, 0.0, 0.0 } };
    for (size_t k = 0; k < a->setup.intervals; k++) {
        const double left_s = (double)(a->setup.intervals - 1 - k) * T;
        const schuler_vec3 f = mean_force(g_e, left_s, T);
        const schuler_vec3 f_b0 =
            schuler_vec3_scale(1.0 / T, schuler_vec3_sub(v_b0[k + 1], v_b0[k]));
        const schuler_vec3 expected = schuler_vec3_add(f, schuler_vec3_cross(f, phi));
        const schuler_vec3 rest = schuler_vec3_sub(schuler_mat3_apply(&C_b0_i, f_b0), expected);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) phi.v[i] += a->gain[k][i][j] * rest.v[j];
    }
    return phi;
}

schuler_quat schuler_alignment_solve(const schuler_alignment *a, schuler_vec3 g_e,
                                     const schuler_vec3 *v_b0, schuler_quat q_b_b0)
{
    schuler_quat q_b0_i = coarse(a, g_e, v_b0);
    /* Computed = (I - [phi x]) true. What is large is not linear: again from where it leads. */
    for (int again = 0; again < 3 && a->setup.fine; again++) {
        const schuler_vec3 phi = filter(a, g_e, v_b0, q_b0_i);
        q_b0_i = schuler_quat_mul(schuler_quat_from_rotvec(phi), q_b0_i);
    }
    return schuler_quat_mul(q_b0_i, q_b_b0);
}

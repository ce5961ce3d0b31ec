/* SPDX-License-Identifier: MIT */
/* Small vectors, matrices and quaternions for scalar code. Frames are in the names: x_a resolved in
 * a; C_a_b and q_a_b take components from a to b. Quaternions: scalar first, Hamilton product. */
#ifndef SCHULER_CORE_VEC_H
#define SCHULER_CORE_VEC_H

#include "core/api.h"
#include <math.h>

SCHULER_BEGIN_C

typedef struct {
    double v[3];
} schuler_vec3;

typedef struct {
    double m[3][3];
} schuler_mat3;

typedef struct {
    double w, x, y, z;
} schuler_quat;

static inline schuler_vec3 schuler_vec3_add(schuler_vec3 a, schuler_vec3 b)
{
    const schuler_vec3 result = { { a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2] } };
    return result;
}

static inline schuler_vec3 schuler_vec3_sub(schuler_vec3 a, schuler_vec3 b)
{
    const schuler_vec3 result = { { a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2] } };
    return result;
}

static inline schuler_vec3 schuler_vec3_scale(double k, schuler_vec3 a)
{
    const schuler_vec3 result = { { k * a.v[0], k * a.v[1], k * a.v[2] } };
    return result;
}

static inline double schuler_vec3_dot(schuler_vec3 a, schuler_vec3 b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

static inline schuler_vec3 schuler_vec3_cross(schuler_vec3 a, schuler_vec3 b)
{
    const schuler_vec3 result = { { a.v[1] * b.v[2] - a.v[2] * b.v[1],
                                    a.v[2] * b.v[0] - a.v[0] * b.v[2],
                                    a.v[0] * b.v[1] - a.v[1] * b.v[0] } };
    return result;
}

static inline double schuler_vec3_norm(schuler_vec3 a)
{
    return sqrt(schuler_vec3_dot(a, a));
}

static inline schuler_vec3 schuler_mat3_apply(const schuler_mat3 *C_a_b, schuler_vec3 x_a)
{
    schuler_vec3 x_b;
    for (int i = 0; i < 3; i++)
        x_b.v[i] =
            C_a_b->m[i][0] * x_a.v[0] + C_a_b->m[i][1] * x_a.v[1] + C_a_b->m[i][2] * x_a.v[2];
    return x_b;
}

/* The transposed matrix applied: x_a from x_b without forming C_b_a. */
static inline schuler_vec3 schuler_mat3_apply_transposed(const schuler_mat3 *C_a_b,
                                                         schuler_vec3 x_b)
{
    schuler_vec3 x_a;
    for (int i = 0; i < 3; i++)
        x_a.v[i] =
            C_a_b->m[0][i] * x_b.v[0] + C_a_b->m[1][i] * x_b.v[1] + C_a_b->m[2][i] * x_b.v[2];
    return x_a;
}

static inline schuler_mat3 schuler_mat3_mul(const schuler_mat3 *C_b_c, const schuler_mat3 *C_a_b)
{
    schuler_mat3 C_a_c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C_a_c.m[i][j] = C_b_c->m[i][0] * C_a_b->m[0][j] + C_b_c->m[i][1] * C_a_b->m[1][j] +
                            C_b_c->m[i][2] * C_a_b->m[2][j];
    return C_a_c;
}

static inline schuler_mat3 schuler_mat3_transpose(const schuler_mat3 *C)
{
    schuler_mat3 T;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) T.m[i][j] = C->m[j][i];
    return T;
}

/* Hamilton product: q_a_c = q_b_c * q_a_b. */
static inline schuler_quat schuler_quat_mul(schuler_quat p, schuler_quat q)
{
    const schuler_quat result = { p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
                                  p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
                                  p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
                                  p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w };
    return result;
}

static inline schuler_quat schuler_quat_conj(schuler_quat q)
{
    const schuler_quat result = { q.w, -q.x, -q.y, -q.z };
    return result;
}

/** Rotation matrix of a unit quaternion, and back (the w >= 0 one of the two). */
SCHULER_API schuler_mat3 schuler_mat3_from_quat(schuler_quat q_a_b);
SCHULER_API schuler_quat schuler_quat_from_mat3(const schuler_mat3 *C_a_b);

/** Rotation vector (rad) to quaternion and back. q = [cos(|phi|/2), sin(|phi|/2) phi/|phi|]; zero
 *  gives the identity, full precision down to zero; the inverse returns |phi| <= pi. */
SCHULER_API schuler_quat schuler_quat_from_rotvec(schuler_vec3 phi);
SCHULER_API schuler_vec3 schuler_quat_to_rotvec(schuler_quat q);

/** Euler angles Z-Y-X (heading, pitch, roll; rad) to C_b_n and back. At |pitch| = 90 deg roll is
 *  returned as 0 and heading takes the whole rotation. Heading in [0, 2 pi). */
SCHULER_API schuler_mat3 schuler_mat3_from_euler(double roll_rad, double pitch_rad,
                                                 double heading_rad);
SCHULER_API void schuler_euler_from_mat3(const schuler_mat3 *C_b_n, double *roll_rad,
                                         double *pitch_rad, double *heading_rad);

SCHULER_END_C

#endif

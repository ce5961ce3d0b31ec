/* SPDX-License-Identifier: MIT */
#include "core/vec.h"
#include "core/earth.h"

schuler_mat3 schuler_mat3_from_quat(schuler_quat q)
{
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return (schuler_mat3){ {
        { 1.0 - 2.0 * (yy + zz), 2.0 * (xy - wz), 2.0 * (xz + wy) },
        { 2.0 * (xy + wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz - wx) },
        { 2.0 * (xz - wy), 2.0 * (yz + wx), 1.0 - 2.0 * (xx + yy) },
    } };
}

/* The largest of the four components is found first (a sum of diagonal elements is four times its
 * square), so that the division by it never loses digits. */
schuler_quat schuler_quat_from_mat3(const schuler_mat3 *C)
{
    const double xx = C->m[0][0], yy = C->m[1][1], zz = C->m[2][2];
    const double square4[4] = { 1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz,
                                1.0 - xx - yy + zz };
    int largest = 0;
    for (int i = 1; i < 4; i++)
        if (square4[i] > square4[largest]) largest = i;

    const double wx4 = C->m[2][1] - C->m[1][2], wy4 = C->m[0][2] - C->m[2][0],
                 wz4 = C->m[1][0] - C->m[0][1];
    const double xy4 = C->m[0][1] + C->m[1][0], xz4 = C->m[0][2] + C->m[2][0],
                 yz4 = C->m[1][2] + C->m[2][1];
    const double rows[4][4] = {
        { square4[0], wx4, wy4, wz4 },
        { wx4, square4[1], xy4, xz4 },
        { wy4, xy4, square4[2], yz4 },
        { wz4, xz4, yz4, square4[3] },
    };
    const double *const q4 = rows[largest];
    double k = 1.0 / sqrt(q4[0] * q4[0] + q4[1] * q4[1] + q4[2] * q4[2] + q4[3] * q4[3]);
    if (q4[0] < 0.0) k = -k;
    return (schuler_quat){ k * q4[0], k * q4[1], k * q4[2], k * q4[3] };
}

schuler_quat schuler_quat_from_rotvec(schuler_vec3 phi)
{
    const double a2 = 0.25 * schuler_vec3_dot(phi, phi), a = sqrt(a2);
    /* sin(a)/a is 0/0 at rest, so switch to its series: the first dropped term, a^4/120, is below
     * double rounding at the switch. */
    const double k = a2 < 1e-8 ? 0.5 * (1.0 - a2 / 6.0) : 0.5 * sin(a) / a;
    return (schuler_quat){ cos(a), k * phi.v[0], k * phi.v[1], k * phi.v[2] };
}

schuler_vec3 schuler_quat_to_rotvec(schuler_quat q)
{
    const double sign = q.w < 0.0 ? -1.0 : 1.0;
    const schuler_vec3 v = { { sign * q.x, sign * q.y, sign * q.z } };
    const double w = sign * q.w, n2 = schuler_vec3_dot(v, v);
    /* Below this the squares lose digits to underflow, and angle/sin(angle/2) is 2 to rounding. */
    if (n2 < 1e-280) return schuler_vec3_scale(2.0, v);
    const double n = sqrt(n2);
    return schuler_vec3_scale(2.0 * atan2(n, w) / n, v);
}

schuler_mat3 schuler_mat3_from_euler(double roll_rad, double pitch_rad, double heading_rad)
{
    const double cr = cos(roll_rad), sr = sin(roll_rad);
    const double cp = cos(pitch_rad), sp = sin(pitch_rad);
    const double ch = cos(heading_rad), sh = sin(heading_rad);
    return (schuler_mat3){ {
        { ch * cp, ch * sp * sr - sh * cr, ch * sp * cr + sh * sr },
        { sh * cp, sh * sp * sr + ch * cr, sh * sp * cr - ch * sr },
        { -sp, cp * sr, cp * cr },
    } };
}

void schuler_euler_from_mat3(const schuler_mat3 *C, double *roll_rad, double *pitch_rad,
                             double *heading_rad)
{
    const double cos_pitch = hypot(C->m[2][1], C->m[2][2]);
    *pitch_rad = atan2(-C->m[2][0], cos_pitch);
    double heading;
    if (cos_pitch < 1e-12) { /* roll and heading turn about the same axis */
        *roll_rad = 0.0;
        heading = atan2(-C->m[0][1], C->m[1][1]);
    } else {
        *roll_rad = atan2(C->m[2][1], C->m[2][2]);
        heading = atan2(C->m[1][0], C->m[0][0]);
    }
    if (heading < 0.0) heading += 2.0 * SCHULER_PI;
    /* A tiny negative angle rounds up to the full turn, which the range excludes. */
    *heading_rad = heading < 2.0 * SCHULER_PI ? heading : 0.0;
}

/* SPDX-License-Identifier: MIT */
/* Two-axis gyros: the x and y gyros as channels of one rotor, whose spin axis is the x gyro's. Both then
 * have the same errors of mass, each on its own right-handed axes i, o, s: with the spin along z they
 * are x: (x, y, z) and y: (y, -x, z), from which the signs of the quadrature terms follow. */
#ifndef SCHULER_SENSORS_ROTOR_H
#define SCHULER_SENSORS_ROTOR_H

#include "core/truth_nodes.h"
#include "sensors/params.h"
#include <math.h>

#define ROTOR_KIND                                                                                 \
    PARAM_CHOICE(                                                                                  \
        "kind", rotor_kinds, "single_axis",                                                        \
        "single_axis, or tuned_rotor: the x and y gyros are one rotor with the spin axis "         \
        "of x, and y has the errors of mass of x")
static const char *const rotor_kinds[] = { "single_axis", "tuned_rotor", NULL };

/* Room for what the y gyro sees on its output and spin axis. */
typedef struct {
    double f[2][SCHULER_NODES_MAX][SCHULER_BLOCK], omega[2][SCHULER_NODES_MAX][SCHULER_BLOCK];
    double omega_end[2][SCHULER_BLOCK + 1];
} rotor_room;

static inline void rotor_project(const double axis[3], const double *const x[3], int count,
                                 double *out)
{
    for (int k = 0; k < count; k++)
        out[k] = axis[0] * x[0][k] + axis[1] * x[1][k] + axis[2] * x[2][k];
}

/* The output (0) and spin (1) axis of the y channel, as components on the axes i, o, s of the x gyro.
 * Returned: whether there are any; there are none when y's input axis is the spin axis. */
static inline int rotor_axes(const schuler_view *v, double out[2][3])
{
    double i[3];
    for (int c = 0; c < 3; c++) {
        i[c] = 0.0;
        for (int j = 0; j < 3; j++) i[c] += v->axes[1][0][j] * v->axes[0][c][j];
    }
    /* The spin axis, (0, 0, 1), less its part along i. */
    const double length = sqrt(i[0] * i[0] + i[1] * i[1]);
    if (!(length > 1e-3)) return 0;
    const double s[3] = { -i[2] * i[0] / length, -i[2] * i[1] / length, length };
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        out[0][c] = s[a] * i[b] - s[b] * i[a];
        out[1][c] = s[c];
    }
    return 1;
}

/* A view in which the y gyro is the other channel of the x gyro's rotor. */
static inline schuler_view rotor_view(const schuler_view *v, rotor_room *room)
{
    schuler_view shared = *v;
    double axes[2][3];
    if (!rotor_axes(v, axes)) return shared;
    for (int a = 0; a < 2; a++) {
        for (int j = 0; j < v->nodes; j++) {
            const int at = j * SCHULER_BLOCK;
            const double *const f[3] = { v->f[0][0] + at, v->f[0][1] + at, v->f[0][2] + at };
            const double *const omega[3] = { v->omega[0][0] + at, v->omega[0][1] + at,
                                             v->omega[0][2] + at };
            rotor_project(axes[a], f, v->n, room->f[a][j]);
            rotor_project(axes[a], omega, v->n, room->omega[a][j]);
        }
        rotor_project(axes[a], v->omega_end[0], v->n + 1, room->omega_end[a]);
        shared.f[1][a + 1] = room->f[a][0];
        shared.omega[1][a + 1] = room->omega[a][0];
        shared.omega_end[1][a + 1] = room->omega_end[a];
    }
    return shared;
}

/* Whose errors of mass a gyro has. */
static inline int rotor_of(int is_shared, int axis)
{
    return is_shared && axis == 1 ? 0 : axis;
}

/* Coefficients of omega_o and omega_s from the angles xy, xz, ..., zy. The y channel of a rotor has
 * minus x as its output axis. */
static inline void rotor_misalignment(const double angles[6], int is_shared, int axis, double *o,
                                      double *s)
{
    const double next = angles[cross_component(axis, 1)], last = angles[cross_component(axis, 2)];
    const int other = is_shared && axis == 1;
    *o = other ? -last : next;
    *s = other ? next : last;
}

#endif

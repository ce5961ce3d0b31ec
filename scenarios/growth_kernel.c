/* SPDX-License-Identifier: MIT */
#include "scenarios/growth_kernel.h"
#include <string.h>

/* x(k): x1 = sin(w t)/w, each next one the integral of the one before. Below one radian the closed
 * forms lose digits to cancellation, and twelve terms of the series are exact to 1e-18. */
static double pendulum(int k, double w_radps, double t_s)
{
    const double angle = w_radps * t_s, w2 = w_radps * w_radps;
    if (angle < 1.0) {
        double term = 1.0, sum = 0.0;
        for (int i = 1; i <= k; i++) term *= t_s / i;
        for (int m = 0; m < 12; m++) {
            sum += term;
            term *= -angle * angle / ((k + 2 * m + 1) * (k + 2 * m + 2));
        }
        return sum;
    }
    if (k == 1) return sin(angle) / w_radps;
    if (k == 2) return (1.0 - cos(angle)) / w2;
    double power = t_s; /* t^(k-2)/(k-2)! */
    for (int i = 2; i <= k - 2; i++) power *= t_s / i;
    return (power - pendulum(k - 2, w_radps, t_s)) / w2;
}

static double grown(const growth_kernel *k, int channel, int order)
{
    const double t_s = k->dt_s * (double)k->step;
    return pendulum(
        order,
        k->law == SCHULER_GROWTH_FIRST ? 0.0 : sqrt(k->rest->g_mps2 / k->rest->radius_m[channel]),
        t_s);
}

/* Each channel by itself. Signs: f x psi with f = (0, 0, -g), psi' = -(error of the rate), and the
 * earth's rate about north turns an error of heading into one about east. */
static void closed_form(const growth_kernel *k, double out_m[2])
{
    const double *const u = k->u_n, g = k->rest->g_mps2;
    const double rate = SCHULER_OMEGA_IE_RADPS * cos(k->rest->lat_rad); /* horizontal part */
    const int n = (int)k->shape;
    switch (k->entry) {
    case SCHULER_ENTERS_POSITION:
        out_m[0] = u[0];
        out_m[1] = u[1];
        break;
    case SCHULER_ENTERS_VELOCITY:
    case SCHULER_ENTERS_ACCEL:
        out_m[0] = u[0] * grown(k, 0, n + 1);
        out_m[1] = u[1] * grown(k, 1, n + 1);
        break;
    case SCHULER_ENTERS_TILT:
    case SCHULER_ENTERS_HEADING: /* psi is u, and an impulse of the rate makes -u of it */
        out_m[0] = g * (u[1] * grown(k, 0, 2) + rate * u[2] * grown(k, 0, 3));
        out_m[1] = -g * u[0] * grown(k, 1, 2);
        break;
    case SCHULER_ENTERS_GYRO:
        out_m[0] = -g * (u[1] * grown(k, 0, n + 2) + rate * u[2] * grown(k, 0, n + 3));
        out_m[1] = g * u[0] * grown(k, 1, n + 2);
        break;
    }
}

/* Level psi-angle model at rest: x' = A x. */
static void level_model(const growth_kernel *k, double A[KERNEL_STATES][KERNEL_STATES])
{
    const schuler_rest *const at = k->rest;
    const double g = at->g_mps2, north = SCHULER_OMEGA_IE_RADPS * cos(at->lat_rad),
                 down = -SCHULER_OMEGA_IE_RADPS * sin(at->lat_rad);
    memset(A, 0, sizeof(double[KERNEL_STATES][KERNEL_STATES]));
    A[0][2] = A[1][3] = 1.0;
    A[2][0] = -g / at->radius_m[0];
    A[3][1] = -g / at->radius_m[1];
    A[2][3] = 2.0 * down; /* Coriolis */
    A[3][2] = -2.0 * down;
    A[2][5] = g;
    A[3][4] = -g;
    A[4][5] = down; /* -omega_ie x psi */
    A[5][4] = -down;
    A[5][6] = north;
    A[6][5] = -north;
    A[7][8] = 1.0;
    for (int i = 0; i < 3; i++)
        if (k->entry == SCHULER_ENTERS_GYRO)
            A[4 + i][7] = -k->u_n[i];
        else if (i < 2)
            A[2 + i][7] = k->u_n[i];
}

/* exp(A dt). Steps are a fiftieth of a radian of the pendulum: the first term dropped is 1e-30. */
static void exponential(const double A[KERNEL_STATES][KERNEL_STATES], double dt_s,
                        double out[KERNEL_STATES][KERNEL_STATES])
{
    enum { TERMS = 16 };
    double term[KERNEL_STATES][KERNEL_STATES] = { { 0 } };
    for (int i = 0; i < KERNEL_STATES; i++) term[i][i] = 1.0;
    memcpy(out, term, sizeof term);
    for (int n = 1; n < TERMS; n++) {
        double next[KERNEL_STATES][KERNEL_STATES] = { { 0 } };
        for (int i = 0; i < KERNEL_STATES; i++)
            for (int j = 0; j < KERNEL_STATES; j++) {
                for (int m = 0; m < KERNEL_STATES; m++) next[i][j] += A[i][m] * term[m][j];
                next[i][j] *= dt_s / n;
                out[i][j] += next[i][j];
            }
        memcpy(term, next, sizeof term);
    }
}

/* A navigator that is off but level there: psi = -(the angle between the two places). Its turn about
 * the vertical, tan(L) r/R, has no meaning where north has none, 60 km about the poles. */
static void displace(const growth_kernel *k, double x[KERNEL_STATES])
{
    const double *const R = k->rest->radius_m, lat_rad = k->rest->lat_rad;
    x[0] = k->u_n[0];
    x[1] = k->u_n[1];
    x[4] = -x[1] / R[1];
    x[5] = x[0] / R[0];
    x[6] = cos(lat_rad) > 0.01 ? x[1] / R[1] * tan(lat_rad) : 0.0;
}

void growth_kernel_start(growth_kernel *k, const schuler_growth *growth, int component,
                         const schuler_rest *rest, schuler_growth_law law, kernel_shape shape,
                         double dt_s)
{
    *k = (growth_kernel){
        .entry = growth->entry, .law = law, .shape = shape, .rest = rest, .dt_s = dt_s
    };
    memcpy(k->u_n, growth->axis_n[component], sizeof k->u_n);
    if (law != SCHULER_GROWTH_EARTH) return;
    double A[KERNEL_STATES][KERNEL_STATES];
    level_model(k, A);
    exponential((const double(*)[KERNEL_STATES])A, dt_s, k->transition);
    if (growth->entry == SCHULER_ENTERS_POSITION)
        displace(k, k->x);
    else if (growth->entry == SCHULER_ENTERS_TILT || growth->entry == SCHULER_ENTERS_HEADING)
        memcpy(k->x + 4, k->u_n, sizeof k->u_n);
    else if (growth->entry == SCHULER_ENTERS_VELOCITY)
        memcpy(k->x + 2, k->u_n, 2 * sizeof *k->u_n);
    else if (shape == KERNEL_IMPULSE)
        for (int i = 0; i < 7; i++) k->x[i] = A[i][7];
    else
        k->x[6 + shape] = 1.0;
}

void growth_kernel_at(const growth_kernel *k, double out_m[2])
{
    if (k->law == SCHULER_GROWTH_EARTH)
        memcpy(out_m, k->x, 2 * sizeof *out_m);
    else
        closed_form(k, out_m);
}

void growth_kernel_step(growth_kernel *k)
{
    k->step++;
    if (k->law != SCHULER_GROWTH_EARTH) return;
    double next[KERNEL_STATES] = { 0 };
    for (int i = 0; i < KERNEL_STATES; i++)
        for (int j = 0; j < KERNEL_STATES; j++) next[i] += k->transition[i][j] * k->x[j];
    memcpy(k->x, next, sizeof next);
}

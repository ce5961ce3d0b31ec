/* SPDX-License-Identifier: MIT */
/* Increments of angle and velocity with steps as lanes. The Gauss-Legendre nodes of a step are
 * taken one after the other, so that nothing is ever added across lanes. */
#include "core/truth_lanes.h"
#include "core/gravity_lanes.h"
#include "core/lanes3.h"

#define UNROLL _Pragma("GCC unroll 16")

LANES_INLINE lanes power_series(const double *c, int terms, lanes s)
{
    lanes sum = lanes_set(c[terms - 1]);
    UNROLL
    for (int k = terms - 2; k >= 0; k--) sum = sum * s + c[k];
    return sum;
}

/* What the turning of the frame needs of the rotation vector: k1 = sin x/x, k2 = (1 - cos x)/x^2,
 * k3 = (x - sin x)/x^3. Within |rho| <= 0.25 the first dropped terms are below 1e-17. */
LANES_INLINE void rotation_factors(lanes x2, lanes *k1, lanes *k2, lanes *k3)
{
    static const double for_k2[] = { 1.0 / 2.0,      -1.0 / 24.0,     1.0 / 720.0,
                                     -1.0 / 40320.0, 1.0 / 3628800.0, -1.0 / 479001600.0 };
    static const double for_k3[] = { 1.0 / 6.0,       -1.0 / 120.0,     1.0 / 5040.0,
                                     -1.0 / 362880.0, 1.0 / 39916800.0, -1.0 / 6227020800.0 };
    *k2 = power_series(for_k2, 6, x2);
    *k3 = power_series(for_k3, 6, x2);
    *k1 = 1.0 - x2 * *k3;
}

/* Components from b0 to b. */
LANES_INLINE lanes3 to_body(lanes3 rho, lanes k1, lanes k2, lanes3 x_b0)
{
    const lanes3 once = lanes3_cross(rho, x_b0), twice = lanes3_cross(rho, once);
    return lanes3_add(x_b0, lanes3_add(lanes3_scale(-k1, once), lanes3_scale(k2, twice)));
}

LANES_INLINE void rates(const schuler_truth_run *run, lanes s, lanes3 dg_e, lanes3 *omega_ib_b,
                        lanes3 *f_ib_b)
{
    const lanes x = run->r0_e[0] + power_series(run->dr_e[0], SCHULER_RUN_TERMS, s);
    const lanes y = run->r0_e[1] + power_series(run->dr_e[1], SCHULER_RUN_TERMS, s);
    const lanes z = run->r0_e[2] + power_series(run->dr_e[2], SCHULER_RUN_TERMS, s);
    lanes g_e[3];
    lanes_gravity(run->gravity, x, y, z, g_e);
    const lanes f0 = power_series(run->free_e[0], SCHULER_PIECE_DEGREE, s) - (g_e[0] + dg_e.x);
    const lanes f1 = power_series(run->free_e[1], SCHULER_PIECE_DEGREE, s) - (g_e[1] + dg_e.y);
    const lanes f2 = power_series(run->free_e[2], SCHULER_PIECE_DEGREE, s) - (g_e[2] + dg_e.z);
    const double(*const C)[3] = run->C_e_b0;
    const lanes3 f_ib_b0 = {
        C[0][0] * f0 + C[0][1] * f1 + C[0][2] * f2,
        C[1][0] * f0 + C[1][1] * f1 + C[1][2] * f2,
        C[2][0] * f0 + C[2][1] * f1 + C[2][2] * f2,
    };
    const lanes3 omega_ie_b0 = { lanes_set(run->omega_ie_b0[0]), lanes_set(run->omega_ie_b0[1]),
                                 lanes_set(run->omega_ie_b0[2]) };
    const lanes3 rho = { power_series(run->rho_b[0], SCHULER_PIECE_DEGREE, s),
                         power_series(run->rho_b[1], SCHULER_PIECE_DEGREE, s),
                         power_series(run->rho_b[2], SCHULER_PIECE_DEGREE, s) };
    const lanes3 rho_dot = { power_series(run->rho_dot_b[0], SCHULER_PIECE_DEGREE - 1, s),
                             power_series(run->rho_dot_b[1], SCHULER_PIECE_DEGREE - 1, s),
                             power_series(run->rho_dot_b[2], SCHULER_PIECE_DEGREE - 1, s) };
    lanes k1, k2, k3;
    rotation_factors(lanes3_dot(rho, rho), &k1, &k2, &k3);
    *f_ib_b = to_body(rho, k1, k2, f_ib_b0);

    /* omega_eb_b = rho' - k2 rho x rho' + k3 rho x (rho x rho') */
    const lanes3 once = lanes3_cross(rho, rho_dot), twice = lanes3_cross(rho, once);
    const lanes3 omega_eb_b =
        lanes3_add(rho_dot, lanes3_add(lanes3_scale(-k2, once), lanes3_scale(k3, twice)));
    *omega_ib_b = lanes3_add(omega_eb_b, to_body(rho, k1, k2, omega_ie_b0));
}

/* Up to a vector of doubles from anywhere, the rest zero; and back. */
LANES_INLINE lanes load_some(const double *p, int n)
{
    double some[SCHULER_LANES] = { 0 };
    memcpy(some, p, sizeof(double) * (size_t)n);
    lanes x;
    memcpy(&x, some, sizeof x);
    return x;
}

LANES_INLINE void store_some(double *p, int n, lanes x)
{
    double some[SCHULER_LANES];
    memcpy(some, &x, sizeof some);
    memcpy(p, some, sizeof(double) * (size_t)n);
}

LANES_INLINE lanes count_up(void)
{
    static const double numbers[8] = { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0 };
    lanes x;
    memcpy(&x, numbers, sizeof x);
    return x;
}

static void increments(const schuler_truth_run *run, double index, int at, int n,
                       const schuler_columns *dg_e, double (*dtheta)[SCHULER_BLOCK],
                       double (*dv)[SCHULER_BLOCK])
{
    const schuler_quadrature *const rule = run->rule;
    const double part = 1.0 / run->parts, part_s = run->dt_s * part;
    for (int i = 0; i < n; i += SCHULER_LANES) {
        const int some = n - i < SCHULER_LANES ? n - i : SCHULER_LANES;
        const lanes step = count_up() + (index + i);
        lanes3 dg = { lanes_set(0.0), lanes_set(0.0), lanes_set(0.0) };
        if (dg_e != NULL)
            dg = (lanes3){ load_some(&dg_e->v[0][at + i], some),
                           load_some(&dg_e->v[1][at + i], some),
                           load_some(&dg_e->v[2][at + i], some) };
        lanes3 theta = { lanes_set(0.0), lanes_set(0.0), lanes_set(0.0) }, v = theta;
        for (int p = 0; p < run->parts; p++)
            for (int j = 0; j < rule->count; j++) {
                const lanes s = run->s0 + (step + (p + rule->node[j]) * part) * run->ds;
                lanes3 omega_ib_b, f_ib_b;
                rates(run, s, dg, &omega_ib_b, &f_ib_b);
                const lanes w = lanes_set(rule->weight[j]);
                theta = lanes3_add(theta, lanes3_scale(w, omega_ib_b));
                v = lanes3_add(v, lanes3_scale(w, f_ib_b));
            }
        store_some(&dtheta[0][at + i], some, theta.x * part_s);
        store_some(&dtheta[1][at + i], some, theta.y * part_s);
        store_some(&dtheta[2][at + i], some, theta.z * part_s);
        store_some(&dv[0][at + i], some, v.x * part_s);
        store_some(&dv[1][at + i], some, v.y * part_s);
        store_some(&dv[2][at + i], some, v.z * part_s);
    }
}

static void points(const schuler_truth_run *run, double index, double fraction, int at, int n,
                   schuler_columns *f, schuler_columns *omega)
{
    const lanes3 no_dg = { lanes_set(0.0), lanes_set(0.0), lanes_set(0.0) };
    for (int i = 0; i < n; i += SCHULER_LANES) {
        const int some = n - i < SCHULER_LANES ? n - i : SCHULER_LANES;
        lanes3 omega_ib_b, f_ib_b;
        rates(run, run->s0 + ((count_up() + (index + i)) + fraction) * run->ds, no_dg, &omega_ib_b,
              &f_ib_b);
        store_some(&f->v[0][at + i], some, f_ib_b.x);
        store_some(&f->v[1][at + i], some, f_ib_b.y);
        store_some(&f->v[2][at + i], some, f_ib_b.z);
        store_some(&omega->v[0][at + i], some, omega_ib_b.x);
        store_some(&omega->v[1][at + i], some, omega_ib_b.y);
        store_some(&omega->v[2][at + i], some, omega_ib_b.z);
    }
}

static void gravity(const schuler_gravity_table *g, int n, const schuler_columns *r_e,
                    schuler_columns *gravity_e, double *height_m, double *normal_z)
{
    for (int i = 0; i < n; i += SCHULER_LANES) {
        const int some = n - i < SCHULER_LANES ? n - i : SCHULER_LANES;
        const lanes x = load_some(&r_e->v[0][i], some), y = load_some(&r_e->v[1][i], some),
                    z = load_some(&r_e->v[2][i], some);
        lanes g_e[3];
        lanes_gravity(g, x, y, z, g_e);
        for (int a = 0; a < 3; a++) store_some(&gravity_e->v[a][i], some, g_e[a]);
        store_some(&height_m[i], some, lanes_height(g, x, y, z));
        store_some(&normal_z[i], some, lanes_normal_z(g, x, y, z));
    }
}

extern const schuler_truth_lanes SCHULER_LANE_NAME(schuler_truth_lanes);
const schuler_truth_lanes SCHULER_LANE_NAME(schuler_truth_lanes) = {
    .increments = increments,
    .points = points,
    .gravity = gravity,
};

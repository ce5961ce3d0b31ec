/* SPDX-License-Identifier: MIT */
/* Weighted least squares for the gravity table, in the Chebyshev basis of the scaled variables, on
 * Chebyshev points in latitude and height. The normal equations are harmless (condition about 15).
 * They are solved here and not by a BLAS, whose last bits depend on the processor: this table is
 * part of every result. Extended precision costs nothing at this size and makes the rounding of the
 * result the only one. */
#include "core/gravity.h"
#include <string.h>

enum {
    DEGREE = SCHULER_GRAVITY_DEGREE,
    TERMS = SCHULER_GRAVITY_TERMS,
    QUANTITIES = 4, /* A, B, height, normal_z */
    LATITUDES = 16,
    HEIGHTS = 8,
};

static const double usual_accepted_mps2 = 1e-11;

typedef struct {
    long double lat, sin_lat, cos_lat, h;
    schuler_vec3 r_e;         /* at longitude 0: the field is one of revolution */
    long double height_off_m; /* h of the rounded r_e minus h, to first order */
} place;

/* The point's rounding to double moves it by 1e-9 m, which would be felt in the height: keep it. */
static place place_at(long double lat, long double h)
{
    place p = { .lat = lat, .sin_lat = sinl(lat), .cos_lat = cosl(lat), .h = h };
    const long double a = SCHULER_WGS84_A_M, e2 = SCHULER_WGS84_E2;
    const long double R_P = a / sqrtl(1.0L - e2 * p.sin_lat * p.sin_lat);
    const long double x = (R_P + h) * p.cos_lat, z = (R_P * (1.0L - e2) + h) * p.sin_lat;
    p.r_e = (schuler_vec3){ { (double)x, 0.0, (double)z } };
    p.height_off_m = (p.r_e.v[0] - x) * p.cos_lat + (p.r_e.v[2] - z) * p.sin_lat;
    return p;
}

static long double normal_z(const place *p)
{
    const long double a = SCHULER_WGS84_A_M, e2 = SCHULER_WGS84_E2;
    const long double R_P = a / sqrtl(1.0L - e2 * p->sin_lat * p->sin_lat);
    return (R_P + p->h) / (R_P * (1.0L - e2) + p->h);
}

/* On a normal at height h, u grows with h fastest at the poles: the box's ends are there. */
static void set_scales(schuler_gravity_table *g, double high_m)
{
    const long double a = SCHULER_WGS84_A_M, b = SCHULER_WGS84_B_M;
    const long double high = 1.0L + high_m / b, low = 1.0L + SCHULER_GRAVITY_LOW_M / b;
    const long double t_max = high * high, u_min = low * low - 1.0L, u_max = high * high - 1.0L;
    const long double u_scale = 2.0L / (u_max - u_min);
    g->t_scale = (double)(2.0L / (t_max * b * b));
    g->t_shift = -1.0;
    g->u_xy = (double)(u_scale / (a * a));
    g->u_z = (double)(u_scale / (b * b));
    g->u_shift = (double)(-u_scale - (u_max + u_min) / (u_max - u_min));
}

static void chebyshev(long double x, long double T[DEGREE + 1])
{
    T[0] = 1.0L;
    T[1] = x;
    for (int i = 2; i <= DEGREE; i++) T[i] = 2.0L * x * T[i - 1] - T[i - 2];
}

static void basis_at(const schuler_gravity_table *g, schuler_vec3 r_e, long double basis[TERMS])
{
    const long double x = r_e.v[0], z = r_e.v[2];
    long double in_t[DEGREE + 1], in_u[DEGREE + 1];
    chebyshev(g->t_scale * z * z + g->t_shift, in_t);
    chebyshev(g->u_xy * x * x + g->u_z * z * z + g->u_shift, in_u);
    for (int i = 0, k = 0; i <= DEGREE; i++)
        for (int j = 0; j <= DEGREE - i; j++) basis[k++] = in_t[i] * in_u[j];
}

/* Cholesky: N = L L^T in place (lower half), then N x = y in place. */
static void factor(long double N[TERMS][TERMS])
{
    for (int j = 0; j < TERMS; j++) {
        for (int k = 0; k < j; k++) N[j][j] -= N[j][k] * N[j][k];
        N[j][j] = sqrtl(N[j][j]);
        for (int i = j + 1; i < TERMS; i++) {
            for (int k = 0; k < j; k++) N[i][j] -= N[i][k] * N[j][k];
            N[i][j] /= N[j][j];
        }
    }
}

static void solve(long double L[TERMS][TERMS], long double y[TERMS])
{
    for (int i = 0; i < TERMS; i++) {
        for (int k = 0; k < i; k++) y[i] -= L[i][k] * y[k];
        y[i] /= L[i][i];
    }
    for (int i = TERMS - 1; i >= 0; i--) {
        for (int k = i + 1; k < TERMS; k++) y[i] -= L[k][i] * y[k];
        y[i] /= L[i][i];
    }
}

/* Coefficients of T_i(x) T_j(y) to those of x^i y^j. */
static void to_powers(const long double cheb[TERMS], double power[TERMS])
{
    long double T[DEGREE + 1][DEGREE + 1] = { { 1.0L }, { 0.0L, 1.0L } }; /* T[n][k]: x^k in T_n */
    for (int n = 2; n <= DEGREE; n++)
        for (int k = 0; k <= n; k++)
            T[n][k] = (k > 0 ? 2.0L * T[n - 1][k - 1] : 0.0L) - T[n - 2][k];
    long double sum[DEGREE + 1][DEGREE + 1];
    memset(sum, 0, sizeof sum);
    for (int i = 0, k = 0; i <= DEGREE; i++)
        for (int j = 0; j <= DEGREE - i; j++, k++)
            for (int p = 0; p <= i; p++)
                for (int q = 0; q <= j; q++) sum[p][q] += cheb[k] * T[i][p] * T[j][q];
    for (int i = 0, k = 0; i <= DEGREE; i++)
        for (int j = 0; j <= DEGREE - i; j++) power[k++] = (double)sum[i][j];
}

/* What is fitted at a place, and the weight that turns its residual into m/s^2 (A, B) or m
 * (height). */
static void sample(const schuler_field_model *field, const place *p, long double value[QUANTITIES],
                   long double weight[QUANTITIES])
{
    const schuler_vec3 g_e = schuler_field_normal_gravitation(field, p->r_e);
    value[0] = -(long double)g_e.v[0] / p->r_e.v[0];
    weight[0] = p->r_e.v[0];
    value[1] = -(long double)g_e.v[2] / p->r_e.v[2];
    weight[1] = p->r_e.v[2];
    value[2] = p->h + p->height_off_m;
    weight[2] = 1.0L;
    value[3] = normal_z(p);
    weight[3] = 1.0L;
}

static void fit(schuler_gravity_table *g, const schuler_field_model *field, double high_m)
{
    long double N[QUANTITIES][TERMS][TERMS], y[QUANTITIES][TERMS];
    memset(N, 0, sizeof N);
    memset(y, 0, sizeof y);
    const long double pi = SCHULER_PI;
    for (int a = 0; a < LATITUDES; a++)
        for (int b = 0; b < HEIGHTS; b++) {
            const long double lat = 0.25L * pi * (1.0L - cosl(pi * (a + 0.5L) / LATITUDES));
            const long double h =
                SCHULER_GRAVITY_LOW_M +
                0.5L * (high_m - SCHULER_GRAVITY_LOW_M) * (1.0L - cosl(pi * (b + 0.5L) / HEIGHTS));
            const place p = place_at(lat, h);
            long double basis[TERMS], value[QUANTITIES], weight[QUANTITIES];
            basis_at(g, p.r_e, basis);
            sample(field, &p, value, weight);
            for (int q = 0; q < QUANTITIES; q++)
                for (int i = 0; i < TERMS; i++) {
                    const long double w2 = weight[q] * weight[q] * basis[i];
                    y[q][i] += w2 * value[q];
                    for (int j = 0; j <= i; j++) N[q][i][j] += w2 * basis[j];
                }
        }
    double *const out[QUANTITIES] = { g->A, g->B, g->height, g->normal_z };
    for (int q = 0; q < QUANTITIES; q++) {
        factor(N[q]);
        solve(N[q], y[q]);
        to_powers(y[q], out[q]);
    }
}

/* Largest component error on a grid off the nodes that holds the poles and the box's edges. */
static double largest_error(const schuler_gravity_table *g, const schuler_field_model *field,
                            double high_m)
{
    enum { LAT_CHECKS = 37, HEIGHT_CHECKS = 17 };
    double worst = 0.0;
    for (int a = 0; a < LAT_CHECKS; a++)
        for (int b = 0; b < HEIGHT_CHECKS; b++) {
            const double lat_rad = SCHULER_PI * (0.5 - a / (LAT_CHECKS - 1.0));
            const double h_m = SCHULER_GRAVITY_LOW_M +
                               (high_m - SCHULER_GRAVITY_LOW_M) * b / (HEIGHT_CHECKS - 1.0);
            const schuler_vec3 r_e = schuler_ecef_from_llh((schuler_llh){ lat_rad, 0.1 * a, h_m });
            const double omega_radps = schuler_field_earth_rate(field);
            schuler_vec3 exact_e = schuler_field_normal_gravitation(field, r_e);
            exact_e.v[0] += omega_radps * omega_radps * r_e.v[0];
            exact_e.v[1] += omega_radps * omega_radps * r_e.v[1];
            const schuler_vec3 off_e = schuler_vec3_sub(schuler_gravity_at(g, r_e), exact_e);
            for (int i = 0; i < 3; i++)
                if (!(fabs(off_e.v[i]) <= worst)) worst = fabs(off_e.v[i]); /* NaN is kept */
        }
    return worst;
}

schuler_status schuler_gravity_fit_to(schuler_gravity_table *out, const schuler_field_model *field,
                                      double high_m, schuler_error *err)
{
    if (!(high_m >= SCHULER_GRAVITY_HIGH_M && high_m <= SCHULER_GRAVITY_HIGHEST_M))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "no gravity table to a height of %.0f m; from %.0f to %.0f m", high_m,
                            SCHULER_GRAVITY_HIGH_M, SCHULER_GRAVITY_HIGHEST_M);
    schuler_gravity_table g;
    memset(&g, 0, sizeof g);
    set_scales(&g, high_m);
    const double omega_radps = schuler_field_earth_rate(field);
    g.omega2 = omega_radps * omega_radps;
    fit(&g, field, high_m);
    const double box =
        (high_m - SCHULER_GRAVITY_LOW_M) / (SCHULER_GRAVITY_HIGH_M - SCHULER_GRAVITY_LOW_M);
    const double accepted_mps2 = usual_accepted_mps2 * box * box * box * box * box * box;
    const double worst_mps2 = largest_error(&g, field, high_m);
    if (!(worst_mps2 <= accepted_mps2))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "gravity table is off by %.3g m/s^2, more than %.0e m/s^2 is refused",
                            worst_mps2, accepted_mps2);
    *out = g;
    return SCHULER_OK;
}

schuler_status schuler_gravity_fit(schuler_gravity_table *out, const schuler_field_model *field,
                                   schuler_error *err)
{
    return schuler_gravity_fit_to(out, field, SCHULER_GRAVITY_HIGH_M, err);
}

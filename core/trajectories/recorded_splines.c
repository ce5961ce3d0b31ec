/* SPDX-License-Identifier: MIT */
/* Splines through recorded rows: three tridiagonal systems. */
#include "core/trajectories/recorded.h"

/* Rows lower x[i-1] + diagonal x[i] + upper x[i+1] = right, for three components at once; the work
 * space is overwritten, x is left in right. All are diagonally dominant, so nothing is pivoted. */
typedef struct {
    double *lower, *diagonal, *upper; /* n each */
    schuler_vec3 *right;
} tridiagonal;

static void solve(const tridiagonal *m, size_t n)
{
    for (size_t i = 1; i < n; i++) {
        const double k = m->lower[i] / m->diagonal[i - 1];
        m->diagonal[i] -= k * m->upper[i - 1];
        m->right[i] = schuler_vec3_sub(m->right[i], schuler_vec3_scale(k, m->right[i - 1]));
    }
    for (size_t i = n; i-- > 0;) {
        if (i + 1 < n)
            m->right[i] =
                schuler_vec3_sub(m->right[i], schuler_vec3_scale(m->upper[i], m->right[i + 1]));
        m->right[i] = schuler_vec3_scale(1.0 / m->diagonal[i], m->right[i]);
    }
}

/* work: 6 n numbers */
static tridiagonal lay_out(double *work, size_t n)
{
    return (tridiagonal){ work, work + n, work + 2 * n, (schuler_vec3 *)(work + 3 * n) };
}

static void fix(const tridiagonal *m, size_t i, schuler_vec3 value)
{
    m->lower[i] = m->upper[i] = 0.0;
    m->diagonal[i] = 1.0;
    m->right[i] = value;
}

static schuler_vec3 sum3(double a, schuler_vec3 x, double b, schuler_vec3 y, double c,
                         schuler_vec3 z)
{
    return schuler_vec3_add(schuler_vec3_add(schuler_vec3_scale(a, x), schuler_vec3_scale(b, y)),
                            schuler_vec3_scale(c, z));
}

static double gap(const recorded_knot *knots, size_t i)
{
    return knots[i + 1].t_s - knots[i].t_s;
}

/* Slope at 0 of the cubic through 0 and three points: at t[k], x[k] away from there. */
static schuler_vec3 end_slope(const double t[3], const schuler_vec3 x[3])
{
    double weight[3];
    for (int k = 0; k < 3; k++) {
        const double a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        weight[k] = a * b / (t[k] * (t[k] - a) * (t[k] - b));
    }
    return sum3(weight[0], x[0], weight[1], x[1], weight[2], x[2]);
}

static schuler_vec3 end_velocity(const schuler_recorded_sample *rows, const recorded_knot *knots,
                                 size_t end, int way)
{
    double t[3];
    schuler_vec3 x[3];
    for (int k = 0; k < 3; k++) {
        const size_t i = way > 0 ? end + (size_t)k + 1 : end - (size_t)k - 1;
        t[k] = knots[i].t_s - knots[end].t_s;
        x[k] = schuler_vec3_sub(rows[i].r_e, rows[end].r_e);
    }
    return end_slope(t, x);
}

static schuler_vec3 end_rate(const schuler_recorded_sample *rows, const recorded_knot *knots,
                             size_t end, int way)
{
    const schuler_quat q = rows[end].q_b_e, back = { q.w, -q.x, -q.y, -q.z };
    double t[3];
    schuler_vec3 x[3];
    for (int k = 0; k < 3; k++) {
        const size_t i = way > 0 ? end + (size_t)k + 1 : end - (size_t)k - 1;
        t[k] = knots[i].t_s - knots[end].t_s;
        x[k] = schuler_quat_to_rotvec(schuler_quat_mul(back, rows[i].q_b_e));
    }
    return end_slope(t, x);
}

void recorded_spline_velocity(const schuler_recorded_sample *rows, recorded_knot *knots, size_t n,
                              double *work)
{
    const tridiagonal m = lay_out(work, n);
    for (size_t i = 1; i + 1 < n; i++) {
        const double h0 = gap(knots, i - 1), h1 = gap(knots, i);
        const schuler_vec3 d0 = schuler_vec3_sub(rows[i].r_e, rows[i - 1].r_e);
        const schuler_vec3 d1 = schuler_vec3_sub(rows[i + 1].r_e, rows[i].r_e);
        m.lower[i] = 1.0 / h0;
        m.diagonal[i] = 2.0 / h0 + 2.0 / h1;
        m.upper[i] = 1.0 / h1;
        m.right[i] = sum3(3.0 / (h0 * h0), d0, 3.0 / (h1 * h1), d1, 0.0, d1);
    }
    fix(&m, 0, end_velocity(rows, knots, 0, 1));
    fix(&m, n - 1, end_velocity(rows, knots, n - 1, -1));
    solve(&m, n);
    for (size_t i = 0; i < n; i++) knots[i].v_e = m.right[i];
}

/* Acceleration at an end row, by the fifth degree through places and velocities of three rows. Less what
 * the end's own place and velocity say, it is t^2 g(t), g a cubic that is known at the other two rows
 * with its slope: twice its value at 0. */
static schuler_vec3 end_acceleration_of_path(const schuler_recorded_sample *rows,
                                             const recorded_knot *knots, size_t end, int way)
{
    double t[2];
    schuler_vec3 g[2], slope[2];
    for (int k = 0; k < 2; k++) {
        const size_t i = way > 0 ? end + (size_t)k + 1 : end - (size_t)k - 1;
        t[k] = knots[i].t_s - knots[end].t_s;
        const schuler_vec3 dp = schuler_vec3_sub(rows[i].r_e, rows[end].r_e);
        const schuler_vec3 dv = schuler_vec3_sub(knots[i].v_e, knots[end].v_e);
        g[k] = sum3(1.0 / (t[k] * t[k]), dp, -1.0 / t[k], knots[end].v_e, 0.0, dp);
        slope[k] = sum3(1.0 / (t[k] * t[k]), dv, -2.0 / t[k], g[k], 0.0, dv);
    }
    const double h = t[1] - t[0], x = -t[0] / h;
    const schuler_vec3 values = sum3((1.0 + 2.0 * x) * (1.0 - x) * (1.0 - x), g[0],
                                     x * x * (3.0 - 2.0 * x), g[1], 0.0, g[0]);
    return schuler_vec3_scale(2.0, sum3(1.0, values, x * (1.0 - x) * (1.0 - x) * h, slope[0],
                                        x * x * (x - 1.0) * h, slope[1]));
}

/* p''' at the ends of [0, h]: (60 dp - h (36 v0 + 24 v1) - h^2 (9 a0 - 3 a1))/h^3 and
 * (60 dp - h (24 v0 + 36 v1) + h^2 (9 a1 - 3 a0))/h^3. */
void recorded_spline_acceleration(const schuler_recorded_sample *rows, recorded_knot *knots,
                                  size_t n, double *work)
{
    const tridiagonal m = lay_out(work, n);
    fix(&m, 0, end_acceleration_of_path(rows, knots, 0, 1));
    fix(&m, n - 1, end_acceleration_of_path(rows, knots, n - 1, -1));
    for (size_t i = 1; i + 1 < n; i++) {
        const double h1 = gap(knots, i);
        const schuler_vec3 d1 = schuler_vec3_sub(rows[i + 1].r_e, rows[i].r_e);
        const double h0 = gap(knots, i - 1);
        const schuler_vec3 d0 = schuler_vec3_sub(rows[i].r_e, rows[i - 1].r_e);
        m.lower[i] = -3.0 / h0;
        m.diagonal[i] = 9.0 / h0 + 9.0 / h1;
        m.upper[i] = -3.0 / h1;
        m.right[i] = schuler_vec3_add(sum3(60.0 / (h1 * h1 * h1), d1, -60.0 / (h0 * h0 * h0), d0,
                                           24.0 / (h0 * h0), knots[i - 1].v_e),
                                      sum3(36.0 / (h0 * h0) - 36.0 / (h1 * h1), knots[i].v_e,
                                           -24.0 / (h1 * h1), knots[i + 1].v_e, 0.0, knots[i].v_e));
    }
    solve(&m, n);
    for (size_t i = 0; i < n; i++) knots[i].a_e = m.right[i];
}

/* k1 = (1 - cos x)/x^2 and k2 = (x - sin x)/x^3 of J = 1 - k1 [rho x] + k2 [rho x]^2, and their slopes
 * over x^2. Series: an interval turns by a radian at most. */
typedef struct {
    double k1, k2, k1_slope, k2_slope;
} jacobian;

static jacobian jacobian_at(schuler_vec3 rho)
{
    const double y = schuler_vec3_dot(rho, rho);
    static const double c1[] = { 1.0 / 2,      -1.0 / 24,     1.0 / 720,
                                 -1.0 / 40320, 1.0 / 3628800, -1.0 / 479001600 };
    static const double c2[] = { 1.0 / 6,       -1.0 / 120,     1.0 / 5040,
                                 -1.0 / 362880, 1.0 / 39916800, -1.0 / 6227020800 };
    jacobian j = { 0 };
    for (int k = 5; k >= 0; k--) {
        j.k1_slope = j.k1_slope * y + j.k1;
        j.k1 = j.k1 * y + c1[k];
        j.k2_slope = j.k2_slope * y + j.k2;
        j.k2 = j.k2 * y + c2[k];
    }
    return j;
}

/* omega = J rho'. */
static schuler_vec3 body_rate(const jacobian *j, schuler_vec3 rho, schuler_vec3 rho_dot)
{
    const schuler_vec3 once = schuler_vec3_cross(rho, rho_dot),
                       twice = schuler_vec3_cross(rho, once);
    return sum3(1.0, rho_dot, -j->k1, once, j->k2, twice);
}

/* By iteration: J is near 1. */
schuler_vec3 recorded_rotvec_rate(schuler_vec3 rho, schuler_vec3 omega)
{
    const jacobian j = jacobian_at(rho);
    schuler_vec3 rho_dot = omega;
    for (int k = 0; k < 60; k++) {
        const schuler_vec3 off = schuler_vec3_sub(omega, body_rate(&j, rho, rho_dot));
        rho_dot = schuler_vec3_add(rho_dot, off);
        if (schuler_vec3_norm(off) <= 1e-17 * schuler_vec3_norm(omega)) break;
    }
    return rho_dot;
}

/* Angular acceleration of the cubic from 0 (rate w0) to theta (rate w1), at its end: J rho'' + J' rho'. */
static schuler_vec3 end_acceleration(schuler_vec3 theta, schuler_vec3 w0, schuler_vec3 w1, double h)
{
    const schuler_vec3 rate = recorded_rotvec_rate(theta, w1);
    const schuler_vec3 bend = sum3(-6.0 / (h * h), theta, 2.0 / h, w0, 4.0 / h, rate);
    const jacobian j = jacobian_at(theta);
    const double y_dot = 2.0 * schuler_vec3_dot(theta, rate);
    const schuler_vec3 once = schuler_vec3_cross(theta, rate),
                       twice = schuler_vec3_cross(theta, once);
    const schuler_vec3 turning = sum3(-j.k1_slope * y_dot, once, j.k2_slope * y_dot, twice, j.k2,
                                      schuler_vec3_cross(rate, once));
    return schuler_vec3_add(body_rate(&j, theta, bend), turning);
}

static schuler_vec3 start_acceleration(schuler_vec3 theta, schuler_vec3 w0, schuler_vec3 w1,
                                       double h)
{
    const schuler_vec3 rate = recorded_rotvec_rate(theta, w1);
    return sum3(6.0 / (h * h), theta, -4.0 / h, w0, -2.0 / h, rate);
}

/* The jump of angular acceleration at every row is brought to zero by Newton's method with the matrix of
 * small angles, that of the cubic spline. */
int recorded_spline_rate(const schuler_recorded_sample *rows, recorded_knot *knots, size_t n,
                         double *work)
{
    enum { ROUNDS = 60 };
    for (size_t i = 0; i < n; i++)
        knots[i].omega_b = schuler_vec3_scale(1.0 / gap(knots, i + 1 < n ? i : i - 1),
                                              knots[i + 1 < n ? i : i - 1].theta_b);
    knots[0].omega_b = end_rate(rows, knots, 0, 1);
    knots[n - 1].omega_b = end_rate(rows, knots, n - 1, -1);
    for (int round = 0; round < ROUNDS; round++) {
        const tridiagonal m = lay_out(work, n);
        const schuler_vec3 none = { { 0.0, 0.0, 0.0 } };
        double fastest = 0.0, change = 0.0;
        fix(&m, 0, none);
        fix(&m, n - 1, none);
        for (size_t i = 1; i + 1 < n; i++) {
            const double h0 = gap(knots, i - 1), h1 = gap(knots, i);
            const schuler_vec3 before =
                end_acceleration(knots[i - 1].theta_b, knots[i - 1].omega_b, knots[i].omega_b, h0);
            const schuler_vec3 after =
                start_acceleration(knots[i].theta_b, knots[i].omega_b, knots[i + 1].omega_b, h1);
            m.lower[i] = 2.0 / h0;
            m.diagonal[i] = 4.0 / h0 + 4.0 / h1;
            m.upper[i] = 2.0 / h1;
            m.right[i] = schuler_vec3_sub(after, before);
            fastest = fmax(fastest, schuler_vec3_norm(knots[i].omega_b));
        }
        solve(&m, n);
        for (size_t i = 1; i + 1 < n; i++) {
            knots[i].omega_b = schuler_vec3_add(knots[i].omega_b, m.right[i]);
            change = fmax(change, schuler_vec3_norm(m.right[i]));
        }
        if (!(change < 1e6)) return 0;
        if (change <= 1e-14 * (fastest + 1e-3)) return 1;
    }
    return 0;
}

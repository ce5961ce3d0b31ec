/* SPDX-License-Identifier: MIT */
#include "sensors/response.h"
#include <math.h>

/* With E = exp(-zeta w dt): E c and E s/w_d, where c, s are cos, sin of w_d dt, w_d = w sqrt(1 -
 * zeta^2); hyperbolic when overdamped, and dt itself for s/w_d between the two. */
static void decaying(double w, double zeta, double dt_s, double *Ec, double *Es_per_w)
{
    const double root = sqrt(fabs(1.0 - zeta * zeta)), w_d = w * root;
    if (zeta < 1.0 && w_d * dt_s > 1e-8) {
        const double E = exp(-zeta * w * dt_s);
        *Ec = E * cos(w_d * dt_s);
        *Es_per_w = E * sin(w_d * dt_s) / w_d;
    } else if (zeta > 1.0 && w_d * dt_s > 1e-8) {
        /* The slow root as 1/(zeta + root): no difference of nearly equal numbers. */
        const double slow = exp(-w * dt_s / (zeta + root)), fast = exp(-w * dt_s * (zeta + root));
        *Ec = 0.5 * (slow + fast);
        *Es_per_w = 0.5 * (slow - fast) / w_d;
    } else {
        const double E = exp(-zeta * w * dt_s);
        *Ec = E;
        *Es_per_w = E * dt_s;
    }
}

/* The response: (y, y') a time after an impulse of the input. */
typedef struct {
    double w, zeta; /* zeta < 0: of first order */
} filter;

static void after_impulse(filter f, double t_s, double h[2])
{
    double Ec, Es;
    if (f.zeta < 0.0) {
        h[0] = f.w * exp(-f.w * t_s);
        h[1] = 0.0;
        return;
    }
    decaying(f.w, f.zeta, t_s, &Ec, &Es);
    h[0] = f.w * f.w * Es;
    h[1] = f.w * f.w * (Ec - f.zeta * f.w * Es);
}

/* Coefficients of 1, s, s^2 of the parabolas that are 1 at one node of [0, 1] and 0 at the others. */
static void parabolas(double L[3][3])
{
    static const double c[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    for (int j = 0; j < 3; j++) {
        const double a = c[(j + 1) % 3], b = c[(j + 2) % 3],
                     scale = 1.0 / ((c[j] - a) * (c[j] - b));
        L[j][0] = a * b * scale;
        L[j][1] = -(a + b) * scale;
        L[j][2] = scale;
    }
}

/* moment[m] = integral over the step of the impulse response to what comes at the part s of it, times
 * s^m: Gauss-Legendre with six nodes in pieces that are short against the response. */
static void moments_by_quadrature(filter f, double dt_s, int pieces, double moment[3][2])
{
    static const double node[3] = { 0.23861918608319691, 0.66120938646626451, 0.93246951420315203 };
    static const double weight[3] = { 0.46791393457269105, 0.36076157304813861,
                                      0.17132449237917035 };
    for (int m = 0; m < 3; m++) moment[m][0] = moment[m][1] = 0.0;
    for (int p = 0; p < pieces; p++)
        for (int q = 0; q < 6; q++) {
            const double x = q < 3 ? node[q] : -node[q - 3];
            const double s = (p + 0.5 * (1.0 + x)) / pieces;
            const double part = 0.5 * dt_s / pieces * weight[q % 3];
            double h[2];
            after_impulse(f, (1.0 - s) * dt_s, h);
            for (int i = 0; i < 2; i++) {
                moment[0][i] += part * h[i];
                moment[1][i] += part * h[i] * s;
                moment[2][i] += part * h[i] * s * s;
            }
        }
}

/* The same by parts: with the system x' = A x + B u, moment[m] = A^-1 (m/dt moment[m - 1] - B), and
 * A^-1 B = (-1, 0). Loses digits in steps that are short against the response. */
static void moments_by_parts(filter f, double dt_s, const double gamma[2], double moment[3][2])
{
    moment[0][0] = gamma[0];
    moment[0][1] = gamma[1];
    for (int m = 1; m < 3; m++) {
        const double *const before = moment[m - 1];
        const double part = m / dt_s;
        if (f.zeta < 0.0) {
            moment[m][0] = 1.0 - part * before[0] / f.w;
            moment[m][1] = 0.0;
        } else {
            moment[m][0] = 1.0 - part * (2.0 * f.zeta * before[0] + before[1] / f.w) / f.w;
            moment[m][1] = part * before[0];
        }
    }
}

static void gains_of_nodes(filter f, double dt_s, schuler_response *r)
{
    enum { PIECES_MAX = 40 };
    const double fastest = f.zeta > 1.0 ? f.w * (f.zeta + sqrt(f.zeta * f.zeta - 1.0)) : f.w;
    const double pieces = ceil(fastest * dt_s / 0.4);
    double L[3][3], moment[3][2];
    parabolas(L);
    if (pieces <= PIECES_MAX)
        moments_by_quadrature(f, dt_s, (int)pieces, moment);
    else
        moments_by_parts(f, dt_s, r->gamma, moment);
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 3; j += 2)
            r->node[j][i] =
                L[j][0] * moment[0][i] + L[j][1] * moment[1][i] + L[j][2] * moment[2][i];
        r->node[1][i] = r->gamma[i] - r->node[0][i] - r->node[2][i]; /* a constant stays one */
    }
}

schuler_response schuler_second_order(double f_hz, double zeta, double dt_s)
{
    const double w = 2.0 * M_PI * f_hz;
    double Ec, Es;
    decaying(w, zeta, dt_s, &Ec, &Es);
    const double phi00 = Ec + zeta * w * Es, phi10 = -w * w * Es;
    schuler_response r = { .phi = { { phi00, Es }, { phi10, Ec - zeta * w * Es } },
                           .gamma = { 1.0 - phi00, -phi10 },
                           .keep = { 2.0 * zeta / w, 1.0 / (w * w) } };
    gains_of_nodes((filter){ w, zeta }, dt_s, &r);
    return r;
}

schuler_response schuler_first_order(double f_hz, double dt_s)
{
    const double w = 2.0 * M_PI * f_hz;
    schuler_response r = { .phi = { { exp(-w * dt_s), 0.0 }, { 0.0, 0.0 } },
                           .gamma = { -expm1(-w * dt_s), 0.0 },
                           .keep = { 1.0 / w, 0.0 } };
    gains_of_nodes((filter){ w, -1.0 }, dt_s, &r);
    return r;
}

double schuler_second_order_gain(double f_n_hz, double zeta, double f_hz)
{
    const double r = f_hz / f_n_hz, a = 1.0 - r * r, b = 2.0 * zeta * r;
    return 1.0 / hypot(a, b);
}

double schuler_second_order_delay(double f_n_hz, double zeta)
{
    return 2.0 * zeta / (2.0 * M_PI * f_n_hz);
}

double schuler_second_order_minus_3_db(double f_n_hz, double zeta)
{
    const double a = 1.0 - 2.0 * zeta * zeta;
    return f_n_hz * sqrt(a + sqrt(a * a + 1.0));
}

double schuler_second_order_noise_bandwidth(double f_n_hz, double zeta)
{
    return M_PI * f_n_hz / (4.0 * zeta);
}

int schuler_delay_weights(double steps, double weight[4])
{
    const int whole = (int)floor(steps);
    const double x = steps - whole;
    weight[0] = (1.0 - x) * (2.0 - x) * (3.0 - x) / 6.0;
    weight[1] = x * (2.0 - x) * (3.0 - x) / 2.0;
    weight[2] = -x * (1.0 - x) * (3.0 - x) / 2.0;
    weight[3] = x * (1.0 - x) * (2.0 - x) / 6.0;
    return whole;
}

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

schuler_response schuler_second_order(double f_hz, double zeta, double dt_s)
{
    const double w = 2.0 * M_PI * f_hz;
    double Ec, Es;
    decaying(w, zeta, dt_s, &Ec, &Es);
    const double phi00 = Ec + zeta * w * Es, phi10 = -w * w * Es;
    return (schuler_response){ .phi = { { phi00, Es }, { phi10, Ec - zeta * w * Es } },
                               .gamma = { 1.0 - phi00, -phi10 },
                               .keep = { 2.0 * zeta / w, 1.0 / (w * w) } };
}

schuler_response schuler_first_order(double f_hz, double dt_s)
{
    const double w = 2.0 * M_PI * f_hz;
    return (schuler_response){ .phi = { { exp(-w * dt_s), 0.0 }, { 0.0, 0.0 } },
                               .gamma = { -expm1(-w * dt_s), 0.0 },
                               .keep = { 1.0 / w, 0.0 } };
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

/* SPDX-License-Identifier: MIT */
#include "sensors/pendulum.h"

void schuler_pendulum_coefficients(const schuler_pendulum *p, schuler_pa_sense sense,
                                   double *K_spin, double *K_ang)
{
    const double sign = sense == SCHULER_PA_TOWARD_MASS ? 1.0 : -1.0;
    *K_spin = sign * ((p->J_i - p->J_p) - p->pendulosity * p->r_c) / p->pendulosity;
    *K_ang = -sign * (p->J_o - p->pendulosity * p->r_c) / p->pendulosity;
}

double schuler_pendulum_percussion(const schuler_pendulum *p)
{
    return p->J_o / p->pendulosity;
}

schuler_two_sided_form schuler_to_two_sided(schuler_symmetric_form s)
{
    return (schuler_two_sided_form){ s.K0 + 0.5 * s.K0_asymmetry, s.K0 - 0.5 * s.K0_asymmetry,
                                     s.K1 * (1.0 + 0.5 * s.K1_asymmetry),
                                     s.K1 * (1.0 - 0.5 * s.K1_asymmetry) };
}

schuler_symmetric_form schuler_to_symmetric(schuler_two_sided_form t)
{
    const double K1 = 0.5 * (t.K1_plus + t.K1_minus);
    return (schuler_symmetric_form){ 0.5 * (t.K0_plus + t.K0_minus), t.K0_plus - t.K0_minus, K1,
                                     (t.K1_plus - t.K1_minus) / K1 };
}

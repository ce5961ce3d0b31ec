/* SPDX-License-Identifier: MIT */
#include "mechanization/vertical.h"
#include "core/earth.h"
#include <math.h>

schuler_baro_gains schuler_baro_gains_of(double tau_s, double g_mps2, double lat_rad)
{
    const double radius_m =
        sqrt(schuler_earth_meridian_radius(lat_rad) * schuler_earth_transverse_radius(lat_rad));
    const double gradient_ps2 = 2.0 * g_mps2 / radius_m;
    return (schuler_baro_gains){ .k1_ps = 3.0 / tau_s,
                                 .k2_ps2 = 3.0 / (tau_s * tau_s) + gradient_ps2,
                                 .k3_ps3 = 1.0 / (tau_s * tau_s * tau_s),
                                 .gradient_ps2 = gradient_ps2 };
}

/* e is taken as its mean over the interval, (before + after)/2, so the error is of second order in
 * T/tau. With m that mean, over the interval
 *
 *     dh = -(k1 T + k2 T^2/2 + k3 T^3/6) m - a_c T^2/2
 *     dv = -(k2 T + k3 T^2/2) m - a_c T + (2g/R) T dh/2        da_c = k3 T m
 *
 * and after = e + dh, which is solved for m. The last part of dv is the gravity of the height that the
 * navigator had not been told of meanwhile. */
void schuler_baro_update(schuler_baro_loop *loop, const schuler_baro_gains *gains, double T_s,
                         double e_m, double *dh_m, double *dv_mps)
{
    const double k1 = gains->k1_ps, k2 = gains->k2_ps2, k3 = gains->k3_ps3;
    const double h_per_m = T_s * (k1 + T_s * (0.5 * k2 + T_s * (k3 / 6.0)));
    const double v_per_m = T_s * (k2 + T_s * (0.5 * k3));
    const double h_from_a = 0.5 * T_s * T_s * loop->a_c_mps2;
    const double mean_m = 0.5 * (loop->e_m + e_m - h_from_a) / (1.0 + 0.5 * h_per_m);
    *dh_m = -h_per_m * mean_m - h_from_a;
    *dv_mps = -v_per_m * mean_m - T_s * (loop->a_c_mps2 - 0.5 * gains->gradient_ps2 * *dh_m);
    loop->a_c_mps2 += T_s * k3 * mean_m;
    loop->e_m = e_m + *dh_m;
}

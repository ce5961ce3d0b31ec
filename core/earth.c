/* SPDX-License-Identifier: MIT */
#include "core/earth.h"

double schuler_earth_meridian_radius(double lat_rad)
{
    const double s = sin(lat_rad), w2 = 1.0 - SCHULER_WGS84_E2 * s * s;
    return SCHULER_WGS84_A_M * (1.0 - SCHULER_WGS84_E2) / (w2 * sqrt(w2));
}

double schuler_earth_transverse_radius(double lat_rad)
{
    const double s = sin(lat_rad);
    return SCHULER_WGS84_A_M / sqrt(1.0 - SCHULER_WGS84_E2 * s * s);
}

schuler_mat3 schuler_C_n_e(double lat_rad, double lon_rad)
{
    const double sl = sin(lat_rad), cl = cos(lat_rad);
    const double so = sin(lon_rad), co = cos(lon_rad);
    return (schuler_mat3){ {
        { -sl * co, -so, -cl * co },
        { -sl * so, co, -cl * so },
        { cl, 0.0, -sl },
    } };
}

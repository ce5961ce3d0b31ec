/* SPDX-License-Identifier: MIT */
/* The WGS84 ellipsoid and what every floor needs of it. Geodetic conversions are GeographicLib's.
 */
#ifndef SCHULER_CORE_EARTH_H
#define SCHULER_CORE_EARTH_H

#include "core/vec.h"

SCHULER_BEGIN_C

/* Defining constants, NIMA TR8350.2 (third edition, amendment 1), table 3.1. */
#define SCHULER_WGS84_A_M      6378137.0
#define SCHULER_WGS84_INV_F    298.257223563
#define SCHULER_WGS84_GM       3.986004418e14 /* m^3/s^2, with the atmosphere */
#define SCHULER_OMEGA_IE_RADPS 7.292115e-5
/* Derived: f = 1/inv_f, e2 = f (2 - f), b = a (1 - f). */
#define SCHULER_WGS84_F   (1.0 / SCHULER_WGS84_INV_F)
#define SCHULER_WGS84_E2  (SCHULER_WGS84_F * (2.0 - SCHULER_WGS84_F))
#define SCHULER_WGS84_B_M (SCHULER_WGS84_A_M * (1.0 - SCHULER_WGS84_F))

#define SCHULER_G0_MPS2        9.80665 /* the unit g, exact: CGPM 1901 */
#define SCHULER_NMI_M          1852.0
#define SCHULER_PI             3.14159265358979323846
#define SCHULER_RAD_PER_DEG    (SCHULER_PI / 180.0)
#define SCHULER_ARCSEC_PER_RAD (180.0 * 3600.0 / SCHULER_PI)

/* Geodetic latitude and longitude, ellipsoidal height. */
typedef struct {
    double lat_rad, lon_rad, h_m;
} schuler_llh;

/** Meridian and prime-vertical (transverse) radii of curvature at a latitude, m. */
SCHULER_API double schuler_earth_meridian_radius(double lat_rad);
SCHULER_API double schuler_earth_transverse_radius(double lat_rad);

/** Geodetic to earth-centred earth-fixed (m) and back, by GeographicLib::Geocentric. */
SCHULER_API schuler_vec3 schuler_ecef_from_llh(schuler_llh p);
SCHULER_API schuler_llh schuler_llh_from_ecef(schuler_vec3 r_e);

/** C_n_e: columns are north, east and down at the place, components in ECEF. */
SCHULER_API schuler_mat3 schuler_C_n_e(double lat_rad, double lon_rad);

SCHULER_END_C

#endif

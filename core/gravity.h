/* SPDX-License-Identifier: MIT */
/* Gravity the lanes can afford: GeographicLib's normal field fitted at load by polynomials in ECEF
 * (no trigonometry, square root or division), the disturbance of a full model interpolated along the
 * true path.
 *
 * With t = z^2/b^2 and u = (x^2 + y^2)/a^2 + z^2/b^2 - 1, both scaled to [-1, 1] over the box of
 * all latitudes and -1..50 km, gravitation is (-x A, -y A, -z B), A and B polynomials of total
 * degree SCHULER_GRAVITY_DEGREE in (t, u); the centrifugal term is added exactly. Two more
 * polynomials give the geodetic height and the ratio that turns a position into its geodetic
 * normal. */
#ifndef SCHULER_CORE_GRAVITY_H
#define SCHULER_CORE_GRAVITY_H

#include "core/geographic.h"

SCHULER_BEGIN_C

enum { SCHULER_GRAVITY_DEGREE = 5, SCHULER_GRAVITY_TERMS = 21 };
/* Heights the table is made for, above the WGS84 ellipsoid; and to which it can be made. */
#define SCHULER_GRAVITY_LOW_M     (-1000.0)
#define SCHULER_GRAVITY_HIGH_M    50000.0
#define SCHULER_GRAVITY_HIGHEST_M 125000.0

/* Nested Horner order, powers of the scaled variables: for i = 0..D, for j = 0..D-i the coefficient
 * of T^i U^j, T = t_scale*z^2 + t_shift, U = u_xy*(x^2+y^2) + u_z*z^2 + u_shift. */
typedef struct {
    double t_scale, t_shift;   /* 1/m^2, -                                                   */
    double u_xy, u_z, u_shift; /* 1/m^2, 1/m^2, -                                            */
    double A[SCHULER_GRAVITY_TERMS], B[SCHULER_GRAVITY_TERMS]; /* 1/s^2                          */
    double height[SCHULER_GRAVITY_TERMS];   /* WGS84 geodetic height, m                           */
    double normal_z[SCHULER_GRAVITY_TERMS]; /* k: the normal is along (x, y, k z)                */
    double omega2; /* centrifugal: square of the field's own earth rate, 1/s^2   */
} schuler_gravity_table;

/** Fit the table to a field and check it on several hundred points off the nodes.
 *  Errors     SCHULER_ERR_NUMERIC when any checked component is off by more than 1e-11 m/s^2 */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_gravity_fit(schuler_gravity_table *out,
                                                                 const schuler_field_model *field,
                                                                 schuler_error *err);

/** The same for heights up to high_m instead of 50 km. The error grows with the sixth power of the box's
 *  height, and so does what is accepted: 2e-9 m/s^2 at 125 km. */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_gravity_fit_to(schuler_gravity_table *out, const schuler_field_model *field, double high_m,
                       schuler_error *err);

/** Gravity (with centrifugal term) of the table at an ECEF point, m/s^2; box: -1..50 km.
 *  The scalar twin of the lane code, bit for bit the same operations. */
SCHULER_API schuler_vec3 schuler_gravity_at(const schuler_gravity_table *g, schuler_vec3 r_e);

/** Geodetic height (m) and the ratio k for which the geodetic normal is along (x, y, k z), from the
 * same table and in the same box; twins of the lane code too. */
SCHULER_API double schuler_gravity_height(const schuler_gravity_table *g, schuler_vec3 r_e);
SCHULER_API double schuler_gravity_normal_z(const schuler_gravity_table *g, schuler_vec3 r_e);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* The only door to GeographicLib: C on the outside, C++ in geographic.cpp. Nothing C++ and no
 * exception passes it. Angles in radians here, lengths in metres. */
#ifndef SCHULER_CORE_GEOGRAPHIC_H
#define SCHULER_CORE_GEOGRAPHIC_H

#include "core/earth.h"
#include "core/error.h"

SCHULER_BEGIN_C

/** Geodesic on WGS84 between two points of the surface.
 *  Returned   s12_m  length;  azi1_rad, azi2_rad  forward azimuths at both ends (east of north) */
SCHULER_API void schuler_geodesic_inverse(double lat1_rad, double lon1_rad, double lat2_rad,
                                          double lon2_rad, double *s12_m, double *azi1_rad,
                                          double *azi2_rad);
/** The point at distance s12 along the geodesic that leaves point 1 at azimuth azi1. */
SCHULER_API void schuler_geodesic_direct(double lat1_rad, double lon1_rad, double azi1_rad,
                                         double s12_m, double *lat2_rad, double *lon2_rad,
                                         double *azi2_rad);

/* A gravity field: a level ellipsoid's normal field, and for the egm names a full model on top. */
typedef struct schuler_field schuler_field_model;

/** Names: "wgs84", "grs80" (built in), else a GravityModel data set ("egm96", "egm2008", ...), looked
 *  for in GEOGRAPHICLIB_GRAVITY_PATH and GeographicLib's default folder, or in a folder written before
 *  it ("data/gravity/egm96"). "egm96:120" is the field to degree and order 120.
 *  Errors   SCHULER_ERR_GRAVITY_DATA: message says how to get the data set; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_field_open(schuler_field_model **out,
                                                                const char *name,
                                                                schuler_error *err);
SCHULER_API void schuler_field_close(schuler_field_model *field); /* NULL is fine */

/* A data set of a full model, as its file NAME.egm describes it. */
typedef struct {
    char name[65], description[160], release[32]; /* release: a date, "" when not said     */
    int degree;                                   /* of the coefficients; 0: cannot be read */
    char problem[160];                            /* why it cannot be read, or ""           */
} schuler_field_data;

/** The folder in which data sets are looked for: GEOGRAPHICLIB_GRAVITY_PATH, else GeographicLib's own.
 *  Returned   out   the name, cut to size bytes with its end */
SCHULER_API void schuler_field_folder(char *out, size_t size);
/** The data sets of a folder, in alphabetical order.
 *  Given      folder     NULL: that of schuler_field_folder;  out  room for capacity entries
 *  Returned   how many there are, perhaps more than capacity; 0 when there is no such folder */
SCHULER_API size_t schuler_field_data_sets(const char *folder, schuler_field_data *out,
                                           size_t capacity);

/** Normal gravitation at an ECEF point, m/s^2, WITHOUT the centrifugal term (NormalGravity::V0). */
SCHULER_API schuler_vec3 schuler_field_normal_gravitation(const schuler_field_model *field,
                                                          schuler_vec3 r_e);
/** Gravity with the centrifugal term: normal field (::U) plus, for egm models, the disturbance
 * (::W). */
SCHULER_API schuler_vec3 schuler_field_gravity(const schuler_field_model *field, schuler_vec3 r_e);
/** Earth rate of the normal field, rad/s: what its centrifugal term is made with. */
SCHULER_API double schuler_field_earth_rate(const schuler_field_model *field);
/** 1 when the model has a disturbance beyond its normal field (egm...), else 0. */
SCHULER_API int schuler_field_has_disturbance(const schuler_field_model *field);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
/* Quantities with units and dimension checking. Exponents are stored doubled, so that sqrt(h) and
 * sqrt(Hz) are exact; angle is a dimension of its own, so that deg/h is not Hz. */
#ifndef SCHULER_CORE_UNITS_H
#define SCHULER_CORE_UNITS_H

#include "core/error.h"
#include <stdbool.h>

SCHULER_BEGIN_C

typedef struct {
    signed char length2, time2, angle2, temperature2, mass2, magnetic2; /* twice the exponent */
} schuler_dim;

/* Initialisers, for tables; in an expression write (schuler_dim)SCHULER_DIM_SPEED. */
/* clang-format off */
#define SCHULER_DIM_NONE          { 0, 0, 0, 0, 0, 0 }
#define SCHULER_DIM_LENGTH        { 2, 0, 0, 0, 0, 0 }
#define SCHULER_DIM_TIME          { 0, 2, 0, 0, 0, 0 }
#define SCHULER_DIM_FREQUENCY     { 0, -2, 0, 0, 0, 0 }
#define SCHULER_DIM_ANGLE         { 0, 0, 2, 0, 0, 0 }
#define SCHULER_DIM_RATE          { 0, -2, 2, 0, 0, 0 }  /* rad/s          */
#define SCHULER_DIM_ANGULAR_ACCEL { 0, -4, 2, 0, 0, 0 }  /* rad/s^2        */
#define SCHULER_DIM_SPEED         { 2, -2, 0, 0, 0, 0 }  /* m/s            */
#define SCHULER_DIM_ACCEL         { 2, -4, 0, 0, 0, 0 }  /* m/s^2          */
#define SCHULER_DIM_JERK          { 2, -6, 0, 0, 0, 0 }  /* m/s^3          */
#define SCHULER_DIM_ARW           { 0, -1, 2, 0, 0, 0 }  /* rad/sqrt(s)    */
#define SCHULER_DIM_VRW           { 2, -3, 0, 0, 0, 0 }  /* m/s/sqrt(s)    */
#define SCHULER_DIM_RRW           { 0, -3, 2, 0, 0, 0 }  /* rad/s/sqrt(s)  */
#define SCHULER_DIM_ACCEL_RW      { 2, -5, 0, 0, 0, 0 }  /* m/s^2/sqrt(s)  */
#define SCHULER_DIM_ACCEL_PSD     { 4, -6, 0, 0, 0, 0 }  /* (m/s^2)^2/Hz   */
#define SCHULER_DIM_HEIGHT_NOISE  { 2, 1, 0, 0, 0, 0 }   /* m sqrt(s)      */
#define SCHULER_DIM_TEMPERATURE   { 0, 0, 0, 2, 0, 0 }
/* clang-format on */

SCHULER_API bool schuler_dim_equal(schuler_dim a, schuler_dim b);
/** What people call it: "angular rate", "speed"; with an example unit in *example ("deg/h"). */
SCHULER_API const char *schuler_dim_name(schuler_dim dim, const char **example);

/** Read "NUMBER UNIT", e.g. "0.003 deg/sqrt(h)", "50 ug", "1e3 m", "-33.5 deg", "10 ppm".
 *  Given      text    the whole of it must be a quantity; number and unit may be joined or spaced
 *             dim     the dimension that is wanted
 *  Returned   si      value in SI units and radians, finite
 *  Errors     SCHULER_ERR_INPUT; err->message says what is wrong (no unit, unknown unit with the
 *             nearest known one, wrong dimension with an example), err->place.column is 1-based
 * within text, place.width the length of the faulty part; si untouched */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_quantity_parse(const char *text,
                                                                    schuler_dim dim, double *si,
                                                                    schuler_error *err);

/** Value of one UNIT in SI ("deg/h" -> 4.848e-6), for tables and tests. Errors as above. */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_unit_parse(const char *text, double *si,
                                                                schuler_dim *dim,
                                                                schuler_error *err);

SCHULER_END_C

#endif

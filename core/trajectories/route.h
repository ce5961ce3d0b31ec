/* SPDX-License-Identifier: MIT */
/* What the files of the kind `route` share. Private to core/trajectories. */
#ifndef SCHULER_CORE_TRAJECTORIES_ROUTE_H
#define SCHULER_CORE_TRAJECTORIES_ROUTE_H

#include "core/course.h"
#include "core/trajectory_specs.h"

extern const schuler_object schuler_route_object;

enum { ROUTE_LABEL_MAX = 48 };

/* A waypoint with everything filled in. */
typedef struct {
    const schuler_place *place;
    char label[ROUTE_LABEL_MAX]; /* its name, or "number 3" */
    double lat_rad, lon_rad, h_m, speed_mps, wait_s;
    schuler_manner manner;
    int flat; /* turns are flat, of manner.radius_m */
} route_point;

/* The geodesic from a waypoint to the next. */
typedef struct {
    double length_m, azimuth_rad, arrival_rad;
} route_leg;

/* The fly-by at a waypoint: where on the two legs it begins and ends. */
typedef struct {
    schuler_phase phase; /* duration 0: no turn */
    double entry_m, exit_m;
} route_turn;

typedef struct {
    size_t count; /* of points; one leg less */
    route_point *points;
    route_leg *legs;   /* legs[i] from points[i] to points[i + 1] */
    route_turn *turns; /* turns[i] at points[i]; none at the first and last */
} route_plan;

/** Fill in what waypoints leave open and check each of them by itself.
 *  Errors   into d, all of them; the function's value is how many */
int route_fill_points(const schuler_route_spec *spec, route_plan *plan, schuler_diagnostics *d);

/** Latitude, longitude and azimuth of a course. */
void route_locate(const schuler_course *course, double *lat_rad, double *lon_rad,
                  double *azimuth_rad);
/** An angle brought to (-pi, pi]. */
double route_wrap(double angle_rad);

/** Solve the turn at points[i]: the angle, and the distance before the waypoint where it begins, so
 *  that it ends on the next leg and aimed at its far end.
 *  Errors   SCHULER_ERR_INPUT too sharp; SCHULER_ERR_NUMERIC; both are in d */
SCHULER_NODISCARD schuler_status route_solve_turn(const route_plan *plan, size_t i, route_turn *out,
                                                  schuler_diagnostics *d);

/** Correct the angle of a solved turn for where the builder really is, so that what legs have
 *  missed by is not carried on: 1e-10 rad are half a millimetre after 5000 km.
 *  Errors   as schuler_course_follow */
SCHULER_NODISCARD schuler_status route_aim_turn(const schuler_path_builder *b,
                                                const route_plan *plan, size_t i,
                                                schuler_phase *phase);

/** The straight part of leg i without its length in time: changes of speed and height, climbs and
 *  accelerations early, descents and decelerations late. shortest_s: the time they need. */
schuler_phase route_straight(const route_plan *plan, size_t i, double duration_s,
                             double *shortest_s);
/** Check that leg i has room for its turns and changes.
 *  Errors   SCHULER_ERR_INPUT, in d */
SCHULER_NODISCARD schuler_status route_check_leg(const route_plan *plan, size_t i,
                                                 schuler_diagnostics *d);
/** Fly the straight part of leg i, up to the turn at its end or to the waypoint.
 *  Errors   as schuler_course_follow, and SCHULER_ERR_INPUT for a leg too short; in d */
SCHULER_NODISCARD schuler_status route_fly_straight(schuler_path_builder *b, const route_plan *plan,
                                                    size_t i, schuler_diagnostics *d);

#endif

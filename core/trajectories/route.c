/* SPDX-License-Identifier: MIT */
/* Waypoints joined by geodesics. All is planned and checked first: legs, turns, room on every leg;
 * then flown with the course carried along, each leg aimed at its far end when the turn before it
 * ends. */
#include "core/trajectories/route.h"
#include "core/geographic.h"
#include <stdlib.h>

/* On the spot, what a line-up may be corrected by. */
static const double pivot_limit_rad = 5.0 * SCHULER_RAD_PER_DEG;
static const double pivot_rate_radps = 2.0 * SCHULER_RAD_PER_DEG, pivot_ramp_s = 1.0;

static int plan_legs(route_plan *plan, schuler_diagnostics *d)
{
    int errors = 0;
    for (size_t i = 0; i + 1 < plan->count; i++) {
        const route_point *const a = &plan->points[i], *const b = &plan->points[i + 1];
        route_leg *const leg = &plan->legs[i];
        schuler_geodesic_inverse(a->lat_rad, a->lon_rad, b->lat_rad, b->lon_rad, &leg->length_m,
                                 &leg->azimuth_rad, &leg->arrival_rad);
        if (leg->length_m < 0.1) {
            schuler_diagnose(d, SCHULER_ERR_INPUT, b->place,
                             "waypoints %s and %s are the same place", a->label, b->label);
            errors++;
        }
    }
    return errors;
}

static schuler_status plan_route(const schuler_route_spec *spec, route_plan *plan,
                                 schuler_diagnostics *d)
{
    if (route_fill_points(spec, plan, d) + plan_legs(plan, d) > 0) return SCHULER_ERR_INPUT;
    schuler_status first = SCHULER_OK;
    for (size_t i = 1; i + 1 < plan->count; i++) {
        const schuler_status status = route_solve_turn(plan, i, &plan->turns[i], d);
        if (first == SCHULER_OK) first = status;
    }
    for (size_t i = 0; first != SCHULER_ERR_NUMERIC && i + 1 < plan->count; i++) {
        const schuler_status status = route_check_leg(plan, i, d);
        if (first == SCHULER_OK) first = status;
    }
    return first;
}

static schuler_status follow(schuler_path_builder *b, const schuler_phase *phase,
                             const route_point *p, schuler_diagnostics *d)
{
    const schuler_status status = b->t_s + phase->duration_s > SCHULER_TRAJECTORY_LONGEST_S
                                      ? SCHULER_ERR_INPUT
                                      : schuler_course_follow(b, SCHULER_COURSE_TRACK, phase);
    if (status == SCHULER_ERR_INPUT)
        schuler_diagnose(d, status, p->place, "the trajectory gets longer than 1000 h");
    else if (status != SCHULER_OK)
        schuler_diagnose(d, status, p->place, "the motion at waypoint %s could not be computed",
                         p->label);
    return status;
}

/* Stand at a waypoint, then point at the next one. */
static schuler_status stand(schuler_path_builder *b, const route_plan *plan, size_t i,
                            schuler_diagnostics *d)
{
    const route_point *const p = &plan->points[i];
    schuler_phase phase = { .height = { .from = p->h_m }, .duration_s = schuler_tick(p->wait_s) };
    schuler_status status = follow(b, &phase, p, d);
    if (status != SCHULER_OK || i + 1 == plan->count) return status;

    const route_point *const next = &plan->points[i + 1];
    double lat_rad, lon_rad, azimuth_rad, s_m, bearing_rad, unused;
    route_locate(&b->course, &lat_rad, &lon_rad, &azimuth_rad);
    schuler_geodesic_inverse(lat_rad, lon_rad, next->lat_rad, next->lon_rad, &s_m, &bearing_rad,
                             &unused);
    const double angle_rad = route_wrap(bearing_rad - azimuth_rad);
    if (fabs(angle_rad) > pivot_limit_rad) {
        schuler_diagnose(
            d, SCHULER_ERR_INPUT, p->place,
            "waypoint %s is at rest and the next leg leaves %.1f deg to the side; at rest "
            "the direction can change by 5 deg at most, so turn at a waypoint with a speed",
            p->label, angle_rad / SCHULER_RAD_PER_DEG);
        return SCHULER_ERR_INPUT;
    }
    phase.heading.trapezoid = schuler_trapezoid_make(angle_rad, pivot_rate_radps, pivot_ramp_s);
    phase.duration_s = schuler_trapezoid_duration(&phase.heading.trapezoid);
    return follow(b, &phase, p, d);
}

static schuler_status fly(const route_plan *plan, schuler_path *path, schuler_diagnostics *d)
{
    const route_point *const start = &plan->points[0];
    schuler_path_builder b;
    schuler_path_begin(&b, path,
                       schuler_course_at(start->lat_rad, start->lon_rad, plan->legs[0].azimuth_rad),
                       start->h_m);
    for (size_t i = 0; i < plan->count; i++) {
        schuler_status status = SCHULER_OK;
        schuler_phase turn = plan->turns[i].phase;
        if (plan->points[i].speed_mps <= 0.0) {
            status = stand(&b, plan, i, d);
        } else {
            /* What fails here fails again when flown, and is reported there. */
            if (route_aim_turn(&b, plan, i, &turn) != SCHULER_OK) turn = plan->turns[i].phase;
            status = follow(&b, &turn, &plan->points[i], d);
        }
        if (status == SCHULER_OK && i + 1 < plan->count)
            status = route_fly_straight(&b, plan, i, d);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_route_spec *const s = spec;
    const size_t count = s->waypoints.count;
    if (count < 2) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place, "a route needs two waypoints or more");
        return SCHULER_ERR_INPUT;
    }
    route_plan plan = {
        .count = count,
        .points = calloc(count, sizeof(route_point)),
        .legs = calloc(count, sizeof(route_leg)),
        .turns = calloc(count, sizeof(route_turn)),
    };
    schuler_path path = { 0 };
    schuler_status status = SCHULER_ERR_MEMORY;
    if (plan.points == NULL || plan.legs == NULL || plan.turns == NULL)
        schuler_diagnose(d, status, &s->place, "out of memory for the route");
    else
        status = plan_route(s, &plan, d);
    if (status == SCHULER_OK) status = fly(&plan, &path, d);
    free(plan.points);
    free(plan.legs);
    free(plan.turns);
    if (status != SCHULER_OK) {
        schuler_path_free(&path);
        return status;
    }
    *out = path;
    return SCHULER_OK;
}

extern const schuler_trajectory_kind schuler_trajectory_route;
const schuler_trajectory_kind schuler_trajectory_route = {
    .name = "route",
    .summary = "waypoints flown along geodesics with coordinated fly-by turns, and taxiing",
    .source = "geodesics: GeographicLib (Karney 2013); turns by shooting on the ellipsoid",
    .object = &schuler_route_object,
    .build = build,
};

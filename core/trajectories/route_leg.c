/* SPDX-License-Identifier: MIT */
/* The straight part of a leg: a geodesic flown with changes of speed and height, whose length in
 * time is solved so that it ends where the next turn begins. */
#include "core/geographic.h"
#include "core/trajectories/route.h"

static schuler_channel change(double from, double to, double rate_limit, double ramp_s)
{
    return (schuler_channel){ .from = from,
                              .trapezoid = schuler_trapezoid_make(to - from, rate_limit, ramp_s) };
}

schuler_phase route_straight(const route_plan *plan, size_t i, double duration_s,
                             double *shortest_s)
{
    const route_point *const a = &plan->points[i], *const b = &plan->points[i + 1];
    const schuler_manner *const m = &b->manner;
    const int faster = b->speed_mps > a->speed_mps, up = b->h_m > a->h_m;
    const double along = faster ? m->acceleration_mps2 : m->deceleration_mps2;
    const double climb = up ? m->climb_mps : m->descent_mps;
    schuler_phase phase = {
        .duration_s = duration_s,
        .speed = change(a->speed_mps, b->speed_mps, along,
                        SCHULER_SMOOTHSTEP_SLOPE * along / m->jerk_mps3),
        .height = change(a->h_m, b->h_m, climb,
                         SCHULER_SMOOTHSTEP_SLOPE * climb / m->vertical_acceleration_mps2),
        .banked = 1,
    };
    const double for_speed_s = schuler_trapezoid_duration(&phase.speed.trapezoid);
    const double for_height_s = schuler_trapezoid_duration(&phase.height.trapezoid);
    /* Nothing climbs or descends at rest: then one change waits for the other. */
    const int in_turn = a->speed_mps <= 0.0 || b->speed_mps <= 0.0;
    *shortest_s = in_turn ? for_speed_s + for_height_s : fmax(for_speed_s, for_height_s);
    if (!faster) phase.speed.start_s = duration_s - for_speed_s;
    if (!up) phase.height.start_s = duration_s - for_height_s;
    if (in_turn && faster && up) phase.height.start_s = for_speed_s;
    if (in_turn && !faster && !up) phase.height.start_s = phase.speed.start_s - for_height_s;
    return phase;
}

/* Metres of the surface below per metre flown, at a mean height; off by 1e-5 at most. */
static double below(const route_point *a, const route_point *b)
{
    return 1.0 / (1.0 + 0.5 * (a->h_m + b->h_m) / 6371000.0);
}

/* Surface length the straight part takes in a time, nearly. */
static double reach(const route_plan *plan, size_t i, double duration_s)
{
    const route_point *const a = &plan->points[i], *const b = &plan->points[i + 1];
    double unused;
    const schuler_phase phase = route_straight(plan, i, duration_s, &unused);
    const double for_speed_s = schuler_trapezoid_duration(&phase.speed.trapezoid);
    const double flown_m = 0.5 * (a->speed_mps + b->speed_mps) * for_speed_s +
                           fmax(a->speed_mps, b->speed_mps) * (duration_s - for_speed_s);
    return flown_m * below(a, b);
}

static void too_short(const route_plan *plan, size_t i, double needs_m, schuler_diagnostics *d)
{
    const route_point *const a = &plan->points[i], *const b = &plan->points[i + 1];
    const double turns_m = plan->turns[i].exit_m + plan->turns[i + 1].entry_m;
    schuler_diagnose(
        d, SCHULER_ERR_INPUT, b->place,
        "the leg from waypoint %s to %s is too short: it has %.0f m and needs %.0f m, "
        "%.0f m for its turns and %.0f m to change speed from %.4g to %.4g m/s and height "
        "from %.0f to %.0f m",
        a->label, b->label, plan->legs[i].length_m, turns_m + needs_m, turns_m, needs_m,
        a->speed_mps, b->speed_mps, a->h_m, b->h_m);
}

schuler_status route_check_leg(const route_plan *plan, size_t i, schuler_diagnostics *d)
{
    const route_point *const a = &plan->points[i], *const b = &plan->points[i + 1];
    const double room_m =
        plan->legs[i].length_m - plan->turns[i].exit_m - plan->turns[i + 1].entry_m;
    if (a->speed_mps <= 0.0 && b->speed_mps <= 0.0) {
        schuler_diagnose(
            d, SCHULER_ERR_INPUT, b->place,
            "the leg from waypoint %s to %s is at rest at both ends; put a waypoint with "
            "a speed between them",
            a->label, b->label);
        return SCHULER_ERR_INPUT;
    }
    double shortest_s;
    route_straight(plan, i, 0.0, &shortest_s);
    const double needs_m = reach(plan, i, shortest_s);
    if (needs_m <= room_m) return SCHULER_OK;
    too_short(plan, i, needs_m, d);
    return SCHULER_ERR_INPUT;
}

/* Distance from the builder's place to the begin of the next turn, negative when it has been
 * passed. */
static double remaining(const schuler_path_builder *b, const route_plan *plan, size_t i)
{
    const route_point *const next = &plan->points[i + 1];
    double lat_rad, lon_rad, azimuth_rad, s_m, bearing_rad, unused;
    route_locate(&b->course, &lat_rad, &lon_rad, &azimuth_rad);
    schuler_geodesic_inverse(lat_rad, lon_rad, next->lat_rad, next->lon_rad, &s_m, &bearing_rad,
                             &unused);
    const double ahead_m = s_m * cos(bearing_rad - azimuth_rad);
    return ahead_m - plan->turns[i + 1].entry_m;
}

static schuler_status report(schuler_status status, const route_plan *plan, size_t i,
                             schuler_diagnostics *d)
{
    schuler_diagnose(d, status, plan->points[i + 1].place,
                     status == SCHULER_ERR_MEMORY
                         ? "out of memory for the leg from waypoint %s to %s"
                         : "the leg from waypoint %s to %s could not be computed",
                     plan->points[i].label, plan->points[i + 1].label);
    return status;
}

schuler_status route_fly_straight(schuler_path_builder *b, const route_plan *plan, size_t i,
                                  schuler_diagnostics *d)
{
    const route_point *const from = &plan->points[i], *const to = &plan->points[i + 1];
    const double fastest_mps = fmax(from->speed_mps, to->speed_mps);
    const double tick_m = fastest_mps / SCHULER_TICKS_PER_S;
    double shortest_s;
    route_straight(plan, i, 0.0, &shortest_s);
    double duration_s = shortest_s + (remaining(b, plan, i) - reach(plan, i, shortest_s)) /
                                         (fastest_mps * below(from, to));
    for (int iteration = 0; iteration < 20; iteration++) {
        duration_s = fmax(schuler_tick(duration_s), 0.0);
        if (b->t_s + duration_s > SCHULER_TRAJECTORY_LONGEST_S) {
            schuler_diagnose(d, SCHULER_ERR_INPUT, to->place,
                             "the trajectory gets longer than 1000 h");
            return SCHULER_ERR_INPUT;
        }
        const schuler_phase phase =
            route_straight(plan, i, fmax(duration_s, shortest_s), &shortest_s);
        schuler_path_builder trial = *b;
        trial.path = NULL;
        schuler_status status = schuler_course_follow(&trial, SCHULER_COURSE_TRACK, &phase);
        if (status != SCHULER_OK) return report(status, plan, i, d);
        const double left_m = remaining(&trial, plan, i);
        if (fabs(left_m) < 1e-7 + tick_m) {
            status = schuler_course_follow(b, SCHULER_COURSE_TRACK, &phase);
            return status == SCHULER_OK ? status : report(status, plan, i, d);
        }
        if (left_m < 0.0 && duration_s <= shortest_s) {
            too_short(plan, i, reach(plan, i, shortest_s), d);
            return SCHULER_ERR_INPUT;
        }
        duration_s += left_m / (fastest_mps * below(from, to));
    }
    return report(SCHULER_ERR_NUMERIC, plan, i, d);
}

/* SPDX-License-Identifier: MIT */
/* Waypoints as given to waypoints complete. */
#include "core/trajectories/route.h"
#include <stdio.h>

static double choose(double own, double otherwise)
{
    return isnan(own) ? otherwise : own;
}

static schuler_manner merge(const schuler_manner *own, const schuler_manner *defaults)
{
    return (schuler_manner){
        .bank_rad = choose(own->bank_rad, defaults->bank_rad),
        .roll_rate_radps = choose(own->roll_rate_radps, defaults->roll_rate_radps),
        .radius_m = choose(own->radius_m, defaults->radius_m),
        .climb_mps = choose(own->climb_mps, defaults->climb_mps),
        .descent_mps = choose(own->descent_mps, defaults->descent_mps),
        .vertical_acceleration_mps2 =
            choose(own->vertical_acceleration_mps2, defaults->vertical_acceleration_mps2),
        .acceleration_mps2 = choose(own->acceleration_mps2, defaults->acceleration_mps2),
        .deceleration_mps2 = choose(own->deceleration_mps2, defaults->deceleration_mps2),
        .jerk_mps3 = choose(own->jerk_mps3, defaults->jerk_mps3),
    };
}

/* A waypoint's own radius or bank counts before those of the defaults. */
static int turns_flat(const schuler_manner *own, const schuler_manner *defaults)
{
    if (!isnan(own->radius_m)) return 1;
    return isnan(own->bank_rad) && !isnan(defaults->radius_m);
}

static int check(const route_point *p, const schuler_waypoint_spec *spec, schuler_diagnostics *d)
{
    int errors = 0;
    if (p->wait_s > 0.0 && p->speed_mps > 0.0) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, p->place,
                         "waypoint %s has a wait, but passes at %.4g m/s; a wait needs speed 0 m/s",
                         p->label, p->speed_mps);
        errors++;
    }
    if (!isnan(spec->manner.radius_m) && !isnan(spec->manner.bank_rad)) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, p->place,
                         "waypoint %s has a bank and a radius; a turn has one of them", p->label);
        errors++;
    }
    return errors;
}

int route_fill_points(const schuler_route_spec *spec, route_plan *plan, schuler_diagnostics *d)
{
    const schuler_waypoint_spec *const given = spec->waypoints.items;
    int errors = 0;
    for (size_t i = 0; i < plan->count; i++) {
        const schuler_waypoint_spec *const w = &given[i];
        route_point *const p = &plan->points[i];
        *p = (route_point){
            .place = &w->place,
            .lat_rad = w->lat_rad,
            .lon_rad = w->lon_rad,
            .h_m = choose(w->h_m, i > 0 ? plan->points[i - 1].h_m : 0.0),
            .speed_mps = choose(w->speed_mps, i > 0 ? plan->points[i - 1].speed_mps : 0.0),
            .wait_s = w->wait_s,
            .manner = merge(&w->manner, &spec->defaults),
            .flat = turns_flat(&w->manner, &spec->defaults),
        };
        if (w->name != NULL)
            snprintf(p->label, sizeof p->label, "'%.40s'", w->name);
        else
            snprintf(p->label, sizeof p->label, "number %zu", i + 1);
        errors += check(p, w, d);
    }
    return errors;
}

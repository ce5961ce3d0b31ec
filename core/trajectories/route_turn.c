/* SPDX-License-Identifier: MIT */
/* A fly-by turn by shooting on the ellipsoid: where to begin and how far to turn, so that the end
 * lies on the next leg and points along it. In a plane the answer follows from symmetry; the
 * ellipsoid moves it a little, so a few steps of Newton's method from there do. */
#include "core/geographic.h"
#include "core/trajectories/route.h"

/* Beyond this a fly-by begins absurdly far before its waypoint. */
static const double sharpest_rad = 170.0 * SCHULER_RAD_PER_DEG;
/* Turns below the first are none; below the second the begin hardly moves the end sideways. */
static const double none_rad = 1e-12, slight_rad = 1e-4;
/* What may be missed. The angle is 5 um after 5000 km; over a short leg GeographicLib's own 15 nm
 * are more. */
static const double miss_m = 1e-7, miss_rad = 1e-12;

void route_locate(const schuler_course *course, double *lat_rad, double *lon_rad,
                  double *azimuth_rad)
{
    const xvec n = course->n_e, u = course->u_e;
    const long double equatorial = hypotl(n.v[0], n.v[1]);
    const long double lon = atan2l(n.v[1], n.v[0]);
    const xvec east_e = xvec_make(-sinl(lon), cosl(lon), 0.0L);
    const xvec north_e = xvec_cross(n, east_e);
    *lat_rad = (double)atan2l(n.v[2], equatorial);
    *lon_rad = (double)lon;
    *azimuth_rad = (double)atan2l(xvec_dot(u, east_e), xvec_dot(u, north_e));
}

double route_wrap(double angle_rad)
{
    const double wrapped = remainder(angle_rad, 2.0 * SCHULER_PI);
    return wrapped <= -SCHULER_PI ? wrapped + 2.0 * SCHULER_PI : wrapped;
}

/* The ramps of a turn rate grow with it: ramp = per_rate * rate keeps roll rate (banked) or jerk
 * (flat) at its limit. A turn too small for the full rate gets the rate whose ramps alone make it,
 * so that a correction of a hundredth of a degree does not take the time of a full roll-in; a
 * second at least. */
static schuler_phase turn_phase(const route_point *p, double angle_rad)
{
    const double v = p->speed_mps;
    const double full_radps =
        p->flat ? v / p->manner.radius_m : tan(p->manner.bank_rad) * SCHULER_G0_MPS2 / v;
    const double per_rate =
        SCHULER_SMOOTHSTEP_SLOPE * v /
        (p->flat ? p->manner.jerk_mps3 : p->manner.roll_rate_radps * SCHULER_G0_MPS2);
    const double rate_radps = fmin(full_radps, sqrt(fabs(angle_rad) / per_rate));
    schuler_phase phase = {
        .speed = { .from = v },
        .height = { .from = p->h_m },
        .heading = { .trapezoid = schuler_trapezoid_make(angle_rad, rate_radps,
                                                         fmax(per_rate * rate_radps, 1.0)) },
        .banked = !p->flat,
    };
    phase.duration_s = schuler_trapezoid_duration(&phase.heading.trapezoid);
    return phase;
}

/* What a try ends with. */
typedef struct {
    double off_m, off_rad; /* beside the next leg; direction against that to its far end */
    double exit_m, left_m; /* along the next leg: from the waypoint, and to its far end */
} miss;

static schuler_status shoot(const route_plan *plan, size_t i, double entry_m,
                            const schuler_phase *phase, miss *out)
{
    const route_point *const before = &plan->points[i - 1], *const here = &plan->points[i],
                             *const next = &plan->points[i + 1];
    const route_leg *const in = &plan->legs[i - 1], *const away = &plan->legs[i];
    double lat_rad, lon_rad, azimuth_rad, s_m, bearing_rad, unused;
    schuler_geodesic_direct(before->lat_rad, before->lon_rad, in->azimuth_rad,
                            in->length_m - entry_m, &lat_rad, &lon_rad, &azimuth_rad);
    schuler_path_builder b;
    schuler_path_begin(&b, NULL, schuler_course_at(lat_rad, lon_rad, azimuth_rad), here->h_m);
    const schuler_status status = schuler_course_follow(&b, SCHULER_COURSE_TRACK, phase);
    if (status != SCHULER_OK) return status;
    route_locate(&b.course, &lat_rad, &lon_rad, &azimuth_rad);
    schuler_geodesic_inverse(here->lat_rad, here->lon_rad, lat_rad, lon_rad, &s_m, &bearing_rad,
                             &unused);
    const double beside_rad = route_wrap(bearing_rad - away->azimuth_rad);
    out->off_m = s_m * sin(beside_rad);
    out->exit_m = s_m * cos(beside_rad);
    schuler_geodesic_inverse(lat_rad, lon_rad, next->lat_rad, next->lon_rad, &out->left_m,
                             &bearing_rad, &unused);
    out->off_rad = route_wrap(azimuth_rad - bearing_rad);
    return SCHULER_OK;
}

/* Newton's method in (entry, angle) with difference quotients. Steps of them are large against the
 * ticks that durations are rounded to. */
static schuler_status newton(const route_plan *plan, size_t i, double *entry_m, double *angle_rad,
                             route_turn *out)
{
    const route_point *const p = &plan->points[i];
    const double de_m = 1.0, da_rad = 1e-3 * fabs(*angle_rad);
    const int slight = fabs(*angle_rad) < slight_rad;
    miss at = { 0 };
    for (int iteration = 0; iteration < 30; iteration++) {
        out->phase = turn_phase(p, *angle_rad);
        schuler_status status = shoot(plan, i, *entry_m, &out->phase, &at);
        if (status != SCHULER_OK) return status;
        if ((fabs(at.off_m) < miss_m || slight) &&
            fabs(at.off_rad) < miss_rad + miss_m / at.left_m) {
            out->entry_m = *entry_m;
            out->exit_m = at.exit_m;
            return SCHULER_OK;
        }
        miss along = { 0 }, more = { 0 };
        const schuler_phase turned_more = turn_phase(p, *angle_rad + da_rad);
        status = shoot(plan, i, *entry_m, &turned_more, &more);
        if (status == SCHULER_OK && !slight)
            status = shoot(plan, i, *entry_m + de_m, &out->phase, &along);
        if (status != SCHULER_OK) return status;
        const double m_a = (more.off_m - at.off_m) / da_rad,
                     r_a = (more.off_rad - at.off_rad) / da_rad;
        if (slight) {
            *angle_rad -= at.off_rad / r_a;
            continue;
        }
        const double m_e = (along.off_m - at.off_m) / de_m,
                     r_e = (along.off_rad - at.off_rad) / de_m;
        const double det = m_e * r_a - m_a * r_e;
        *entry_m -= (r_a * at.off_m - m_a * at.off_rad) / det;
        *angle_rad -= (m_e * at.off_rad - r_e * at.off_m) / det;
        if (!isfinite(*entry_m + *angle_rad) || fabs(*angle_rad) > SCHULER_PI) break;
    }
    return SCHULER_ERR_NUMERIC;
}

schuler_status route_aim_turn(const schuler_path_builder *b, const route_plan *plan, size_t i,
                              schuler_phase *phase)
{
    const route_point *const next = &plan->points[i + 1];
    if (phase->duration_s <= 0.0) return SCHULER_OK;
    for (int iteration = 0; iteration < 5; iteration++) {
        schuler_path_builder trial = *b;
        trial.path = NULL;
        const schuler_status status = schuler_course_follow(&trial, SCHULER_COURSE_TRACK, phase);
        if (status != SCHULER_OK) return status;
        double lat_rad, lon_rad, azimuth_rad, s_m, bearing_rad, unused;
        route_locate(&trial.course, &lat_rad, &lon_rad, &azimuth_rad);
        schuler_geodesic_inverse(lat_rad, lon_rad, next->lat_rad, next->lon_rad, &s_m, &bearing_rad,
                                 &unused);
        /* The end turns with the angle, one to one but for the curvature of the earth. */
        const double off_rad = route_wrap(azimuth_rad - bearing_rad);
        if (fabs(off_rad) < 1e-13 + 1e-8 / s_m) break;
        *phase = turn_phase(&plan->points[i], phase->heading.trapezoid.change - off_rad);
    }
    return SCHULER_OK;
}

schuler_status route_solve_turn(const route_plan *plan, size_t i, route_turn *out,
                                schuler_diagnostics *d)
{
    const route_point *const p = &plan->points[i];
    double angle_rad = route_wrap(plan->legs[i].azimuth_rad - plan->legs[i - 1].arrival_rad);
    if (p->speed_mps <= 0.0 || fabs(angle_rad) < none_rad) {
        *out = (route_turn){ 0 };
        return SCHULER_OK;
    }
    if (fabs(angle_rad) > sharpest_rad) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, p->place,
                         "the turn at waypoint %s is %.1f deg; a fly-by turns at most 170 deg, so "
                         "add a waypoint beside it",
                         p->label, angle_rad / SCHULER_RAD_PER_DEG);
        return SCHULER_ERR_INPUT;
    }
    /* An arc of the turn's length and angle, on the surface below. */
    const schuler_phase guess = turn_phase(p, angle_rad);
    const double length_m = p->speed_mps * guess.duration_s / (1.0 + p->h_m / SCHULER_WGS84_A_M);
    double entry_m = 0.5 * length_m * tan(0.5 * angle_rad) / (0.5 * angle_rad);
    if (entry_m >= plan->legs[i - 1].length_m || entry_m >= plan->legs[i].length_m) {
        /* Hopeless: the check of the legs will say so, with these figures. */
        *out = (route_turn){ .entry_m = entry_m, .exit_m = entry_m };
        return SCHULER_OK;
    }
    const schuler_status status = newton(plan, i, &entry_m, &angle_rad, out);
    if (status != SCHULER_OK)
        schuler_diagnose(d, status, p->place, "the turn at waypoint %s could not be solved",
                         p->label);
    return status;
}

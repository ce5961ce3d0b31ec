/* SPDX-License-Identifier: MIT */
/* A list of manoeuvres, each of one or a few phases in which something changes along a smooth
 * trapezoid or a polynomial and the rest stays. */
#include "core/trajectories/segments.h"
#include "core/trajectories/fields.h"

/* Nearer to a pole heading changes too fast to be what anybody means by it. */
static const double lat_limit_deg = 89.9;

schuler_phase segment_steady(const flight *f)
{
    return (schuler_phase){
        .speed = { .from = f->speed_mps },
        .height = { .from = f->h_m },
        .path_angle = { .from = f->path_angle_rad },
        .heading = { .from = f->heading_rad },
        .yaw = { .from = f->yaw_rad },
        .pitch = { .from = f->pitch_rad },
        .roll = { .from = f->roll_rad },
        .along_path = f->path_angle_rad != 0.0,
        .banked = 1,
    };
}

static schuler_status refuse(schuler_diagnostics *d, const schuler_place *place,
                             schuler_status status, const char *message)
{
    schuler_diagnose(d, status, place, "%s", message);
    return status;
}

schuler_status segment_refuse(const flight *f, const schuler_place *place, const char *message)
{
    return refuse(f->d, place, SCHULER_ERR_INPUT, message);
}

static int near_pole(const schuler_path_builder *b)
{
    return fabsl(b->course.n_e.v[2]) > sinl(lat_limit_deg * SCHULER_RAD_PER_DEG);
}

/* Many turns make large angles, which lose digits. */
static long double wrap(long double angle_rad)
{
    return remainderl(angle_rad, 2.0L * acosl(-1.0L));
}

/* A path that leads over the top goes the other way, and the vehicle is upside down: that is the
 * same motion with a path angle within 90 deg. What full turns leave of rounding is level. */
static void tidy_path_angle(flight *f, long double angle_rad, long double heading_rad)
{
    const long double pi = acosl(-1.0L), rounding = 1e-14L;
    angle_rad = wrap(angle_rad);
    if (fabsl(angle_rad) > 0.5L * pi + rounding) {
        angle_rad = wrap(pi - angle_rad);
        heading_rad += pi;
        f->yaw_rad = -f->yaw_rad;
        f->pitch_rad = -f->pitch_rad;
        f->roll_rad = (double)wrap(f->roll_rad + pi);
    }
    f->path_angle_rad = fabsl(angle_rad) < rounding ? 0.0 : (double)angle_rad;
    f->heading_rad = (double)wrap(heading_rad);
}

/* Pieces get short where the course gets singular, so a pole is seen before it is crossed. */
schuler_status segment_follow(flight *f, const schuler_phase *phase, const schuler_place *place)
{
    schuler_path_builder *const b = f->builder;
    if (b->t_s + phase->duration_s > SCHULER_TRAJECTORY_LONGEST_S)
        return segment_refuse(f, place, "the trajectory gets longer than 1000 h");
    b->course.h_m = f->h_m;
    const schuler_status status = schuler_course_follow(b, SCHULER_COURSE_RHUMB, phase);
    if (near_pole(b)) {
        schuler_diagnose(f->d, SCHULER_ERR_INPUT, place,
                         "this leads beyond latitude %.1f deg, where a heading has no meaning; "
                         "kind 'route' can cross a pole",
                         lat_limit_deg);
        return SCHULER_ERR_INPUT;
    }
    if (status == SCHULER_ERR_MEMORY)
        return refuse(f->d, place, status, "out of memory for the trajectory");
    if (b->lowest_m < FIELD_LOWEST_M - 1e-3 || b->highest_m > FIELD_HIGHEST_M + 1e-3) {
        const int low = b->lowest_m < FIELD_LOWEST_M - 1e-3;
        schuler_diagnose(f->d, SCHULER_ERR_INPUT, place,
                         "this leads to a height of %.0f m; allowed: %.0f to %.0f m",
                         (double)(low ? b->lowest_m : b->highest_m), FIELD_LOWEST_M,
                         FIELD_HIGHEST_M);
        return SCHULER_ERR_INPUT;
    }
    if (status != SCHULER_OK)
        return refuse(f->d, place, status,
                      "this cannot be computed: too abrupt, or the whole trajectory has too many "
                      "manoeuvres");
    f->speed_mps = schuler_channel_end(&phase->speed);
    f->yaw_rad = (double)wrap(schuler_channel_end(&phase->yaw));
    f->pitch_rad = (double)wrap(schuler_channel_end(&phase->pitch));
    f->roll_rad = (double)wrap(schuler_channel_end(&phase->roll));
    if (!phase->along_path) {
        f->h_m = schuler_channel_end(&phase->height);
        f->heading_rad = (double)wrap(schuler_channel_end(&phase->heading));
        return SCHULER_OK;
    }
    f->h_m = (double)b->course.h_m;
    tidy_path_angle(f, schuler_channel_end(&phase->path_angle),
                    schuler_channel_end(&phase->heading));
    return SCHULER_OK;
}

static schuler_status one(flight *f, const schuler_variant *v)
{
    const segment_kind *kind = schuler_segment_kinds;
    while (kind->object != v->which) kind++;
    return kind->fly(f, v->spec);
}

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_segments_spec *const s = spec;
    const schuler_start *const at = &s->start;
    schuler_path path = { 0 };
    schuler_path_builder builder;
    schuler_path_begin(&builder, &path,
                       schuler_course_at(at->lat_rad, at->lon_rad, at->heading_rad), at->h_m);
    flight f = { .builder = &builder,
                 .speed_mps = at->speed_mps,
                 .h_m = at->h_m,
                 .heading_rad = at->heading_rad,
                 .path_angle_rad = at->path_angle_rad,
                 .d = d };
    schuler_status status = SCHULER_OK;
    if (near_pole(&builder))
        status = segment_refuse(&f, &at->place,
                                "kind 'segments' must start within 89.9 deg of latitude");
    for (size_t i = 0; status == SCHULER_OK && i < s->segments.count; i++)
        status = one(&f, &s->segments.items[i]);
    if (status == SCHULER_OK && path.count == 0)
        status = segment_refuse(&f, &s->place,
                                "the trajectory lasts no time; it needs at least one segment that "
                                "does");
    if (status != SCHULER_OK) {
        schuler_path_free(&path);
        return status;
    }
    *out = path;
    return SCHULER_OK;
}

extern const schuler_trajectory_kind schuler_trajectory_segments;
const schuler_trajectory_kind schuler_trajectory_segments = {
    .name = "segments",
    .summary = "manoeuvres one after the other: hold, accelerate, climb, turn, pull, loop, roll, "
               "orbit, stop_and_go, polynomial and more",
    .source = "smoothstep trapezoids and Bernstein polynomials on the WGS84 ellipsoid, coordinated "
              "turns",
    .object = &schuler_segments_object,
    .build = build,
};

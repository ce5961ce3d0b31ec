/* SPDX-License-Identifier: MIT */
/* A list of manoeuvres: each is one phase in which speed, height or heading changes along a smooth
 * trapezoid and the two others stay. */
#include "core/trajectories/segments.h"
#include "core/course.h"

/* Nearer to a pole heading changes too fast to be what anybody means by it. */
static const double lat_limit_deg = 89.9;

/* What the manoeuvres hand on. */
typedef struct {
    schuler_path_builder *builder;
    double speed_mps, h_m, heading_rad;
    schuler_diagnostics *d;
} flight;

static schuler_phase steady(const flight *f)
{
    return (schuler_phase){
        .speed = { .from = f->speed_mps },
        .height = { .from = f->h_m },
        .heading = { .from = f->heading_rad },
        .banked = 1,
    };
}

static schuler_status refuse(schuler_diagnostics *d, const schuler_place *place,
                             schuler_status status, const char *message)
{
    schuler_diagnose(d, status, place, "%s", message);
    return status;
}

static int near_pole(const schuler_path_builder *b)
{
    return fabsl(b->course.n_e.v[2]) > sinl(lat_limit_deg * SCHULER_RAD_PER_DEG);
}

/* Pieces get short where the course gets singular, so a pole is seen before it is crossed. */
static schuler_status follow(flight *f, const schuler_phase *phase, const schuler_place *place)
{
    schuler_path_builder *const b = f->builder;
    if (b->t_s + phase->duration_s > SCHULER_TRAJECTORY_LONGEST_S)
        return refuse(f->d, place, SCHULER_ERR_INPUT, "the trajectory gets longer than 1000 h");
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
    if (status != SCHULER_OK)
        return refuse(f->d, place, status,
                      "this cannot be computed: too abrupt, or the whole trajectory has too many "
                      "manoeuvres");
    f->speed_mps = schuler_channel_end(&phase->speed);
    f->h_m = schuler_channel_end(&phase->height);
    /* Many turns make large angles, which lose digits. */
    f->heading_rad = (double)remainderl(schuler_channel_end(&phase->heading), 2.0L * acosl(-1.0L));
    return SCHULER_OK;
}

static schuler_status hold(flight *f, const schuler_hold_spec *s)
{
    schuler_phase phase = steady(f);
    phase.duration_s = schuler_tick(s->for_s);
    return follow(f, &phase, &s->place);
}

static schuler_status accelerate(flight *f, const schuler_accelerate_spec *s)
{
    schuler_phase phase = steady(f);
    phase.speed.trapezoid = schuler_trapezoid_make(
        s->to_mps - f->speed_mps, s->at_mps2, SCHULER_SMOOTHSTEP_SLOPE * s->at_mps2 / s->jerk_mps3);
    phase.duration_s = schuler_trapezoid_duration(&phase.speed.trapezoid);
    return follow(f, &phase, &s->place);
}

static schuler_status climb(flight *f, const schuler_climb_spec *s)
{
    if (f->speed_mps <= 0.0 && s->to_m != f->h_m)
        return refuse(f->d, &s->place, SCHULER_ERR_INPUT, "cannot climb at rest; accelerate first");
    schuler_phase phase = steady(f);
    phase.height.trapezoid = schuler_trapezoid_make(
        s->to_m - f->h_m, s->at_mps, SCHULER_SMOOTHSTEP_SLOPE * s->at_mps / s->acceleration_mps2);
    phase.duration_s = schuler_trapezoid_duration(&phase.height.trapezoid);
    return follow(f, &phase, &s->place);
}

static schuler_status turn(flight *f, const schuler_turn_spec *s)
{
    if (f->speed_mps <= 0.0 && s->by_rad != 0.0)
        return refuse(f->d, &s->place, SCHULER_ERR_INPUT, "cannot turn at rest; accelerate first");
    schuler_phase phase = steady(f);
    if (s->by_rad != 0.0) {
        const double tan_bank = tan(s->bank_rad);
        phase.heading.trapezoid =
            schuler_trapezoid_make(s->by_rad, tan_bank * SCHULER_G0_MPS2 / f->speed_mps,
                                   SCHULER_SMOOTHSTEP_SLOPE * tan_bank / s->roll_rate_radps);
    }
    phase.duration_s = schuler_trapezoid_duration(&phase.heading.trapezoid);
    return follow(f, &phase, &s->place);
}

static schuler_status one(flight *f, const schuler_variant *v)
{
    if (v->which == &schuler_segment_accelerate) return accelerate(f, v->spec);
    if (v->which == &schuler_segment_climb) return climb(f, v->spec);
    if (v->which == &schuler_segment_turn) return turn(f, v->spec);
    return hold(f, v->spec);
}

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_segments_spec *const s = spec;
    const schuler_start *const at = &s->start;
    schuler_path path = { 0 };
    schuler_path_builder builder;
    schuler_path_begin(&builder, &path,
                       schuler_course_at(at->lat_rad, at->lon_rad, at->heading_rad), at->h_m);
    flight f = { &builder, at->speed_mps, at->h_m, at->heading_rad, d };
    schuler_status status = SCHULER_OK;
    if (near_pole(&builder))
        status = refuse(d, &at->place, SCHULER_ERR_INPUT,
                        "kind 'segments' must start within 89.9 deg of latitude");
    for (size_t i = 0; status == SCHULER_OK && i < s->segments.count; i++)
        status = one(&f, &s->segments.items[i]);
    if (status == SCHULER_OK && path.count == 0)
        status = refuse(d, &s->place, SCHULER_ERR_INPUT,
                        "the trajectory lasts no time; it needs at least one segment that does");
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
    .summary = "manoeuvres one after the other: hold, accelerate, climb, turn, cruise",
    .source = "smoothstep trapezoids on the WGS84 ellipsoid, coordinated turns",
    .object = &schuler_segments_object,
    .build = build,
};

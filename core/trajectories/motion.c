/* SPDX-License-Identifier: MIT */
/* One test motion in closed form, at a place or along a line. */
#include "core/trajectories/motion.h"
#include "core/course.h"
#include "core/earth.h"

static schuler_status refuse(const schuler_place *place, const char *message,
                             schuler_diagnostics *d)
{
    schuler_diagnose(d, SCHULER_ERR_INPUT, place, "%s", message);
    return SCHULER_ERR_INPUT;
}

/* The motion that is given; NULL unless it is one. */
static schuler_flow_function *flow_of(const schuler_motion_spec *s, const schuler_place **place,
                                      int *count)
{
    const struct {
        const schuler_place *place;
        schuler_flow_function *flow;
    } all[] = {
        { &s->coning.place, schuler_motion_coning },
        { &s->sculling.place, schuler_motion_sculling },
        { &s->spin_cone.place, schuler_motion_spin_cone },
        { &s->constant_rate.place, schuler_motion_constant_rate },
        { &s->turntable.place, schuler_motion_turntable },
        { &s->parallel.place, schuler_motion_parallel },
        { &s->geodesic.place, NULL },
    };
    schuler_flow_function *flow = NULL;
    *count = 0;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        if (!all[i].place->file) continue;
        flow = all[i].flow;
        *place = all[i].place;
        ++*count;
    }
    return flow;
}

/* Along the geodesic that starts towards the heading, level: over a pole like anywhere. */
static schuler_status follow_geodesic(const schuler_motion_spec *s, schuler_path *path)
{
    const schuler_start *const at = &s->start;
    const schuler_phase phase = { .duration_s = schuler_tick(s->for_s),
                                  .speed = { .from = s->geodesic.speed_mps },
                                  .height = { .from = at->h_m } };
    schuler_path_builder b;
    schuler_path_begin(&b, path, schuler_course_at(at->lat_rad, at->lon_rad, at->heading_rad),
                       at->h_m);
    return schuler_course_follow(&b, SCHULER_COURSE_TRACK, &phase);
}

static schuler_status follow(const schuler_motion_spec *s, schuler_flow_function *flow,
                             schuler_path *path)
{
    const schuler_start *const at = &s->start;
    const schuler_course north = schuler_course_at(at->lat_rad, at->lon_rad, 0.0);
    motion_frame m = { .spec = s };
    m.axes_r[0] = north.u_e;
    m.axes_r[1] = xvec_cross(north.u_e, north.n_e);
    m.axes_r[2] = xvec_scale(-1.0L, north.n_e);
    xvec_turn(m.axes_r, 2, at->heading_rad);
    if (flow != schuler_motion_turntable) {
        xvec_turn(m.axes_r, 1, at->pitch_rad);
        xvec_turn(m.axes_r, 0, at->roll_rad);
    }
    schuler_path_builder b;
    schuler_path_begin(&b, path, north, at->h_m);
    b.pieces_max = 4000000; /* 2.5 GB; a coning of 5 Hz takes 200000 an hour */
    return schuler_path_extend(&b, flow, &m, 0.0, schuler_tick(s->for_s));
}

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_motion_spec *const s = spec;
    const schuler_start *const at = &s->start;
    const schuler_place *place = &s->place;
    int count;
    schuler_flow_function *const flow = flow_of(s, &place, &count);
    if (count != 1)
        return refuse(count ? place : &s->place,
                      "one motion is expected: coning, sculling, spin_cone, constant_rate, "
                      "turntable, parallel or geodesic",
                      d);
    const int goes = place == &s->parallel.place || place == &s->geodesic.place;
    if (goes && (at->roll_rad != 0.0 || at->pitch_rad != 0.0))
        return refuse(&at->place, "this motion is level; leave out roll and pitch", d);
    if (place == &s->parallel.place && at->heading_rad != 0.0)
        return refuse(&at->place, "a flight along a parallel heads east; leave out heading", d);
    if (place == &s->parallel.place && fabs(at->lat_rad) > 89.9 * SCHULER_RAD_PER_DEG)
        return refuse(&at->place, "a parallel is flown up to 89.9 deg of latitude", d);
    schuler_path path = { 0 };
    const schuler_status status = flow ? follow(s, flow, &path) : follow_geodesic(s, &path);
    if (status != SCHULER_OK) {
        schuler_diagnose(d, status, place,
                         status == SCHULER_ERR_MEMORY
                             ? "out of memory for the motion"
                             : "the motion is too fast, or too long for its speed, to be computed");
        schuler_path_free(&path);
        return status;
    }
    *out = path;
    return SCHULER_OK;
}

extern const schuler_trajectory_kind schuler_trajectory_motion;
const schuler_trajectory_kind schuler_trajectory_motion = {
    .name = "motion",
    .summary =
        "test motions in closed form: coning, sculling, spin-cone, constant rate, turntable, "
        "along a parallel, along a geodesic",
    .source = "P. G. Savage, J. Guidance, Control, and Dynamics 21(1), 21(2), 1998; closed forms",
    .object = &schuler_motion_object,
    .build = build,
};

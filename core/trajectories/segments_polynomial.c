/* SPDX-License-Identifier: MIT */
/* Anything at once, along polynomials of time that the user gives. */
#include "core/trajectories/segments.h"

static void curve(schuler_channel *channel, const schuler_quantity_list *to, double offset,
                  double duration_s)
{
    channel->curve.count = to->count;
    channel->curve.duration_s = duration_s;
    for (size_t i = 0; i < to->count; i++) channel->curve.to[i] = offset + to->items[i];
}

schuler_status segment_polynomial(flight *f, const void *spec)
{
    const schuler_polynomial_spec *const s = spec;
    const int bends = s->path_angle.count > 0;
    if (s->height.count > 0 && (bends || f->path_angle_rad != 0.0))
        return segment_refuse(
            f, &s->place,
            "a polynomial of height starts from level flight and goes without one "
            "of path_angle");
    schuler_phase phase = segment_steady(f);
    phase.duration_s = schuler_tick(s->for_s);
    phase.along_path |= bends;
    curve(&phase.speed, &s->speed, 0.0, phase.duration_s);
    curve(&phase.height, &s->height, 0.0, phase.duration_s);
    curve(&phase.path_angle, &s->path_angle, 0.0, phase.duration_s);
    curve(&phase.heading, &s->turn, f->heading_rad, phase.duration_s);
    curve(&phase.yaw, &s->yaw, 0.0, phase.duration_s);
    curve(&phase.pitch, &s->pitch, 0.0, phase.duration_s);
    curve(&phase.roll, &s->roll, 0.0, phase.duration_s);
    if (s->height.count > 0 && f->speed_mps <= 0.0)
        return segment_refuse(f, &s->place, "cannot climb at rest; accelerate first");
    return segment_follow(f, &phase, &s->place);
}

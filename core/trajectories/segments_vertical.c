/* SPDX-License-Identifier: MIT */
/* Manoeuvres in the vertical plane of the heading: the flight path is bent at constant speed, by an
 * acceleration across it of speed times rate. */
#include "core/trajectories/segments.h"

static schuler_status bend(flight *f, double by_rad, double at_mps2, double jerk_mps3,
                           const schuler_place *place)
{
    if (f->speed_mps <= 0.0 && by_rad != 0.0)
        return segment_refuse(f, place,
                              "the flight path cannot be bent at rest; accelerate first, or say "
                              "'path_angle' at the start");
    schuler_phase phase = segment_steady(f);
    phase.along_path = 1;
    if (by_rad != 0.0)
        phase.path_angle.trapezoid = schuler_trapezoid_make(
            by_rad, at_mps2 / f->speed_mps, SCHULER_SMOOTHSTEP_SLOPE * at_mps2 / jerk_mps3);
    phase.duration_s = schuler_trapezoid_duration(&phase.path_angle.trapezoid);
    return segment_follow(f, &phase, place);
}

schuler_status segment_pull(flight *f, const void *spec)
{
    const schuler_pull_spec *const s = spec;
    return bend(f, s->to_rad - f->path_angle_rad, s->at_mps2, s->jerk_mps3, &s->place);
}

schuler_status segment_loop(flight *f, const void *spec)
{
    const schuler_loop_spec *const s = spec;
    return bend(f, s->by_rad, s->at_mps2, s->jerk_mps3, &s->place);
}

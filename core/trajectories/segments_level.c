/* SPDX-License-Identifier: MIT */
/* Manoeuvres of speed, height and heading. */
#include "core/trajectories/segments.h"

schuler_status segment_hold(flight *f, const void *spec)
{
    const schuler_hold_spec *const s = spec;
    schuler_phase phase = segment_steady(f);
    phase.duration_s = schuler_tick(s->for_s);
    return segment_follow(f, &phase, &s->place);
}

schuler_status segment_accelerate(flight *f, const void *spec)
{
    const schuler_accelerate_spec *const s = spec;
    schuler_phase phase = segment_steady(f);
    phase.speed.trapezoid = schuler_trapezoid_make(
        s->to_mps - f->speed_mps, s->at_mps2, SCHULER_SMOOTHSTEP_SLOPE * s->at_mps2 / s->jerk_mps3);
    phase.duration_s = schuler_trapezoid_duration(&phase.speed.trapezoid);
    return segment_follow(f, &phase, &s->place);
}

schuler_status segment_climb(flight *f, const void *spec)
{
    const schuler_climb_spec *const s = spec;
    if (f->path_angle_rad != 0.0)
        return segment_refuse(f, &s->place,
                              "climb starts from level flight; level it first with 'pull: {to: 0 "
                              "deg, ...}'");
    if (f->speed_mps <= 0.0 && s->to_m != f->h_m)
        return segment_refuse(f, &s->place, "cannot climb at rest; accelerate first");
    schuler_phase phase = segment_steady(f);
    phase.height.trapezoid = schuler_trapezoid_make(
        s->to_m - f->h_m, s->at_mps, SCHULER_SMOOTHSTEP_SLOPE * s->at_mps / s->acceleration_mps2);
    phase.duration_s = schuler_trapezoid_duration(&phase.height.trapezoid);
    return segment_follow(f, &phase, &s->place);
}

/* The rate of a turn and the ramps that keep its roll rate (banked) or its jerk (flat). */
schuler_status segment_turn(flight *f, const void *spec)
{
    const schuler_turn_spec *const s = spec;
    if (f->path_angle_rad != 0.0)
        return segment_refuse(
            f, &s->place,
            "turn starts from level flight; level it first with 'pull: {to: 0 deg, ...}'");
    if (f->speed_mps <= 0.0 && s->by_rad != 0.0)
        return segment_refuse(f, &s->place,
                              "cannot turn at rest; accelerate first, or say 'yaw' to turn on the "
                              "spot");
    schuler_phase phase = segment_steady(f);
    const double v = f->speed_mps;
    phase.banked = !(s->radius_m > 0.0);
    if (s->by_rad != 0.0) {
        const double tan_bank = tan(s->bank_rad);
        phase.heading.trapezoid =
            phase.banked
                ? schuler_trapezoid_make(s->by_rad, tan_bank * SCHULER_G0_MPS2 / v,
                                         SCHULER_SMOOTHSTEP_SLOPE * tan_bank / s->roll_rate_radps)
                : schuler_trapezoid_make(s->by_rad, v / s->radius_m,
                                         SCHULER_SMOOTHSTEP_SLOPE * v * v /
                                             (s->radius_m * s->jerk_mps3));
    }
    phase.duration_s = schuler_trapezoid_duration(&phase.heading.trapezoid);
    return segment_follow(f, &phase, &s->place);
}

/* SPDX-License-Identifier: MIT */
/* Turns of the body relative to the flight path, which goes on as it was. */
#include "core/trajectories/segments.h"

static schuler_status turn_body(flight *f, const schuler_body_turn_spec *s, schuler_phase *phase,
                                schuler_channel *channel)
{
    channel->trapezoid =
        schuler_trapezoid_make(s->by_rad, s->rate_radps,
                               SCHULER_SMOOTHSTEP_SLOPE * s->rate_radps / s->acceleration_radps2);
    phase->duration_s = schuler_trapezoid_duration(&channel->trapezoid);
    return segment_follow(f, phase, &s->place);
}

/* At rest there is no path to turn against: the vehicle turns on the spot, and goes that way. */
schuler_status segment_yaw(flight *f, const void *spec)
{
    schuler_phase phase = segment_steady(f);
    return turn_body(f, spec, &phase, f->speed_mps > 0.0 ? &phase.yaw : &phase.heading);
}

schuler_status segment_pitch(flight *f, const void *spec)
{
    schuler_phase phase = segment_steady(f);
    return turn_body(f, spec, &phase, &phase.pitch);
}

schuler_status segment_roll(flight *f, const void *spec)
{
    schuler_phase phase = segment_steady(f);
    return turn_body(f, spec, &phase, &phase.roll);
}

/* SPDX-License-Identifier: MIT */
/* Manoeuvres that are several simpler ones. */
#include "core/trajectories/segments.h"

static const double steepest_rad = 85.0 * SCHULER_RAD_PER_DEG;

/* Out, across and across, and back to the first heading. */
schuler_status segment_s_turn(flight *f, const void *spec)
{
    const schuler_s_turn_spec *const s = spec;
    schuler_turn_spec turn = s->turn;
    schuler_status status = segment_turn(f, &turn);
    for (int64_t i = 1; status == SCHULER_OK && i < 2 * s->times; i++) {
        turn.by_rad = i % 2 ? -2.0 * s->turn.by_rad : 2.0 * s->turn.by_rad;
        status = segment_turn(f, &turn);
    }
    turn.by_rad = s->turn.by_rad;
    return status == SCHULER_OK ? segment_turn(f, &turn) : status;
}

schuler_status segment_orbit(flight *f, const void *spec)
{
    const schuler_orbit_spec *const s = spec;
    const schuler_turn_spec turn = {
        .place = s->place,
        .by_rad = s->turns * 2.0 * SCHULER_PI,
        .bank_rad = atan(f->speed_mps * f->speed_mps / (s->radius_m * SCHULER_G0_MPS2)),
        .roll_rate_radps = s->roll_rate_radps,
    };
    if (turn.bank_rad > steepest_rad) {
        schuler_diagnose(f->d, SCHULER_ERR_INPUT, &s->place,
                         "an orbit of %g m at %g m/s needs %.1f deg of bank; at most 85 deg, which "
                         "takes %.0f m",
                         s->radius_m, f->speed_mps, turn.bank_rad / SCHULER_RAD_PER_DEG,
                         ceil(f->speed_mps * f->speed_mps / (SCHULER_G0_MPS2 * tan(steepest_rad))));
        return SCHULER_ERR_INPUT;
    }
    return segment_turn(f, &turn);
}

schuler_status segment_stop_and_go(flight *f, const void *spec)
{
    const schuler_stop_and_go_spec *const s = spec;
    schuler_accelerate_spec change = { .place = s->place,
                                       .at_mps2 = s->at_mps2,
                                       .jerk_mps3 = s->jerk_mps3 };
    const schuler_hold_spec drive = { .place = s->place, .for_s = s->drive_s };
    const schuler_hold_spec stop = { .place = s->place, .for_s = s->stop_s };
    schuler_status status = SCHULER_OK;
    for (int64_t i = 0; status == SCHULER_OK && i < s->times; i++) {
        change.to_mps = s->speed_mps;
        status = segment_accelerate(f, &change);
        if (status == SCHULER_OK) status = segment_hold(f, &drive);
        change.to_mps = 0.0;
        if (status == SCHULER_OK) status = segment_accelerate(f, &change);
        if (status == SCHULER_OK) status = segment_hold(f, &stop);
    }
    return status;
}

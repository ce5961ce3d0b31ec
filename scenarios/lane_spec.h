/* SPDX-License-Identifier: MIT */
/* From what a scenario or a part says of a triad to what one lane of its chain is. */
#ifndef SCHULER_SCENARIOS_LANE_SPEC_H
#define SCHULER_SCENARIOS_LANE_SPEC_H

#include "scenarios/sources.h"
#include "sensors/chain.h"

/** A lane with every source off: run and settings, which are the same in every lane. */
void schuler_lane_spec_start(const schuler_triad *triad, uint64_t run, schuler_lane_spec *spec);

/** Switch a source of its triad on: the value that it has in the lane's run. */
void schuler_lane_spec_draw(const error_source *source, uint64_t seed, schuler_lane_spec *spec);

/* What a chain setup borrows. */
typedef struct {
    schuler_lane_spec settings;
    bool given[SCHULER_PARAMS_MAX];
} chain_parts;

/** A chain for a triad of an IMU; valid as long as the IMU and *parts. */
schuler_chain_setup schuler_chain_setup_of(const schuler_imu *imu, schuler_instrument instrument,
                                           schuler_isa isa, double dt_s, uint64_t seed,
                                           chain_parts *parts);

#endif

/* SPDX-License-Identifier: MIT */
/* Trajectories for tests, built from their specs without a file. */
#ifndef SCHULER_TESTS_FLIGHTS_H
#define SCHULER_TESTS_FLIGHTS_H

#include "check.h"
#include "core/trajectory_specs.h"
#include "core/truth.h"
#include <string.h>

static inline const schuler_trajectory_kind *flight_kind(const char *name)
{
    for (size_t i = 0; schuler_trajectory_kinds[i] != NULL; i++)
        if (strcmp(schuler_trajectory_kinds[i]->name, name) == 0)
            return schuler_trajectory_kinds[i];
    fail_msg("no trajectory kind %s", name);
    return NULL;
}

/* Build, or fail with what it said. */
static inline schuler_path flight_build(const char *kind, const void *spec)
{
    schuler_path path = { 0 };
    schuler_diagnostics d = { 0 };
    const schuler_status status = flight_kind(kind)->build(spec, &path, &d);
    if (status != SCHULER_OK && d.kept > 0) print_error("%s\n", d.items[0].message);
    schuler_diagnostics_free(&d);
    assert_int_equal(status, SCHULER_OK);
    return path;
}

static inline schuler_path flight_segments(schuler_start start, schuler_variant *items,
                                           size_t count)
{
    const schuler_segments_spec spec = { .start = start, .segments = { items, count } };
    return flight_build("segments", &spec);
}

#define DEG SCHULER_RAD_PER_DEG

/* Everything there is: at rest, take-off run, climb, turns both ways with small and large bank, one
 * too small for its bank, descent, slowing down; about 21 minutes. */
static inline schuler_path flight_of_all_manoeuvres(void)
{
    schuler_hold_spec hold = { .for_s = 30.0 }, cruise = { .for_s = 400.0 };
    schuler_accelerate_spec faster = { .to_mps = 180.0, .at_mps2 = 2.5, .jerk_mps3 = 1.0 };
    schuler_accelerate_spec slower = { .to_mps = 90.0, .at_mps2 = 1.0, .jerk_mps3 = 0.7 };
    schuler_climb_spec climb = { .to_m = 4000.0, .at_mps = 12.0, .acceleration_mps2 = 1.0 };
    schuler_climb_spec descend = { .to_m = 3000.0, .at_mps = 9.0, .acceleration_mps2 = 0.5 };
    schuler_turn_spec right = { .by_rad = 100.0 * DEG,
                                .bank_rad = 25.0 * DEG,
                                .roll_rate_radps = 5.0 * DEG };
    schuler_turn_spec left = { .by_rad = -200.0 * DEG,
                               .bank_rad = 60.0 * DEG,
                               .roll_rate_radps = 30.0 * DEG };
    schuler_turn_spec slight = { .by_rad = 0.3 * DEG,
                                 .bank_rad = 25.0 * DEG,
                                 .roll_rate_radps = 5.0 * DEG };
    schuler_variant items[] = {
        { &schuler_segment_hold, &hold },         { &schuler_segment_accelerate, &faster },
        { &schuler_segment_climb, &climb },       { &schuler_segment_turn, &right },
        { &schuler_segment_cruise, &cruise },     { &schuler_segment_turn, &left },
        { &schuler_segment_turn, &slight },       { &schuler_segment_climb, &descend },
        { &schuler_segment_accelerate, &slower },
    };
    const schuler_start start = {
        .lat_rad = 48.0 * DEG, .lon_rad = 11.0 * DEG, .h_m = 500.0, .heading_rad = 80.0 * DEG
    };
    return flight_segments(start, items, sizeof(items) / sizeof(items[0]));
}

static inline schuler_truth *flight_truth(const schuler_path *path, double dt_s,
                                          const char *truth_gravity, const char *nav_gravity)
{
    schuler_truth *truth = NULL;
    schuler_error err = { 0 };
    const schuler_status status =
        schuler_truth_create(&truth, path, dt_s, truth_gravity, nav_gravity, &err);
    if (status != SCHULER_OK) print_error("%s\n", err.message);
    assert_int_equal(status, SCHULER_OK);
    return truth;
}

#endif

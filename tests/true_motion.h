/* SPDX-License-Identifier: MIT */
/* The truth of a scenario written in a test, at 100 Hz and with normal gravity on both sides. */
#ifndef SCHULER_TESTS_TRUE_MOTION_H
#define SCHULER_TESTS_TRUE_MOTION_H

#include "core/truth.h"
#include "mission.h"

typedef struct {
    schuler_scenario *scenario;
    schuler_truth *truth;
} motion;

static inline motion motion_start(const char *text)
{
    motion m = { .scenario = mission_text(text) };
    assert_int_equal(
        schuler_truth_create(&m.truth, &m.scenario->path, 0.01, "wgs84", "wgs84", NULL),
        SCHULER_OK);
    return m;
}

static inline void motion_end(motion *m)
{
    schuler_truth_free(m->truth);
    schuler_scenario_free(m->scenario);
}

#endif

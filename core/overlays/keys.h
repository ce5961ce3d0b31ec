/* SPDX-License-Identifier: MIT */
/* Rows of an overlay's table that several kinds have. Private to core/overlays. */
#ifndef SCHULER_CORE_OVERLAYS_KEYS_H
#define SCHULER_CORE_OVERLAYS_KEYS_H

#include "core/overlay.h"
#include "core/overlay_spectrum.h"
#include "core/trajectories/fields.h"

/* clang-format off */
#define OVERLAY_TIMES(TYPE)                                                                     \
    FIELD_OPTIONAL("from", TYPE, times.from_s, SCHULER_DIM_TIME, 0.0, 0.0,                      \
                   SCHULER_TRAJECTORY_LONGEST_S, "10 min", "when it begins"),                   \
    FIELD_OPTIONAL("for", TYPE, times.for_s, SCHULER_DIM_TIME, NAN, 1e-3,                       \
                   SCHULER_TRAJECTORY_LONGEST_S, "5 min", "how long; else to the end"),         \
    FIELD_OPTIONAL("ramp", TYPE, times.ramp_s, SCHULER_DIM_TIME, NAN, 0.0,                      \
                   SCHULER_TRAJECTORY_LONGEST_S, "10 s",                                        \
                   "to fade in and out over, where it begins or ends within the mission")

#define OVERLAY_LINES(TYPE)                                                                     \
    { .key = "lines", .kind = SCHULER_FIELD_INTEGER, .offset = offsetof(TYPE, lines),           \
      .def = 40, .min = 1, .max = 1000, .example = "40",                                        \
      .doc = "sinusoids that realise the spectrum" },                                           \
    { .key = "seed", .kind = SCHULER_FIELD_INTEGER, .offset = offsetof(TYPE, seed), .def = 1,   \
      .min = 0, .max = 1e15, .example = "1",                                                    \
      .doc = "of their frequencies and phases; the same in all runs" }
/* clang-format on */

#endif

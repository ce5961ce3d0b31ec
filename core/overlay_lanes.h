/* SPDX-License-Identifier: MIT */
/* Sums of many sinusoids, lines as lanes. Private to core. */
#ifndef SCHULER_CORE_OVERLAY_LANES_H
#define SCHULER_CORE_OVERLAY_LANES_H

#include "core/isa.h"
#include "core/overlay.h"

/* Lines are taken eight at a time and summed in eight columns, so that no sum depends on the width. */
enum { OVERLAY_COLUMNS = 8 };

/* The lines of a group; arrays of `count`, a multiple of OVERLAY_COLUMNS, aligned to 64. */
typedef struct {
    size_t count;
    int first, end; /* channels that some line acts in */
    double *frequency_Hz;
    double *base_turns;                 /* phase at the base instant, a part of a turn */
    double *in_phase[OVERLAY_CHANNELS]; /* only first .. end - 1 */
    double *in_quadrature[OVERLAY_CHANNELS];
} overlay_columns;

typedef struct {
    /** Channels first .. end - 1 and their rates, dt_s after the base instant. */
    void (*sum)(const overlay_columns *g, double dt_s, double x[OVERLAY_CHANNELS],
                double x_dot[OVERLAY_CHANNELS]);
} overlay_lanes;

const overlay_lanes *schuler_overlay_lanes_for(schuler_isa isa);

#endif

/* SPDX-License-Identifier: MIT */
/* Navigator minus truth. */
#ifndef SCHULER_SCENARIOS_COMPARATOR_H
#define SCHULER_SCENARIOS_COMPARATOR_H

#include "core/truth.h"
#include "mechanization/mechanization.h"
#include "scenarios/simulation.h"

/* Heights beyond which a navigator is lost: the gravity table holds from -1 to 50 km, or to 125 km where
 * the mission goes that high, and goes wrong slowly. */
enum { COMPARATOR_HEIGHT_MIN_M = -10000, COMPARATOR_HEIGHT_MAX_M = 200000 };

/** Position and velocity errors of one lane at one instant, resolved in NED at the truth; attitude
 * is left zero. */
schuler_error_row schuler_compare(const schuler_nav_state *nav, const schuler_truth_state *truth);

/** The attitude of a row as well: Euler angles that the navigator would show, in the
 * north-east-down of its own position, minus the true ones. Ten times the work of the rest, so only
 * where rows are wanted. */
void schuler_compare_attitude(const schuler_nav_state *nav, const schuler_truth_state *truth,
                              schuler_error_row *row);

/* What is kept of a lane as it goes. */
typedef struct {
    double start_m[2];           /* north, east at the start                              */
    double sum_tr, sum_tt;       /* of the radial error: for the slope through the origin */
    double sum_ta[2];            /* the same of north and east                            */
    double sum_late, count_late; /* (radial error/time)^2, from half an hour on            */
    double harmonic[3][5]; /* normal equations of t, 1 - cos, sin of Schuler's rate: north, east  */
    double end_s, end_a[2];              /* at the end, of what started at zero                   */
    double sum_v2, count;                /* horizontal velocity error                             */
    double end_m, max_m;                 /* horizontal error                                      */
    double clipped[SCHULER_INSTRUMENTS]; /* samples beyond the range, over all axes */
} lane_metrics;

/** The error at the start, which the slope is not to count: it is subtracted as a vector. */
void schuler_metrics_start(lane_metrics *m, const schuler_error_row *row);

/** What the drift of the run is, m/s; axis 0 north, 1 east, -1 radial. */
double schuler_metrics_drift(const lane_metrics *m, schuler_metric metric, int axis);

/** Take in one report. Returns the square of the horizontal error, m^2. */
double schuler_metrics_take(lane_metrics *m, const schuler_error_row *row);

#endif

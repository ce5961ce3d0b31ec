/* SPDX-License-Identifier: MIT */
/* The lines of an overlay put so that they are summed quickly. Private to core. */
#ifndef SCHULER_CORE_OVERLAY_SUM_H
#define SCHULER_CORE_OVERLAY_SUM_H

#include "core/overlay.h"

typedef struct overlay_sum overlay_sum;

/** NULL without memory. The overlay must outlive it. */
overlay_sum *schuler_overlay_sum_create(const schuler_overlay *o);
void schuler_overlay_sum_free(overlay_sum *s);

/** All channels and their rates at t. */
void schuler_overlay_sum_at(overlay_sum *s, long double t_s, double x[OVERLAY_CHANNELS],
                            double x_dot[OVERLAY_CHANNELS]);

#endif

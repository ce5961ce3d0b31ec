/* SPDX-License-Identifier: MIT */
/* Wander azimuth: local-level axes that do not turn about the vertical relative to the earth, so they are
 * as good at a pole as anywhere. At the start x is north. */
#include "core/lanes3.h"

LANES_INLINE lanes frame_vertical_rate(lanes omega_x, lanes3 z)
{
    (void)omega_x;
    (void)z;
    return lanes_set(0.0);
}

#include "mechanization/local_level.h"

extern const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_wander);
const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_wander) = {
    .name = "wander",
    .summary = "local level, wander azimuth: direction cosines of the vertical, height; valid at "
               "the poles",
    .source = "P. G. Savage, Strapdown Analytics, 2nd ed., 2007, ch. 4; D. H. Titterton, J. L. "
              "Weston, 2nd ed., 2004, ch. 3",
    LOCAL_LEVEL_FUNCTIONS,
};

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
    .equation = "v' = C_b_w f_ib_b - (2 omega_ie + omega_ew) x v + g\n"
                "C_w_e' = C_w_e [omega_ew x],  h' = -v_z\n"
                "C_b_w' = C_b_w [omega_ib_b x] - [(omega_ie + omega_ew) x] C_b_w\n"
                "omega_ew = (n_y, -n_x, 0),  n = A (v_x, v_y) + B (v_x c_x + v_y c_y) (c_x, c_y)\n"
                "A = 1/(R_P + h),  B = e^2 R_P/(1 - e^2 sin^2 lat)/((R_M + h)(R_P + h))\n"
                "c = the earth's axis in w; the wander angle is atan2(-c_y, c_x)",
    .limits = "none: nothing is singular at the poles, the wander angle itself is not used",
    LOCAL_LEVEL_FUNCTIONS,
};

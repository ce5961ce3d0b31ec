/* SPDX-License-Identifier: MIT */
/* North-east-down: local-level axes that turn about the vertical with omega_D = -v_E tan(lat)/(R_P + h),
 * so that x stays north. That grows without bound at a pole, so the frame ends before it. */
#include "core/lanes3.h"

/* omega_x = v_E/(R_P + h), and tan(lat) = -z_z/z_x. */
LANES_INLINE lanes frame_vertical_rate(lanes omega_x, lanes3 z)
{
    return omega_x * (z.z / z.x);
}

#include "mechanization/local_level.h"

extern const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_ned);
const schuler_mechanization SCHULER_LANE_NAME(schuler_frame_ned) = {
    .name = "ned",
    .summary = "local level, north-east-down; up to 89.5 deg of latitude",
    .source = "D. H. Titterton, J. L. Weston, 2nd ed., 2004, ch. 3; P. D. Groves, 2nd ed., ch. 5",
    .equation = "v' = C_b_n f_ib_b - (2 omega_ie + omega_en) x v + g\n"
                "C_n_e' = C_n_e [omega_en x],  h' = -v_D\n"
                "C_b_n' = C_b_n [omega_ib_b x] - [(omega_ie + omega_en) x] C_b_n\n"
                "omega_en = (v_E/(R_P + h), -v_N/(R_M + h), -v_E tan(lat)/(R_P + h))",
    .limits =
        "latitudes up to 89.5 deg, where omega_D of 250 m/s is 0.26 deg/s; it has no bound at "
        "a pole. A trajectory that goes beyond is refused before the run, and a navigator "
        "that drifts there ends it",
    .latitude_max_rad = 89.5 * SCHULER_RAD_PER_DEG,
    LOCAL_LEVEL_FUNCTIONS,
};

/* SPDX-License-Identifier: MIT */
/* The axes of the three instruments of a triad. */
#ifndef SCHULER_SENSORS_MOUNTING_H
#define SCHULER_SENSORS_MOUNTING_H

#include "core/api.h"
#include <stdbool.h>

SCHULER_BEGIN_C

/** Unit vectors of each instrument in body axes.
 *  Given      input    rows: input axes, any length; all nine 0 = the body axes
 *             second   rows: pendulous or output axes; only the part square to the input axis
 *                      counts; all nine 0 = the next body axis (x: y, y: z, z: x)
 *  Returned   axes     [instrument][input, second, input x second] */
SCHULER_API void schuler_mounting_axes(const double input[9], const double second[9],
                                       double axes[3][3][3]);

/** From what three instruments measure along their input axes to body axes.
 *  Returned   back   inverse of the matrix whose rows are the input axes; false when those lie
 *                    within 1e-3 of a plane, or some axis is no direction; back is then untouched */
SCHULER_API bool schuler_mounting_back(double axes[3][3][3], double back[3][3]);

SCHULER_END_C

#endif

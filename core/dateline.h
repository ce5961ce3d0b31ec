/* SPDX-License-Identifier: MIT */
/* Lines and areas on a map whose longitudes end at +-180 degrees: cut there into pieces that do not cross. */
#ifndef SCHULER_CORE_DATELINE_H
#define SCHULER_CORE_DATELINE_H

#include "core/error.h"

SCHULER_BEGIN_C

typedef struct {
    double lon_deg, lat_deg, height_m;
} schuler_map_point;

/* One piece, at least two points (of an area: three, the first not again at the end), longitudes within
 * [-180, 180]. */
typedef void schuler_map_piece(void *user, const schuler_map_point *points, size_t count);

/** A line. From one point to the next it goes the short way round; where that crosses the dateline, latitude
 *  and height there are taken linearly.
 *  Given      points    count >= 2, longitudes within [-180, 180]
 *  Errors     SCHULER_ERR_MEMORY, piece is not called */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_dateline_line(const schuler_map_point *points,
                                                                   size_t count,
                                                                   schuler_map_piece *piece,
                                                                   void *user);

/** An area by the points around it. One around a pole, the nearer one, reaches up to it.
 *  Given      points    count >= 3 in order, the last is joined to the first; longitudes as above
 *  Errors     SCHULER_ERR_MEMORY, piece is not called */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_dateline_area(const schuler_map_point *points,
                                                                   size_t count,
                                                                   schuler_map_piece *piece,
                                                                   void *user);

SCHULER_END_C

#endif

/* SPDX-License-Identifier: MIT */
#include "core/dateline.h"
#include <math.h>
#include <stdlib.h>

/* The short way round, in [-180, 180]. */
static double turn_deg(double from_deg, double to_deg)
{
    return remainder(to_deg - from_deg, 360.0);
}

/* Where the way from a to b meets a longitude between theirs. */
static schuler_map_point at_longitude(schuler_map_point a, schuler_map_point b, double lon_deg)
{
    const double w = (lon_deg - a.lon_deg) / (b.lon_deg - a.lon_deg);
    return (schuler_map_point){ lon_deg, a.lat_deg + w * (b.lat_deg - a.lat_deg),
                                a.height_m + w * (b.height_m - a.height_m) };
}

schuler_status schuler_dateline_line(const schuler_map_point *points, size_t count,
                                     schuler_map_piece *piece, void *user)
{
    schuler_map_point *const held = calloc(count + 1, sizeof *held);
    if (!held) return SCHULER_ERR_MEMORY;
    size_t n = 0;
    held[n++] = points[0];
    for (size_t i = 1; i < count; i++) {
        const schuler_map_point a = held[n - 1];
        schuler_map_point b = points[i], beyond = b;
        beyond.lon_deg = a.lon_deg + turn_deg(a.lon_deg, b.lon_deg);
        const double edge = beyond.lon_deg < 0.0 ? -180.0 : 180.0;
        if (fabs(beyond.lon_deg) > 180.0) {
            held[n] = at_longitude(a, beyond, edge);
            schuler_map_point other = held[n++];
            other.lon_deg = -edge;
            piece(user, held, n);
            held[0] = other;
            n = 1;
        } else if (fabs(beyond.lon_deg - b.lon_deg) > 180.0) {
            b.lon_deg = edge; /* the same meridian, as seen from here */
        }
        held[n++] = b;
    }
    if (n > 1) piece(user, held, n);
    free(held);
    return SCHULER_OK;
}

/* The part of an area on one side of a longitude: sign 1 the east, -1 the west. (Sutherland, Hodgman:
 * Reentrant polygon clipping, CACM 17(1), 1974.) */
static size_t clip(const schuler_map_point *in, size_t n, double lon_deg, double sign,
                   schuler_map_point *out)
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        const schuler_map_point a = in[(i + n - 1) % n], b = in[i];
        const double da = sign * (a.lon_deg - lon_deg), db = sign * (b.lon_deg - lon_deg);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0))
            out[kept++] = at_longitude(a, b, lon_deg);
        if (db >= 0.0) out[kept++] = b;
    }
    return kept;
}

schuler_status schuler_dateline_area(const schuler_map_point *points, size_t count,
                                     schuler_map_piece *piece, void *user)
{
    const size_t room = 4 * (count + 3); /* each cut adds at most half as many again */
    schuler_map_point *const all = calloc(3 * room, sizeof *all);
    if (!all) return SCHULER_ERR_MEMORY;
    schuler_map_point *const east = all + room, *const both = east + room;
    /* Longitudes that go on beyond 180 degrees instead of jumping. */
    size_t n = 0;
    double lat_sum = 0.0;
    all[n++] = points[0];
    for (size_t i = 1; i <= count; i++) {
        all[n] = points[i % count];
        all[n].lon_deg = all[n - 1].lon_deg + turn_deg(all[n - 1].lon_deg, all[n].lon_deg);
        lat_sum += all[n++].lat_deg;
    }
    const double around = all[n - 1].lon_deg - all[0].lon_deg;
    if (fabs(around) > 180.0) { /* a pole is inside: up there, and back along it */
        const double pole = lat_sum > 0.0 ? 90.0 : -90.0;
        const schuler_map_point last = all[n - 1];
        all[n++] = (schuler_map_point){ last.lon_deg, pole, last.height_m };
        all[n++] = (schuler_map_point){ all[0].lon_deg, pole, all[0].height_m };
    } else {
        n--; /* the first again */
    }
    for (int turn = -2; turn <= 2; turn++) {
        const double west_deg = 360.0 * turn - 180.0;
        const size_t kept = clip(all, n, west_deg, 1.0, east);
        const size_t m = clip(east, kept, west_deg + 360.0, -1.0, both);
        double least = INFINITY, most = -INFINITY;
        for (size_t i = 0; i < m; i++) {
            both[i].lon_deg -= 360.0 * turn;
            least = fmin(least, both[i].lon_deg);
            most = fmax(most, both[i].lon_deg);
        }
        if (m >= 3 && most > least) piece(user, both, m); /* else it only touches the edge */
    }
    free(all);
    return SCHULER_OK;
}

/* SPDX-License-Identifier: MIT */
#include "core/dateline.h"
#include "core/geographic.h"
#include "scenarios/metrics.h"
#include "tools/export.h"
#include "tools/xml.h"
#include <math.h>
#include <stdlib.h>

enum { RING = 72 };
static const double least_m = 1e-3, most_m = 5e6;

static void put_point(FILE *out, schuler_map_point p)
{
    fprintf(out, "%.9f,%.9f,%.3f\n", p.lon_deg, p.lat_deg, p.height_m);
}

static void put_points(FILE *out, const schuler_map_point *points, size_t count)
{
    fputs("<coordinates>\n", out);
    for (size_t i = 0; i < count; i++) put_point(out, points[i]);
    fputs("</coordinates>", out);
}

static void put_line(void *user, const schuler_map_point *points, size_t count)
{
    FILE *const out = user;
    fputs("<LineString><altitudeMode>absolute</altitudeMode>", out);
    put_points(out, points, count);
    fputs("</LineString>\n", out);
}

/* A ring ends where it begins. */
static void put_area(void *user, const schuler_map_point *points, size_t count)
{
    FILE *const out = user;
    fputs("<Polygon><outerBoundaryIs><LinearRing><coordinates>\n", out);
    for (size_t i = 0; i <= count; i++) put_point(out, points[i % count]);
    fputs("</coordinates></LinearRing></outerBoundaryIs></Polygon>\n", out);
}

static void begin(FILE *out, const char *name, const char *style)
{
    fprintf(out, "<Placemark><name>%s</name><styleUrl>#%s</styleUrl>\n", name, style);
}

static void put_mark(FILE *out, const char *name, schuler_map_point at)
{
    begin(out, name, "track");
    fputs("<Point><altitudeMode>absolute</altitudeMode>", out);
    put_points(out, &at, 1);
    fputs("</Point></Placemark>\n", out);
}

/* The points of the track, without those at which it stands still; the last is its end. */
static size_t track_points(const schuler_result_file *f, schuler_map_point *points)
{
    size_t n = 0;
    for (size_t k = 0; k < f->track_count; k++) {
        const schuler_map_point p = { f->lon_deg[k], f->lat_deg[k], f->height_m[k] };
        const schuler_map_point *const last = n > 0 ? &points[n - 1] : NULL;
        const int moved = !last || fabs(p.lon_deg - last->lon_deg) > 1e-9 ||
                          fabs(p.lat_deg - last->lat_deg) > 1e-9 ||
                          fabs(p.height_m - last->height_m) > 1e-3;
        if (moved || (k + 1 == f->track_count && n == 1)) /* a line has two at least */
            points[n++] = p;
        else
            points[n - 1] = n > 1 ? p : points[0];
    }
    return n;
}

static schuler_status put_circle(FILE *out, schuler_map_point centre, int percent, double radius_m,
                                 int runs)
{
    if (!(radius_m >= least_m && radius_m <= most_m)) {
        fprintf(out, "<!-- %d %% of %d navigators end within %.6g m: not drawn -->\n", percent,
                runs, radius_m);
        return SCHULER_OK;
    }
    schuler_map_point ring[RING];
    for (int i = 0; i < RING; i++) {
        double lat_rad, lon_rad, azimuth_rad;
        schuler_geodesic_direct(centre.lat_deg * SCHULER_RAD_PER_DEG,
                                centre.lon_deg * SCHULER_RAD_PER_DEG, -2.0 * SCHULER_PI * i / RING,
                                radius_m, &lat_rad, &lon_rad, &azimuth_rad);
        const double lon_deg = remainder(lon_rad / SCHULER_RAD_PER_DEG, 360.0);
        ring[i] = (schuler_map_point){ lon_deg, lat_rad / SCHULER_RAD_PER_DEG, 0.0 };
    }
    char name[80], style[20];
    snprintf(name, sizeof name, "%d %% of %d navigators end within %.6g m", percent, runs,
             radius_m);
    snprintf(style, sizeof style, "within%d", percent);
    begin(out, name, style);
    fputs("<MultiGeometry>\n", out);
    const schuler_status status = schuler_dateline_area(ring, RING, put_area, out);
    fputs("</MultiGeometry></Placemark>\n", out);
    return status;
}

static void put_style(FILE *out, const char *id, const char *line, const char *area)
{
    fprintf(out,
            "<Style id=\"%s\"><LineStyle><color>%s</color><width>2</width></LineStyle>"
            "<PolyStyle><color>%s</color></PolyStyle></Style>\n",
            id, line, area);
}

static void put_head(FILE *out, const schuler_result_file *f)
{
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<name>",
          out);
    xml_text(out, f->scenario_name);
    fputs("</name>\n<description>schuler ", out);
    xml_text(out, f->version);
    fputs(", scenario sha256 ", out);
    xml_text(out, f->scenario_sha256);
    fputs("; heights above the WGS84 ellipsoid</description>\n", out);
    put_style(out, "track", "ff0000ff", "00000000"); /* aabbggrr */
    put_style(out, "within50", "ff00aaff", "6000aaff");
    put_style(out, "within95", "ffffaa00", "30ffaa00");
}

static schuler_status put_circles(FILE *out, const schuler_result_file *f, schuler_map_point centre)
{
    const int runs = (int)f->run_count, all = schuler_result_file_find(f, "all");
    const double *const end_m = f->end_m + (size_t)all * f->run_count;
    double *const scratch = calloc(f->run_count, sizeof *scratch);
    if (!scratch) return SCHULER_ERR_MEMORY;
    const double half_m = schuler_percentile(end_m, runs, 0.5, scratch);
    const double most_of_m = schuler_percentile(end_m, runs, 0.95, scratch);
    free(scratch);
    const schuler_status status = put_circle(out, centre, 95, most_of_m, runs);
    return status == SCHULER_OK ? put_circle(out, centre, 50, half_m, runs) : status;
}

schuler_status export_kml(FILE *out, const schuler_result_file *f)
{
    schuler_map_point *const points = calloc(f->track_count, sizeof *points);
    if (!points) return SCHULER_ERR_MEMORY;
    const size_t n = track_points(f, points);
    put_head(out, f);
    begin(out, "True track", "track");
    fputs("<MultiGeometry>\n", out);
    schuler_status status = schuler_dateline_line(points, n, put_line, out);
    fputs("</MultiGeometry></Placemark>\n", out);
    put_mark(out, "Start", points[0]);
    put_mark(out, "True end", points[n - 1]);
    if (status == SCHULER_OK) status = put_circles(out, f, points[n - 1]);
    fputs("</Document>\n</kml>\n", out);
    free(points);
    return status;
}

/* SPDX-License-Identifier: MIT */
/* Lines and areas cut at the dateline. */
#include "check.h"
#include "core/dateline.h"
#include <string.h>

enum { PIECES = 8, POINTS = 40 };

static struct {
    size_t pieces, counts[PIECES];
    schuler_map_point points[PIECES][POINTS];
} got;

static void keep(void *user, const schuler_map_point *points, size_t count)
{
    assert_ptr_equal(user, &got);
    assert_in_range(got.pieces, 0, PIECES - 1);
    assert_in_range(count, 2, POINTS);
    memcpy(got.points[got.pieces], points, count * sizeof *points);
    for (size_t i = 0; i < count; i++) assert_true(fabs(points[i].lon_deg) <= 180.0);
    got.counts[got.pieces++] = count;
}

static void line(const schuler_map_point *points, size_t count)
{
    got.pieces = 0;
    assert_int_equal(schuler_dateline_line(points, count, keep, &got), SCHULER_OK);
}

static void expect(int piece, int at, double lon, double lat, double height)
{
    assert_true((size_t)piece < got.pieces && (size_t)at < got.counts[piece]);
    CHECK_NEAR(got.points[piece][at].lon_deg, lon, 1e-12);
    CHECK_NEAR(got.points[piece][at].lat_deg, lat, 1e-12);
    CHECK_NEAR(got.points[piece][at].height_m, height, 1e-9);
}

static void a_line_away_from_it_stays_whole(void **state)
{
    (void)state;
    const schuler_map_point p[] = { { -100, 1, 5 }, { 20, 2, 6 }, { 30, 3, 7 } };
    line(p, 3);
    assert_int_equal(got.pieces, 1);
    assert_int_equal(got.counts[0], 3);
    assert_memory_equal(got.points[0], p, sizeof p);
}

static void a_crossing_cuts_and_interpolates(void **state)
{
    (void)state;
    const schuler_map_point there[] = { { 170, 0, 0 }, { 179, 10, 100 }, { -178, 40, 400 } };
    line(there, 3);
    assert_int_equal(got.pieces, 2);
    assert_int_equal(got.counts[0], 3);
    expect(0, 2, 180, 20, 200); /* a third of the way */
    assert_int_equal(got.counts[1], 2);
    expect(1, 0, -180, 20, 200);
    expect(1, 1, -178, 40, 400);
    const schuler_map_point back[] = { { -178, 40, 400 }, { 179, 10, 100 } };
    line(back, 2);
    assert_int_equal(got.pieces, 2);
    expect(0, 1, -180, 20, 200);
    expect(1, 0, 180, 20, 200);
}

/* A point on the dateline itself may be written either way. */
static void points_on_it_belong_to_both_sides(void **state)
{
    (void)state;
    const schuler_map_point through[] = { { 179, 0, 0 }, { -180, 1, 0 }, { -179, 2, 0 } };
    line(through, 3);
    assert_int_equal(got.pieces, 2);
    expect(0, 1, 180, 1, 0);
    expect(1, 0, -180, 1, 0);
    expect(1, (int)got.counts[1] - 1, -179, 2, 0);
    const schuler_map_point along[] = { { 180, 0, 0 }, { -180, 1, 0 }, { 180, 2, 0 } };
    line(along, 3);
    assert_int_equal(got.pieces, 1);
    for (int i = 0; i < 3; i++) expect(0, i, 180, i, 0);
}

/* Shoelace formula, degrees squared. */
static double area_of(const schuler_map_point *p, size_t n)
{
    double twice = 0.0;
    for (size_t i = 0; i < n; i++) {
        const schuler_map_point a = p[i], b = p[(i + 1) % n];
        twice += a.lon_deg * b.lat_deg - b.lon_deg * a.lat_deg;
    }
    return fabs(twice) / 2.0;
}

static double area(const schuler_map_point *points, size_t count)
{
    double sum = 0.0;
    got.pieces = 0;
    assert_int_equal(schuler_dateline_area(points, count, keep, &got), SCHULER_OK);
    for (size_t i = 0; i < got.pieces; i++) sum += area_of(got.points[i], got.counts[i]);
    return sum;
}

static void an_area_across_it_is_two_that_sum_to_the_whole(void **state)
{
    (void)state;
    const schuler_map_point square[] = {
        { 177, 0, 0 }, { -173, 0, 0 }, { -173, 10, 0 }, { 177, 10, 0 }
    };
    CHECK_NEAR(area(square, 4), 100.0, 1e-9);
    assert_int_equal(got.pieces, 2);
    /* East of the dateline 7 of 10 degrees. */
    const double first = area_of(got.points[0], got.counts[0]);
    CHECK_NEAR(first, 30.0, 1e-9);
    const schuler_map_point from_west[] = {
        { -173, 0, 0 }, { -173, 10, 0 }, { 177, 10, 0 }, { 177, 0, 0 }
    };
    CHECK_NEAR(area(from_west, 4), 100.0, 1e-9);
    assert_int_equal(got.pieces, 2);
    const schuler_map_point away[] = { { 7, 0, 0 }, { 17, 0, 0 }, { 17, 10, 0 }, { 7, 10, 0 } };
    CHECK_NEAR(area(away, 4), 100.0, 1e-9);
    assert_int_equal(got.pieces, 1);
    const schuler_map_point touches[] = {
        { 170, 0, 0 }, { 180, 0, 0 }, { 180, 5, 0 }, { 180, 10, 0 }, { 170, 10, 0 }
    };
    CHECK_NEAR(area(touches, 5), 100.0, 1e-9);
    assert_int_equal(got.pieces, 1);
}

static void an_area_around_a_pole_reaches_it(void **state)
{
    (void)state;
    for (int pole = -1; pole <= 1; pole += 2)
        for (int way = -1; way <= 1; way += 2)
            for (int start = 0; start < 360; start += 60) {
                schuler_map_point ring[12];
                for (int i = 0; i < 12; i++)
                    ring[i] = (schuler_map_point){ remainder(start + way * 30 * i, 360.0),
                                                   pole * 80, 0.0 };
                CHECK_NEAR(area(ring, 12), 360.0 * 10.0, 1e-9);
                for (size_t k = 0; k < got.pieces; k++)
                    for (size_t i = 0; i < got.counts[k]; i++)
                        assert_true(pole * got.points[k][i].lat_deg >= 80.0);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_away_from_it_stays_whole),
        cmocka_unit_test(a_crossing_cuts_and_interpolates),
        cmocka_unit_test(points_on_it_belong_to_both_sides),
        cmocka_unit_test(an_area_across_it_is_two_that_sum_to_the_whole),
        cmocka_unit_test(an_area_around_a_pole_reaches_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

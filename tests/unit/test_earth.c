/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/earth.h"
#include "core/geographic.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define DEG SCHULER_RAD_PER_DEG

static void the_ellipsoid_is_wgs84(void **state)
{
    (void)state;
    /* Derived constants in 40-digit arithmetic, 15 digits kept. */
    CHECK_REL(SCHULER_WGS84_B_M, 6356752.31424518, 1e-14);
    CHECK_REL(SCHULER_WGS84_E2, 0.00669437999014132, 1e-14);
    CHECK_REL(schuler_earth_meridian_radius(45.0 * DEG), 6367381.81561955, 1e-14);
    CHECK_REL(schuler_earth_transverse_radius(45.0 * DEG), 6388838.29012115, 1e-14);
    /* At a pole both are a^2/b. */
    const double polar_m = SCHULER_WGS84_A_M * SCHULER_WGS84_A_M / SCHULER_WGS84_B_M;
    CHECK_REL(schuler_earth_meridian_radius(90.0 * DEG), polar_m, 1e-14);
    CHECK_REL(schuler_earth_transverse_radius(-90.0 * DEG), polar_m, 1e-14);
}

static void places_survive_the_way_through_ecef(void **state)
{
    (void)state;
    for (int lat = -90; lat <= 90; lat += 15)
        for (int lon = -180; lon <= 150; lon += 30) {
            const schuler_llh p = { lat * DEG, lon * DEG, 1000.0 * (lat + 90) / 6.0 - 1000.0 };
            const schuler_llh back = schuler_llh_from_ecef(schuler_ecef_from_llh(p));
            /* One nanometre is an ulp of the coordinates; a few come together. */
            CHECK_NEAR(back.lat_rad * 6.4e6, p.lat_rad * 6.4e6, 4e-9);
            CHECK_NEAR(back.h_m, p.h_m, 4e-9);
            if (lat == -90 || lat == 90) continue;
            CHECK_NEAR(remainder(back.lon_rad - p.lon_rad, 2.0 * SCHULER_PI) * 6.4e6 *
                           cos(p.lat_rad),
                       0.0, 4e-9);
        }
}

/* North, east and down are where the position goes when latitude, longitude and depth grow. */
static void ned_axes_point_where_coordinates_grow(void **state)
{
    (void)state;
    const schuler_llh p = { -33.5 * DEG, 151.0 * DEG, 2000.0 };
    const schuler_mat3 C_n_e = schuler_C_n_e(p.lat_rad, p.lon_rad);
    const double step = 1e-5;
    const schuler_llh ahead[3] = { { p.lat_rad + step, p.lon_rad, p.h_m },
                                   { p.lat_rad, p.lon_rad + step, p.h_m },
                                   { p.lat_rad, p.lon_rad, p.h_m - 100.0 } };
    const schuler_llh behind[3] = { { p.lat_rad - step, p.lon_rad, p.h_m },
                                    { p.lat_rad, p.lon_rad - step, p.h_m },
                                    { p.lat_rad, p.lon_rad, p.h_m + 100.0 } };
    for (int axis = 0; axis < 3; axis++) {
        const schuler_vec3 along = schuler_vec3_sub(schuler_ecef_from_llh(ahead[axis]),
                                                    schuler_ecef_from_llh(behind[axis]));
        const schuler_vec3 n = schuler_mat3_apply_transposed(&C_n_e, along);
        const double length_m = schuler_vec3_norm(along);
        /* A central difference bends by step^2/6, times e^2 at most: below 1e-10. */
        for (int i = 0; i < 3; i++) CHECK_NEAR(n.v[i] / length_m, i == axis ? 1.0 : 0.0, 1e-10);
    }
}

static void geodesics_close(void **state)
{
    (void)state;
    double s_m, azi1, azi2, lat, lon, azi;
    /* A quarter of a meridian: 10 001 965.729 m (Moritz, GRS 80 has .7293; WGS84 the same to a
     * millimetre). */
    schuler_geodesic_inverse(0.0, 0.3, 90.0 * DEG, 0.3, &s_m, &azi1, &azi2);
    CHECK_NEAR(s_m, 10001965.729, 1e-3);
    CHECK_NEAR(azi1, 0.0, 1e-15);
    schuler_geodesic_inverse(38.7 * DEG, -9.1 * DEG, 40.6 * DEG, -73.8 * DEG, &s_m, &azi1, &azi2);
    assert_true(azi1 < 0.0 && azi1 > -90.0 * DEG); /* it leaves Lisbon north of west */
    schuler_geodesic_direct(38.7 * DEG, -9.1 * DEG, azi1, s_m, &lat, &lon, &azi);
    /* 15 nm is GeographicLib's own figure, twice. */
    CHECK_NEAR(lat * 6.4e6, 40.6 * DEG * 6.4e6, 3e-8);
    CHECK_NEAR(lon * 6.4e6, -73.8 * DEG * 6.4e6, 4e-8);
    CHECK_NEAR(azi, azi2, 1e-13);
}

static void unknown_gravity_models_are_refused_with_advice(void **state)
{
    (void)state;
    static const char *const names[] = { "egm1896", "", "../../etc/passwd", "wgs84 ", "a/b" };
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
        schuler_field_model *field = NULL;
        schuler_error err = { 0 };
        assert_int_equal(schuler_field_open(&field, names[i], &err), SCHULER_ERR_GRAVITY_DATA);
        assert_null(field);
        assert_int_equal(err.status, SCHULER_ERR_GRAVITY_DATA);
        assert_non_null(strstr(err.message, "geographiclib-get-gravity"));
        assert_non_null(strstr(err.message, "GEOGRAPHICLIB_GRAVITY_PATH"));
    }
    /* A good name in a folder without it: the command to type. */
    schuler_field_model *field = NULL;
    schuler_error err = { 0 };
    assert_int_equal(schuler_field_open(&field, "/nowhere/egm96:120", &err),
                     SCHULER_ERR_GRAVITY_DATA);
    assert_non_null(strstr(err.message, "install with 'geographiclib-get-gravity egm96'"));
    assert_non_null(strstr(err.message, "/nowhere"));
    schuler_field_close(NULL);
}

static void put(const char *folder, const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}

static void data_sets_of_a_folder_are_listed(void **state)
{
    (void)state;
    schuler_field_data sets[8];
    assert_int_equal(schuler_field_data_sets("/nowhere", sets, 8), 0);
    char folder[] = "/tmp/schuler-test-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(schuler_field_data_sets(folder, sets, 8), 0);
    put(folder, "noise.egm", "what is this\n");
    put(folder, "absent.egm", "EGMF-1\nName absent\nDescription coefficients are missing\n");
    put(folder, "no name.egm", "");
    put(folder, "other.txt", "");
    assert_int_equal(schuler_field_data_sets(folder, sets, 8), 2);
    assert_string_equal(sets[0].name, "absent");
    assert_string_equal(sets[1].name, "noise");
    for (int i = 0; i < 2; i++) {
        assert_int_equal(sets[i].degree, 0);
        assert_true(sets[i].problem[0] != '\0');
    }
    assert_int_equal(schuler_field_data_sets(folder, sets, 1), 2);
    static const char *const names[] = { "noise.egm", "absent.egm", "no name.egm", "other.txt" };
    for (int i = 0; i < 4; i++) {
        char path[256];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        assert_int_equal(unlink(path), 0);
    }
    assert_int_equal(rmdir(folder), 0);
}

static void an_installed_data_set_says_its_degree(void **state)
{
    (void)state;
    schuler_field_data sets[64];
    size_t count = schuler_field_data_sets(NULL, sets, 64), k = 0;
    count = count < 64 ? count : 64;
    while (k < count && strcmp(sets[k].name, "egm96") != 0) k++;
    if (k == count) {
        print_message("egm96 is not installed: skipped\n");
        skip();
    }
    assert_int_equal(sets[k].degree, 360);
    assert_string_equal(sets[k].problem, "");
    assert_non_null(strstr(sets[k].description, "1996"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ellipsoid_is_wgs84),
        cmocka_unit_test(places_survive_the_way_through_ecef),
        cmocka_unit_test(ned_axes_point_where_coordinates_grow),
        cmocka_unit_test(geodesics_close),
        cmocka_unit_test(unknown_gravity_models_are_refused_with_advice),
        cmocka_unit_test(data_sets_of_a_folder_are_listed),
        cmocka_unit_test(an_installed_data_set_says_its_degree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

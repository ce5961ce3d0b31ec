/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/gravity.h"
#include "core/truth_lanes.h"
#include <string.h>

#define DEG SCHULER_RAD_PER_DEG

/* What the table promises (and refuses itself above). */
static const double table_mps2 = 1e-11;

static void load(const char *name, schuler_field_model **field, schuler_gravity_table *table)
{
    schuler_error err = { 0 };
    assert_int_equal(schuler_field_open(field, name, &err), SCHULER_OK);
    assert_int_equal(schuler_gravity_fit(table, *field, &err), SCHULER_OK);
}

static schuler_vec3 to_ned(schuler_vec3 g_e, schuler_llh p)
{
    const schuler_mat3 C_n_e = schuler_C_n_e(p.lat_rad, p.lon_rad);
    return schuler_mat3_apply_transposed(&C_n_e, g_e);
}

/* Closed-form normal gravity in 40-digit arithmetic: north and down. */
static const struct {
    double lat_deg, h_m, north_mps2, down_mps2;
} closed_form[] = {
    { 45.0, 0.0, 0.0, 9.80619776937738 },
    { 45.0, 10000.0, -8.13519889760967e-5, 9.77541418788896 },
    { -33.5, 1000.0, 7.49800725184811e-6, 9.7929892661515 },
    { 60.0, 20000.0, -0.00014070239382229, 9.75777584647163 },
    { 0.0, 0.0, 0.0, 9.78032533590389 },
    { 90.0, 0.0, 0.0, 9.8321849378634 },
};

static void gravity_has_its_closed_form_values(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    load("wgs84", &field, &table);
    for (size_t i = 0; i < sizeof(closed_form) / sizeof(closed_form[0]); i++) {
        const schuler_llh p = { closed_form[i].lat_deg * DEG, 2.0, closed_form[i].h_m };
        const schuler_vec3 r_e = schuler_ecef_from_llh(p);
        /* Rounding of a dozen operations on numbers of size 10 in the field; the fit in the table.
         */
        const schuler_vec3 exact_n = to_ned(schuler_field_gravity(field, r_e), p);
        CHECK_NEAR(exact_n.v[0], closed_form[i].north_mps2, 3e-14);
        CHECK_NEAR(exact_n.v[1], 0.0, 3e-14);
        CHECK_NEAR(exact_n.v[2], closed_form[i].down_mps2, 3e-14);
        const schuler_vec3 table_n = to_ned(schuler_gravity_at(&table, r_e), p);
        CHECK_NEAR(table_n.v[0], closed_form[i].north_mps2, table_mps2);
        CHECK_NEAR(table_n.v[2], closed_form[i].down_mps2, table_mps2);
    }
    schuler_field_close(field);
}

static void centrifugal_acceleration_is_in_gravity_and_not_in_gravitation(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    load("wgs84", &field, &table);
    const schuler_vec3 r_e = schuler_ecef_from_llh((schuler_llh){ 30.0 * DEG, 1.0, 5000.0 });
    const schuler_vec3 extra = schuler_vec3_sub(schuler_field_gravity(field, r_e),
                                                schuler_field_normal_gravitation(field, r_e));
    const double w2 = SCHULER_OMEGA_IE_RADPS * SCHULER_OMEGA_IE_RADPS;
    CHECK_NEAR(extra.v[0], w2 * r_e.v[0], 4e-15);
    CHECK_NEAR(extra.v[1], w2 * r_e.v[1], 4e-15);
    CHECK_NEAR(extra.v[2], 0.0, 4e-15);
    schuler_field_close(field);
}

/* Places all over the box, its corners among them: a golden-section spiral times heights. */
static schuler_llh somewhere_to(double high_m, int i, int count)
{
    const double z = -1.0 + 2.0 * i / (count - 1.0);
    const double lat_rad = asin(fmin(fmax(z, -1.0), 1.0));
    const double h_m = SCHULER_GRAVITY_LOW_M +
                       fmod(i * 0.6180339887498949, 1.0) * (high_m - SCHULER_GRAVITY_LOW_M);
    const double edge_m = i % 10 == 0 ? SCHULER_GRAVITY_LOW_M : high_m;
    return (schuler_llh){ lat_rad, 2.39996322972865332 * i, i % 5 == 0 ? edge_m : h_m };
}

static schuler_llh somewhere(int i, int count)
{
    return somewhere_to(SCHULER_GRAVITY_HIGH_M, i, count);
}

static void the_table_follows_geographiclib_on_the_whole_globe(void **state)
{
    (void)state;
    static const char *const names[] = { "wgs84", "grs80" };
    enum { PLACES = 20001 };
    for (int m = 0; m < 2; m++) {
        schuler_field_model *field = NULL;
        schuler_gravity_table table;
        load(names[m], &field, &table);
        double worst = 0.0;
        for (int i = 0; i < PLACES; i++) {
            const schuler_vec3 r_e = schuler_ecef_from_llh(somewhere(i, PLACES));
            const schuler_vec3 off = schuler_vec3_sub(schuler_gravity_at(&table, r_e),
                                                      schuler_field_gravity(field, r_e));
            for (int a = 0; a < 3; a++) worst = fmax(worst, fabs(off.v[a]));
        }
        CHECK_NEAR(worst, 0.0, table_mps2);
        schuler_field_close(field);
    }
}

/* A polynomial of degree 5 leaves an error that grows with the sixth power of the box's height, 126 km
 * against 51; and no table is made for heights that are not needed or cannot be had. */
static void a_higher_table_holds_to_the_edge_of_space(void **state)
{
    (void)state;
    enum { PLACES = 5001 };
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    load("wgs84", &field, &table);
    assert_int_equal(schuler_gravity_fit_to(&table, field, SCHULER_GRAVITY_HIGHEST_M, NULL),
                     SCHULER_OK);
    double worst = 0.0;
    for (int i = 0; i < PLACES; i++) {
        const schuler_vec3 r_e =
            schuler_ecef_from_llh(somewhere_to(SCHULER_GRAVITY_HIGHEST_M, i, PLACES));
        const schuler_vec3 off =
            schuler_vec3_sub(schuler_gravity_at(&table, r_e), schuler_field_gravity(field, r_e));
        for (int a = 0; a < 3; a++) worst = fmax(worst, fabs(off.v[a]));
    }
    CHECK_NEAR(worst, 0.0, table_mps2 * pow(126.0 / 51.0, 6.0));
    static const double refused_m[] = { 40000.0, 126000.0, NAN };
    for (int i = 0; i < 3; i++)
        assert_int_equal(schuler_gravity_fit_to(&table, field, refused_m[i], NULL),
                         SCHULER_ERR_NUMERIC);
    schuler_field_close(field);
}

static void the_two_ellipsoids_are_told_apart(void **state)
{
    (void)state;
    schuler_field_model *wgs84 = NULL, *grs80 = NULL;
    schuler_gravity_table a, b;
    load("wgs84", &wgs84, &a);
    load("grs80", &grs80, &b);
    const schuler_vec3 r_e = schuler_ecef_from_llh((schuler_llh){ 0.0, 0.0, 0.0 });
    /* GRS 80: 9.7803267715 at the equator (Moritz 1980), WGS84 9.7803253359. */
    CHECK_NEAR(-schuler_gravity_at(&b, r_e).v[0], 9.7803267715, 1e-10);
    CHECK_NEAR(-schuler_gravity_at(&a, r_e).v[0], 9.7803253359, 1e-10);
    schuler_field_close(wgs84);
    schuler_field_close(grs80);
}

static void height_and_normal_are_those_of_the_ellipsoid(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    load("grs80", &field, &table); /* also there they are WGS84's */
    enum { PLACES = 20001 };
    for (int i = 0; i < PLACES; i++) {
        const schuler_llh p = somewhere(i, PLACES);
        const schuler_vec3 r_e = schuler_ecef_from_llh(p);
        /* Degree 5 leaves 5.4e-8 m in the fit; the promise is 1e-5 m. */
        CHECK_NEAR(schuler_gravity_height(&table, r_e), p.h_m, 2e-7);
        const double R_P = schuler_earth_transverse_radius(p.lat_rad);
        const double k = (R_P + p.h_m) / (R_P * (1.0 - SCHULER_WGS84_E2) + p.h_m);
        CHECK_NEAR(schuler_gravity_normal_z(&table, r_e), k, 4e-15);
    }
    schuler_field_close(field);
}

static void every_instruction_set_has_the_bits_of_the_scalar_twin(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    load("wgs84", &field, &table);
    enum { PLACES = 31 * 50 };
    for (int first = 0; first < PLACES; first += 31) { /* 31: a last vector that is not full */
        schuler_columns r_e = { 0 };
        for (int i = 0; i < 31; i++) {
            const schuler_vec3 r = schuler_ecef_from_llh(somewhere(first + i, PLACES));
            for (int a = 0; a < 3; a++) r_e.v[a][i] = r.v[a];
        }
        for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            schuler_columns g_e;
            double h_m[SCHULER_BLOCK], k[SCHULER_BLOCK];
            schuler_truth_lanes_for((schuler_isa)isa)->gravity(&table, 31, &r_e, &g_e, h_m, k);
            for (int i = 0; i < 31; i++) {
                const schuler_vec3 r = { { r_e.v[0][i], r_e.v[1][i], r_e.v[2][i] } };
                const schuler_vec3 expected = schuler_gravity_at(&table, r);
                for (int a = 0; a < 3; a++)
                    assert_memory_equal(&g_e.v[a][i], &expected.v[a], sizeof(double));
                const double height = schuler_gravity_height(&table, r);
                const double normal_z = schuler_gravity_normal_z(&table, r);
                assert_memory_equal(&h_m[i], &height, sizeof(double));
                assert_memory_equal(&k[i], &normal_z, sizeof(double));
            }
        }
    }
    schuler_field_close(field);
}

/* What GeographicLib's own program prints: Gravity -n egm96 -p 8 --input-string "LAT LON H". */
static const struct {
    double lat_deg, lon_deg, h_m, east_mps2, north_mps2, up_mps2;
} printed[] = {
    { 27.988, 86.925, 8820.0, -0.00020967, 0.00083855, -9.76653289 },
    { 0.0, 0.0, 0.0, -0.00001814, 0.00000776, -9.78036868 },
    { 45.5, 6.0, 2000.0, 0.00033010, -0.00038910, -9.80053737 },
    { 42.0, -40.0, 10000.0, 0.00037723, 0.00005880, -9.77291010 },
    { -33.5, 151.0, 1000.0, -0.00005684, 0.00033798, -9.79322752 },
    { 90.0, 0.0, 0.0, -0.00007274, -0.00006121, -9.83208154 },
};

static void egm96_is_that_of_geographiclibs_own_program(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    schuler_error err = { 0 };
    if (schuler_field_open(&field, "egm96", &err) != SCHULER_OK) {
        print_message("skipped: %s\n", err.message);
        skip();
    }
    assert_true(schuler_field_has_disturbance(field));
    for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
        const schuler_llh p = { printed[i].lat_deg * DEG, printed[i].lon_deg * DEG,
                                printed[i].h_m };
        const schuler_vec3 g_n = to_ned(schuler_field_gravity(field, schuler_ecef_from_llh(p)), p);
        /* Half a printed digit, and rounding of sums of 10. */
        const double digit_mps2 = 0.5e-8 + 1e-13;
        CHECK_NEAR(g_n.v[0], printed[i].north_mps2, digit_mps2);
        CHECK_NEAR(g_n.v[1], printed[i].east_mps2, digit_mps2);
        CHECK_NEAR(-g_n.v[2], printed[i].up_mps2, digit_mps2);
    }
    schuler_field_close(field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gravity_has_its_closed_form_values),
        cmocka_unit_test(centrifugal_acceleration_is_in_gravity_and_not_in_gravitation),
        cmocka_unit_test(the_table_follows_geographiclib_on_the_whole_globe),
        cmocka_unit_test(a_higher_table_holds_to_the_edge_of_space),
        cmocka_unit_test(the_two_ellipsoids_are_told_apart),
        cmocka_unit_test(height_and_normal_are_those_of_the_ellipsoid),
        cmocka_unit_test(every_instruction_set_has_the_bits_of_the_scalar_twin),
        cmocka_unit_test(egm96_is_that_of_geographiclibs_own_program),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Increments against closed forms, against a finer quadrature, and against themselves. */
#include "flights.h"
#include <stdlib.h>

/* The gravity table is within 2e-12 m/s^2 of the closed form (its own test); the rest is rounding.
 */
static const double gravity_mps2 = 3e-12;

static void at_rest_the_sensors_feel_the_earth_turn_and_gravity(void **state)
{
    (void)state;
    const double lat = -33.5 * DEG, dt_s = 0.01;
    const schuler_static_spec spec = {
        .start = { .lat_rad = lat,
                   .lon_rad = 151.0 * DEG,
                   .h_m = 1000.0,
                   .roll_rad = 0.3,
                   .pitch_rad = -0.2,
                   .heading_rad = 2.0 },
        .for_s = 60.0,
    };
    schuler_path path = flight_build("static", &spec);
    schuler_truth *truth = flight_truth(&path, dt_s, "wgs84", "wgs84");
    assert_int_equal(schuler_truth_steps(truth), 6000);
    schuler_truth_block block;
    schuler_truth_block_compute(truth, schuler_isa_best(), 3000, SCHULER_BLOCK, &block);
    const schuler_mat3 C_b_n = schuler_mat3_from_euler(0.3, -0.2, 2.0);
    const schuler_vec3 omega_ie_n = { { SCHULER_OMEGA_IE_RADPS * cos(lat), 0.0,
                                        -SCHULER_OMEGA_IE_RADPS * sin(lat) } };
    /* Closed form at 1000 m and 33.5 S: north, down. */
    const schuler_vec3 f_n = { { -7.49800725184811e-6, 0.0, -9.7929892661515 } };
    const schuler_vec3 omega_b = schuler_mat3_apply_transposed(&C_b_n, omega_ie_n);
    const schuler_vec3 f_b = schuler_mat3_apply_transposed(&C_b_n, f_n);
    for (int k = 0; k < SCHULER_BLOCK; k++)
        for (int i = 0; i < 3; i++) {
            CHECK_NEAR(block.dtheta_ib_b[i][k] / dt_s, omega_b.v[i], 1e-19);
            CHECK_NEAR(block.dv_ib_b[i][k] / dt_s, f_b.v[i], gravity_mps2);
        }
    assert_false(block.has_dg);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void flight_along_a_parallel_has_constant_rates(void **state)
{
    (void)state;
    schuler_hold_spec hour = { .for_s = 3600.0 };
    schuler_variant items[] = { { &schuler_segment_cruise, &hour } };
    const schuler_start start = {
        .lat_rad = 45.0 * DEG, .h_m = 10000.0, .heading_rad = 90.0 * DEG, .speed_mps = 250.0
    };
    schuler_path path = flight_segments(start, items, 1);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    /* f^n = (2 omega_ie + omega_en) x v - g in 40-digit arithmetic; heading east: forward = east,
     * right = south. */
    const double f_n[3] = { 0.0356302697678571, 0.0, -9.73986527011007 };
    const double f_b[3] = { f_n[1], -f_n[0], f_n[2] };
    const double omega_b[3] = { 0.0, -9.06326314586025e-5, -9.06326314586025e-5 };
    for (int64_t first = 0; first < 360000; first += 359968 / 7) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
        for (int i = 0; i < 3; i++) {
            CHECK_NEAR(block.dv_ib_b[i][5] / 0.01, f_b[i], gravity_mps2);
            CHECK_NEAR(block.dtheta_ib_b[i][5] / 0.01, omega_b[i], 1e-18);
        }
    }
    /* It stays on the parallel, and longitude grows linearly. */
    schuler_truth_state end;
    schuler_truth_at(truth, 3600.0, &end);
    CHECK_NEAR(end.llh.lat_rad * 6.4e6, 45.0 * DEG * 6.4e6, 5e-9);
    CHECK_NEAR(end.llh.h_m, 10000.0, 5e-9);
    CHECK_NEAR(end.llh.lon_rad, 5.5252746602318e-5 * 3600.0, 2e-15);
    CHECK_NEAR(end.v_n.v[1], 250.0, 2e-13);
    CHECK_NEAR(end.heading_rad, 90.0 * DEG, 2e-15);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* Six-point Gauss-Legendre of the rates from the scalar functions, cut at the joints of the path.
 */
static const double node6[6] = { 0.033765242898423986, 0.169395306766867743, 0.380690406958401546,
                                 0.619309593041598454, 0.830604693233132257, 0.966234757101576014 };
static const double weight6[6] = {
    0.085662246189585173, 0.180380786524069304, 0.233956967286345524,
    0.233956967286345524, 0.180380786524069304, 0.085662246189585173
};

/* On a copy of the piece that begins at 0: instants since the start of a path are rounded at 1e-13
 * s, which a jerk of 20 m/s^3 would show. */
static void add_part(const schuler_piece *piece, const schuler_gravity_table *g, long double from_s,
                     double length_s, double dtheta[3], double dv[3])
{
    schuler_piece copy = *piece;
    copy.t0_s = 0.0;
    const schuler_path alone = { 1, &copy, copy.duration_s };
    const schuler_vec3 omega_ie_e = { { 0.0, 0.0, SCHULER_OMEGA_IE_RADPS } };
    for (int j = 0; j < 6; j++) {
        const long double t_s = from_s - piece->t0_s + node6[j] * length_s;
        const schuler_motion m = schuler_path_at(&alone, (double)t_s);
        const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
        const schuler_vec3 coriolis_e =
            schuler_vec3_scale(2.0, schuler_vec3_cross(omega_ie_e, m.v_e));
        const schuler_vec3 f_e =
            schuler_vec3_sub(schuler_vec3_add(m.a_e, coriolis_e), schuler_gravity_at(g, m.r_e));
        const schuler_vec3 f_b = schuler_mat3_apply_transposed(&C_b_e, f_e);
        const schuler_vec3 omega_ib_b =
            schuler_vec3_add(m.omega_eb_b, schuler_mat3_apply_transposed(&C_b_e, omega_ie_e));
        for (int i = 0; i < 3; i++) {
            dtheta[i] += weight6[j] * length_s * omega_ib_b.v[i];
            dv[i] += weight6[j] * length_s * f_b.v[i];
        }
    }
}

static void reference_step(const schuler_path *path, const schuler_gravity_table *g, int64_t k,
                           double dt_s, double dtheta[3], double dv[3])
{
    const long double from_s = (long double)k * dt_s, to_s = (long double)(k + 1) * dt_s;
    for (int i = 0; i < 3; i++) dtheta[i] = dv[i] = 0.0;
    for (size_t p = 0; p < path->count; p++) {
        const schuler_piece *const piece = &path->pieces[p];
        const long double end_s = piece->t0_s + piece->duration_s;
        const long double a_s = fmaxl(from_s, piece->t0_s), b_s = fminl(to_s, end_s);
        /* The difference of instants would be rounded, too. */
        const double length_s = a_s == from_s && b_s == to_s ? dt_s : (double)(b_s - a_s);
        if (b_s > a_s) add_part(piece, g, a_s, length_s, dtheta, dv);
    }
}

/* Every step of every manoeuvre at several rates; odd ones, so that joints fall inside steps. */
static void the_quadrature_is_exact_to_1e_13(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    static const double rates_hz[] = { 100.0, 73.0, 1000.0, 10.0, 1.0 };
    for (int r = 0; r < 5; r++) {
        const double dt_s = 1.0 / rates_hz[r];
        schuler_truth *truth = flight_truth(&path, dt_s, "wgs84", "wgs84");
        const schuler_gravity_table *const g = schuler_truth_nav_gravity(truth);
        const int64_t steps = schuler_truth_steps(truth);
        double worst_v = 0.0, worst_theta = 0.0;
        for (int64_t first = 0; first + SCHULER_BLOCK <= steps; first += SCHULER_BLOCK * 5) {
            schuler_truth_block block;
            schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
            for (int k = 0; k < SCHULER_BLOCK; k++) {
                double dtheta[3], dv[3];
                reference_step(&path, g, first + k, dt_s, dtheta, dv);
                for (int i = 0; i < 3; i++) {
                    worst_v = fmax(worst_v, fabs(block.dv_ib_b[i][k] - dv[i]) / dt_s);
                    worst_theta =
                        fmax(worst_theta, fabs(block.dtheta_ib_b[i][k] - dtheta[i]) / dt_s);
                }
            }
        }
        /* The promise is 1e-13 of 10 m/s^2 and of 1 rad/s. Only rounding is left of it: some thirty
         * operations at 1e-16 of the largest number, 20 m/s^2 and 0.6 rad/s. */
        CHECK_NEAR(worst_v, 0.0, 1e-13);
        CHECK_NEAR(worst_theta, 0.0, 2e-15);
        schuler_truth_free(truth);
    }
    schuler_path_free(&path);
}

static void compare(const schuler_truth_block *a, int at, const schuler_truth_block *b, int from,
                    int n)
{
    for (int i = 0; i < 3; i++) {
        const size_t bytes = sizeof(double) * (size_t)n;
        assert_memory_equal(&a->dtheta_ib_b[i][at], &b->dtheta_ib_b[i][from], bytes);
        assert_memory_equal(&a->dv_ib_b[i][at], &b->dv_ib_b[i][from], bytes);
    }
}

static void every_instruction_set_gives_the_same_bytes(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 1.0 / 73.0, "grs80", "wgs84");
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = -SCHULER_BLOCK; first < steps + SCHULER_BLOCK; first += SCHULER_BLOCK) {
        schuler_truth_block scalar, wide;
        schuler_truth_block_compute(truth, SCHULER_ISA_SCALAR, first, SCHULER_BLOCK, &scalar);
        for (int isa = SCHULER_ISA_SSE2; isa < SCHULER_ISA_COUNT; isa++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            schuler_truth_block_compute(truth, (schuler_isa)isa, first, SCHULER_BLOCK, &wide);
            compare(&scalar, 0, &wide, 0, SCHULER_BLOCK);
        }
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void it_does_not_matter_where_blocks_begin(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 1.0 / 73.0, "wgs84", "wgs84");
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = -40; first + 2 * SCHULER_BLOCK < steps; first += 29) {
        const int n = 1 + (int)((first + 40) % SCHULER_BLOCK);
        schuler_truth_block whole, part;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &whole);
        schuler_truth_block_compute(truth, schuler_isa_best(), first, n, &part);
        compare(&whole, 0, &part, 0, n);
        if (n == SCHULER_BLOCK) continue;
        schuler_truth_block_compute(truth, schuler_isa_best(), first + n, SCHULER_BLOCK - n, &part);
        compare(&whole, n, &part, 0, SCHULER_BLOCK - n);
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void steps_far_outside_the_path_stay_finite(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 1.0, "wgs84", "wgs84");
    static const int64_t firsts[] = { -1000000, -400, -33, 0, 100000, 1000000000 };
    for (int f = 0; f < 6; f++) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), firsts[f], SCHULER_BLOCK, &block);
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < SCHULER_BLOCK; k++) {
                assert_true(isfinite(block.dtheta_ib_b[i][k]));
                assert_true(fabs(block.dv_ib_b[i][k]) < 100.0);
            }
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    schuler_static_spec spec = { .start = { .lat_rad = 0.5, .h_m = 130000.0 }, .for_s = 10.0 };
    schuler_path path = flight_build("static", &spec);
    schuler_truth *truth = NULL;
    schuler_error err = { 0 };
    assert_int_equal(schuler_truth_create(&truth, &path, 0.01, "wgs84", "wgs84", &err),
                     SCHULER_ERR_NUMERIC);
    assert_non_null(strstr(err.message, "130000 m"));
    schuler_path_free(&path);
    spec.start.h_m = 0.0;
    path = flight_build("static", &spec);
    assert_int_equal(schuler_truth_create(&truth, &path, 0.01, "wgs84", "moon", &err),
                     SCHULER_ERR_GRAVITY_DATA);
    assert_int_equal(schuler_truth_create(&truth, &path, 0.0, "wgs84", "wgs84", &err),
                     SCHULER_ERR_NUMERIC);
    assert_null(truth);
    schuler_path_free(&path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_rest_the_sensors_feel_the_earth_turn_and_gravity),
        cmocka_unit_test(flight_along_a_parallel_has_constant_rates),
        cmocka_unit_test(the_quadrature_is_exact_to_1e_13),
        cmocka_unit_test(every_instruction_set_gives_the_same_bytes),
        cmocka_unit_test(it_does_not_matter_where_blocks_begin),
        cmocka_unit_test(steps_far_outside_the_path_stay_finite),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
#include "core/path.h"
#include "flights.h"
#include <stdlib.h>

/* Position relative to the piece's origin and attitude in extended precision, straight from the
 * definition. */
static void exact(const schuler_piece *piece, long double s, long double dr[3],
                  long double C_b_b0[3][3])
{
    long double rho[3];
    for (int i = 0; i < 3; i++) {
        dr[i] = rho[i] = 0.0L;
        for (int k = SCHULER_PIECE_DEGREE; k >= 0; k--) dr[i] = dr[i] * s + piece->dr_e[i][k];
        for (int k = SCHULER_PIECE_DEGREE - 1; k >= 0; k--)
            rho[i] = rho[i] * s + piece->rho_b[i][k];
    }
    const long double angle = sqrtl(rho[0] * rho[0] + rho[1] * rho[1] + rho[2] * rho[2]);
    const long double k1 = angle > 0.0L ? sinl(angle) / angle : 1.0L;
    const long double k2 = angle > 0.0L ? 2.0L * powl(sinl(0.5L * angle) / angle, 2.0L) : 0.5L;
    const long double X[3][3] = { { 0.0L, -rho[2], rho[1] },
                                  { rho[2], 0.0L, -rho[0] },
                                  { -rho[1], rho[0], 0.0L } };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            long double square = 0.0L;
            for (int k = 0; k < 3; k++) square += X[i][k] * X[k][j];
            C_b_b0[i][j] = (i == j ? 1.0L : 0.0L) + k1 * X[i][j] + k2 * square;
        }
}

/* Derivatives by central differences with Richardson's rule: their error is h^4/30 times the fifth
 * derivative. Extended precision rounds at 1e-19 of up to 20 km. */
static long double slope(const long double at[4], long double h)
{
    return (8.0L * (at[2] - at[1]) - (at[3] - at[0])) / (12.0L * h);
}

static void velocity_acceleration_and_rate_are_the_derivatives(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    for (size_t p = 0; p < path.count; p += 3) {
        const schuler_piece *const piece = &path.pieces[p];
        const double t_s = piece->t0_s + 0.37 * piece->duration_s;
        const long double h_s = 3e-4L, h = 0.5L * h_s * piece->duration_s;
        const long double s = (t_s - (long double)piece->t0_s) * 2.0L / piece->duration_s - 1.0L;
        const schuler_motion m = schuler_path_at(&path, t_s);
        long double dr[5][3], C[5][3][3], wide[5][3], unused[3][3];
        for (int k = 0; k < 5; k++) {
            exact(piece, s + (k - 2) * h_s, dr[k], C[k]);
            exact(piece, s + (k - 2) * 4e-3L, wide[k], unused);
        }
        for (int i = 0; i < 3; i++) {
            const long double near4[4] = { dr[0][i], dr[1][i], dr[3][i], dr[4][i] };
            /* Rounding of v in double: three units of 200 m/s; the difference adds a tenth of that.
             */
            CHECK_NEAR(m.v_e.v[i], (double)slope(near4, h), 1e-13);
            /* Second differences over 0.004 of s, where the fourth order leaves 3e-10/90 of a
             * sixth derivative and rounding 1e-19 of the position over 1.6e-5; both times (2/T)^2.
             */
            const long double second = (16.0L * (wide[3][i] + wide[1][i]) -
                                        (wide[4][i] + wide[0][i]) - 30.0L * wide[2][i]) /
                                       (12.0L * 1.6e-5L) * powl(2.0L / piece->duration_s, 2.0L);
            CHECK_NEAR(m.a_e.v[i], (double)second, 3e-11);
        }
        /* omega x = C^T C' */
        long double Omega[3][3] = { { 0.0L } };
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int k = 0; k < 3; k++) {
                    const long double near4[4] = { C[0][k][j], C[1][k][j], C[3][k][j], C[4][k][j] };
                    Omega[i][j] += C[2][k][i] * slope(near4, h);
                }
        CHECK_NEAR(m.omega_eb_b.v[0], (double)Omega[2][1], 1e-13);
        CHECK_NEAR(m.omega_eb_b.v[1], (double)Omega[0][2], 1e-13);
        CHECK_NEAR(m.omega_eb_b.v[2], (double)Omega[1][0], 1e-13);
    }
    schuler_path_free(&path);
}

static void pieces_join_smoothly(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    assert_true(path.count > 10);
    assert_true(path.pieces[0].t0_s == 0.0);
    for (size_t p = 0; p + 1 < path.count; p++) {
        schuler_piece *const pieces = &path.pieces[p];
        const double joint_s = pieces[1].t0_s;
        assert_true(pieces[0].t0_s + pieces[0].duration_s == joint_s);
        const schuler_path before = { 1, &pieces[0], 0.0 }, after = { 1, &pieces[1], 0.0 };
        const schuler_motion a = schuler_path_at(&before, joint_s),
                             b = schuler_path_at(&after, joint_s);
        for (int i = 0; i < 3; i++) {
            /* An ulp of an ECEF coordinate; rounding of the largest coefficient over the piece;
             * acceleration and rate to what the tails of the fit allow at the ends: 100 times the
             * tail over half a piece of 0.1 s at least. */
            CHECK_NEAR(a.r_e.v[i], b.r_e.v[i], 1e-9);
            CHECK_NEAR(a.v_e.v[i], b.v_e.v[i], 2e-13);
            CHECK_NEAR(a.a_e.v[i], b.a_e.v[i], 3e-11);
            CHECK_NEAR(a.omega_eb_b.v[i], b.omega_eb_b.v[i], 1e-13);
        }
        const schuler_vec3 off =
            schuler_quat_to_rotvec(schuler_quat_mul(schuler_quat_conj(a.q_b_e), b.q_b_e));
        CHECK_NEAR(schuler_vec3_norm(off), 0.0, 1e-15);
    }
    schuler_path_free(&path);
}

/* The end is the start plus all displacements: rounding of one piece is not handed to the next. Two
 * ulps of an ECEF coordinate; lost remainders of 300 pieces would be ten times that. */
static void position_is_the_integral_of_velocity_over_all_pieces(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    assert_true(path.count > 200);
    const schuler_motion start = schuler_path_at(&path, 0.0),
                         end = schuler_path_at(&path, path.duration_s);
    for (int i = 0; i < 3; i++) {
        long double moved_m = 0.0L;
        for (size_t p = 0; p < path.count; p++)
            for (int k = 1; k <= SCHULER_PIECE_DEGREE; k += 2)
                moved_m += 2.0L * path.pieces[p].dr_e[i][k];
        CHECK_NEAR((double)(end.r_e.v[i] - start.r_e.v[i] - moved_m), 0.0, 2e-9);
    }
    schuler_path_free(&path);
}

static void rotation_vectors_stay_small(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    for (size_t p = 0; p < path.count; p++)
        for (int end = -1; end <= 1; end += 2) {
            double angle2 = 0.0;
            for (int i = 0; i < 3; i++) {
                double rho = 0.0;
                for (int k = SCHULER_PIECE_DEGREE - 1; k >= 0; k--)
                    rho = rho * end + path.pieces[p].rho_b[i][k];
                angle2 += rho * rho;
            }
            assert_true(sqrt(angle2) <= SCHULER_PIECE_ANGLE_RAD * (1.0 + 1e-12));
        }
    schuler_path_free(&path);
}

static void the_piece_of_an_instant_is_found(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    for (size_t p = 0; p < path.count; p++) {
        assert_int_equal(schuler_path_find(&path, path.pieces[p].t0_s), p);
        assert_int_equal(
            schuler_path_find(&path, path.pieces[p].t0_s + 0.9 * path.pieces[p].duration_s), p);
    }
    assert_int_equal(schuler_path_find(&path, -5.0), 0);
    assert_int_equal(schuler_path_find(&path, path.duration_s + 5.0), path.count - 1);
    schuler_path_free(&path);
    schuler_path_free(NULL);
}

static void the_motion_goes_on_before_the_start_and_stays_finite(void **state)
{
    (void)state;
    schuler_hold_spec cruise = { .for_s = 100.0 };
    schuler_variant items[] = { { &schuler_segment_cruise, &cruise } };
    const schuler_start start = { .lat_rad = 0.5, .h_m = 1000.0, .speed_mps = 200.0 };
    schuler_path path = flight_segments(start, items, 1);
    const schuler_motion at_start = schuler_path_at(&path, 0.0),
                         before = schuler_path_at(&path, -0.03);
    /* Straight flight: v changes by the curvature only, 0.03 s * v^2/R. */
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(at_start.r_e.v[i] - before.r_e.v[i], 0.03 * at_start.v_e.v[i], 1e-5);
    const schuler_motion far = schuler_path_at(&path, -1e9);
    for (int i = 0; i < 3; i++)
        assert_true(isfinite(far.r_e.v[i]) && isfinite(far.omega_eb_b.v[i]));
    schuler_path_free(&path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(velocity_acceleration_and_rate_are_the_derivatives),
        cmocka_unit_test(pieces_join_smoothly),
        cmocka_unit_test(position_is_the_integral_of_velocity_over_all_pieces),
        cmocka_unit_test(rotation_vectors_stay_small),
        cmocka_unit_test(the_piece_of_an_instant_is_found),
        cmocka_unit_test(the_motion_goes_on_before_the_start_and_stays_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

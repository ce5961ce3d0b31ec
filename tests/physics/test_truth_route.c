/* SPDX-License-Identifier: MIT */
/* Routes: the ground track is GeographicLib's geodesic between turns, turns meet the next leg,
 * values hold at waypoints, and what does not fit is refused. */
#include "core/geographic.h"
#include "flights.h"
#include <stdlib.h>

static const schuler_manner airliner = {
    .bank_rad = 25.0 * DEG,
    .roll_rate_radps = 5.0 * DEG,
    .radius_m = NAN,
    .climb_mps = 10.0,
    .descent_mps = 8.0,
    .vertical_acceleration_mps2 = 1.0,
    .acceleration_mps2 = 1.5,
    .deceleration_mps2 = 1.5,
    .jerk_mps3 = 1.0,
};
static const schuler_manner as_defaults = { { 0 }, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN };

static schuler_waypoint_spec waypoint(double lat_deg, double lon_deg, double h_m, double speed_mps)
{
    return (schuler_waypoint_spec){ .lat_rad = lat_deg * DEG,
                                    .lon_rad = lon_deg * DEG,
                                    .h_m = h_m,
                                    .speed_mps = speed_mps,
                                    .manner = as_defaults };
}

static schuler_path build(schuler_waypoint_spec *waypoints, size_t count)
{
    const schuler_route_spec spec = { .defaults = airliner, .waypoints = { waypoints, count } };
    return flight_build("route", &spec);
}

/* Distance beside the geodesic from a to b, with its sign: positive right. The reduced length of
 * GeographicLib would be exact; a sphere's is off by e^2 of a thing that is to be zero. */
static double beside(const schuler_waypoint_spec *a, const schuler_waypoint_spec *b, schuler_llh p,
                     double *along_m)
{
    const double R_m = 6371000.0;
    double length_m, azimuth_rad, s_m, bearing_rad, unused;
    schuler_geodesic_inverse(a->lat_rad, a->lon_rad, b->lat_rad, b->lon_rad, &length_m,
                             &azimuth_rad, &unused);
    schuler_geodesic_inverse(a->lat_rad, a->lon_rad, p.lat_rad, p.lon_rad, &s_m, &bearing_rad,
                             &unused);
    *along_m = s_m / length_m;
    return R_m * asin(sin(s_m / R_m) * sin(bearing_rad - azimuth_rad));
}

static schuler_llh place_at(const schuler_path *path, double t_s)
{
    return schuler_llh_from_ecef(schuler_path_at(path, t_s).r_e);
}

static void a_leg_of_5000_km_stays_on_its_geodesic(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = {
        waypoint(38.0, -9.0, 10000.0, 230.0),
        waypoint(39.0, -11.0, 10000.0, 230.0), /* a turn before, to be met by the long leg */
        waypoint(41.0, -70.0, 11000.0, 240.0),
        waypoint(39.0, -71.0, 11000.0, 240.0),
    };
    schuler_path path = build(w, 4);
    int on_long_leg = 0;
    for (double t_s = 0.0; t_s < path.duration_s; t_s += 60.0) {
        const schuler_llh p = place_at(&path, t_s);
        double along;
        const double off_m = beside(&w[1], &w[2], p, &along);
        if (p.lon_rad > -11.4 * DEG || p.lon_rad < -69.6 * DEG) continue; /* clear of the turns */
        /* The promise is 1 mm. GeographicLib's 15 nm near the far ends and 1e-12 rad of aim over
         * 5000 km leave 5 um. */
        CHECK_NEAR(off_m, 0.0, 1e-5);
        on_long_leg++;
    }
    assert_true(on_long_leg > 300);
    schuler_path_free(&path);
}

static void short_legs_do_not_spoil_the_aim_of_a_long_one(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = {
        waypoint(38.0, -9.0, 100.0, 20.0),  waypoint(38.004, -9.0, NAN, NAN),
        waypoint(38.004, -9.005, NAN, NAN), waypoint(38.0, -9.005, NAN, NAN),
        waypoint(39.0, -40.0, NAN, NAN),
    };
    for (int i = 1; i < 4; i++) w[i].manner.radius_m = 50.0;
    schuler_path path = build(w, 5);
    for (double t_s = 600.0; t_s < path.duration_s; t_s += 5000.0) {
        double along;
        /* 1e-12 rad over 2700 km, and the 1e-7 m of the turn. */
        CHECK_NEAR(beside(&w[3], &w[4], place_at(&path, t_s), &along), 0.0, 5e-6);
    }
    schuler_path_free(&path);
}

static void a_turn_leaves_one_leg_and_meets_the_next(void **state)
{
    (void)state;
    static const double corners_deg[][2] = {
        { 51.0, 9.0 }, { 49.5, 10.0 }, { 49.2, 7.5 }, { 50.03, 10.0 }
    };
    for (int c = 0; c < 4; c++) {
        schuler_waypoint_spec w[] = {
            waypoint(50.0, 8.0, 8000.0, 200.0),
            waypoint(50.0, 9.0, 8000.0, 200.0),
            waypoint(corners_deg[c][0], corners_deg[c][1], 8000.0, 200.0),
        };
        schuler_path path = build(w, 3);
        double highest_bank = 0.0;
        int on_first = 0, on_second = 0;
        for (double t_s = 0.0; t_s < path.duration_s; t_s += 0.5) {
            const schuler_llh p = place_at(&path, t_s);
            double along_in, along_out;
            const double in_m = beside(&w[0], &w[1], p, &along_in);
            const double out_m = beside(&w[1], &w[2], p, &along_out);
            const schuler_motion m = schuler_path_at(&path, t_s);
            const schuler_mat3 C_n_e = schuler_C_n_e(p.lat_rad, p.lon_rad);
            const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
            const schuler_mat3 C_e_n = schuler_mat3_transpose(&C_n_e);
            const schuler_mat3 C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
            double roll, pitch, heading;
            schuler_euler_from_mat3(&C_b_n, &roll, &pitch, &heading);
            highest_bank = fmax(highest_bank, fabs(roll));
            /* Wings level means on a leg, to the solver's 1e-7 m and the aim's. */
            if (fabs(roll) > 1e-12) continue;
            const int first = fabs(in_m) < 1e-5, second = fabs(out_m) < 1e-5;
            assert_true(first || second);
            on_first += first;
            on_second += second;
        }
        assert_true(on_first > 10 && on_second > 10);
        assert_true(highest_bank < 25.0001 * DEG);
        schuler_path_free(&path);
    }
}

static void values_hold_at_their_waypoints(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = {
        waypoint(45.0, 7.0, 300.0, 0.0),    waypoint(45.05, 7.05, NAN, 90.0),
        waypoint(45.4, 7.4, 3000.0, 150.0), waypoint(46.0, 7.5, 1500.0, 120.0),
        waypoint(46.05, 7.51, 1500.0, 0.0),
    };
    w[0].wait_s = 42.0;
    w[4].wait_s = 17.0;
    schuler_path path = build(w, 5);
    /* At rest for the wait, and back at rest on the last waypoint. */
    const schuler_vec3 still = schuler_path_at(&path, 42.0).v_e;
    CHECK_NEAR(schuler_vec3_norm(still), 0.0, 1e-12);
    assert_true(schuler_vec3_norm(schuler_path_at(&path, 43.0).v_e) > 1e-3);
    const schuler_llh end = place_at(&path, path.duration_s),
                      stopped = place_at(&path, path.duration_s - 17.0);
    double s_m, unused1, unused2;
    schuler_geodesic_inverse(end.lat_rad, end.lon_rad, w[4].lat_rad, w[4].lon_rad, &s_m, &unused1,
                             &unused2);
    CHECK_NEAR(s_m, 0.0, 3e-7); /* what a tick at 120 m/s and the solver's 1e-7 m leave */
    schuler_geodesic_inverse(end.lat_rad, end.lon_rad, stopped.lat_rad, stopped.lon_rad, &s_m,
                             &unused1, &unused2);
    CHECK_NEAR(s_m, 0.0, 5e-9);
    /* Height and speed when passing each inner waypoint. */
    for (int i = 1; i < 4; i++) {
        double best_m = 1e9, h_m = 0.0, speed_mps = 0.0;
        for (double t_s = 0.0; t_s < path.duration_s; t_s += 0.25) {
            const schuler_llh p = place_at(&path, t_s);
            schuler_geodesic_inverse(p.lat_rad, p.lon_rad, w[i].lat_rad, w[i].lon_rad, &s_m,
                                     &unused1, &unused2);
            if (s_m < best_m) {
                best_m = s_m;
                h_m = p.h_m;
                speed_mps = schuler_vec3_norm(schuler_path_at(&path, t_s).v_e);
            }
        }
        CHECK_NEAR(h_m, i == 1 ? 300.0 : w[i].h_m, 1e-6);
        CHECK_NEAR(speed_mps, w[i].speed_mps, 1e-6);
    }
    schuler_path_free(&path);
}

static void climbs_come_early_and_descents_late(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = { waypoint(45.0, 7.0, 1000.0, 100.0),
                                  waypoint(46.0, 7.0, 3000.0, 150.0),
                                  waypoint(47.0, 7.0, 2000.0, 120.0) };
    schuler_path path = build(w, 3);
    /* 111 km a leg; changes take 250 s at most, so the second third of a leg is steady at the
     * higher values. */
    for (double t_s = 0.0; t_s < path.duration_s; t_s += 1.0) {
        const schuler_llh p = place_at(&path, t_s);
        const double lat_deg = p.lat_rad / DEG;
        if (lat_deg < 45.4 || lat_deg > 46.6) continue;
        CHECK_NEAR(p.h_m, 3000.0, 1e-6);
        CHECK_NEAR(schuler_vec3_norm(schuler_path_at(&path, t_s).v_e), 150.0, 1e-9);
    }
    /* And they end on time. */
    CHECK_NEAR(place_at(&path, path.duration_s).h_m, 2000.0, 1e-6);
    assert_true(place_at(&path, 60.0).h_m > 1300.0);
    assert_true(place_at(&path, path.duration_s - 60.0).h_m > 2200.0);
    schuler_path_free(&path);
}

static void a_route_crosses_the_pole(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = { waypoint(80.0, 20.0, 10000.0, 240.0),
                                  waypoint(80.0, -159.0, 10000.0, 240.0) };
    schuler_path path = build(w, 2);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    double northmost = 0.0;
    for (double t_s = 0.0; t_s < path.duration_s; t_s += 1.0) {
        const schuler_llh p = place_at(&path, t_s);
        northmost = fmax(northmost, p.lat_rad);
        CHECK_NEAR(p.h_m, 10000.0, 1e-7);
    }
    assert_true(northmost > 89.9 * DEG);
    /* Level flight at 240 m/s turns by less than its transport and earth rates, also there. */
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = 0; first + SCHULER_BLOCK < steps; first += 50 * SCHULER_BLOCK) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
        for (int i = 0; i < 3; i++) assert_true(fabs(block.dtheta_ib_b[i][0]) < 1.2e-4 * 0.01);
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void taxi_turns_are_flat_and_have_their_radius(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = { waypoint(45.0, 7.0, 200.0, 0.0),
                                  waypoint(45.003, 7.0, 200.0, 8.0),
                                  waypoint(45.003, 7.004, 200.0, 0.0) };
    w[1].manner.radius_m = 40.0;
    schuler_path path = build(w, 3);
    schuler_truth *truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    double fastest_radps = 0.0, bank = 0.0;
    for (double t_s = 0.0; t_s < path.duration_s; t_s += 0.05) {
        schuler_truth_state s;
        schuler_truth_at(truth, t_s, &s);
        bank = fmax(bank, fabs(s.roll_rad));
        fastest_radps = fmax(fastest_radps, fabs(schuler_path_at(&path, t_s).omega_eb_b.v[2]));
    }
    CHECK_NEAR(bank, 0.0, 1e-14);
    /* Turn rate = speed/radius, on top of the transport rate (1e-6). */
    CHECK_NEAR(fastest_radps, 8.0 / 40.0, 2e-6);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

static void refuse(schuler_waypoint_spec *w, size_t count, const char *says, int line)
{
    for (size_t i = 0; i < count; i++)
        w[i].place = (schuler_place){ "route.yaml", (int)i + 1, 1, 1 };
    const schuler_route_spec spec = { .defaults = airliner, .waypoints = { w, count } };
    schuler_path path = { 0 };
    schuler_diagnostics d = { 0 };
    assert_int_equal(flight_kind("route")->build(&spec, &path, &d), SCHULER_ERR_INPUT);
    assert_true(d.kept > 0);
    if (strstr(d.items[0].message, says) == NULL)
        fail_msg("'%s' is not in '%s'", says, d.items[0].message);
    assert_int_equal(d.items[0].place.line, line);
    assert_null(path.pieces);
    schuler_diagnostics_free(&d);
}

static void what_does_not_fit_is_refused_by_name(void **state)
{
    (void)state;
    schuler_waypoint_spec near[] = { waypoint(45.0, 7.0, 1000.0, 100.0),
                                     waypoint(45.1, 7.0, 9000.0, 100.0) };
    near[1].name = "SUMMIT";
    refuse(near, 2, "to 'SUMMIT' is too short: it has 11113 m and needs", 2);
    schuler_waypoint_spec tight[] = { waypoint(45.0, 7.0, 1000.0, 250.0),
                                      waypoint(45.2, 7.0, NAN, NAN),
                                      waypoint(45.2, 7.05, NAN, NAN) };
    refuse(tight, 3, "for its turns", 3);
    schuler_waypoint_spec back[] = { waypoint(45.0, 7.0, 1000.0, 100.0),
                                     waypoint(45.5, 7.0, NAN, NAN),
                                     waypoint(45.0, 7.01, NAN, NAN) };
    refuse(back, 3, "at most 170 deg", 2);
    schuler_waypoint_spec rest[] = { waypoint(45.0, 7.0, 1000.0, 0.0),
                                     waypoint(45.5, 7.0, NAN, NAN) };
    refuse(rest, 2, "at rest at both ends", 2);
    schuler_waypoint_spec same[] = { waypoint(45.0, 7.0, 1000.0, 90.0),
                                     waypoint(45.0, 7.0, NAN, NAN) };
    refuse(same, 2, "the same place", 2);
    schuler_waypoint_spec pass[] = { waypoint(45.0, 7.0, 1000.0, 90.0),
                                     waypoint(46.0, 7.0, NAN, NAN) };
    pass[1].wait_s = 5.0;
    refuse(pass, 2, "a wait needs speed 0", 2);
    schuler_waypoint_spec pivot[] = { waypoint(45.0, 7.0, 0.0, 50.0), waypoint(45.2, 7.0, NAN, 0.0),
                                      waypoint(45.2, 7.2, NAN, 50.0) };
    refuse(pivot, 3, "at rest the direction can change by 5 deg", 2);
    schuler_waypoint_spec both[] = { waypoint(45.0, 7.0, 1000.0, 90.0),
                                     waypoint(46.0, 7.0, NAN, NAN) };
    both[1].manner.radius_m = 5000.0;
    both[1].manner.bank_rad = 0.3;
    refuse(both, 2, "a bank and a radius", 2);
    refuse(both, 1, "two waypoints or more", 0);
}

/* All mistakes of single waypoints are told at once. */
static void several_mistakes_are_reported_together(void **state)
{
    (void)state;
    schuler_waypoint_spec w[] = { waypoint(45.0, 7.0, 1000.0, 90.0), waypoint(45.0, 7.0, NAN, NAN),
                                  waypoint(46.0, 7.0, NAN, NAN) };
    w[2].wait_s = 5.0;
    const schuler_route_spec spec = { .defaults = airliner, .waypoints = { w, 3 } };
    schuler_path path = { 0 };
    schuler_diagnostics d = { 0 };
    assert_int_equal(flight_kind("route")->build(&spec, &path, &d), SCHULER_ERR_INPUT);
    assert_int_equal(d.errors, 2);
    schuler_diagnostics_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leg_of_5000_km_stays_on_its_geodesic),
        cmocka_unit_test(short_legs_do_not_spoil_the_aim_of_a_long_one),
        cmocka_unit_test(a_turn_leaves_one_leg_and_meets_the_next),
        cmocka_unit_test(values_hold_at_their_waypoints),
        cmocka_unit_test(climbs_come_early_and_descents_late),
        cmocka_unit_test(a_route_crosses_the_pole),
        cmocka_unit_test(taxi_turns_are_flat_and_have_their_radius),
        cmocka_unit_test(what_does_not_fit_is_refused_by_name),
        cmocka_unit_test(several_mistakes_are_reported_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

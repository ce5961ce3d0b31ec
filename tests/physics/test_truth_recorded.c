/* SPDX-License-Identifier: MIT */
/* A trajectory through recorded rows: rows taken from a known motion, the curve between them against it,
 * and what files are refused or warned of. */
#include "../unit/scenario_text.h"
#include "core/truth.h"
#include "flights.h"

#define HEAD "time_s,lat_deg,lon_deg,height_m,vn_mps,ve_mps,vd_mps,roll_deg,pitch_deg,heading_deg\n"

static schuler_path recorded_of(const schuler_path *path, double every_s, const char *velocity)
{
    const size_t n = (size_t)floor(path->duration_s / every_s) + 1;
    schuler_recorded_sample *const rows = malloc(n * sizeof *rows);
    assert_non_null(rows);
    for (size_t i = 0; i < n; i++) {
        const double t = every_s * (double)i;
        const schuler_motion m = schuler_path_at(path, t);
        rows[i] = (schuler_recorded_sample){ t, m.r_e, m.v_e, m.q_b_e };
    }
    const schuler_recorded_spec spec = { .velocity = velocity, .samples = { "rows", n, rows } };
    schuler_path out = flight_build("recorded", &spec);
    free(rows);
    return out;
}

typedef struct {
    double place_m, attitude_rad;
} deviation;

static deviation largest_deviation(const schuler_path *a, const schuler_path *b)
{
    deviation most = { 0 };
    for (double t = 0.0; t < b->duration_s; t += 0.0377) {
        const schuler_motion x = schuler_path_at(a, t), y = schuler_path_at(b, t);
        most.place_m = fmax(most.place_m, schuler_vec3_norm(schuler_vec3_sub(x.r_e, y.r_e)));
        const schuler_quat back = { x.q_b_e.w, -x.q_b_e.x, -x.q_b_e.y, -x.q_b_e.z };
        most.attitude_rad =
            fmax(most.attitude_rad,
                 schuler_vec3_norm(schuler_quat_to_rotvec(schuler_quat_mul(back, y.q_b_e))));
    }
    return most;
}

/* Fifth degree through places and velocities leaves p'''''' h^6/46080, cubic rotation vectors and places alone
 * 5/384 of the fourth derivative h^4: halving the interval gains 64 and 16. At the ends, where a cubic
 * through four rows starts the curve, somewhat less. */
static void the_curve_follows_a_smooth_motion(void **state)
{
    (void)state;
    loaded l;
    load_good(&l,
              "scenario: x\ntrajectory: {kind: motion, for: 100 s, start: {lat: 50 deg, lon: 10 "
              "deg}, geodesic: "
              "{speed: 20 m/s}, overlays: [sway: {motion: roll, angle: 20 deg, period: 7 s}, sway: "
              "{motion: "
              "pitch, angle: 10 deg, period: 5 s, phase: 40 deg}, sway: {motion: heave, distance: "
              "5 m, period: "
              "6 s}]}\nimu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n",
              NULL);
    deviation with[2], alone[2];
    for (int i = 0; i < 2; i++) {
        schuler_path a = recorded_of(&l.s->path, i ? 0.25 : 0.5, "use");
        schuler_path b = recorded_of(&l.s->path, i ? 0.25 : 0.5, "ignore");
        with[i] = largest_deviation(&l.s->path, &a);
        alone[i] = largest_deviation(&l.s->path, &b);
        print_message("every %.2f s: %.3g m, %.3g rad; by places alone %.3g m\n", i ? 0.25 : 0.5,
                      with[i].place_m, with[i].attitude_rad, alone[i].place_m);
        schuler_path_free(&a);
        schuler_path_free(&b);
    }
    assert_true(with[0].place_m > 40.0 * with[1].place_m);
    assert_true(with[0].attitude_rad > 10.0 * with[1].attitude_rad);
    assert_true(alone[0].place_m > 10.0 * alone[1].place_m);
    /* 5 m (2 pi/6 s)^6 (0.25 s)^6/46080 = 3.5e-8 m; at an end, whose acceleration is extrapolated with
     * p^(6) 8 h^4/720 off, nine times as much. */
    assert_true(with[1].place_m < 4e-7);
    unload(&l);
}

/* A flight with the kinks of its manoeuvres, ten rows a second. */
static void the_curve_follows_a_flight(void **state)
{
    (void)state;
    schuler_path flight = flight_of_all_manoeuvres();
    schuler_path curve = recorded_of(&flight, 0.1, "use");
    const deviation d = largest_deviation(&flight, &curve);
    print_message("flight, every 0.1 s: %.3g m, %.3g rad\n", d.place_m, d.attitude_rad);
    assert_true(d.place_m < 1e-6);
    assert_true(d.attitude_rad < 1e-5);
    schuler_path_free(&curve);
    schuler_path_free(&flight);
}

/* Through every row, and smooth there: acceleration and rate have no jump. Rows 0.3 s apart and unevenly
 * so, across the pole and the date line. */
static void rows_are_met_smoothly(void **state)
{
    (void)state;
    static const char text[] =
        "scenario: x\ntrajectory: {kind: motion, for: 200 s, start: {lat: 89.9 deg, lon: 10 deg, "
        "height: 5 "
        "km, heading: 2 deg}, geodesic: {speed: 250 m/s}, overlays: [sway: {motion: roll, angle: "
        "20 deg, period: "
        "7 s}, sway: {motion: yaw, angle: 10 deg, period: 5 s}]}\n"
        "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n";
    loaded l;
    load_good(&l, text, NULL);
    schuler_recorded_sample rows[600];
    size_t n = 0;
    for (double t = 0.0; t < 199.0 && n < 600; t += n % 3 == 0 ? 0.25 : 0.4375, n++) {
        const schuler_motion m = schuler_path_at(&l.s->path, t);
        rows[n] = (schuler_recorded_sample){ t, m.r_e, m.v_e, m.q_b_e };
    }
    const schuler_recorded_spec spec = { .velocity = "use", .samples = { "rows", n, rows } };
    schuler_path path = flight_build("recorded", &spec);
    for (size_t i = 1; i + 1 < n; i++) {
        const double t = rows[i].t_s;
        const schuler_motion m = schuler_path_at(&path, t);
        for (int k = 0; k < 3; k++) CHECK_NEAR(m.r_e.v[k], rows[i].r_e.v[k], 5e-8);
        for (int k = 0; k < 3; k++) CHECK_NEAR(m.v_e.v[k], rows[i].v_e.v[k], 1e-9);
        const size_t at = schuler_path_find(&path, t);
        const schuler_motion before = schuler_piece_at(&path.pieces[at - 1], 1.0);
        /* Places round at 1e-9 m, so accelerations at 60 of them over h^2: 1e-6 m/s^2. */
        for (int k = 0; k < 3; k++) CHECK_NEAR(before.a_e.v[k], m.a_e.v[k], 3e-6);
        for (int k = 0; k < 3; k++) CHECK_NEAR(before.omega_eb_b.v[k], m.omega_eb_b.v[k], 1e-12);
    }
    const deviation d = largest_deviation(&l.s->path, &path);
    /* 5/384 h^4 of 0.35 rad (2 pi/7 s)^4 and 0.17 rad (2 pi/5 s)^4 with h = 0.44 s: 4e-4. */
    print_message("across the pole: %.3g m, %.3g rad\n", d.place_m, d.attitude_rad);
    assert_true(d.attitude_rad < 5e-4);
    assert_true(d.place_m < 1e-6);
    schuler_path_free(&path);
    unload(&l);
}

static void load_with(loaded *l, const char *rows, const char *keys)
{
    char text[400];
    make_folder(l);
    snprintf(text, sizeof text,
             "scenario: x\ntrajectory: {kind: recorded, file: t.csv%s}\n"
             "imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}\n",
             keys);
    write_file(l->dir, "s.yaml", text, strlen(text));
    if (rows) write_file(l->dir, "t.csv", rows, strlen(rows));
    l->rc = schuler_scenario_load(&l->s, l->path, NULL, &l->d);
}

static void unload_with(loaded *l)
{
    char path[100];
    snprintf(path, sizeof path, "%s/t.csv", l->dir);
    unlink(path);
    unload(l);
}

#define ROW(t, lat, vn, heading) #t "," #lat ",7,1000," #vn ",0,0,0,0," #heading "\n"

static void bad_files_are_refused_with_their_line(void **state)
{
    (void)state;
    static const struct {
        const char *rows;
        int line;
        const char *message;
    } cases[] = {
        { NULL, 0, "cannot be opened: No such file or directory" },
        { "", 0, "empty; the first line must be time_s" },
        { "time,lat\n", 1, "column 1 is 'time', but 'time_s' is expected" },
        { HEAD ROW(0, 45, 0, 0) ROW(1, 45, 0, 0) ROW(2, 45, 0, 0), 0,
          "3 rows; a trajectory has 4 to 4000000 of them" },
        { HEAD ROW(0, 45, 0, 0) ROW(1, 45, nan, 0) ROW(2, 45, 0, 0), 3, "'nan' is not a number" },
        { HEAD ROW(0, 45, 0, 0) ROW(1, 95, 0, 0) ROW(2, 45, 0, 0), 3,
          "latitude 95 deg is outside -90 .. 90 deg" },
        { HEAD ROW(0, 45, 0, 0) ROW(2, 45, 0, 0) ROW(1, 45, 0, 0) ROW(3, 45, 0, 0), 4,
          "time 1 s does not come after 2 s" },
        { HEAD ROW(0, 45, 0, 0) ROW(1, 45, 0, 0) ROW(2, 46, 0, 0) ROW(3, 46, 0, 0), 4,
          "the place is 1.112e+05 m/s from the row before; up to 10000 m/s is believed" },
        { HEAD ROW(0, 45, 0, 0) ROW(1, 45, 0, 170) ROW(2, 45, 0, 190) ROW(3, 45, 0, 190), 3,
          "the attitude turns by 170 deg since the row before; between rows up to 57.3 deg can be "
          "followed: "
          "record faster" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        loaded l;
        load_with(&l, cases[i].rows, "");
        assert_int_not_equal(l.rc, SCHULER_OK);
        assert_true(l.d.kept > 0);
        if (!strstr(l.d.items[0].message, cases[i].message))
            fail_msg("case %zu: %s", i, l.d.items[0].message);
        assert_int_equal(l.d.items[0].place.line, cases[i].line);
        assert_non_null(strstr(l.d.items[0].place.file, "t.csv"));
        unload_with(&l);
    }
}

/* Wraps of longitude and heading are no jumps; a gap and a wrong velocity are said, with their line. */
static void what_is_odd_is_said(void **state)
{
    (void)state;
    loaded l;
    load_with(&l,
              HEAD
              "0,45,179.99999,1000,0,2.3658,0,0,0,179\n1,45,-179.99998,1000,0,2.3658,0,0,0,-179\n"
              "2,45,-179.99995,1000,0,2.3658,0,0,0,181\n3,45,180.00008,1000,0,2.3658,0,0,0,-178\n",
              "");
    for (size_t i = 0; i < l.d.kept; i++) print_error("%s\n", l.d.items[i].message);
    assert_int_equal(l.rc, SCHULER_OK);
    assert_int_equal(l.d.warnings, 0);
    unload_with(&l);

    load_with(&l,
              HEAD ROW(0, 45, 0, 0) ROW(1, 45, 0, 0) ROW(2, 45, 0, 0) ROW(9, 45, 0, 0)
                  ROW(10, 45, 3, 0) ROW(11, 45, 0, 0),
              "");
    assert_int_equal(l.rc, SCHULER_OK);
    assert_int_equal(l.d.warnings, 2);
    assert_non_null(strstr(l.d.items[0].message, "1 gap of up to 7 s where rows come every 1 s"));
    assert_int_equal(l.d.items[0].place.line, 5);
    assert_non_null(strstr(l.d.items[1].message,
                           "2 of 5 rows have a velocity that is not the change of "
                           "position, this one by 1.5 m/s"));
    unload_with(&l);
    load_with(&l,
              HEAD ROW(0, 45, 0, 0) ROW(1, 45, 0, 0) ROW(2, 45, 0, 0) ROW(3, 45, 0, 0)
                  ROW(4, 45, 3, 0) ROW(5, 45, 0, 0),
              ", velocity: ignore");
    assert_int_equal(l.rc, SCHULER_OK);
    assert_int_equal(l.d.warnings, 0);
    unload_with(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curve_follows_a_smooth_motion),
        cmocka_unit_test(the_curve_follows_a_flight),
        cmocka_unit_test(rows_are_met_smoothly),
        cmocka_unit_test(bad_files_are_refused_with_their_line),
        cmocka_unit_test(what_is_odd_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

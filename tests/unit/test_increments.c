/* SPDX-License-Identifier: MIT */
/* What is odd in recorded increments is found, counted and, when asked, bridged: on files whose faults are
 * put in here. */
#include "check.h"
#include "scenarios/increments.h"
#include "scenarios/trajectory_file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double dt_s = 0.01;
static char path[] = "/tmp/test_increments.XXXXXX";

enum { ROWS = 1000 };

/* Row k = 1..ROWS, at line k + 1 of a file without faults: x-angle k^2 1e-9, so that no two rows are
 * the same and any row is known; the other values too, but for a factor. */
typedef struct {
    double t_s, x[6];
    int out; /* 1: not written */
} sample;

static sample *rows(double t0_s)
{
    sample *const s = calloc(ROWS + 1, sizeof *s);
    assert_non_null(s);
    for (int k = 0; k <= ROWS; k++) {
        s[k].t_s = t0_s + k * dt_s;
        for (int i = 0; i < 6; i++) s[k].x[i] = (i + 1) * 1e-9 * k * k;
    }
    return s;
}

static void put(sample *s)
{
    FILE *const file = fopen(path, "w");
    assert_non_null(file);
    fputs(SCHULER_IMU_HEADER "\n", file);
    for (int k = 1; k <= ROWS; k++) {
        char line[SCHULER_IMU_LINE_MAX];
        if (!s[k].out) fwrite(line, 1, schuler_imu_line(line, s[k].t_s, s[k].x, s[k].x + 3), file);
    }
    fclose(file);
    free(s);
}

typedef struct {
    schuler_status status;
    schuler_error error;
    schuler_faults faults;
    double dt_s, sum; /* of the x-angles */
    int64_t steps;
    int irregular;
} found;

static found look(double t0_s, int bridge)
{
    static schuler_increments in; /* large */
    found f = { 0 };
    in = (schuler_increments){ .bridge = bridge, .faults = &f.faults };
    f.status = schuler_increments_open(&in, path, t0_s, &f.error);
    while (f.status == SCHULER_OK && in.n > 0) {
        for (; in.used < in.n; in.used++) f.sum += in.dtheta[0][in.used];
        f.status = schuler_increments_more(&in, &f.error);
    }
    schuler_increments_judge(&in);
    f.dt_s = in.dt_s;
    f.steps = in.read;
    f.irregular = in.irregular;
    schuler_increments_close(&in);
    return f;
}

/* Sum of the squares 1..n. */
static double squares(double n)
{
    return n * (n + 1) * (2 * n + 1) / 6.0;
}

static void is(const found *f, schuler_fault_kind kind, int count, int line, double worst)
{
    assert_int_equal(f->faults.of[kind].count, count);
    assert_int_equal(f->faults.of[kind].first_line, line);
    CHECK_NEAR(f->faults.of[kind].worst, worst, 1e-9 + 1e-12 * worst);
}

static void nothing_but(const found *f, schuler_fault_kind a, schuler_fault_kind b)
{
    for (int k = 0; k < SCHULER_FAULT_KINDS; k++)
        if (k != (int)a && k != (int)b) assert_int_equal(f->faults.of[k].count, 0);
}

static void good_data_have_no_fault(void **state)
{
    (void)state;
    put(rows(0.0));
    const found f = look(0.0, 0);
    assert_int_equal(f.status, SCHULER_OK);
    assert_int_equal(f.steps, ROWS);
    assert_int_equal(f.irregular, 0);
    CHECK_NEAR(f.dt_s, dt_s, 0.0);
    CHECK_REL(f.sum, 1e-9 * squares(ROWS), 1e-12);
    nothing_but(&f, SCHULER_FAULT_GAP, SCHULER_FAULT_GAP);
}

/* Rows 300..302 and 700 are missing: the rows after them stand at lines 301 and 698. */
static void put_gaps(void)
{
    sample *const s = rows(0.0);
    s[300].out = s[301].out = s[302].out = s[700].out = 1;
    put(s);
}

static void all_gaps_are_counted_before_the_error(void **state)
{
    (void)state;
    put_gaps();
    const found f = look(0.0, 0);
    assert_int_equal(f.status, SCHULER_ERR_INPUT);
    assert_int_equal(f.error.place.line, 301);
    assert_int_equal(f.error.place.column, 1);
    assert_non_null(strstr(f.error.message, "a gap: 3.03 s follows 2.99 s"));
    is(&f, SCHULER_FAULT_GAP, 2, 301, 0.04);
    nothing_but(&f, SCHULER_FAULT_GAP, SCHULER_FAULT_GAP);
}

/* Each missing row is that after the gap: k = 303 three times more, 701 once more. */
static void a_gap_is_bridged_with_the_row_after_it(void **state)
{
    (void)state;
    put_gaps();
    const found f = look(0.0, 1);
    assert_int_equal(f.status, SCHULER_OK);
    assert_int_equal(f.steps, ROWS);
    is(&f, SCHULER_FAULT_GAP, 2, 301, 0.04);
    const double lost = 300.0 * 300 + 301.0 * 301 + 302.0 * 302 + 700.0 * 700;
    CHECK_REL(f.sum, 1e-9 * (squares(ROWS) - lost + 3 * 303.0 * 303 + 701.0 * 701), 1e-12);
    nothing_but(&f, SCHULER_FAULT_GAP, SCHULER_FAULT_GAP);
}

static void a_gap_of_more_than_a_minute_is_not_bridged(void **state)
{
    (void)state;
    sample *const s = rows(0.0);
    for (int k = 500; k <= ROWS; k++) s[k].t_s += 61.0;
    put(s);
    const found f = look(0.0, 1);
    assert_int_equal(f.status, SCHULER_ERR_INPUT);
    assert_int_equal(f.error.place.line, 501);
    assert_non_null(strstr(f.error.message, "more than a minute"));
}

/* Row 400 has the time of 399, row 500 that of 490, row 600 comes a tenth of an interval after 599. Left
 * out, each leaves a gap of two intervals. */
static void rows_out_of_time_are_left_out(void **state)
{
    (void)state;
    sample *const s = rows(0.0);
    s[400].t_s = s[399].t_s;
    s[500].t_s = s[490].t_s;
    s[600].t_s = s[599].t_s + 0.1 * dt_s;
    put(s);
    found f = look(0.0, 1);
    assert_int_equal(f.status, SCHULER_OK);
    is(&f, SCHULER_FAULT_REPEATED, 1, 401, 0.0);
    is(&f, SCHULER_FAULT_BACKWARD, 1, 501, 9 * dt_s);
    is(&f, SCHULER_FAULT_SOON, 1, 601, 0.1 * dt_s);
    is(&f, SCHULER_FAULT_GAP, 3, 402, 2 * dt_s);
    assert_int_equal(f.steps, ROWS);
    const double more =
        401.0 * 401 - 400.0 * 400 + 501.0 * 501 - 500.0 * 500 + 601.0 * 601 - 600.0 * 600;
    CHECK_REL(f.sum, 1e-9 * (squares(ROWS) + more), 1e-12);
    f = look(0.0, 0);
    assert_int_equal(f.status, SCHULER_ERR_INPUT);
    assert_int_equal(f.error.place.line, 401);
    assert_non_null(strstr(f.error.message, "is repeated"));
    is(&f, SCHULER_FAULT_BACKWARD, 1, 501, 9 * dt_s);
}

/* Late by up to 0.2 of an interval, nine rows of ten; the mean of all is off by
 * that at the end, 2e-4, which is within the noise of 100 Hz. */
static void noisy_times_are_told_and_the_mean_interval_is_used(void **state)
{
    (void)state;
    sample *const s = rows(5.0);
    for (int k = 1; k <= ROWS; k++) s[k].t_s += 0.2 * dt_s * ((k + 9) % 10) / 9.0;
    put(s);
    const found f = look(5.0, 0);
    assert_int_equal(f.status, SCHULER_OK);
    assert_int_equal(f.irregular, 1);
    CHECK_NEAR(f.dt_s, dt_s, 0.0);
    assert_int_equal(f.steps, ROWS);
    is(&f, SCHULER_FAULT_JITTER, 900, 3, 0.2 * dt_s);
    CHECK_REL(f.sum, 1e-9 * squares(ROWS), 1e-12);
}

/* 120 Hz in microseconds: no constant interval, a mean that is 1/120 to 1e-6. At least a third of the
 * times is right; a third of 1e-6 s is the largest error. */
static void times_rounded_to_microseconds_keep_their_rate(void **state)
{
    (void)state;
    sample *const s = rows(0.0);
    for (int k = 1; k <= ROWS; k++) s[k].t_s = nearbyint(k / 120.0 * 1e6) / 1e6;
    put(s);
    const found f = look(0.0, 0);
    assert_int_equal(f.status, SCHULER_OK);
    CHECK_NEAR(f.dt_s, 1.0 / 120.0, 0.0);
    is(&f, SCHULER_FAULT_JITTER, 667, 2, 1e-6 / 3.0);
}

/* From 100 to 80 samples a second: no gap in it, but a whole interval off after four rows. */
static void a_rate_that_changes_is_an_error(void **state)
{
    (void)state;
    sample *const s = rows(0.0);
    for (int k = 501; k <= ROWS; k++) s[k].t_s += 0.25 * dt_s * (k - 500);
    put(s);
    const found f = look(0.0, 1);
    assert_int_equal(f.status, SCHULER_ERR_INPUT);
    assert_int_equal(f.error.place.line, 506);
    assert_non_null(strstr(f.error.message, "the rate is not constant"));
}

static void what_no_vehicle_does_is_a_spike(void **state)
{
    (void)state;
    sample *const s = rows(0.0);
    s[250].x[1] = -0.5; /* 50 rad/s */
    s[260].x[1] = 0.39;
    s[300].x[5] = 11.0; /* 1100 m/s^2 */
    s[310].x[3] = -12.0;
    s[320].x[3] = 9.9;
    put(s);
    const found f = look(0.0, 0);
    assert_int_equal(f.status, SCHULER_OK);
    is(&f, SCHULER_FAULT_RATE_SPIKE, 1, 251, 50.0);
    is(&f, SCHULER_FAULT_FORCE_SPIKE, 2, 301, 1200.0);
    nothing_but(&f, SCHULER_FAULT_RATE_SPIKE, SCHULER_FAULT_FORCE_SPIKE);
}

/* Rows 200..229 alike: 30; 400..418 are one too few. */
static void sensors_that_stand_still_are_told(void **state)
{
    (void)state;
    sample *s = rows(0.0);
    for (int k = 200; k < 230; k++) memcpy(s[k].x, s[200].x, 3 * sizeof(double));
    for (int k = 400; k < 419; k++) memcpy(s[k].x, s[400].x, 6 * sizeof(double));
    put(s);
    found f = look(0.0, 0);
    is(&f, SCHULER_FAULT_STUCK_GYRO, 30, 201, 30.0);
    nothing_but(&f, SCHULER_FAULT_STUCK_GYRO, SCHULER_FAULT_STUCK_GYRO);
    s = rows(0.0); /* all rows alike are exact data at rest */
    for (int k = 1; k <= ROWS; k++) memcpy(s[k].x, s[1].x, sizeof s[k].x);
    put(s);
    f = look(0.0, 0);
    nothing_but(&f, SCHULER_FAULT_GAP, SCHULER_FAULT_GAP);
}

static int make_file(void **state)
{
    (void)state;
    const int fd = mkstemp(path);
    return fd < 0 ? -1 : close(fd);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_data_have_no_fault),
        cmocka_unit_test(all_gaps_are_counted_before_the_error),
        cmocka_unit_test(a_gap_is_bridged_with_the_row_after_it),
        cmocka_unit_test(a_gap_of_more_than_a_minute_is_not_bridged),
        cmocka_unit_test(rows_out_of_time_are_left_out),
        cmocka_unit_test(noisy_times_are_told_and_the_mean_interval_is_used),
        cmocka_unit_test(times_rounded_to_microseconds_keep_their_rate),
        cmocka_unit_test(a_rate_that_changes_is_an_error),
        cmocka_unit_test(what_no_vehicle_does_is_a_spike),
        cmocka_unit_test(sensors_that_stand_still_are_told),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}

/* SPDX-License-Identifier: MIT */
/* Recordings: what is read, and what is refused with its place. */
#include "check.h"
#include "core/earth.h"
#include "scenarios/recording.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char path[] = "/tmp/schuler-recording-XXXXXX";

static void put(const char *text, size_t length)
{
    FILE *const out = fopen(path, "w");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, length, out), length);
    assert_int_equal(fclose(out), 0);
}

/* A header and 20 rows; row number `at` (from 1, 0: none) is replaced. Times are k/100. */
static void put_rows(const char *header, const char *rest, int at, const char *row)
{
    char text[4096];
    int length = snprintf(text, sizeof text, "%s\n", header);
    for (int k = 1; k <= 20; k++)
        length += k == at ? snprintf(text + length, sizeof text - (size_t)length, "%s\n", row)
                          : snprintf(text + length, sizeof text - (size_t)length, "%.2f%s\n",
                                     0.01 * k, rest);
    put(text, (size_t)length);
}

static schuler_recording *read_all(const schuler_recording_options *options)
{
    schuler_recording *r;
    schuler_error error = { 0 };
    const schuler_status status = schuler_recording_read(&r, path, options, &error);
    if (status != SCHULER_OK) print_error("%s\n", error.message);
    assert_int_equal(status, SCHULER_OK);
    return r;
}

/* line 0: any */
static void refused(const schuler_recording_options *options, int line, int column,
                    const char *message)
{
    schuler_recording *r;
    schuler_error error = { 0 };
    const schuler_status status = schuler_recording_read(&r, path, options, &error);
    assert_null(r);
    if (status == SCHULER_ERR_INPUT && strstr(error.message, message) &&
        (line == 0 || error.place.line == line) && (column == 0 || error.place.column == column))
        return;
    print_error("status %d, %d:%d: %s\ninstead of %d:%d: %s\n", status, error.place.line,
                error.place.column, error.message, line, column, message);
    fail();
}

static const schuler_recording_options plain = { .threads = 1 };

static void names_tell_units_and_kinds(void **state)
{
    static const char header[] =
        "time_s,gx_radps,gy_degps,gz_degph,ax_mps2,ay_g,dtheta_x_rad,dv_x_mps,temp_c,note";
    static const double si[] = { 1.0, SCHULER_RAD_PER_DEG, SCHULER_RAD_PER_DEG / 3600.0,
                                 1.0, SCHULER_G0_MPS2,     1.0,
                                 1.0 };
    (void)state;
    put_rows(header, ",2,2,2,2,2,2,2,25.1,any text", 0, "");
    schuler_recording *const r = read_all(&plain);
    assert_int_equal(r->columns, 7);
    assert_int_equal(r->n, 20);
    CHECK_NEAR(r->dt_s, 0.01, 0.0);
    for (int i = 0; i < 7; i++) {
        CHECK_REL(r->column[i].values[19], 2.0 * si[i], 1e-15);
        assert_int_equal(r->column[i].instrument, i < 3 || i == 5 ? SCHULER_GYRO : SCHULER_ACCEL);
        assert_int_equal(r->column[i].increments, i >= 5);
    }
    assert_string_equal(r->column[1].name, "gy_degps");
    schuler_recording_free(r);
}

static void options_choose_columns(void **state)
{
    (void)state;
    put_rows("time_ms,gx,gy,gz,a_g", ",1,2,3,4", 0, "");
    schuler_recording_options o = { .threads = 1, .columns = "gz,gx:deg/s,a_g" };
    schuler_recording *r = read_all(&o);
    assert_int_equal(r->columns, 3); /* in the order that was asked for */
    CHECK_REL(r->column[0].values[0], 3.0 * SCHULER_RAD_PER_DEG, 1e-15);
    CHECK_REL(r->column[1].values[0], SCHULER_RAD_PER_DEG, 1e-15);
    CHECK_REL(r->column[2].values[0], 4.0 * SCHULER_G0_MPS2, 1e-15);
    CHECK_REL(r->dt_s, 1e-5, 1e-9); /* the times of 0.01 are milliseconds */
    schuler_recording_free(r);

    put_rows("t_s,gx_radps,dtheta_x_rad,ax_g", ",1,2,3", 0, "");
    o = (schuler_recording_options){ .kind = SCHULER_DATA_RATES,
                                     .only_instrument = 1,
                                     .instrument = SCHULER_GYRO };
    r = read_all(&o);
    assert_int_equal(r->columns, 1);
    assert_string_equal(r->column[0].name, "gx_radps");
    schuler_recording_free(r);
}

static void a_rate_stands_for_the_time(void **state)
{
    (void)state;
    put_rows("id,gx_radps", ",1e-3", 0, "");
    refused(&plain, 1, 0, "no column of time");
    const schuler_recording_options o = { .rate_hz = 50.0 };
    schuler_recording *const r = read_all(&o);
    CHECK_NEAR(r->dt_s, 0.02, 0.0);
    assert_int_equal(r->times, 0);
    schuler_recording_free(r);
    put_rows("time_s,gx_radps", ",1e-3", 0, "");
    refused(&o, 0, 0, "says 100 Hz, not 50 Hz");
}

static void rough_text_is_read(void **state)
{
    char text[2048];
    (void)state;
    int length = snprintf(text, sizeof text, "\xEF\xBB\xBF\"time_s\" , gx_radps\r\n");
    for (int k = 0; k < 20;
         k++) /* the last line without its end; times with a rounding of 0.3 ms */
        length += snprintf(text + length, sizeof text - (size_t)length, " %.4f ,\t-1.5e-3 %s",
                           k / 128.0 + (k % 2 ? 3e-4 : 0.0), k < 19 ? "\r\n" : "");
    put(text, (size_t)length);
    schuler_recording *const r = read_all(&plain);
    assert_int_equal(r->n, 20);
    CHECK_REL(r->dt_s, 1.0 / 128.0, 3e-3);
    CHECK_NEAR(r->column[0].values[19], -1.5e-3, 0.0);
    schuler_recording_free(r);
}

static void wrong_headers_are_refused(void **state)
{
    schuler_recording_options o = { .threads = 1 };
    (void)state;
    put("", 0);
    refused(&plain, 0, 0, "empty");
    put("1,2,3\n1,2,3\n", 12);
    refused(&plain, 1, 1, "must name the columns");
    put("time_s;gx_radps\n1;2\n", 20);
    refused(&plain, 1, 0, "separated by commas");
    put("time_s,gx,gy\n1,2,3\n", 19);
    refused(&plain, 1, 0, "names must end with a unit");
    put("time_s,gx_radps,gx_radps\n1,2,3\n", 31);
    refused(&plain, 1, 17, "two columns 'gx_radps'");
    put("a\0b,gx_radps\n1,2\n", 17);
    refused(&plain, 1, 0, "NUL");
    put_rows("time_s,gx,gyro_y", ",1,2", 0, "");
    o.columns = "gyro_x:deg/s";
    refused(&o, 1, 0, "no column 'gyro_x'; did you mean 'gyro_y'?");
    o.columns = "gx";
    refused(&o, 1, 8, "needs a unit");
    o.columns = "gx:deg/sec2x";
    refused(&o, 1, 8, "unit");
    o.columns = "gx:m";
    refused(&o, 1, 8, "neither");
    o.columns = "gx:deg/s,gx:deg/s";
    refused(&o, 1, 8, "twice");
    o.columns = "";
    refused(&o, 1, 0, "names must end with a unit");
    o.columns = "gx:deg/s";
    o.kind = SCHULER_DATA_INCREMENTS;
    refused(&o, 1, 8, "no increment");
    o.kind = SCHULER_DATA_ANY;
    o.only_instrument = 1;
    o.instrument = SCHULER_ACCEL;
    refused(&o, 1, 8, "no unit of an accelerometer");
}

static void many_columns_have_a_limit(void **state)
{
    char text[8192] = "time_s";
    (void)state;
    for (int i = 0; i < 300; i++) sprintf(text + strlen(text), ",c%d_radps", i);
    strcat(text, "\n");
    put(text, strlen(text));
    refused(&plain, 1, 0, "more than 256 columns");
    strcpy(text, "time_s");
    for (int i = 0; i < 13; i++) sprintf(text + strlen(text), ",c%d_radps", i);
    strcat(text, "\n");
    put(text, strlen(text));
    refused(&plain, 1, 0, "more than 12 columns of data");
}

static void wrong_rows_are_refused_with_their_place(void **state)
{
    static const char header[] = "time_s,gx_radps,note,gy_radps";
    static const struct {
        const char *row, *message;
        int column;
    } wrong[] = {
        { "0.07,1,x,nan", "'nan' is not a finite number, for 'gy_radps'", 10 },
        { "0.07,inf,x,1", "'inf' is not a finite number", 6 },
        { "0.07,1e999,x,1", "'1e999' is not a finite number", 6 },
        { "0.07,0x1,x,1", "'0x1' is not a finite number", 6 },
        { "0.07,1 2,x,1", "is not a finite number", 6 },
        { "0.07,,x,1", "'gx_radps' has no value", 6 },
        { "0.07,1,x", "fewer fields", 0 },
        { "0.07,1", "fewer fields", 0 },
        { "0.07,1,x,1,5", "more fields", 11 },
        { "", "empty line", 1 },
        { "0.06,1,x,1", "time 0.06 s is repeated", 0 },
        { "0.05,1,x,1", "time runs back from 0.06 s to 0.05 s", 0 },
        { "0.09,1,x,1", "a gap: 0.09 s follows 0.06 s", 0 },
        { "0.061,1,x,1", "too soon", 0 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        put_rows(header, ",1,x,1", 7, wrong[i].row);
        refused(&plain, 8, wrong[i].column, wrong[i].message);
    }
    put("time_s,gx_radps\n0,1\n0.01,1\n", 27);
    refused(&plain, 0, 0, "2 samples are too few");
    put("time_s,gx_radps\n", 16);
    refused(&plain, 0, 0, "0 samples are too few");
    put("time_s,gx_radps", 15);
    refused(&plain, 0, 0, "0 samples are too few");
}

static void what_is_no_file_is_said(void **state)
{
    schuler_recording *r;
    schuler_error error = { 0 };
    const volatile int stop = 1;
    (void)state;
    assert_int_equal(schuler_recording_read(&r, "/nowhere/at/all", &plain, &error),
                     SCHULER_ERR_FILE);
    assert_int_equal(schuler_recording_read(&r, "/tmp", &plain, NULL), SCHULER_ERR_FILE);
    put_rows("time_s,gx_radps", ",1", 0, "");
    const schuler_recording_options o = { .stop = &stop };
    assert_int_equal(schuler_recording_read(&r, path, &o, &error), SCHULER_ERR_INTERRUPTED);
    schuler_recording_free(NULL);
}

enum { MANY = 900000 };

/* bad_row: from 1, 0 none. About 20 MB: five parts. */
static void put_many(int bad_row, const char *bad)
{
    FILE *const out = fopen(path, "w");
    assert_non_null(out);
    fputs("time_s,gx_radps\n", out);
    for (int k = 1; k <= MANY; k++)
        if (k == bad_row)
            fprintf(out, "%s\n", bad);
        else
            fprintf(out, "%.2f,%d.000000000\n", 0.01 * k, k);
    assert_int_equal(fclose(out), 0);
}

/* The parts of a file join without a seam, and lines are counted through. */
static void parts_are_read_side_by_side(void **state)
{
    (void)state;
    put_many(0, "");
    for (int threads = 1; threads <= 8; threads += 3) {
        const schuler_recording_options o = { .threads = threads };
        schuler_recording *const r = read_all(&o);
        int64_t wrong = 0;
        assert_int_equal(r->n, MANY);
        for (int64_t k = 0; k < MANY; k++) wrong += r->column[0].values[k] != (double)(k + 1);
        assert_int_equal(wrong, 0);
        CHECK_NEAR(r->dt_s, 0.01, 0.0);
        schuler_recording_free(r);
        refused(&(schuler_recording_options){ .threads = threads, .rate_hz = 99.0 }, 0, 0, "99 Hz");
    }
    put_many(700000, "7000.00,nan");
    refused(&(schuler_recording_options){ .threads = 4 }, 700001, 9, "'nan'");
    put_many(700000, "7000.5,1");
    refused(&(schuler_recording_options){ .threads = 4 }, 700001, 0, "a gap");
}

/* What stands between two parts is checked too: without one row anywhere there is a gap. */
static void a_gap_at_any_line_is_found(void **state)
{
    char buffer[64];
    (void)state;
    put_many(0, "");
    FILE *in = fopen(path, "r");
    struct stat info;
    assert_non_null(in);
    assert_int_equal(fstat(fileno(in), &info), 0);
    /* The line in the middle of the data, where two parts meet. */
    assert_int_equal(fseek(in, 16 + ((long)info.st_size - 16) / 2, SEEK_SET), 0);
    assert_non_null(fgets(buffer, sizeof buffer, in));
    assert_non_null(fgets(buffer, sizeof buffer, in));
    fclose(in);
    const int row = (int)lround(atof(buffer) * 100.0);
    for (int near = row - 2; near <= row + 2; near++) {
        char moved[64];
        snprintf(moved, sizeof moved, "%.3f,1", 0.01 * near + 0.007);
        put_many(near, moved);
        refused(&(schuler_recording_options){ .threads = 2 }, near + 1, 0, "gap");
    }
}

static void streams_are_read_in_one_go(void **state)
{
    (void)state;
    int ends[2];
    char name[64];
    char text[512] = "time_s,gx_radps\n";
    assert_int_equal(pipe(ends), 0);
    for (int k = 0; k < 20; k++) sprintf(text + strlen(text), "%d,%d\n", k, 2 * k);
    assert_int_equal(write(ends[1], text, strlen(text)), (ssize_t)strlen(text));
    close(ends[1]);
    snprintf(name, sizeof name, "/dev/fd/%d", ends[0]);
    schuler_recording *r;
    schuler_error error = { 0 };
    if (schuler_recording_read(&r, name, &plain, &error) != SCHULER_OK)
        fail_msg("%d: %s", error.place.line, error.message);
    assert_int_equal(r->n, 20);
    CHECK_NEAR(r->column[0].values[19], 38.0, 0.0);
    schuler_recording_free(r);
    close(ends[0]);
}

static size_t doubts(const char *header, const char *rest, const char *message)
{
    schuler_diagnostics d = { 0 };
    put_rows(header, rest, 0, "");
    schuler_recording *const r = read_all(&plain);
    schuler_recording_doubt(r, path, &d);
    const size_t count = d.warnings;
    if (count > 0 && !strstr(d.items[0].message, message)) {
        print_error("%s\n", d.items[0].message);
        fail();
    }
    schuler_diagnostics_free(&d);
    schuler_recording_free(r);
    return count;
}

static void an_unlikely_rest_is_doubted(void **state)
{
    static const char accel[] = "time_s,ax_mps2,ay_mps2,az_mps2",
                      gyro[] = "time_s,x_radps,y_radps,z_radps";
    (void)state;
    assert_int_equal(doubts(accel, ",0.1,-0.2,-9.8", ""), 0);
    assert_int_equal(doubts("time_s,ax_g,ay_g,az_g", ",0,0,1", ""), 0);
    assert_int_equal(doubts(accel, ",0,0,-1", "is the unit right?"), 1);
    assert_int_equal(doubts(accel, ",0,0,98", "is the unit right?"), 1);
    assert_int_equal(doubts(accel, ",1e-3,0,1e-4", "no gravity"), 1);
    assert_int_equal(doubts(gyro, ",5e-5,0,-5e-5", ""), 0);
    assert_int_equal(doubts(gyro, ",1e-7,0,0", "no earth rate"), 1);
    assert_int_equal(doubts(gyro, ",0.5,0,0", "is the unit right"), 1);
    assert_int_equal(doubts("time_s,ax_mps2,ay_mps2", ",0,0", ""), 0); /* two do not tell */
    /* Increments: 7.3e-7 rad in 10 ms. */
    assert_int_equal(doubts("time_s,x_rad,y_rad,z_rad", ",7.3e-7,0,0", ""), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_tell_units_and_kinds),
        cmocka_unit_test(options_choose_columns),
        cmocka_unit_test(a_rate_stands_for_the_time),
        cmocka_unit_test(rough_text_is_read),
        cmocka_unit_test(wrong_headers_are_refused),
        cmocka_unit_test(many_columns_have_a_limit),
        cmocka_unit_test(wrong_rows_are_refused_with_their_place),
        cmocka_unit_test(what_is_no_file_is_said),
        cmocka_unit_test(parts_are_read_side_by_side),
        cmocka_unit_test(a_gap_at_any_line_is_found),
        cmocka_unit_test(streams_are_read_in_one_go),
        cmocka_unit_test(an_unlikely_rest_is_doubted),
    };
    const int fd = mkstemp(path);
    if (fd < 0) return 1;
    close(fd);
    const int failures = cmocka_run_group_tests(tests, NULL, NULL);
    unlink(path);
    return failures;
}

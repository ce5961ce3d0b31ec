/* SPDX-License-Identifier: MIT */
/* NetCDF files written here, read back by the NetCDF library itself. */
#include "check.h"
#include "scenarios/csv.h"
#include "scenarios/netcdf.h"
#include "scenarios/trajectory_file.h"
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_netcdf.XXXXXX.nc";

enum { ROWS = 20000 }; /* more than two of the writer's blocks */

static const schuler_netcdf_attribute attributes[] = {
    { .name = "scenario", .text = "a: {b: 1 m}\n# 1 \xC2\xB0\n" },
    { .name = "seed", .number = 18446744073709551615u },
};

static schuler_status write_rows(int announced, int written, schuler_error *err)
{
    schuler_netcdf *file = NULL;
    assert_int_equal(
        schuler_netcdf_create(&file, path, &schuler_imu_table, announced, attributes, 2, err),
        SCHULER_OK);
    for (int k = 0; k < written; k++) {
        double values[SCHULER_IMU_COLUMNS];
        for (int i = 0; i < SCHULER_IMU_COLUMNS; i++) values[i] = k / 3.0 + i * 1e6;
        schuler_netcdf_put(file, values);
    }
    return schuler_netcdf_close(file, err);
}

static void text_of(int id, int variable, const char *name, char *text)
{
    size_t length;
    assert_int_equal(nc_inq_attlen(id, variable, name, &length), NC_NOERR);
    assert_in_range(length, 0, 199);
    assert_int_equal(nc_get_att_text(id, variable, name, text), NC_NOERR);
    text[length] = '\0';
}

static void numbers_come_back_with_their_units(void **state)
{
    static double got[ROWS];
    char text[200];
    int id, variable, variables;
    (void)state;
    assert_int_equal(write_rows(ROWS, ROWS, NULL), SCHULER_OK);
    assert_int_equal(nc_open(path, NC_NOWRITE, &id), NC_NOERR);
    assert_int_equal(nc_inq_nvars(id, &variables), NC_NOERR);
    assert_int_equal(variables, SCHULER_IMU_COLUMNS);
    for (int i = 0; i < SCHULER_IMU_COLUMNS; i++) {
        const schuler_column *const column = &schuler_imu_table.columns[i];
        size_t length;
        int dimension;
        char name[NC_MAX_NAME + 1];
        assert_int_equal(nc_inq_varid(id, column->name, &variable), NC_NOERR);
        assert_int_equal(nc_inq_vardimid(id, variable, &dimension), NC_NOERR);
        assert_int_equal(nc_inq_dim(id, dimension, name, &length), NC_NOERR);
        assert_string_equal(name, "time_s"); /* which makes time_s the coordinate */
        assert_int_equal(length, ROWS);
        assert_int_equal(nc_get_var_double(id, variable, got), NC_NOERR);
        for (int k = 0; k < ROWS; k++) CHECK_NEAR(got[k], k / 3.0 + i * 1e6, 0.0);
        text_of(id, variable, "units", text);
        assert_string_equal(text, column->unit);
        text_of(id, variable, "long_name", text);
        assert_string_equal(text, column->long_name);
    }
    unsigned long long seed;
    text_of(id, NC_GLOBAL, "scenario", text);
    assert_string_equal(text, attributes[0].text);
    text_of(id, NC_GLOBAL, "title", text);
    assert_string_equal(text, schuler_imu_table.title);
    assert_int_equal(nc_get_att_ulonglong(id, NC_GLOBAL, "seed", &seed), NC_NOERR);
    assert_true(seed == 18446744073709551615u);
    nc_close(id);
}

static void missing_rows_are_an_error(void **state)
{
    schuler_error error = { 0 };
    (void)state;
    assert_int_equal(write_rows(100, 99, &error), SCHULER_ERR_FILE);
    assert_non_null(strstr(error.message, "99 rows of 100"));
    /* One too many is none of the file's. */
    assert_int_equal(write_rows(100, 101, &error), SCHULER_ERR_FILE);
}

static void a_file_that_cannot_be_made_is_an_error(void **state)
{
    schuler_netcdf *file = NULL;
    schuler_error error = { 0 };
    (void)state;
    assert_int_equal(
        schuler_netcdf_create(&file, "/nowhere/x.nc", &schuler_imu_table, 1, attributes, 2, &error),
        SCHULER_ERR_FILE);
    assert_null(file);
    assert_string_equal(error.place.file, "/nowhere/x.nc");
}

/* By the reader of tables, which takes either kind of file. */
static void rows_are_read_like_those_of_a_csv_file(void **state)
{
    schuler_csv *csv = NULL;
    double x[SCHULER_CSV_COLUMNS_MAX];
    schuler_error error = { 0 };
    int got;
    (void)state;
    assert_int_equal(write_rows(ROWS, ROWS, NULL), SCHULER_OK);
    assert_int_equal(schuler_csv_open(&csv, path, SCHULER_IMU_HEADER, NULL), SCHULER_OK);
    for (int k = 0; k < ROWS; k++) {
        assert_int_equal(schuler_csv_next(csv, x, &got, NULL), SCHULER_OK);
        assert_int_equal(got, 1);
        for (int i = 0; i < SCHULER_IMU_COLUMNS; i++) CHECK_NEAR(x[i], k / 3.0 + i * 1e6, 0.0);
    }
    CHECK_NEAR(schuler_csv_fraction(csv), 1.0, 0.0);
    schuler_csv_refuse(csv, 3, &error, "no");
    assert_int_equal(error.place.line, ROWS);
    assert_int_equal(error.place.column, 0);
    assert_int_equal(schuler_csv_next(csv, x, &got, NULL), SCHULER_OK);
    assert_int_equal(got, 0);
    schuler_csv_close(csv);
    assert_int_equal(schuler_csv_open(&csv, path, SCHULER_RATES_HEADER, &error), SCHULER_ERR_INPUT);
    assert_non_null(strstr(error.message, "no variable 'omega_x_radps'"));
}

/* A file with variables a and b, b along so many dimensions, or another one; row 3 of b is b2. */
static void put_odd(int dimensions, int other, double b2)
{
    const double a[4] = { 0, 1, 2, 3 }, b[4] = { 5, 6, b2, 8 };
    int id, dim[2], va, vb;
    assert_int_equal(nc_create(path, NC_NETCDF4, &id), NC_NOERR);
    nc_def_dim(id, "n", 4, &dim[0]);
    nc_def_dim(id, "m", 1, &dim[1]);
    nc_def_var(id, "a", NC_DOUBLE, 1, &dim[0], &va);
    nc_def_var(id, "b", NC_DOUBLE, dimensions, &dim[other], &vb);
    nc_enddef(id);
    assert_int_equal(nc_put_var_double(id, va, a), NC_NOERR);
    assert_int_equal(nc_put_var_double(id, vb, b), NC_NOERR);
    nc_close(id);
}

static schuler_status read_odd(int *rows, schuler_error *err)
{
    schuler_csv *csv = NULL;
    double x[SCHULER_CSV_COLUMNS_MAX];
    int got = 1;
    *rows = 0;
    schuler_status status = schuler_csv_open(&csv, path, "a,b", err);
    while (status == SCHULER_OK && got) {
        status = schuler_csv_next(csv, x, &got, err);
        *rows += status == SCHULER_OK && got;
    }
    schuler_csv_close(csv);
    return status;
}

static void what_is_no_table_is_refused(void **state)
{
    schuler_error error = { 0 };
    int rows;
    (void)state;
    put_odd(1, 0, 7.0);
    assert_int_equal(read_odd(&rows, &error), SCHULER_OK);
    assert_int_equal(rows, 4);
    put_odd(1, 0, (double)NAN);
    assert_int_equal(read_odd(&rows, &error), SCHULER_ERR_INPUT);
    assert_int_equal(rows, 2);
    assert_int_equal(error.place.line, 3);
    assert_string_equal(error.message, "'b' is not a finite number");
    put_odd(2, 0, 7.0);
    assert_int_equal(read_odd(&rows, &error), SCHULER_ERR_INPUT);
    assert_non_null(strstr(error.message, "'b' is not along"));
    put_odd(1, 1, 7.0);
    assert_int_equal(read_odd(&rows, &error), SCHULER_ERR_INPUT);
    FILE *const file = fopen(path, "w");
    fputs("a,b\n1,2\n", file);
    fclose(file);
    assert_int_equal(read_odd(&rows, &error), SCHULER_ERR_FILE);
    assert_string_equal(error.place.file, path);
}

static void names_say_what_is_wanted(void **state)
{
    (void)state;
    assert_true(schuler_netcdf_named("a/b.nc"));
    assert_false(schuler_netcdf_named(".nc"));
    assert_false(schuler_netcdf_named("nc"));
    assert_false(schuler_netcdf_named("a.nc.csv"));
    assert_false(schuler_netcdf_named(""));
}

static void columns_are_those_of_the_csv_files(void **state)
{
    static const struct {
        const schuler_table *table;
        const char *header;
    } pairs[] = { { &schuler_imu_table, SCHULER_IMU_HEADER },
                  { &schuler_rates_table, SCHULER_RATES_HEADER },
                  { &schuler_trajectory_table, SCHULER_TRAJECTORY_HEADER } };
    (void)state;
    for (int p = 0; p < 3; p++) {
        char header[400] = "";
        for (int i = 0; i < pairs[p].table->count; i++) {
            if (i > 0) strcat(header, ",");
            strcat(header, pairs[p].table->columns[i].name);
        }
        assert_string_equal(header, pairs[p].header);
    }
}

static int make_file(void **state)
{
    (void)state;
    const int fd = mkstemps(path, 3);
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
        cmocka_unit_test(numbers_come_back_with_their_units),
        cmocka_unit_test(missing_rows_are_an_error),
        cmocka_unit_test(a_file_that_cannot_be_made_is_an_error),
        cmocka_unit_test(rows_are_read_like_those_of_a_csv_file),
        cmocka_unit_test(what_is_no_table_is_refused),
        cmocka_unit_test(names_say_what_is_wanted),
        cmocka_unit_test(columns_are_those_of_the_csv_files),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}

/* SPDX-License-Identifier: MIT */
/* NetCDF files written here, read back by the NetCDF library itself. */
#include "check.h"
#include "scenarios/netcdf.h"
#include "scenarios/trajectory_file.h"
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_netcdf.XXXXXX";

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
        cmocka_unit_test(numbers_come_back_with_their_units),
        cmocka_unit_test(missing_rows_are_an_error),
        cmocka_unit_test(a_file_that_cannot_be_made_is_an_error),
        cmocka_unit_test(names_say_what_is_wanted),
        cmocka_unit_test(columns_are_those_of_the_csv_files),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}

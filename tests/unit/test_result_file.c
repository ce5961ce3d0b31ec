/* SPDX-License-Identifier: MIT */
/* Result files read back, and what is none refused. */
#include "mission.h"
#include "scenarios/result_file.h"
#include "scenarios/result_netcdf.h"
#include <netcdf.h>

static const char text[] =
    "scenario: \"a <flight> & back\"\nruns: 3\n"
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 300 m}, for: 10 s}\n"
    "imu:\n  rate: 10 Hz\n"
    "  accel: {model: linear, bias: {normal: 50 ug}}\n  gyro: {model: linear}\n";

static char path[] = "/tmp/test_result_file.XXXXXX.nc";

static void write_good(schuler_scenario **s, schuler_result **r)
{
    const schuler_run_options options = { .threads = 1 };
    *s = mission_text(text);
    *r = mission_run(*s, &options);
    assert_int_equal(schuler_result_netcdf_write(path, *r, NULL, "", NULL), SCHULER_OK);
}

static void what_was_written_is_read(void **state)
{
    (void)state;
    schuler_scenario *s;
    schuler_result *r;
    schuler_result_file f;
    write_good(&s, &r);
    assert_int_equal(schuler_result_file_read(&f, path, NULL), SCHULER_OK);
    assert_string_equal(f.scenario_name, "a <flight> & back");
    assert_string_equal(f.scenario_sha256, s->sha256);
    assert_string_equal(f.version, SCHULER_VERSION);
    assert_int_equal(f.source_count, r->row_count + 2);
    assert_int_equal(f.run_count, 3);
    assert_int_equal(f.track_count, 101); /* of a hundred steps */
    const int all = schuler_result_file_find(&f, "all");
    assert_int_equal(all, r->row_count);
    assert_int_equal(schuler_result_file_find(&f, "none"), all + 1);
    assert_int_equal(schuler_result_file_find(&f, "accel.bias"), 0);
    assert_int_equal(schuler_result_file_find(&f, "accel"), -1);
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(f.end_m[all * 3 + k], r->all.end_m[k], 0.0);
        CHECK_NEAR(f.max_m[all * 3 + k], r->all.max_m[k], 0.0);
        CHECK_NEAR(f.slope_mps[all * 3 + k], r->all.slope_mps[k], 0.0);
        CHECK_NEAR(f.velocity_rms_mps[all * 3 + k], r->all.v_rms_mps[k], 0.0);
    }
    CHECK_NEAR(f.lat_deg[0], 45.0, 1e-12);
    CHECK_NEAR(f.lon_deg[100], 7.0, 1e-12);
    CHECK_NEAR(f.height_m[100], 300.0, 1e-6);
    schuler_result_file_free(&f);
    schuler_result_free(r);
    schuler_scenario_free(s);
}

static void refused(const char *because)
{
    schuler_result_file f;
    schuler_error error = { 0 };
    assert_int_equal(schuler_result_file_read(&f, path, &error), SCHULER_ERR_INPUT);
    if (!strstr(error.message, because)) fail_msg("'%s' instead of '%s'", error.message, because);
    assert_string_equal(error.place.file, path);
    assert_null(f.names);
    assert_null(f.end_m);
}

/* A good file with one value, or one attribute, spoiled. */
static void spoiled(const char *name, double value, const char *attribute, const char *because)
{
    schuler_scenario *s;
    schuler_result *r;
    int id, variable;
    const size_t at[2] = { 0, 0 };
    write_good(&s, &r);
    assert_int_equal(nc_open(path, NC_WRITE, &id), NC_NOERR);
    if (name) {
        assert_int_equal(nc_inq_varid(id, name, &variable), NC_NOERR);
        assert_int_equal(nc_put_var1_double(id, variable, at, &value), NC_NOERR);
    }
    if (attribute) {
        nc_redef(id);
        assert_int_equal(nc_put_att_text(id, NC_GLOBAL, attribute, 3, "odd"), NC_NOERR);
    }
    nc_close(id);
    if (because) {
        refused(because);
    } else {
        schuler_result_file f;
        assert_int_equal(schuler_result_file_read(&f, path, NULL), SCHULER_OK);
        schuler_result_file_free(&f);
    }
    schuler_result_free(r);
    schuler_scenario_free(s);
}

static void values_that_no_result_holds_are_refused(void **state)
{
    (void)state;
    spoiled("end_m", 12.0, NULL, NULL);
    spoiled("end_m", (double)NAN, NULL, "'end_m' holds nan");
    spoiled("slope_mps", (double)INFINITY, NULL, "'slope_mps' holds inf");
    spoiled("track_lat_deg", 90.1, NULL, "'track_lat_deg' holds 90.1; allowed: up to 90");
    spoiled("track_lon_deg", -181.0, NULL, "'track_lon_deg'");
    spoiled(NULL, 0.0, "format", "the format is 'odd'");
    spoiled(NULL, 0.0, "scenario_name", NULL);
}

static void the_joint_runs_must_be_there(void **state)
{
    (void)state;
    schuler_scenario *s;
    schuler_result *r;
    int id, variable;
    write_good(&s, &r);
    const size_t at[2] = { r->row_count, 1 };
    assert_int_equal(nc_open(path, NC_WRITE, &id), NC_NOERR);
    assert_int_equal(nc_inq_varid(id, "source_name", &variable), NC_NOERR);
    assert_int_equal(nc_put_var1_text(id, variable, at, "x"), NC_NOERR);
    nc_close(id);
    refused("'source_name' has no source 'all'");
    schuler_result_free(r);
    schuler_scenario_free(s);
}

/* Dimensions of these sizes, end_m along `second`. */
static void put_other(size_t sources, const char *second, int type)
{
    int id, dimensions[4], along[2], variable;
    assert_int_equal(nc_create(path, NC_NETCDF4 | NC_CLOBBER, &id), NC_NOERR);
    nc_put_att_text(id, NC_GLOBAL, "format", strlen(SCHULER_RESULT_FORMAT), SCHULER_RESULT_FORMAT);
    nc_put_att_text(id, NC_GLOBAL, "scenario_name", 0, "");
    nc_put_att_text(id, NC_GLOBAL, "scenario_sha256", 0, "");
    nc_put_att_text(id, NC_GLOBAL, "schuler_version", 0, "");
    nc_def_dim(id, "source", sources, &dimensions[0]);
    nc_def_dim(id, "run", 2, &dimensions[1]);
    nc_def_dim(id, "track", 2, &dimensions[2]);
    nc_def_dim(id, "letter", 64, &dimensions[3]);
    along[0] = dimensions[0];
    along[1] = dimensions[3];
    nc_def_var(id, "source_name", NC_CHAR, 2, along, &variable);
    nc_inq_dimid(id, second, &along[1]);
    nc_def_var(id, "end_m", type, 2, along, &variable);
    nc_close(id);
}

static void files_of_other_shape_are_refused(void **state)
{
    (void)state;
    put_other(1001, "run", NC_DOUBLE);
    refused("dimension 'source' has 1001 entries");
    put_other(2, "track", NC_DOUBLE);
    refused("'end_m' is along other dimensions");
    put_other(2, "run", NC_CHAR);
    refused("'end_m' cannot be read as numbers");
    put_other(2, "run", NC_INT); /* whole numbers are numbers; NetCDF's fill is as good as any */
    refused("'end_m' holds -2.1");
    FILE *const file = fopen(path, "w");
    fputs("end_m\n1\n", file);
    fclose(file);
    refused("cannot be read");
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
        cmocka_unit_test(what_was_written_is_read),
        cmocka_unit_test(values_that_no_result_holds_are_refused),
        cmocka_unit_test(the_joint_runs_must_be_there),
        cmocka_unit_test(files_of_other_shape_are_refused),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}

/* SPDX-License-Identifier: MIT */
/* The result file, read back by the NetCDF library itself. */
#include "core/earth.h"
#include "mission.h"
#include "scenarios/result_netcdf.h"
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char text[] =
    "scenario: \"a <flight> & back\"\nseed: 9223372036854775807\nruns: 11\n"
    "report: {every: 2 s}\n"
    "trajectory:\n  kind: segments\n"
    "  start: {lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 100 m/s}\n"
    "  segments:\n    - turn: {by: 40 deg, bank: 20 deg}\n    - hold: {for: 33 s}\n"
    "imu:\n  rate: 50 Hz\n"
    "  accel:\n    model: linear\n    bias: {normal: 50 ug}\n    scale_factor: 100 ppm\n"
    "    quantization: 0.0001 m/s\n"
    "  gyro:\n    model: linear\n    angle_random_walk: 0.003 deg/sqrt(h)\n";

static struct {
    char path[40];
    schuler_scenario *s;
    schuler_result *r;
    schuler_covariance *linear;
    size_t sources;
} now;

static const schuler_budget_row *row_at(size_t i)
{
    return i < now.r->row_count    ? &now.r->rows[i]
           : i == now.r->row_count ? &now.r->all
                                   : &now.r->none;
}

static int opened(const schuler_covariance *linear)
{
    int id;
    schuler_error error = { 0 };
    if (schuler_result_netcdf_write(now.path, now.r, linear, "schuler run SCENARIO", &error) !=
        SCHULER_OK)
        fail_msg("%s", error.message);
    assert_int_equal(nc_open(now.path, NC_NOWRITE, &id), NC_NOERR);
    return id;
}

/* All numbers of a variable, which must be along these dimensions (NULL: one alone); to be freed. */
static double *numbers_of(int id, const char *name, const char *first, const char *second)
{
    const char *const wanted[] = { first, second };
    char got[NC_MAX_NAME + 1], unit[40] = "";
    int variable, count, where[2];
    size_t size = 1, length;
    if (nc_inq_varid(id, name, &variable) != NC_NOERR) fail_msg("no variable %s", name);
    assert_int_equal(nc_inq_varndims(id, variable, &count), NC_NOERR);
    assert_int_equal(count, second ? 2 : 1);
    assert_int_equal(nc_inq_vardimid(id, variable, where), NC_NOERR);
    for (int i = 0; i < count; i++) {
        assert_int_equal(nc_inq_dim(id, where[i], got, &length), NC_NOERR);
        assert_string_equal(got, wanted[i]);
        size *= length;
    }
    assert_int_equal(nc_get_att_text(id, variable, "units", unit), NC_NOERR);
    assert_true(unit[0] != '\0');
    assert_int_equal(nc_inq_attlen(id, variable, "long_name", &length), NC_NOERR);
    assert_true(length > 10);
    double *const values = calloc(size, sizeof *values);
    assert_int_equal(nc_get_var_double(id, variable, values), NC_NOERR);
    return values;
}

static void runs_come_back_by_source(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t offset;
    } metrics[] = { { "end_m", offsetof(schuler_budget_row, end_m) },
                    { "max_m", offsetof(schuler_budget_row, max_m) },
                    { "slope_mps", offsetof(schuler_budget_row, slope_mps) },
                    { "velocity_rms_mps", offsetof(schuler_budget_row, v_rms_mps) } };
    const int id = opened(now.linear);
    double *const drawn = numbers_of(id, "drawn", "source", NULL);
    size_t fixed = 0;
    for (int m = 0; m < 4; m++) {
        double *const got = numbers_of(id, metrics[m].name, "source", "run");
        for (size_t i = 0; i < now.sources; i++) {
            const schuler_budget_row *const row = row_at(i);
            const double *values;
            memcpy(&values, (const char *)row + metrics[m].offset, sizeof values);
            fixed += row->runs == 1;
            CHECK_NEAR(drawn[i], row->drawn, 0.0);
            for (int k = 0; k < 11; k++)
                CHECK_NEAR(got[i * 11 + (size_t)k], values[row->runs == 1 ? 0 : k], 0.0);
        }
        free(got);
    }
    assert_true(fixed > 0 && fixed < 4 * now.sources); /* both kinds were there */
    double *const runs = numbers_of(id, "run", "run", NULL);
    for (int k = 0; k < 11; k++) CHECK_NEAR(runs[k], k, 0.0);
    free(runs);
    free(drawn);
    nc_close(id);
}

static void curves_and_sums_come_back(void **state)
{
    (void)state;
    const int id = opened(now.linear);
    const size_t times = now.r->time_count;
    double *const time = numbers_of(id, "time", "time", NULL);
    double *const curve = numbers_of(id, "rms_curve_m", "source", "time");
    double *const end = numbers_of(id, "rms_end_m", "source", NULL);
    double *const share = numbers_of(id, "share", "source", NULL);
    double *const cep = numbers_of(id, "drift_cep_mps", "source", NULL);
    assert_memory_equal(time, now.r->times_s, times * sizeof *time);
    for (size_t i = 0; i < now.sources; i++) {
        assert_memory_equal(curve + i * times, row_at(i)->rms_curve_m, times * sizeof *curve);
        CHECK_NEAR(end[i], row_at(i)->rms_end_m, 0.0);
        CHECK_NEAR(share[i], row_at(i)->share, 0.0);
        CHECK_NEAR(cep[i], row_at(i)->cep_mps, 0.0);
    }
    free(time);
    free(curve);
    free(end);
    free(share);
    free(cep);
    nc_close(id);
}

static void covariance_is_there_where_it_covers(void **state)
{
    (void)state;
    const size_t times = now.r->time_count;
    int id = opened(now.linear), covered = 0;
    double *got = numbers_of(id, "covariance_rms_curve_m", "source", "time");
    for (size_t i = 0; i < now.sources; i++) {
        const schuler_covariance_row *row = schuler_covariance_find(now.linear, row_at(i)->id);
        if (i == now.r->row_count) row = &now.linear->total;
        covered += row && !row->uncovered;
        for (size_t k = 0; k < times; k++) {
            if (row && !row->uncovered)
                CHECK_NEAR(got[i * times + k], row->rms_curve_m[k], 0.0);
            else
                assert_true(isnan(got[i * times + k]));
        }
    }
    assert_true(covered >= 3 && covered < (int)now.sources);
    free(got);
    nc_close(id);
    id = opened(NULL);
    got = numbers_of(id, "covariance_rms_curve_m", "source", "time");
    for (size_t i = 0; i < now.sources * times; i++) assert_true(isnan(got[i]));
    free(got);
    nc_close(id);
}

static void the_track_is_the_true_one_from_start_to_end(void **state)
{
    (void)state;
    const int id = opened(now.linear);
    double *const t = numbers_of(id, "track_time", "track", NULL);
    double *const lat = numbers_of(id, "track_lat_deg", "track", NULL);
    double *const lon = numbers_of(id, "track_lon_deg", "track", NULL);
    double *const height = numbers_of(id, "track_height_m", "track", NULL);
    int dimension;
    size_t n;
    assert_int_equal(nc_inq_dimid(id, "track", &dimension), NC_NOERR);
    assert_int_equal(nc_inq_dimlen(id, dimension, &n), NC_NOERR);
    assert_int_equal(n, SCHULER_RESULT_TRACK_MAX); /* of more steps than that */
    CHECK_NEAR(t[0], 0.0, 0.0);
    CHECK_NEAR(t[n - 1], now.r->duration_s, 0.0);
    for (size_t k = 0; k < n; k++) {
        if (k > 0) assert_true(t[k] > t[k - 1]);
        const schuler_vec3 r = schuler_path_at(&now.s->path, t[k]).r_e;
        const schuler_llh at = { lat[k] * SCHULER_RAD_PER_DEG, lon[k] * SCHULER_RAD_PER_DEG,
                                 height[k] };
        const schuler_vec3 same = schuler_ecef_from_llh(at);
        for (int i = 0; i < 3; i++) CHECK_NEAR(same.v[i], r.v[i], 1e-8); /* ulp of 6.4e6 m: 1e-9 */
    }
    free(t);
    free(lat);
    free(lon);
    free(height);
    nc_close(id);
}

static void expect_text(int id, const char *name, const char *wanted)
{
    char got[4000];
    size_t length;
    if (nc_inq_attlen(id, NC_GLOBAL, name, &length) != NC_NOERR) fail_msg("no %s", name);
    assert_in_range(length, 1, sizeof got - 1);
    assert_int_equal(nc_get_att_text(id, NC_GLOBAL, name, got), NC_NOERR);
    got[length] = '\0';
    assert_string_equal(got, wanted);
}

static void names_and_provenance_come_back(void **state)
{
    (void)state;
    const int id = opened(now.linear);
    char names[20][64];
    int variable;
    assert_in_range(now.sources, 5, 20);
    assert_int_equal(nc_inq_varid(id, "source_name", &variable), NC_NOERR);
    assert_int_equal(nc_get_var_text(id, variable, names[0]), NC_NOERR);
    for (size_t i = 0; i < now.sources; i++) assert_string_equal(names[i], row_at(i)->id);
    assert_string_equal(names[now.sources - 2], "all");
    assert_string_equal(names[now.sources - 1], "none");
    char encoding[6] = "";
    assert_int_equal(nc_get_att_text(id, variable, "_Encoding", encoding), NC_NOERR);
    assert_string_equal(encoding, "utf-8");
    unsigned long long seed, runs;
    assert_int_equal(nc_get_att_ulonglong(id, NC_GLOBAL, "seed", &seed), NC_NOERR);
    assert_int_equal(nc_get_att_ulonglong(id, NC_GLOBAL, "runs", &runs), NC_NOERR);
    assert_true(seed == now.s->seed);
    assert_int_equal(runs, 11);
    expect_text(id, "format", "schuler-result-1");
    expect_text(id, "schuler_version", SCHULER_VERSION);
    expect_text(id, "command", "schuler run SCENARIO");
    expect_text(id, "scenario_name", "a <flight> & back");
    expect_text(id, "scenario_sha256", now.s->sha256);
    expect_text(id, "scenario", text);
    expect_text(id, "Conventions", "CF-1.8");
    nc_close(id);
}

static void a_file_that_cannot_be_made_is_an_error(void **state)
{
    (void)state;
    schuler_error error = { 0 };
    assert_int_equal(schuler_result_netcdf_usable(&error), SCHULER_OK);
    assert_int_equal(schuler_result_netcdf_write("/nowhere/x.nc", now.r, NULL, "", &error),
                     SCHULER_ERR_FILE);
    assert_string_equal(error.place.file, "/nowhere/x.nc");
    assert_true(error.message[0] != '\0');
}

static int simulate_once(void **state)
{
    (void)state;
    strcpy(now.path, "/tmp/test_result.XXXXXX.nc");
    const int fd = mkstemps(now.path, 3);
    if (fd < 0 || close(fd) != 0) return -1;
    const schuler_run_options options = { .threads = 1 };
    now.s = mission_text(text);
    now.r = mission_run(now.s, &options);
    now.sources = now.r->row_count + 2;
    return schuler_covariance_run(now.s, &options, &now.linear, NULL) != SCHULER_OK;
}

static int forget(void **state)
{
    (void)state;
    schuler_covariance_free(now.linear);
    schuler_result_free(now.r);
    schuler_scenario_free(now.s);
    return unlink(now.path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_come_back_by_source),
        cmocka_unit_test(curves_and_sums_come_back),
        cmocka_unit_test(covariance_is_there_where_it_covers),
        cmocka_unit_test(the_track_is_the_true_one_from_start_to_end),
        cmocka_unit_test(names_and_provenance_come_back),
        cmocka_unit_test(a_file_that_cannot_be_made_is_an_error),
    };
    return cmocka_run_group_tests(tests, simulate_once, forget);
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/result_netcdf.h"
#include "core/earth.h"
#include "scenarios/netcdf_library.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SOURCE, RUN, TIME, TRACK, LETTER, DIMENSIONS };
static const char *const dimension_names[DIMENSIONS] = { "source", "run", "time", "track",
                                                         "letter" };

/* Numbers of a budget row: one for each run or time, or (along SOURCE) a single one. */
static const struct {
    const char *name, *unit, *long_name;
    int along;
    size_t offset;
} of_rows[] = {
    { "end_m", "m", "horizontal position error at the end", RUN,
      offsetof(schuler_budget_row, end_m) },
    { "max_m", "m", "largest horizontal position error", RUN, offsetof(schuler_budget_row, max_m) },
    { "slope_mps", "m s-1",
      "drift: least-squares slope through the origin of the horizontal position error", RUN,
      offsetof(schuler_budget_row, slope_mps) },
    { "velocity_rms_mps", "m s-1", "horizontal velocity error, rms over the report times", RUN,
      offsetof(schuler_budget_row, v_rms_mps) },
    { "rms_curve_m", "m", "horizontal position error, rms over the runs", TIME,
      offsetof(schuler_budget_row, rms_curve_m) },
    { "rms_end_m", "m", "horizontal position error at the end, rms over the runs", SOURCE,
      offsetof(schuler_budget_row, rms_end_m) },
    { "rms_max_m", "m", "largest horizontal position error, rms over the runs", SOURCE,
      offsetof(schuler_budget_row, rms_max_m) },
    { "drift_cep_mps", "m s-1", "median of the drift over the runs", SOURCE,
      offsetof(schuler_budget_row, cep_mps) },
    { "drift_r95_mps", "m s-1", "95th percentile of the drift over the runs", SOURCE,
      offsetof(schuler_budget_row, r95_mps) },
    { "drift_rms_mps", "m s-1", "rms of the drift over the runs", SOURCE,
      offsetof(schuler_budget_row, rms_slope_mps) },
    { "share", "1", "share of the summed variance at the end; 0 for all and none", SOURCE,
      offsetof(schuler_budget_row, share) },
};
enum { OF_ROWS = sizeof(of_rows) / sizeof(of_rows[0]) };

/* The others, with numbers of their own. */
enum { NAME, RUNS, TIMES, DRAWN, COVARIANCE, TRACK_TIME, LAT, LON, HEIGHT, OTHERS };
static const struct {
    const char *name, *unit, *long_name;
    int type, count, dimensions[2];
} others[OTHERS] = {
    { "source_name", NULL, "name of the error source", NC_CHAR, 2, { SOURCE, LETTER } },
    { "run", "1", "number of the run", NC_INT, 1, { RUN } },
    { "time", "s", "time since the start of the mission", NC_DOUBLE, 1, { TIME } },
    { "drawn", "1", "1: depends on the run; 0: all runs are the same", NC_BYTE, 1, { SOURCE } },
    { "covariance_rms_curve_m",
      "m",
      "horizontal position error, rms by linear covariance",
      NC_DOUBLE,
      2,
      { SOURCE, TIME } },
    { "track_time", "s", "time since the start of the mission", NC_DOUBLE, 1, { TRACK } },
    { "track_lat_deg", "degrees_north", "true geodetic latitude, WGS84", NC_DOUBLE, 1, { TRACK } },
    { "track_lon_deg", "degrees_east", "true longitude, WGS84", NC_DOUBLE, 1, { TRACK } },
    { "track_height_m", "m", "true height above the WGS84 ellipsoid", NC_DOUBLE, 1, { TRACK } },
};

typedef struct {
    netcdf_library nc;
    const schuler_result *result;
    const schuler_covariance *linear;
    const char *command;
    size_t size[DIMENSIONS];
    int id, code; /* of the open file; the first error */
    int dimensions[DIMENSIONS], row_ids[OF_ROWS], ids[OTHERS];
    double *values; /* room for the longest dimension      */
} writer;

static void note(writer *w, int code)
{
    if (w->code == NC_NOERR) w->code = code;
}

static const schuler_budget_row *row_at(const schuler_result *r, size_t i)
{
    return i < r->row_count ? &r->rows[i] : i == r->row_count ? &r->all : &r->none;
}

static void put_text(writer *w, int variable, const char *name, const char *text)
{
    if (text) note(w, w->nc.put_att_text(w->id, variable, name, strlen(text), text));
}

static void put_count(writer *w, const char *name, uint64_t count)
{
    const unsigned long long number = count;
    note(w, w->nc.put_att_ulonglong(w->id, NC_GLOBAL, name, NC_UINT64, 1, &number));
}

static void put_provenance(writer *w)
{
    const schuler_scenario *const s = w->result->scenario;
    size_t length;
    put_text(w, NC_GLOBAL, "Conventions", "CF-1.8");
    put_text(w, NC_GLOBAL, "title", "Error budget of an inertial navigator");
    put_text(w, NC_GLOBAL, "format", SCHULER_RESULT_FORMAT);
    put_text(w, NC_GLOBAL, "schuler_version", SCHULER_VERSION);
    put_text(w, NC_GLOBAL, "command", w->command);
    put_count(w, "seed", s->seed);
    put_count(w, "runs", (uint64_t)w->result->runs);
    put_text(w, NC_GLOBAL, "scenario_name", s->name);
    put_text(w, NC_GLOBAL, "scenario_sha256", s->sha256);
    put_text(w, NC_GLOBAL, "scenario",
             s->document_count ? schuler_document_text(s->documents[0], &length) : "");
}

static void define(writer *w, int *id, const char *name, int type, int count, const int *dimensions,
                   const char *unit, const char *long_name)
{
    int where[2] = { 0 };
    for (int i = 0; i < count; i++) where[i] = w->dimensions[dimensions[i]];
    note(w, w->nc.def_var(w->id, name, type, count, where, id));
    if (w->code != NC_NOERR) return;
    put_text(w, *id, "units", unit);
    put_text(w, *id, "long_name", long_name);
    if (type != NC_CHAR && dimensions[0] == SOURCE) put_text(w, *id, "coordinates", "source_name");
}

static void define_all(writer *w)
{
    const double missing = (double)NAN;
    int before;
    note(w, w->nc.set_fill(w->id, NC_NOFILL, &before));
    put_provenance(w);
    for (int i = 0; i < DIMENSIONS; i++)
        note(w, w->nc.def_dim(w->id, dimension_names[i], w->size[i], &w->dimensions[i]));
    for (int i = 0; i < OTHERS && w->code == NC_NOERR; i++)
        define(w, &w->ids[i], others[i].name, others[i].type, others[i].count, others[i].dimensions,
               others[i].unit, others[i].long_name);
    for (int i = 0; i < OF_ROWS && w->code == NC_NOERR; i++) {
        const int along = of_rows[i].along, dimensions[] = { SOURCE, along };
        define(w, &w->row_ids[i], of_rows[i].name, NC_DOUBLE, along == SOURCE ? 1 : 2, dimensions,
               of_rows[i].unit, of_rows[i].long_name);
    }
    put_text(w, w->ids[NAME], "_Encoding",
             "utf-8"); /* which makes them texts, not bytes, in xarray */
    note(w, w->nc.put_att_double(w->id, w->ids[COVARIANCE], "_FillValue", NC_DOUBLE, 1, &missing));
    note(w, w->nc.enddef(w->id));
}

/* One row of a variable along source and another dimension, or all of one along that alone. */
static void put(writer *w, int variable, size_t source, int along, const double *values)
{
    const size_t start[2] = { source, 0 }, count[2] = { 1, w->size[along] };
    const int flat = along == SOURCE;
    if (w->code == NC_NOERR)
        note(w, w->nc.put_vara_double(w->id, variable, start, flat ? &count[0] : count, values));
}

static void put_whole(writer *w, int other, const double *values)
{
    const size_t start = 0;
    if (w->code == NC_NOERR)
        note(w, w->nc.put_vara_double(w->id, w->ids[other], &start,
                                      &w->size[others[other].dimensions[0]], values));
}

static void put_row(writer *w, size_t source)
{
    const schuler_budget_row *const row = row_at(w->result, source);
    const size_t start[2] = { source, 0 }, count[2] = { 1, w->size[LETTER] };
    char name[sizeof row->id] = "";
    memcpy(name, row->id, strlen(row->id));
    note(w, w->nc.put_vara_text(w->id, w->ids[NAME], start, count, name));
    const double drawn = row->drawn;
    put(w, w->ids[DRAWN], source, SOURCE, &drawn);
    for (int i = 0; i < OF_ROWS; i++) {
        const char *const member = (const char *)row + of_rows[i].offset;
        const double *values = (const double *)(const void *)member;
        if (of_rows[i].along != SOURCE) memcpy(&values, member, sizeof values);
        if (of_rows[i].along == RUN) {
            for (size_t k = 0; k < w->size[RUN]; k++) w->values[k] = values[row->runs > 1 ? k : 0];
            values = w->values;
        }
        put(w, w->row_ids[i], source, of_rows[i].along, values);
    }
}

static void put_covariance(writer *w, size_t source)
{
    const schuler_result *const r = w->result;
    const schuler_covariance_row *row = NULL;
    if (w->linear && w->linear->time_count == r->time_count)
        row = source == r->row_count ? &w->linear->total
                                     : schuler_covariance_find(w->linear, row_at(r, source)->id);
    const int covered = row && !row->uncovered && row->rms_curve_m;
    for (size_t k = 0; k < r->time_count; k++)
        w->values[k] = covered ? row->rms_curve_m[k] : (double)NAN;
    put(w, w->ids[COVARIANCE], source, TIME, w->values);
}

static double track_time(const writer *w, size_t k)
{
    return w->result->duration_s * ((double)k / (double)(w->size[TRACK] - 1));
}

static void put_track(writer *w)
{
    for (int other = TRACK_TIME; other <= HEIGHT; other++) {
        for (size_t k = 0; k < w->size[TRACK]; k++) {
            const double t_s = track_time(w, k);
            const schuler_llh at =
                schuler_llh_from_ecef(schuler_path_at(&w->result->scenario->path, t_s).r_e);
            w->values[k] = other == TRACK_TIME ? t_s
                           : other == LAT      ? at.lat_rad / SCHULER_RAD_PER_DEG
                           : other == LON      ? at.lon_rad / SCHULER_RAD_PER_DEG
                                               : at.h_m;
        }
        put_whole(w, other, w->values);
    }
}

static void put_all(writer *w)
{
    for (size_t k = 0; k < w->size[RUN]; k++) w->values[k] = (double)k;
    put_whole(w, RUNS, w->values);
    put_whole(w, TIMES, w->result->times_s);
    put_track(w);
    for (size_t i = 0; i < w->size[SOURCE] && w->code == NC_NOERR; i++) {
        put_row(w, i);
        put_covariance(w, i);
    }
}

schuler_status schuler_result_netcdf_usable(schuler_error *err)
{
    netcdf_library nc;
    return netcdf_library_load(&nc, err);
}

schuler_status schuler_result_netcdf_write(const char *path, const schuler_result *result,
                                           const schuler_covariance *linear, const char *command,
                                           schuler_error *err)
{
    const schuler_place place = { path, 0, 0, 0 };
    writer w = { .result = result, .linear = linear, .command = command };
    w.size[SOURCE] = result->row_count + 2;
    w.size[RUN] = (size_t)result->runs;
    w.size[TIME] = result->time_count;
    w.size[TRACK] = result->steps + 1 < SCHULER_RESULT_TRACK_MAX ? (size_t)result->steps + 1
                                                                 : SCHULER_RESULT_TRACK_MAX;
    w.size[LETTER] = sizeof result->all.id;
    size_t longest = 0;
    for (int i = 0; i < DIMENSIONS; i++)
        if (w.size[i] > longest) longest = w.size[i];
    schuler_status status = netcdf_library_load(&w.nc, err);
    if (status != SCHULER_OK) return status;
    w.values = calloc(longest, sizeof *w.values);
    if (!w.values) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    w.code = w.nc.create(path, NC_NETCDF4 | NC_CLOBBER, &w.id);
    if (w.code == NC_NOERR) {
        define_all(&w);
        if (w.code == NC_NOERR) put_all(&w);
        note(&w, w.nc.close(w.id));
    }
    free(w.values);
    if (w.code == NC_NOERR) return SCHULER_OK;
    return schuler_fail(err, SCHULER_ERR_FILE, &place, "%s", w.nc.strerror(w.code));
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/result_file.h"
#include "scenarios/netcdf_library.h"
#include "scenarios/result_netcdf.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS_MAX = 100000, TEXT_MAX = 1 << 24 };
enum { SOURCE, RUN, TRACK, LETTER, DIMENSIONS };
static const struct {
    const char *name;
    size_t least, most;
} limits[DIMENSIONS] = { { "source", 1, SCHULER_RESULT_SOURCES_MAX },
                         { "run", 1, RUNS_MAX },
                         { "track", 2, SCHULER_RESULT_TRACK_MAX },
                         { "letter", 1, SCHULER_RESULT_NAME_MAX } };

typedef struct {
    netcdf_library nc;
    schuler_place place;
    schuler_error *err;
    int id, dimensions[DIMENSIONS];
    size_t size[DIMENSIONS];
} reader;

static schuler_status broken(const reader *r, const char *name, const char *how)
{
    return schuler_fail(r->err, SCHULER_ERR_INPUT, &r->place, "'%s' %s", name, how);
}

static schuler_status out_of_memory(const reader *r)
{
    return schuler_fail(r->err, SCHULER_ERR_MEMORY, NULL, "out of memory");
}

static schuler_status read_text(const reader *r, const char *name, char **out)
{
    nc_type type;
    size_t length;
    if (r->nc.inq_att(r->id, NC_GLOBAL, name, &type, &length) != NC_NOERR || type != NC_CHAR ||
        length > TEXT_MAX)
        return broken(r, name, "is no attribute of text here: this is no result of schuler run");
    *out = calloc(length + 1, 1);
    if (!*out) return out_of_memory(r);
    if (length > 0 && r->nc.get_att_text(r->id, NC_GLOBAL, name, *out) != NC_NOERR)
        return broken(r, name, "cannot be read");
    return SCHULER_OK;
}

static schuler_status check_format(const reader *r)
{
    char *format = NULL;
    schuler_status status = read_text(r, "format", &format);
    if (status == SCHULER_OK && strcmp(format, SCHULER_RESULT_FORMAT) != 0)
        status = schuler_fail(r->err, SCHULER_ERR_INPUT, &r->place,
                              "the format is '%.40s', not " SCHULER_RESULT_FORMAT, format);
    free(format);
    return status;
}

static schuler_status read_dimensions(reader *r)
{
    for (int i = 0; i < DIMENSIONS; i++) {
        const char *const name = limits[i].name;
        if (r->nc.inq_dimid(r->id, name, &r->dimensions[i]) != NC_NOERR ||
            r->nc.inq_dimlen(r->id, r->dimensions[i], &r->size[i]) != NC_NOERR)
            return broken(r, name, "is no dimension here");
        if (r->size[i] < limits[i].least || r->size[i] > limits[i].most)
            return schuler_fail(r->err, SCHULER_ERR_INPUT, &r->place,
                                "dimension '%s' has %zu entries; allowed: %zu to %zu", name,
                                r->size[i], limits[i].least, limits[i].most);
    }
    return SCHULER_OK;
}

/* A variable along one or two dimensions (second -1: one). */
static schuler_status find(const reader *r, const char *name, int first, int second, int *variable)
{
    int count, where[NC_MAX_VAR_DIMS];
    if (r->nc.inq_varid(r->id, name, variable) != NC_NOERR)
        return broken(r, name, "is no variable here");
    if (r->nc.inq_varndims(r->id, *variable, &count) != NC_NOERR || count != (second < 0 ? 1 : 2) ||
        r->nc.inq_vardimid(r->id, *variable, where) != NC_NOERR ||
        where[0] != r->dimensions[first] || (second >= 0 && where[1] != r->dimensions[second]))
        return broken(r, name, "is along other dimensions than a result's");
    return SCHULER_OK;
}

static schuler_status read_numbers(const reader *r, const char *name, int first, int second,
                                   double most, double **out)
{
    const size_t start[2] = { 0, 0 };
    const size_t count[2] = { r->size[first], second < 0 ? 1 : r->size[second] };
    int variable;
    const schuler_status status = find(r, name, first, second, &variable);
    if (status != SCHULER_OK) return status;
    *out = calloc(count[0] * count[1], sizeof **out);
    if (!*out) return out_of_memory(r);
    if (r->nc.get_vara_double(r->id, variable, start, count, *out) != NC_NOERR)
        return broken(r, name, "cannot be read as numbers");
    for (size_t i = 0; i < count[0] * count[1]; i++)
        if (!(fabs((*out)[i]) <= most)) /* also what is not a number */
            return schuler_fail(r->err, SCHULER_ERR_INPUT, &r->place,
                                "'%s' holds %g; allowed: up to %g", name, (*out)[i], most);
    return SCHULER_OK;
}

static schuler_status read_names(const reader *r, schuler_result_file *out)
{
    int variable;
    const schuler_status status = find(r, "source_name", SOURCE, LETTER, &variable);
    if (status != SCHULER_OK) return status;
    out->names = calloc(r->size[SOURCE], sizeof *out->names);
    if (!out->names) return out_of_memory(r);
    for (size_t i = 0; i < r->size[SOURCE]; i++) {
        const size_t start[2] = { i, 0 }, count[2] = { 1, r->size[LETTER] };
        if (r->nc.get_vara_text(r->id, variable, start, count, out->names[i]) != NC_NOERR)
            return broken(r, "source_name", "cannot be read as text");
        out->names[i][SCHULER_RESULT_NAME_MAX - 1] = '\0';
    }
    return SCHULER_OK;
}

static schuler_status read_all(reader *r, schuler_result_file *out)
{
    enum {
        ANY_M = 100000000
    }; /* nothing on earth is farther away, and no drift or speed as large */
    const struct {
        const char *name;
        int first, second;
        double most;
        double **to;
    } numbers[] = { { "end_m", SOURCE, RUN, ANY_M, &out->end_m },
                    { "max_m", SOURCE, RUN, ANY_M, &out->max_m },
                    { "slope_mps", SOURCE, RUN, ANY_M, &out->slope_mps },
                    { "velocity_rms_mps", SOURCE, RUN, ANY_M, &out->velocity_rms_mps },
                    { "track_lat_deg", TRACK, -1, 90.0, &out->lat_deg },
                    { "track_lon_deg", TRACK, -1, 180.0, &out->lon_deg },
                    { "track_height_m", TRACK, -1, ANY_M, &out->height_m } };
    schuler_status status = check_format(r);
    if (status == SCHULER_OK) status = read_text(r, "scenario_name", &out->scenario_name);
    if (status == SCHULER_OK) status = read_text(r, "scenario_sha256", &out->scenario_sha256);
    if (status == SCHULER_OK) status = read_text(r, "schuler_version", &out->version);
    if (status == SCHULER_OK) status = read_dimensions(r);
    if (status == SCHULER_OK) status = read_names(r, out);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0] && status == SCHULER_OK; i++)
        status = read_numbers(r, numbers[i].name, numbers[i].first, numbers[i].second,
                              numbers[i].most, numbers[i].to);
    out->source_count = r->size[SOURCE];
    out->run_count = r->size[RUN];
    out->track_count = r->size[TRACK];
    if (status == SCHULER_OK && schuler_result_file_find(out, "all") < 0)
        status = broken(r, "source_name", "has no source 'all'");
    return status;
}

schuler_status schuler_result_file_read(schuler_result_file *out, const char *path,
                                        schuler_error *err)
{
    reader r = { .place = { path, 0, 0, 0 }, .err = err };
    *out = (schuler_result_file){ 0 };
    schuler_status status = netcdf_library_load(&r.nc, err);
    if (status != SCHULER_OK) return status;
    const int code = r.nc.open(path, NC_NOWRITE, &r.id);
    if (code != NC_NOERR)
        return schuler_fail(err, SCHULER_ERR_INPUT, &r.place, "cannot be read: %s",
                            r.nc.strerror(code));
    status = read_all(&r, out);
    r.nc.close(r.id);
    if (status != SCHULER_OK) schuler_result_file_free(out);
    return status;
}

void schuler_result_file_free(schuler_result_file *f)
{
    free(f->scenario_name);
    free(f->scenario_sha256);
    free(f->version);
    free(f->names);
    free(f->end_m);
    free(f->max_m);
    free(f->slope_mps);
    free(f->velocity_rms_mps);
    free(f->lat_deg);
    free(f->lon_deg);
    free(f->height_m);
    *f = (schuler_result_file){ 0 };
}

int schuler_result_file_find(const schuler_result_file *f, const char *name)
{
    for (size_t i = 0; i < f->source_count; i++)
        if (strcmp(f->names[i], name) == 0) return (int)i;
    return -1;
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/netcdf_rows.h"
#include "scenarios/csv.h"
#include "scenarios/netcdf_library.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_HELD = 4096 };

struct netcdf_rows {
    netcdf_library nc;
    const char *path, *header;
    int id, columns;
    int ids[SCHULER_CSV_COLUMNS_MAX];
    size_t rows, read; /* in the file, handed out */
    size_t first, held;
    double values[SCHULER_CSV_COLUMNS_MAX][ROWS_HELD];
};

/* The name of a column. */
static const char *name_of(const netcdf_rows *r, int column, int *length)
{
    const char *name = r->header;
    for (; column > 0; column--) name += strcspn(name, ",") + 1;
    *length = (int)strcspn(name, ",");
    return name;
}

static schuler_status find_column(netcdf_rows *r, int column, int *dimension, schuler_error *err)
{
    const schuler_place place = { r->path, 0, 0, 0 };
    char name[NC_MAX_NAME + 1];
    int length, dimensions, along;
    const char *const start = name_of(r, column, &length);
    snprintf(name, sizeof name, "%.*s", length, start);
    if (r->nc.inq_varid(r->id, name, &r->ids[column]) != NC_NOERR)
        return schuler_fail(err, SCHULER_ERR_INPUT, &place,
                            "there is no variable '%s'; there must be %s", name, r->header);
    if (r->nc.inq_varndims(r->id, r->ids[column], &dimensions) != NC_NOERR || dimensions != 1 ||
        r->nc.inq_vardimid(r->id, r->ids[column], &along) != NC_NOERR ||
        (column > 0 && along != *dimension))
        return schuler_fail(err, SCHULER_ERR_INPUT, &place,
                            "variable '%s' is not along the one dimension of the others", name);
    *dimension = along;
    return SCHULER_OK;
}

schuler_status netcdf_rows_open(netcdf_rows **out, const char *path, const char *header,
                                schuler_error *err)
{
    const schuler_place place = { path, 0, 0, 0 };
    netcdf_rows *const r = calloc(1, sizeof *r);
    if (!r) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    r->path = path;
    r->header = header;
    r->id = -1;
    schuler_status status = netcdf_library_load(&r->nc, err);
    if (status == SCHULER_OK) {
        const int code = r->nc.open(path, NC_NOWRITE, &r->id);
        if (code != NC_NOERR) {
            r->id = -1;
            status = schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be read: %s",
                                  r->nc.strerror(code));
        }
    }
    int dimension = 0;
    for (const char *p = header; status == SCHULER_OK && p; r->columns++) {
        status = find_column(r, r->columns, &dimension, err);
        p = strchr(p, ',');
        if (p) p++;
    }
    if (status == SCHULER_OK && r->nc.inq_dimlen(r->id, dimension, &r->rows) != NC_NOERR)
        status = schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be read");
    if (status == SCHULER_OK)
        *out = r;
    else
        netcdf_rows_close(r);
    return status;
}

void netcdf_rows_close(netcdf_rows *r)
{
    if (!r) return;
    if (r->id >= 0) r->nc.close(r->id);
    free(r);
}

static schuler_status fetch(netcdf_rows *r, schuler_error *err)
{
    const schuler_place place = { r->path, 0, 0, 0 };
    const size_t left = r->rows - r->read, count = left < ROWS_HELD ? left : ROWS_HELD;
    r->first = r->read;
    r->held = count;
    for (int i = 0; i < r->columns; i++) {
        const int code = r->nc.get_vara_double(r->id, r->ids[i], &r->first, &count, r->values[i]);
        if (code != NC_NOERR)
            return schuler_fail(err, SCHULER_ERR_FILE, &place, "cannot be read: %s",
                                r->nc.strerror(code));
    }
    return SCHULER_OK;
}

schuler_status netcdf_rows_next(netcdf_rows *r, double *values, int *got, schuler_error *err)
{
    *got = r->read < r->rows;
    if (!*got) return SCHULER_OK;
    if (r->read == r->first + r->held) {
        const schuler_status status = fetch(r, err);
        if (status != SCHULER_OK) return status;
    }
    const size_t at = r->read++ - r->first;
    for (int i = 0; i < r->columns; i++) {
        values[i] = r->values[i][at];
        if (isfinite(values[i])) continue;
        const schuler_place place = { r->path, netcdf_rows_number(r), 0, 0 };
        int length;
        const char *const name = name_of(r, i, &length);
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "'%.*s' is not a finite number", length,
                            name);
    }
    return SCHULER_OK;
}

int netcdf_rows_number(const netcdf_rows *r)
{
    return (int)r->read;
}

double netcdf_rows_fraction(const netcdf_rows *r)
{
    return r->rows > 0 ? (double)r->read / (double)r->rows : 0.0;
}

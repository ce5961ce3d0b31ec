/* SPDX-License-Identifier: MIT */
#include "scenarios/netcdf.h"
#include "scenarios/netcdf_library.h"
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 16, ROWS_HELD = 8192 }; /* a megabyte of the widest table */

struct schuler_netcdf {
    netcdf_library nc;
    const schuler_table *table;
    const char *path;      /* borrowed */
    int id;                /* of the open file; -1: none   */
    int ids[COLUMNS_MAX];  /* of the variables             */
    int64_t rows, written; /* announced, in the file       */
    int held;              /* in `values`, not yet written */
    int code;              /* the first error              */
    double values[COLUMNS_MAX][ROWS_HELD];
};

int schuler_netcdf_named(const char *path)
{
    const size_t length = strlen(path);
    return length > 3 && strcmp(path + length - 3, ".nc") == 0;
}

/* The first error stays. */
static void note(schuler_netcdf *f, int code)
{
    if (f->code == NC_NOERR) f->code = code;
}

static schuler_status fail(const schuler_netcdf *f, schuler_error *err)
{
    const schuler_place place = { f->path, 0, 0, 0 };
    return schuler_fail(err, SCHULER_ERR_FILE, &place, "%s", f->nc.strerror(f->code));
}

static void put_text(schuler_netcdf *f, int variable, const char *name, const char *text)
{
    note(f, f->nc.put_att_text(f->id, variable, name, strlen(text), text));
}

static void define(schuler_netcdf *f, const schuler_netcdf_attribute *attributes, int count)
{
    const schuler_column *const columns = f->table->columns;
    int dimension, before;
    note(f, f->nc.set_fill(f->id, NC_NOFILL, &before));
    put_text(f, NC_GLOBAL, "title", f->table->title);
    for (int i = 0; i < count; i++) {
        const schuler_netcdf_attribute *const a = &attributes[i];
        const unsigned long long number = a->number;
        if (a->text)
            put_text(f, NC_GLOBAL, a->name, a->text);
        else
            note(f, f->nc.put_att_ulonglong(f->id, NC_GLOBAL, a->name, NC_UINT64, 1, &number));
    }
    /* A dimension of the first column's name makes that one the coordinate of the others. */
    note(f, f->nc.def_dim(f->id, columns[0].name, (size_t)f->rows, &dimension));
    for (int i = 0; i < f->table->count && f->code == NC_NOERR; i++) {
        note(f, f->nc.def_var(f->id, columns[i].name, NC_DOUBLE, 1, &dimension, &f->ids[i]));
        put_text(f, f->ids[i], "units", columns[i].unit);
        put_text(f, f->ids[i], "long_name", columns[i].long_name);
    }
    note(f, f->nc.enddef(f->id));
}

schuler_status schuler_netcdf_create(schuler_netcdf **out, const char *path,
                                     const schuler_table *table, int64_t rows,
                                     const schuler_netcdf_attribute *attributes, int count,
                                     schuler_error *err)
{
    schuler_netcdf *const f = calloc(1, sizeof *f);
    if (!f || table->count > COLUMNS_MAX) {
        free(f);
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    }
    f->table = table;
    f->path = path;
    f->rows = rows;
    f->id = -1;
    schuler_status status = netcdf_library_load(&f->nc, err);
    if (status == SCHULER_OK) {
        f->code = f->nc.create(path, NC_NETCDF4 | NC_CLOBBER, &f->id);
        if (f->code == NC_NOERR)
            define(f, attributes, count);
        else
            f->id = -1;
        if (f->code != NC_NOERR) status = fail(f, err);
    }
    if (status == SCHULER_OK)
        *out = f;
    else
        schuler_netcdf_close(f, NULL);
    return status;
}

static void flush(schuler_netcdf *f)
{
    const size_t from = (size_t)f->written, count = (size_t)f->held;
    for (int i = 0; i < f->table->count && f->code == NC_NOERR && count > 0; i++)
        note(f, f->nc.put_vara_double(f->id, f->ids[i], &from, &count, f->values[i]));
    f->written += f->held;
    f->held = 0;
}

void schuler_netcdf_put(schuler_netcdf *f, const double *values)
{
    for (int i = 0; i < f->table->count; i++) f->values[i][f->held] = values[i];
    if (++f->held == ROWS_HELD) flush(f);
}

int schuler_netcdf_failed(const schuler_netcdf *f)
{
    return f->code != NC_NOERR;
}

schuler_status schuler_netcdf_close(schuler_netcdf *f, schuler_error *err)
{
    schuler_status status = SCHULER_OK;
    if (!f) return SCHULER_OK;
    if (f->id >= 0) {
        flush(f);
        note(f, f->nc.close(f->id));
        if (f->code != NC_NOERR) status = fail(f, err);
        if (status == SCHULER_OK && f->written != f->rows) {
            const schuler_place place = { f->path, 0, 0, 0 };
            status = schuler_fail(err, SCHULER_ERR_FILE, &place, "%lld rows of %lld written",
                                  (long long)f->written, (long long)f->rows);
        }
    }
    free(f);
    return status;
}

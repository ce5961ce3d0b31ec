/* SPDX-License-Identifier: MIT */
#include "tools/data_file.h"
#include "scenarios/trajectory_file.h"
#include "tools/messages.h"
#include <string.h>
#include <sys/stat.h>

static void put_header(const data_file *d)
{
    for (int i = 0; i < d->table->count; i++)
        fprintf(d->file.file, "%s%s", i > 0 ? "," : "", d->table->columns[i].name);
    fputc('\n', d->file.file);
}

exit_code data_file_open(data_file *d, const char *path, const schuler_table *table, int64_t rows,
                         const schuler_netcdf_attribute *attributes, int count)
{
    const bool netcdf = schuler_netcdf_named(path);
    struct stat info;
    *d = (data_file){ .table = table };
    /* A device or a pipe cannot hold such a file. */
    if (netcdf && stat(path, &info) == 0 && !S_ISREG(info.st_mode))
        return say_bad_input("%s: NetCDF needs a regular file", path);
    const exit_code code = outfile_open(&d->file, path);
    if (code != EXIT_DONE) return code;
    if (!netcdf) {
        put_header(d);
        return EXIT_DONE;
    }
    schuler_error error = { 0 };
    if (schuler_netcdf_create(&d->netcdf, d->file.partial, table, rows, attributes, count,
                              &error) == SCHULER_OK)
        return EXIT_DONE;
    return say_failure("cannot write %s: %s", path, error.message);
}

void data_file_put(data_file *d, const double *values)
{
    char line[16 * 32];
    if (d->netcdf)
        schuler_netcdf_put(d->netcdf, values);
    else if (d->file.file)
        fwrite(line, 1, schuler_values_line(line, values, d->table->count), d->file.file);
}

bool data_file_failed(const data_file *d)
{
    return d->netcdf ? schuler_netcdf_failed(d->netcdf) : d->file.file && ferror(d->file.file);
}

exit_code data_file_complete(data_file *d)
{
    if (d->netcdf) {
        schuler_error error = { 0 };
        const schuler_status status = schuler_netcdf_close(d->netcdf, &error);
        d->netcdf = NULL;
        if (status != SCHULER_OK)
            return say_failure("cannot write %s: %s (%s)", d->file.target,
                               strerror(outfile_reason(&d->file)), error.message);
    }
    return outfile_complete(&d->file);
}

exit_code data_file_publish(data_file *d)
{
    const exit_code code = data_file_complete(d);
    return code == EXIT_DONE ? outfile_publish(&d->file) : code;
}

void data_file_drop(data_file *d)
{
    schuler_netcdf_close(d->netcdf, NULL);
    outfile_drop(&d->file);
    *d = (data_file){ 0 };
}

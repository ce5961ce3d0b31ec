/* SPDX-License-Identifier: MIT */
#include "scenarios/netcdf_library.h"
#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

static const struct {
    const char *name;
    size_t offset;
} functions[] = {
    { "nc_strerror", offsetof(netcdf_library, strerror) },
    { "nc_create", offsetof(netcdf_library, create) },
    { "nc_set_fill", offsetof(netcdf_library, set_fill) },
    { "nc_def_dim", offsetof(netcdf_library, def_dim) },
    { "nc_def_var", offsetof(netcdf_library, def_var) },
    { "nc_put_att_text", offsetof(netcdf_library, put_att_text) },
    { "nc_put_att_double", offsetof(netcdf_library, put_att_double) },
    { "nc_put_att_ulonglong", offsetof(netcdf_library, put_att_ulonglong) },
    { "nc_enddef", offsetof(netcdf_library, enddef) },
    { "nc_put_vara_double", offsetof(netcdf_library, put_vara_double) },
    { "nc_put_vara_text", offsetof(netcdf_library, put_vara_text) },
    { "nc_open", offsetof(netcdf_library, open) },
    { "nc_inq_att", offsetof(netcdf_library, inq_att) },
    { "nc_get_att_text", offsetof(netcdf_library, get_att_text) },
    { "nc_inq_dimid", offsetof(netcdf_library, inq_dimid) },
    { "nc_inq_varid", offsetof(netcdf_library, inq_varid) },
    { "nc_inq_varndims", offsetof(netcdf_library, inq_varndims) },
    { "nc_inq_vardimid", offsetof(netcdf_library, inq_vardimid) },
    { "nc_inq_dimlen", offsetof(netcdf_library, inq_dimlen) },
    { "nc_get_vara_double", offsetof(netcdf_library, get_vara_double) },
    { "nc_get_vara_text", offsetof(netcdf_library, get_vara_text) },
    { "nc_close", offsetof(netcdf_library, close) },
};

/* Never unloaded: libraries below it leave things behind that must not lose their code. */
schuler_status netcdf_library_load(netcdf_library *out, schuler_error *err)
{
    void *const handle = dlopen(SCHULER_NETCDF_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (!handle)
        return schuler_fail(err, SCHULER_ERR_FILE, NULL,
                            "NetCDF files need the library " SCHULER_NETCDF_LIBRARY ": %s",
                            dlerror());
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        void *const function = dlsym(handle, functions[i].name);
        if (!function)
            return schuler_fail(err, SCHULER_ERR_FILE, NULL,
                                SCHULER_NETCDF_LIBRARY " has no function %s", functions[i].name);
        memcpy((char *)out + functions[i].offset, &function, sizeof function);
    }
    return SCHULER_OK;
}

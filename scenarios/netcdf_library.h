/* SPDX-License-Identifier: MIT */
/* The NetCDF library, loaded when it is needed: linked, it would cost every start of every program some
 * ten milliseconds. */
#ifndef SCHULER_SCENARIOS_NETCDF_LIBRARY_H
#define SCHULER_SCENARIOS_NETCDF_LIBRARY_H

#include "core/error.h"
#include <netcdf.h>

typedef struct {
    __typeof__(nc_strerror) *strerror;
    __typeof__(nc_create) *create;
    __typeof__(nc_set_fill) *set_fill;
    __typeof__(nc_def_dim) *def_dim;
    __typeof__(nc_def_var) *def_var;
    __typeof__(nc_put_att_text) *put_att_text;
    __typeof__(nc_put_att_double) *put_att_double;
    __typeof__(nc_put_att_ulonglong) *put_att_ulonglong;
    __typeof__(nc_enddef) *enddef;
    __typeof__(nc_put_vara_double) *put_vara_double;
    __typeof__(nc_put_vara_text) *put_vara_text;
    __typeof__(nc_open) *open;
    __typeof__(nc_inq_att) *inq_att;
    __typeof__(nc_get_att_text) *get_att_text;
    __typeof__(nc_inq_dimid) *inq_dimid;
    __typeof__(nc_inq_varid) *inq_varid;
    __typeof__(nc_inq_varndims) *inq_varndims;
    __typeof__(nc_inq_vardimid) *inq_vardimid;
    __typeof__(nc_inq_dimlen) *inq_dimlen;
    __typeof__(nc_get_vara_double) *get_vara_double;
    __typeof__(nc_get_vara_text) *get_vara_text;
    __typeof__(nc_close) *close;
} netcdf_library;

/** Errors   SCHULER_ERR_FILE: it is not there, or lacks a function */
SCHULER_NODISCARD schuler_status netcdf_library_load(netcdf_library *out, schuler_error *err);

#endif

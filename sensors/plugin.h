/* SPDX-License-Identifier: MIT */
/* For the file of a plug-in: error models in a shared object of their own, in the very form that
 * the models of sensors/models/ have, for one lane. After the tables of its models it says
 *
 *     SCHULER_PLUGIN(&MODEL_NAME(mine));
 *
 * and is compiled with -shared -fPIC -ffp-contract=off (a fused multiply-add rounds otherwise). */
#ifndef SCHULER_SENSORS_PLUGIN_H
#define SCHULER_SENSORS_PLUGIN_H

#include "core/version.h"
#include "sensors/model.h"
#include "sensors/params.h"

enum { SCHULER_PLUGIN_NUMBERS = 1000 }; /* source numbers of a plug-in's own keys begin here */

/* What the program looks for; nothing behind `api` is looked at unless that is its own. */
typedef struct {
    int api;                                   /* SCHULER_MODEL_API when it was compiled */
    const char *version;                       /* of schuler then                        */
    const schuler_sensor_model *const *models; /* NULL-terminated                        */
} schuler_plugin_table;

#ifdef __cplusplus
#define SCHULER_PLUGIN_LINKAGE extern "C"
#else
#define SCHULER_PLUGIN_LINKAGE extern
#endif

#define SCHULER_PLUGIN(...)                                                                        \
    static const schuler_sensor_model *const schuler_plugin_models[] = { __VA_ARGS__, NULL };      \
    SCHULER_PLUGIN_LINKAGE __attribute__((visibility("default")))                                  \
    const schuler_plugin_table schuler_plugin;                                                     \
    const schuler_plugin_table schuler_plugin = { SCHULER_MODEL_API, SCHULER_VERSION_TEXT,         \
                                                  schuler_plugin_models }

#endif

/* SPDX-License-Identifier: MIT */
/* Everything pluggable, as `schuler models` shows it. */
#ifndef SCHULER_TOOLS_REGISTRY_H
#define SCHULER_TOOLS_REGISTRY_H

#include "sensors/plugins.h"
#include "tools/json.h"
#include <stdbool.h>
#include <stdio.h>

/* What has no table of the library: gravity models, and keys that say another one in the words of
 * data sheets. Both end with name NULL. */
typedef struct {
    const char *name, *summary, *source;
} registry_entry;

extern const registry_entry registry_gravities[], registry_spellings[];

/** Whether a stage changes what comes through (bandwidth, quantization); else it adds an error. */
bool registry_is_response(const schuler_sensor_model *stage);
/** "constant", "white", ...: how an error acts. */
const char *registry_acts(schuler_acts acts);
/** The stage of that name, or the one that has a parameter of that key; NULL: none. */
const schuler_sensor_model *registry_stage(const char *name);

void registry_list(FILE *out, const schuler_plugins *plugins);
/** false: there is nothing of that name. */
bool registry_show(FILE *out, const char *name, const schuler_plugins *plugins);
/** Says so, with what is near or known. */
exit_code registry_unknown(const char *name, const schuler_plugins *plugins);
/** Format schuler-models-1; owned by the caller, NULL when out of memory. */
json_t *registry_json(const schuler_plugins *plugins);

#endif

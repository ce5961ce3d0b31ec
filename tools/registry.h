/* SPDX-License-Identifier: MIT */
/* Everything pluggable, as `schuler models` shows it. */
#ifndef SCHULER_TOOLS_REGISTRY_H
#define SCHULER_TOOLS_REGISTRY_H

#include "sensors/plugins.h"
#include "tools/json.h"
#include <stdbool.h>
#include <stdio.h>

/* What has no table of the library: keys that say another one in the words of data sheets. Ends with
 * name NULL. */
typedef struct {
    const char *name, *summary, *source;
} registry_entry;

extern const registry_entry registry_spellings[];

/** A row of a list; the head of what 'show' prints. */
void registry_row(FILE *out, const char *name, const char *summary);
void registry_head(FILE *out, const char *what, const char *name, const char *summary,
                   const char *source);

/* Gravity models: those that are built in, those that are known and those that are installed. The
 * last four are as those below. */
enum { REGISTRY_GRAVITIES_MAX = 64 };
typedef struct {
    char names[REGISTRY_GRAVITIES_MAX][65];
    int count;
} registry_gravity_names;
void registry_gravity_known(registry_gravity_names *out);
void registry_gravity_list(FILE *out);
bool registry_gravity_show(FILE *out, const char *name);
json_t *registry_gravity_json(void);

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

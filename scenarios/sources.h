/* SPDX-License-Identifier: MIT */
/* The error sources of a scenario: what each is, and what it is worth in one run. */
#ifndef SCHULER_SCENARIOS_SOURCES_H
#define SCHULER_SCENARIOS_SOURCES_H

#include "scenarios/scenario.h"

typedef enum {
    SOURCE_SENSOR,
    SOURCE_POSITION,
    SOURCE_VELOCITY,
    SOURCE_TILT,
    SOURCE_HEADING,
    SOURCE_GRAVITY,
    SOURCE_BARO,
} source_kind;

typedef struct {
    source_kind kind;
    char id[64], group[16];
    schuler_instrument instrument; /* SOURCE_SENSOR: whose parameter */
    int param;                     /* SOURCE_SENSOR; SOURCE_BARO: a schuler_baro_error */
    unsigned number;               /* in the random key; 0 for gravity, which draws nothing */
    int components;
    int64_t unit;               /* the specimen that flies; -1 = another in each run */
    const schuler_value *value; /* NULL for gravity */
    bool drawn;                 /* differs from run to run */
    int normals;                /* random numbers a step, for balancing work */
} error_source;

enum { SOURCES_MAX = 2 * SCHULER_PARAMS_MAX + 8 + SCHULER_BARO_ERRORS };

/** The sources that act in a scenario: given, not zero, and let through by errors.only and
 *  errors.without (ids or group names).
 *  Returned   out, at most SOURCES_MAX;  count */
int schuler_sources_list(const schuler_scenario *s, error_source out[SOURCES_MAX]);

/** Its key in the scenario's `baro`. */
const char *schuler_baro_key(schuler_baro_error error);

/** Those of an IMU alone. */
int schuler_sources_of_imu(const schuler_imu *imu, const schuler_text_list *only,
                           const schuler_text_list *without, error_source out[SOURCES_MAX]);

/** true when errors.only / errors.without let this id or group through. */
bool schuler_source_selected(const schuler_scenario *s, const char *id, const char *group);

/** One component of a source's value in one run, SI. A pure function of its arguments. */
double schuler_source_draw(const error_source *source, int component, uint64_t seed, uint64_t run);

#endif

/* SPDX-License-Identifier: MIT */
/* What the readers of objects and of values share. Private to core and the scenario reader. */
#ifndef SCHULER_CORE_SCHEMA_PRIVATE_H
#define SCHULER_CORE_SCHEMA_PRIVATE_H

#include "core/schema.h"

/* One reading. An out-of-memory is said once and then only remembered. */
typedef struct {
    schuler_arena *arena;
    schuler_diagnostics *d;
    bool memory_failed;
    const struct schuler_plugins *plugins; /* for the reader of sensors: only passed on here */
} schuler_reading;

void *schuler_reading_alloc(schuler_reading *r, size_t size);
/** A path for messages: "imu.gyro" and "bias" give "imu.gyro.bias"; "" and "imu" give "imu". */
const char *schuler_reading_path(schuler_reading *r, const char *what, const char *key);
const char *schuler_reading_index(schuler_reading *r, const char *what, size_t index);

/** The text of a scalar node; otherwise NULL after "WHAT: WANTED is expected, found a list". */
const char *schuler_read_scalar(schuler_reading *r, const schuler_node *node, const char *what,
                                const char *wanted);

/** "WHAT: WANTED is expected, found ..." at the node. */
void schuler_expected(schuler_reading *r, const schuler_node *node, const char *what,
                      const char *wanted);

/** Where a message about a whole map points: at the key in front of it. */
const schuler_place *schuler_node_place(const schuler_node *node);

/** "unknown KIND 'x'..." with the nearest of the known names, or all of them.
 *  Given      lead   the sentence up to the suggestion, without end mark */
void schuler_diagnose_unknown(schuler_reading *r, const schuler_place *place, const char *lead,
                              const char *written, const char *const *known, size_t count);

/** One quantity or plain number of a field: unit, dimension and range checked.
 *  Returned   false after an error */
bool schuler_read_quantity(schuler_reading *r, const schuler_node *node, const char *what,
                           const schuler_field *field, double *si);
/** A schuler_value of the field. */
bool schuler_read_value(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *field, schuler_value *out);

#endif

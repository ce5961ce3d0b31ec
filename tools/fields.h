/* SPDX-License-Identifier: MIT */
/* Keys of scenario files, printed from the tables that read them. */
#ifndef SCHULER_TOOLS_FIELDS_H
#define SCHULER_TOOLS_FIELDS_H

#include "core/schema.h"
#include <stdio.h>

/** All keys of an object and of the objects in it. */
void fields_print(FILE *out, const schuler_object *object, int indent);

/* Parts of it, for parameters of sensor models: the line "key: example"; what it means; the name of
 * its dimension; "; from A to B UNIT" and "; default A UNIT". */
void fields_key(FILE *out, int indent, const char *key, const char *example);
void fields_doc(FILE *out, int indent, const char *doc);
enum { FIELDS_UNIT_MAX = 64 };
/** The SI unit of a dimension, such as "m/s^2", "s^2/m" or "1/K"; "" for a plain number. */
const char *fields_si_unit(schuler_dim dim, char text[FIELDS_UNIT_MAX]);
void fields_unit(FILE *out, schuler_dim dim);
void fields_range(FILE *out, double min, double max, schuler_dim dim);
void fields_default(FILE *out, double def, schuler_dim dim);

#endif

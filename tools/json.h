/* SPDX-License-Identifier: MIT */
/* The little that jansson leaves to its users. */
#ifndef SCHULER_TOOLS_JSON_H
#define SCHULER_TOOLS_JSON_H

#include "core/error.h"
#include "tools/verbs.h"
#include <jansson.h>
#include <stdio.h>

/** A number with all its digits; null when it is infinite or not a number. */
json_t *json_of_number(double x);
/** A text; what is not UTF-8 in it becomes '?'. NULL gives null. */
json_t *json_of_text(const char *text);
/** One error or warning with its place. */
json_t *json_of_error(const schuler_error *error);

/** Write and free a document (NULL counts as out of memory). Path "-" is standard output. Says
 * errors. */
exit_code json_write(json_t *root, const char *path);
/** The same to a stream that is checked by its owner; frees root. */
exit_code json_put(json_t *root, FILE *out);

#endif

/* SPDX-License-Identifier: MIT */
/* A YAML text as a tree of nodes that know their place. All scalars stay text: the schema decides
 * what they are, so `no`, `1e3` and `012` mean nothing special. */
#ifndef SCHULER_CORE_DOCUMENT_H
#define SCHULER_CORE_DOCUMENT_H

#include "core/error.h"

SCHULER_BEGIN_C

typedef enum { SCHULER_NODE_SCALAR, SCHULER_NODE_LIST, SCHULER_NODE_MAP } schuler_node_kind;

typedef struct schuler_node schuler_node;
typedef struct {
    schuler_node *key; /* always a scalar */
    schuler_node *value;
} schuler_pair;

struct schuler_node {
    schuler_node_kind kind;
    schuler_place place;
    const char *text; /* scalar: NUL-terminated UTF-8                                        */
    int text_column;  /* where text begins on its line, 0 when the file spells it otherwise  */
    const schuler_node *key; /* the key in front of it; NULL for a list's items and the root     */
    size_t count; /* list: items; map: pairs, in the order of the file                   */
    schuler_node **items;
    schuler_pair *pairs;
};

typedef struct schuler_document schuler_document; /* owns text, nodes and names */

/** Read and parse one YAML document. Refused with a place: syntax errors, duplicate keys (with the
 *  line of the first), anchors and aliases, tags, non-scalar keys, depth over 64, NUL or invalid
 *  UTF-8, size over 16 MiB, more than 200000 nodes or 1000 keys in a map, a directory, an empty
 *  file.
 *  Given      path    file to read;  or for _parse: name to show, text and its length
 *  Returned   out     owned by the caller: schuler_document_free; NULL when there were errors
 *             d       what was wrong
 *  Errors     SCHULER_ERR_FILE cannot be read; SCHULER_ERR_INPUT; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_document_load(schuler_document **out,
                                                                   const char *path,
                                                                   schuler_diagnostics *d);
SCHULER_API SCHULER_NODISCARD schuler_status schuler_document_parse(schuler_document **out,
                                                                    const char *name,
                                                                    const char *text, size_t length,
                                                                    schuler_diagnostics *d);
SCHULER_API void schuler_document_free(schuler_document *doc); /* NULL is fine */
SCHULER_API const schuler_node *schuler_document_root(const schuler_document *doc);
/** The text as read and its length (for hashing). */
SCHULER_API const char *schuler_document_text(const schuler_document *doc, size_t *length);

/** Give every diagnostic that is about this document the source line at its place. */
SCHULER_API void schuler_document_excerpts(const schuler_document *doc, schuler_diagnostics *d);

/** Value of a key in a map, or NULL. */
SCHULER_API const schuler_node *schuler_node_find(const schuler_node *map, const char *key);

/** Put a value at a dotted path ("imu.gyro.bias", "trajectory.segments.0.hold.for" or
 *  "trajectory.segments[0].hold.for"), making maps that are missing. value is YAML flow text.
 *  Places then have the file "--set PATH=VALUE" and no line.
 *  Errors     SCHULER_ERR_INPUT with the reason in d */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_document_set(schuler_document *doc,
                                                                  const char *path,
                                                                  const char *value,
                                                                  schuler_diagnostics *d);

SCHULER_END_C

#endif

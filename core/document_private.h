/* SPDX-License-Identifier: MIT */
/* The parts of the document reader, and what the scenario reader needs beyond core/document.h. */
#ifndef SCHULER_CORE_DOCUMENT_PRIVATE_H
#define SCHULER_CORE_DOCUMENT_PRIVATE_H

#include "core/document.h"
#include "core/schema.h"

enum {
    SCHULER_DOCUMENT_DEPTH = 64,
    SCHULER_DOCUMENT_KEYS = 1000, /* keys of a map are compared pair by pair */
    SCHULER_DOCUMENT_NODES = 200000,
    SCHULER_DOCUMENT_BYTES = 16 << 20,
};

struct schuler_document {
    schuler_arena *arena;
    const char *name, *text;
    size_t length;
    schuler_node *root;
};

/** As the public functions, but a text whose only faults are repeated keys still gives its tree
 * (the first of each counts), so that the rest of it can be checked too. */
schuler_status schuler_document_load_lenient(schuler_document **out, const char *path,
                                             schuler_diagnostics *d);
schuler_status schuler_document_parse_lenient(schuler_document **out, const char *name,
                                              const char *text, size_t length,
                                              schuler_diagnostics *d);

/** Read the bytes of a file into memory of the arena, one NUL behind them. */
schuler_status schuler_document_read_file(schuler_arena *arena, const char *path, const char **text,
                                          size_t *length, schuler_diagnostics *d);

/** First byte or character that may not be in a document; diagnoses it.
 *  Returned   true when the text is clean */
bool schuler_document_text_is_clean(const char *name, const char *text, size_t length,
                                    schuler_diagnostics *d);

/** Line number `line` (1-based) of a text, counted as libyaml does.
 *  Returned   its start and length without the line break; NULL when there is no such line */
const char *schuler_document_line(const char *text, size_t length, int line, size_t *line_length);

/** Build the tree of a clean text.
 *  Given      line_places  false: places get line and column 0 (a text from the command line)
 *  Returned   the root, or NULL after an error that leaves no tree */
schuler_node *schuler_document_tree(schuler_arena *arena, const char *name, const char *text,
                                    size_t length, bool line_places, schuler_diagnostics *d);

/** Put a node at a dotted path, as schuler_document_set; shown is the file name of its places. */
schuler_status schuler_document_put(schuler_document *doc, const char *path, schuler_node *value,
                                    const char *shown, schuler_diagnostics *d);

/** A scalar node that stands for text from the command line; NULL when memory is out. */
schuler_node *schuler_document_scalar(schuler_document *doc, const char *text, const char *shown);

#endif

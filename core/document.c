/* SPDX-License-Identifier: MIT */
#include "core/document.h"
#include "core/document_private.h"
#include "core/utf8.h"
#include <string.h>

static schuler_status out_of_memory(schuler_document *doc, const char *name, schuler_diagnostics *d)
{
    const schuler_place place = { name, 0, 0, 0 };
    schuler_diagnose(d, SCHULER_ERR_MEMORY, &place, "out of memory");
    schuler_document_free(doc);
    return SCHULER_ERR_MEMORY;
}

static schuler_document *create(void)
{
    schuler_arena *arena = schuler_arena_create();
    schuler_document *doc = arena ? schuler_arena_alloc(arena, sizeof *doc) : NULL;
    if (doc)
        doc->arena = arena;
    else
        schuler_arena_free(arena);
    return doc;
}

/* The document owns its arena and its text by now; the rest is to be made from them. */
static schuler_status finish(schuler_document *doc, schuler_document **out, schuler_diagnostics *d)
{
    const char *text = doc->text;
    size_t length = doc->length;
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) { /* byte order mark */
        text += 3;
        length -= 3;
    }
    if (schuler_document_text_is_clean(doc->name, text, length, d))
        doc->root = schuler_document_tree(doc->arena, doc->name, text, length, true, d);
    schuler_document_excerpts(doc, d);
    if (!doc->root) {
        schuler_document_free(doc);
        return SCHULER_ERR_INPUT;
    }
    *out = doc;
    return SCHULER_OK;
}

schuler_status schuler_document_load_lenient(schuler_document **out, const char *path,
                                             schuler_diagnostics *d)
{
    *out = NULL;
    schuler_document *doc = create();
    if (!doc) return out_of_memory(NULL, path, d);
    doc->name = schuler_arena_printf(doc->arena, "%s", path);
    if (!doc->name) return out_of_memory(doc, path, d);
    const schuler_status rc =
        schuler_document_read_file(doc->arena, path, &doc->text, &doc->length, d);
    if (rc != SCHULER_OK) {
        schuler_document_free(doc);
        return rc;
    }
    return finish(doc, out, d);
}

schuler_status schuler_document_parse_lenient(schuler_document **out, const char *name,
                                              const char *text, size_t length,
                                              schuler_diagnostics *d)
{
    *out = NULL;
    const schuler_place place = { name, 0, 0, 0 };
    if (length > SCHULER_DOCUMENT_BYTES) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &place, "larger than 16 MiB");
        return SCHULER_ERR_INPUT;
    }
    schuler_document *doc = create();
    if (!doc) return out_of_memory(NULL, name, d);
    doc->name = schuler_arena_printf(doc->arena, "%s", name);
    char *copy = schuler_arena_alloc(doc->arena, length + 1);
    if (!doc->name || !copy) return out_of_memory(doc, name, d);
    if (length > 0) memcpy(copy, text, length);
    doc->text = copy;
    doc->length = length;
    return finish(doc, out, d);
}

/* What a lenient reader let pass is an error to everyone else. */
static schuler_status strict(schuler_status rc, schuler_document **out, size_t errors_before,
                             const schuler_diagnostics *d)
{
    if (rc == SCHULER_OK && d->errors > errors_before) {
        schuler_document_free(*out);
        *out = NULL;
        rc = SCHULER_ERR_INPUT;
    }
    return rc;
}

schuler_status schuler_document_load(schuler_document **out, const char *path,
                                     schuler_diagnostics *d)
{
    const size_t before = d->errors;
    return strict(schuler_document_load_lenient(out, path, d), out, before, d);
}

schuler_status schuler_document_parse(schuler_document **out, const char *name, const char *text,
                                      size_t length, schuler_diagnostics *d)
{
    const size_t before = d->errors;
    return strict(schuler_document_parse_lenient(out, name, text, length, d), out, before, d);
}

void schuler_document_free(schuler_document *doc)
{
    if (doc) schuler_arena_free(doc->arena); /* which holds doc itself */
}

const schuler_node *schuler_document_root(const schuler_document *doc)
{
    return doc->root;
}

const char *schuler_document_text(const schuler_document *doc, size_t *length)
{
    if (length) *length = doc->length;
    return doc->text;
}

const schuler_node *schuler_node_find(const schuler_node *map, const char *key)
{
    if (!map || map->kind != SCHULER_NODE_MAP) return NULL;
    for (size_t i = 0; i < map->count; i++)
        if (strcmp(map->pairs[i].key->text, key) == 0) return map->pairs[i].value;
    return NULL;
}

/* SPDX-License-Identifier: MIT */
/* Changes to a document from the command line. */
#include "core/document.h"
#include "core/document_private.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    schuler_document *doc;
    const char *path, *shown;
    schuler_diagnostics *d;
} setter;

static schuler_status refuse(const setter *s, const char *what, const char *part)
{
    const schuler_place place = { s->shown, 0, 0, 0 };
    schuler_diagnose(s->d, SCHULER_ERR_INPUT, &place, "%s '%.60s'", what, part);
    return SCHULER_ERR_INPUT;
}

static schuler_status no_memory(const setter *s)
{
    const schuler_place place = { s->shown, 0, 0, 0 };
    schuler_diagnose(s->d, SCHULER_ERR_MEMORY, &place, "out of memory");
    return SCHULER_ERR_MEMORY;
}

static schuler_node *new_node(const setter *s, schuler_node_kind kind)
{
    schuler_node *node = schuler_arena_alloc(s->doc->arena, sizeof *node);
    if (!node) return NULL;
    node->kind = kind;
    node->place = (schuler_place){ s->shown, 0, 0, 0 };
    return node;
}

schuler_node *schuler_document_scalar(schuler_document *doc, const char *text, const char *shown)
{
    const setter s = { doc, "", schuler_arena_printf(doc->arena, "%s", shown), NULL };
    schuler_node *node = s.shown ? new_node(&s, SCHULER_NODE_SCALAR) : NULL;
    if (node) node->text = schuler_arena_printf(doc->arena, "%s", text);
    return node && node->text ? node : NULL;
}

/* Take the next part of the path: up to a dot, or within brackets. Empty at the end. */
static char *next_part(char **rest)
{
    char *part = *rest + strspn(*rest, ".[]");
    char *end = part + strcspn(part, ".[]");
    *rest = *end ? end + 1 : end;
    *end = '\0';
    return part;
}

/* The place of a key's value in a map; an empty map when it was missing. */
static schuler_status slot_in_map(const setter *s, schuler_node *map, const char *key,
                                  schuler_node ***slot)
{
    for (size_t i = 0; i < map->count; i++) {
        if (strcmp(map->pairs[i].key->text, key) != 0) continue;
        *slot = &map->pairs[i].value;
        return SCHULER_OK;
    }
    if (map->count >= SCHULER_DOCUMENT_KEYS) return refuse(s, "too many keys beside", key);
    schuler_pair *pairs = schuler_arena_alloc(s->doc->arena, (map->count + 1) * sizeof *map->pairs);
    schuler_node *name = new_node(s, SCHULER_NODE_SCALAR);
    if (!pairs || !name) return no_memory(s);
    name->text = schuler_arena_printf(s->doc->arena, "%s", key);
    if (!name->text) return no_memory(s);
    if (map->count > 0) memcpy(pairs, map->pairs, map->count * sizeof *pairs);
    schuler_node *value = new_node(s, SCHULER_NODE_MAP);
    if (!value) return no_memory(s);
    pairs[map->count] = (schuler_pair){ name, value };
    map->pairs = pairs;
    *slot = &pairs[map->count++].value;
    return SCHULER_OK;
}

static schuler_status slot_in_list(const setter *s, schuler_node *list, const char *part,
                                   schuler_node ***slot)
{
    const size_t digits = strspn(part, "0123456789");
    if (digits == 0 || digits > 6 || part[digits] != '\0')
        return refuse(s, "a list is there, so a number (from 0) is expected, not", part);
    const size_t index = (size_t)strtoul(part, NULL, 10);
    if (index >= list->count) return refuse(s, "the list is too short for the number", part);
    *slot = &list->items[index];
    return SCHULER_OK;
}

static const schuler_node *key_of(const schuler_node *parent, schuler_node *const *slot)
{
    if (parent->kind != SCHULER_NODE_MAP) return NULL;
    for (size_t i = 0; i < parent->count; i++)
        if (&parent->pairs[i].value == slot) return parent->pairs[i].key;
    return NULL;
}

static schuler_status put(const setter *s, schuler_node *value)
{
    char *rest = schuler_arena_alloc(s->doc->arena, strlen(s->path) + 1);
    if (!rest) return no_memory(s);
    memcpy(rest, s->path, strlen(s->path) + 1);
    schuler_node *at = s->doc->root;
    char *part = next_part(&rest);
    if (*part == '\0') return refuse(s, "a key such as imu.gyro.bias is expected, not", s->path);
    for (int depth = 1;; depth++) {
        schuler_node **slot = NULL;
        schuler_status rc;
        if (depth >= SCHULER_DOCUMENT_DEPTH) return refuse(s, "too many parts in", s->path);
        if (at->kind == SCHULER_NODE_SCALAR)
            return refuse(s, "a single value is there, so there can be no key", part);
        rc = at->kind == SCHULER_NODE_MAP ? slot_in_map(s, at, part, &slot)
                                          : slot_in_list(s, at, part, &slot);
        if (rc != SCHULER_OK) return rc;
        part = next_part(&rest);
        const schuler_node *key = key_of(at, slot);
        if (*part == '\0') {
            value->key = key;
            *slot = value;
            return SCHULER_OK;
        }
        (*slot)->key = key;
        at = *slot;
    }
}

schuler_status schuler_document_put(schuler_document *doc, const char *path, schuler_node *value,
                                    const char *shown, schuler_diagnostics *d)
{
    const setter s = { doc, path, schuler_arena_printf(doc->arena, "%s", shown), d };
    return s.shown ? put(&s, value) : no_memory(&s);
}

schuler_status schuler_document_set(schuler_document *doc, const char *path, const char *value,
                                    schuler_diagnostics *d)
{
    const setter s = { doc, path, schuler_arena_printf(doc->arena, "--set %s=%s", path, value), d };
    if (!s.shown) return no_memory(&s);
    const size_t length = strlen(value);
    if (length > SCHULER_DOCUMENT_BYTES) return refuse(&s, "the value is too long for", path);
    if (value[strspn(value, " \t")] == '\0') return refuse(&s, "no value is given for", path);
    char *copy = schuler_arena_alloc(doc->arena, length + 1);
    if (!copy) return no_memory(&s);
    memcpy(copy, value, length + 1);
    const size_t before = d->errors;
    if (!schuler_document_text_is_clean(s.shown, copy, length, d)) return SCHULER_ERR_INPUT;
    schuler_node *node = schuler_document_tree(doc->arena, s.shown, copy, length, false, d);
    if (!node || d->errors > before) return SCHULER_ERR_INPUT;
    return put(&s, node);
}

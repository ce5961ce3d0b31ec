/* SPDX-License-Identifier: MIT */
/* From libyaml's events to nodes, with a stack of our own: no recursion on what the input says. */
#include "core/document_private.h"
#include "core/utf8.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* An open list or map; its children are collected here and moved to the arena when it closes. */
typedef struct {
    schuler_node *node;
    schuler_node **children; /* map: key, value, key, value, ... */
    size_t count, capacity;
} frame;

typedef struct {
    schuler_arena *arena;
    const char *name, *text;
    size_t length;
    bool line_places;
    schuler_diagnostics *d;
    frame stack[SCHULER_DOCUMENT_DEPTH];
    int depth;
    size_t nodes;
    schuler_node *root;
} builder;

static schuler_place place_of(const builder *b, yaml_mark_t start, yaml_mark_t end)
{
    schuler_place place = { b->name, 0, 0, 0 };
    if (!b->line_places) return place;
    place.line = (int)start.line + 1;
    place.column = (int)start.column + 1;
    place.width = start.line == end.line ? (int)(end.column - start.column) : 1;
    if (place.width < 1) place.width = 1;
    return place;
}

static bool fail_at(builder *b, schuler_place place, const char *what)
{
    schuler_diagnose(b->d, SCHULER_ERR_INPUT, &place, "%s", what);
    return false;
}

static bool no_memory(builder *b)
{
    const schuler_place place = { b->name, 0, 0, 0 };
    schuler_diagnose(b->d, SCHULER_ERR_MEMORY, &place, "out of memory");
    return false;
}

static schuler_node *new_node(builder *b, schuler_node_kind kind, const yaml_event_t *event)
{
    schuler_node *node = schuler_arena_alloc(b->arena, sizeof *node);
    if (!node) {
        no_memory(b);
        return NULL;
    }
    node->kind = kind;
    node->place = place_of(b, event->start_mark, event->end_mark);
    if (kind != SCHULER_NODE_SCALAR && node->place.width > 1) node->place.width = 1;
    return node;
}

/* Key of a map that is already there. */
static const schuler_node *same_key(const frame *f, const char *key)
{
    for (size_t i = 0; i < f->count; i += 2)
        if (strcmp(f->children[i]->text, key) == 0) return f->children[i];
    return NULL;
}

static bool push_child(builder *b, frame *f, schuler_node *child)
{
    if (f->count == f->capacity) {
        const size_t capacity = f->capacity > 0 ? 2 * f->capacity : 8;
        schuler_node **children = realloc(f->children, capacity * sizeof(schuler_node *));
        if (!children) return no_memory(b);
        f->children = children;
        f->capacity = capacity;
    }
    f->children[f->count++] = child;
    return true;
}

/* Hang a node under what is open. */
static bool attach(builder *b, schuler_node *node)
{
    if (++b->nodes > SCHULER_DOCUMENT_NODES)
        return fail_at(b, node->place, "more than 200000 values in one file");
    if (b->depth == 0) {
        b->root = node;
        return true;
    }
    frame *f = &b->stack[b->depth - 1];
    if (f->node->kind == SCHULER_NODE_MAP) {
        if (f->count % 2 == 1) {
            node->key = f->children[f->count - 1];
        } else if (node->kind != SCHULER_NODE_SCALAR) {
            return fail_at(b, node->place, "a key must be a single word, not a list or a map");
        } else if (f->count / 2 >= SCHULER_DOCUMENT_KEYS) {
            return fail_at(b, node->place, "more than 1000 keys in one map");
        } else {
            const schuler_node *first = same_key(f, node->text);
            if (first && first->place.line > 0)
                schuler_diagnose(b->d, SCHULER_ERR_INPUT, &node->place,
                                 "duplicate key '%.60s' (first given on line %d)", node->text,
                                 first->place.line);
            else if (first)
                schuler_diagnose(b->d, SCHULER_ERR_INPUT, &node->place, "duplicate key '%.60s'",
                                 node->text);
        }
    }
    return push_child(b, f, node);
}

static bool open_frame(builder *b, schuler_node_kind kind, const yaml_event_t *event)
{
    schuler_node *node = new_node(b, kind, event);
    if (!node || !attach(b, node)) return false;
    if (b->depth == SCHULER_DOCUMENT_DEPTH)
        return fail_at(b, node->place, "more than 64 lists and maps inside one another");
    b->stack[b->depth++] = (frame){ .node = node };
    return true;
}

static bool close_frame(builder *b)
{
    frame *f = &b->stack[--b->depth];
    schuler_node *node = f->node;
    const size_t step = node->kind == SCHULER_NODE_MAP ? 2 : 1;
    node->count = f->count / step;
    bool ok = true;
    if (step == 2) {
        node->pairs = schuler_arena_alloc(b->arena, node->count * sizeof *node->pairs);
        ok = node->pairs != NULL;
        for (size_t i = 0; ok && i < node->count; i++)
            node->pairs[i] = (schuler_pair){ f->children[2 * i], f->children[2 * i + 1] };
    } else {
        node->items = schuler_arena_alloc(b->arena, node->count * sizeof(schuler_node *));
        ok = node->items != NULL;
        if (ok && node->count > 0)
            memcpy(node->items, f->children, node->count * sizeof(schuler_node *));
    }
    free(f->children);
    f->children = NULL;
    return ok || no_memory(b);
}

static bool add_scalar(builder *b, const yaml_event_t *event)
{
    const size_t length = event->data.scalar.length;
    schuler_node *node = new_node(b, SCHULER_NODE_SCALAR, event);
    if (!node) return false;
    char *text = schuler_arena_alloc(b->arena, length + 1);
    if (!text) return no_memory(b);
    memcpy(text, event->data.scalar.value, length);
    node->text = text;
    if (strlen(text) != length) /* "\0" in double quotes */
        return fail_at(b, node->place, "a NUL character in a text");
    const int quotes = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE ? 0 : 2;
    if (event->start_mark.line == event->end_mark.line && length > 0 &&
        node->place.width == schuler_utf8_count(text, length) + quotes)
        node->text_column = node->place.column + quotes / 2;
    return attach(b, node);
}

/* Anchors make a text that cannot be read from top to bottom, tags are types; neither is needed. */
static bool is_plain(builder *b, const yaml_event_t *event)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    if (event->type == YAML_SCALAR_EVENT) {
        anchor = event->data.scalar.anchor;
        tag = event->data.scalar.tag;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        anchor = event->data.sequence_start.anchor;
        tag = event->data.sequence_start.tag;
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        anchor = event->data.mapping_start.anchor;
        tag = event->data.mapping_start.tag;
    }
    const schuler_place place = place_of(b, event->start_mark, event->end_mark);
    if (anchor || event->type == YAML_ALIAS_EVENT)
        return fail_at(b, place,
                       "anchors (&) and aliases (*) are not allowed; write the value out");
    if (tag) return fail_at(b, place, "tags (!) are not allowed");
    return true;
}

/* libyaml's own words, and a hint where they are poor. */
static bool syntax_error(builder *b, const yaml_parser_t *parser)
{
    if (parser->error == YAML_MEMORY_ERROR) return no_memory(b);
    const schuler_place place = place_of(b, parser->problem_mark, parser->problem_mark);
    char context[80] = "";
    if (parser->context && parser->context_mark.line != parser->problem_mark.line && b->line_places)
        snprintf(context, sizeof context, ", %s (from line %d)", parser->context,
                 (int)parser->context_mark.line + 1);
    else if (parser->context)
        snprintf(context, sizeof context, ", %s", parser->context);
    size_t n = 0;
    const char *line =
        schuler_document_line(b->text, b->length, (int)parser->problem_mark.line + 1, &n);
    size_t blank = 0;
    while (line && blank < n && line[blank] == ' ') blank++;
    const bool tab = line && blank < n && line[blank] == '\t';
    schuler_diagnose(b->d, SCHULER_ERR_INPUT, &place, "not valid YAML: %s%s%s",
                     parser->problem ? parser->problem : "unreadable", context,
                     tab ? "; indent with spaces, not tabs" : "");
    return false;
}

/* One event; false after an error. */
static bool take_event(builder *b, const yaml_event_t *event)
{
    if (!is_plain(b, event)) return false;
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        return add_scalar(b, event);
    case YAML_SEQUENCE_START_EVENT:
        return open_frame(b, SCHULER_NODE_LIST, event);
    case YAML_MAPPING_START_EVENT:
        return open_frame(b, SCHULER_NODE_MAP, event);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        return close_frame(b);
    case YAML_DOCUMENT_START_EVENT:
        if (!b->root) return true;
        return fail_at(b, place_of(b, event->start_mark, event->end_mark),
                       "a second document (---); only one is read");
    default:
        return true;
    }
}

schuler_node *schuler_document_tree(schuler_arena *arena, const char *name, const char *text,
                                    size_t length, bool line_places, schuler_diagnostics *d)
{
    builder b = { .arena = arena,
                  .name = name,
                  .text = text,
                  .length = length,
                  .line_places = line_places,
                  .d = d };
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser)) {
        no_memory(&b);
        return NULL;
    }
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, length);
    bool ok = true;
    for (bool done = false; ok && !done;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            ok = syntax_error(&b, &parser);
            break;
        }
        ok = take_event(&b, &event);
        done = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    for (int i = 0; i < b.depth; i++) free(b.stack[i].children);
    if (ok && !b.root) {
        const schuler_place place = { name, line_places, line_places, line_places };
        ok = fail_at(&b, place, "the file is empty");
    }
    return ok ? b.root : NULL;
}

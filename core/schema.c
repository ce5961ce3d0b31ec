/* SPDX-License-Identifier: MIT */
#include "core/schema.h"
#include "core/schema_private.h"
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *member(void *spec, size_t offset)
{
    return (char *)spec + offset;
}

/* Defaults of the object and of the objects within it. */
static void set_defaults(const schuler_object *object, void *spec)
{
    memset(spec, 0, object->size);
    for (const schuler_field *f = object->fields; f->key; f++) {
        void *at = member(spec, f->offset);
        switch (f->kind) {
        case SCHULER_FIELD_QUANTITY:
        case SCHULER_FIELD_NUMBER:
            *(double *)at = f->def;
            break;
        case SCHULER_FIELD_INTEGER:
            *(int64_t *)at = isnan(f->def) ? 0 : (int64_t)f->def;
            break;
        case SCHULER_FIELD_CHOICE:
            if (!f->required) *(const char **)at = f->choices[0];
            break;
        case SCHULER_FIELD_OBJECT:
            set_defaults(f->object, at);
            break;
        default:
            break;
        }
    }
}

static bool read_integer(schuler_reading *r, const schuler_node *node, const char *what,
                         const schuler_field *f, int64_t *out)
{
    const char *text = schuler_read_scalar(r, node, what, "a whole number");
    if (!text) return false;
    char *end;
    errno = 0;
    const size_t sign = *text == '-' || *text == '+';
    const long long number = strtoll(text, &end, 10);
    const bool is_number = text[sign] >= '0' && text[sign] <= '9' && *end == '\0';
    if (!is_number) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place, "%s: '%.40s' is not a whole number",
                         what, text);
        return false;
    }
    const bool bounded = f->min != 0.0 || f->max != 0.0;
    if (errno == ERANGE || (bounded && ((double)number < f->min || (double)number > f->max))) {
        /* 2^63 is not an int64_t, but the double nearest to the largest one. */
        char allowed[80] = "";
        if (bounded && f->max >= 0x1p63)
            snprintf(allowed, sizeof allowed, "; allowed: %.0f to %lld", f->min, LLONG_MAX);
        else if (bounded)
            snprintf(allowed, sizeof allowed, "; allowed: %.0f to %.0f", f->min, f->max);
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place, "%s: %.40s is out of range%s", what,
                         text, allowed);
        return false;
    }
    *out = number;
    return true;
}

static void read_choice(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *f, const char **out)
{
    size_t count = 0;
    while (f->choices[count]) count++;
    const char *text = schuler_read_scalar(r, node, what, "a word");
    if (!text) return;
    for (size_t i = 0; i < count; i++) {
        if (strcmp(f->choices[i], text) != 0) continue;
        *out = f->choices[i];
        return;
    }
    char lead[200];
    snprintf(lead, sizeof lead, "%.100s: unknown '%.60s'", what, text);
    schuler_diagnose_unknown(r, &node->place, lead, text, f->choices, count);
}

static void read_texts(schuler_reading *r, const schuler_node *node, const char *what,
                       schuler_text_list *out)
{
    const bool is_list = node->kind == SCHULER_NODE_LIST;
    const size_t count = is_list ? node->count : 1;
    out->items = schuler_reading_alloc(r, count * sizeof *out->items);
    out->places = schuler_reading_alloc(r, count * sizeof *out->places);
    if (!out->items || !out->places) return;
    for (size_t i = 0; i < count; i++) {
        const schuler_node *item = is_list ? node->items[i] : node;
        const char *text = schuler_read_scalar(r, item, what, "a word or a list of words");
        if (!text) continue;
        out->items[out->count] = text;
        out->places[out->count++] = item->place;
    }
}

static void read_quantities(schuler_reading *r, const schuler_node *node, const char *what,
                            const schuler_field *f, schuler_quantity_list *out)
{
    const bool is_list = node->kind == SCHULER_NODE_LIST;
    const size_t count = is_list ? node->count : 1;
    if (count == 0 || count > (size_t)f->components) {
        char wanted[60];
        snprintf(wanted, sizeof wanted, "a list of 1 to %d values", f->components);
        schuler_expected(r, node, what, wanted);
        return;
    }
    out->items = schuler_reading_alloc(r, count * sizeof *out->items);
    if (!out->items) return;
    for (size_t i = 0; i < count; i++)
        if (schuler_read_quantity(r, is_list ? node->items[i] : node, what, f,
                                  &out->items[out->count]))
            out->count++;
}

static void read_object(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_object *object, void *spec);

static void read_list(schuler_reading *r, const schuler_node *node, const char *what,
                      const schuler_field *f, schuler_list *out)
{
    if (node->kind != SCHULER_NODE_LIST || node->count == 0) {
        schuler_expected(r, node, what, "a list of maps");
        return;
    }
    out->items = schuler_reading_alloc(r, node->count * f->object->size);
    if (!out->items) return;
    out->count = node->count;
    for (size_t i = 0; i < node->count; i++)
        read_object(r, node->items[i], schuler_reading_index(r, what, i), f->object,
                    member(out->items, i * f->object->size));
}

static void read_variant(schuler_reading *r, const schuler_node *node, const char *what,
                         const schuler_field *f, schuler_variant *out)
{
    const char *names[64];
    size_t count = 0;
    for (; f->variants[count] && count < 64; count++) names[count] = f->variants[count]->name;
    if (node->kind != SCHULER_NODE_MAP || node->count != 1) {
        char wanted[120];
        snprintf(wanted, sizeof wanted, "a map with one key, such as '%s: {...}',", names[0]);
        schuler_expected(r, node, what, wanted);
        return;
    }
    const schuler_node *key = node->pairs[0].key;
    for (size_t i = 0; i < count; i++) {
        if (strcmp(names[i], key->text) != 0) continue;
        out->which = f->variants[i];
        out->spec = schuler_reading_alloc(r, f->variants[i]->size);
        if (out->spec)
            read_object(r, node->pairs[0].value, schuler_reading_path(r, what, key->text),
                        f->variants[i], out->spec);
        return;
    }
    char lead[200];
    snprintf(lead, sizeof lead, "%.100s: unknown '%.60s'", what, key->text);
    schuler_diagnose_unknown(r, &key->place, lead, key->text, names, count);
}

static void read_variants(schuler_reading *r, const schuler_node *node, const char *what,
                          const schuler_field *f, schuler_variant_list *out)
{
    if (node->kind == SCHULER_NODE_LIST && node->count == 0 && !f->required) return;
    if (node->kind != SCHULER_NODE_LIST || node->count == 0) {
        schuler_expected(r, node, what, "a list of single-key maps");
        return;
    }
    out->items = schuler_reading_alloc(r, node->count * sizeof *out->items);
    if (!out->items) return;
    out->count = node->count;
    for (size_t i = 0; i < node->count; i++)
        read_variant(r, node->items[i], schuler_reading_index(r, what, i), f, &out->items[i]);
}

static void read_field(schuler_reading *r, const schuler_node *node, const char *what,
                       const schuler_field *f, void *at)
{
    switch (f->kind) {
    case SCHULER_FIELD_QUANTITY:
    case SCHULER_FIELD_NUMBER:
        (void)schuler_read_quantity(r, node, what, f, at);
        break;
    case SCHULER_FIELD_QUANTITIES:
        read_quantities(r, node, what, f, at);
        break;
    case SCHULER_FIELD_INTEGER:
        (void)read_integer(r, node, what, f, at);
        break;
    case SCHULER_FIELD_TEXT: {
        const char *text = schuler_read_scalar(r, node, what, "a text");
        if (text) *(const char **)at = text;
        break;
    }
    case SCHULER_FIELD_CHOICE:
        read_choice(r, node, what, f, at);
        break;
    case SCHULER_FIELD_VALUE:
        (void)schuler_read_value(r, node, what, f, at);
        break;
    case SCHULER_FIELD_OBJECT:
        read_object(r, node, what, f->object, at);
        break;
    case SCHULER_FIELD_LIST:
        read_list(r, node, what, f, at);
        break;
    case SCHULER_FIELD_VARIANTS:
        read_variants(r, node, what, f, at);
        break;
    case SCHULER_FIELD_TEXTS:
        read_texts(r, node, what, at);
        break;
    case SCHULER_FIELD_NODE:
        *(const schuler_node **)at = node;
        break;
    }
}

enum { KEYS_MAX = 64 };

static size_t key_names(const schuler_object *object, const char *names[KEYS_MAX])
{
    size_t count = 0;
    for (const schuler_field *f = object->fields; f->key && count < KEYS_MAX; f++)
        names[count++] = f->key;
    return count;
}

static const schuler_field *find_field(const schuler_object *object, const char *key)
{
    for (const schuler_field *f = object->fields; f->key; f++)
        if (strcmp(f->key, key) == 0) return f;
    return NULL;
}

/* A missing key is not complained of when a misspelling of it already was. */
static bool is_misspelled(const schuler_node *node, const schuler_object *object, const char *key)
{
    const char *names[KEYS_MAX];
    const size_t count = key_names(object, names);
    for (size_t i = 0; i < node->count; i++) {
        const char *written = node->pairs[i].key->text;
        if (find_field(object, written)) continue;
        const char *near = schuler_nearest(written, names, count);
        if (near && strcmp(near, key) == 0) return true;
    }
    return false;
}

static void missing_key(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *f)
{
    const char *example = f->example;
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                     "%s%.100s%s needs the key '%s'%s%s", *what ? "'" : "",
                     *what ? what : "the file", *what ? "'" : "", f->key,
                     example ? ", for example: " : "", example ? example : "");
}

static void unknown_key(schuler_reading *r, const schuler_node *key, const char *what,
                        const schuler_object *object)
{
    const char *names[KEYS_MAX];
    const size_t count = key_names(object, names);
    char lead[240];
    if (*what)
        snprintf(lead, sizeof lead, "unknown key '%.60s' in '%.100s'", key->text, what);
    else
        snprintf(lead, sizeof lead, "unknown key '%.60s'", key->text);
    schuler_diagnose_unknown(r, &key->place, lead, key->text, names, count);
}

static void read_object(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_object *object, void *spec)
{
    set_defaults(object, spec);
    *(schuler_place *)spec = *schuler_node_place(node);
    if (node->kind != SCHULER_NODE_MAP) {
        schuler_expected(r, node, what, "a map of keys");
        return;
    }
    for (size_t i = 0; i < node->count; i++) {
        const schuler_pair *pair = &node->pairs[i];
        /* Of repeated keys the first counts; the others were complained of when the text was read.
         */
        if (schuler_node_find(node, pair->key->text) != pair->value) continue;
        const schuler_field *f = find_field(object, pair->key->text);
        if (f)
            read_field(r, pair->value, schuler_reading_path(r, what, f->key), f,
                       member(spec, f->offset));
        else
            unknown_key(r, pair->key, what, object);
    }
    for (const schuler_field *f = object->fields; f->key; f++)
        if (f->required && !schuler_node_find(node, f->key) && !is_misspelled(node, object, f->key))
            missing_key(r, node, what, f);
}

static schuler_status status_of(const schuler_reading *r, size_t errors_before)
{
    if (r->memory_failed) return SCHULER_ERR_MEMORY;
    return r->d->errors > errors_before ? SCHULER_ERR_INPUT : SCHULER_OK;
}

schuler_status schuler_schema_read(const schuler_node *node, const char *what,
                                   const schuler_object *object, void *spec, schuler_arena *arena,
                                   schuler_diagnostics *d)
{
    schuler_reading r = { .arena = arena, .d = d };
    const size_t before = d->errors;
    read_object(&r, node, what, object, spec);
    return status_of(&r, before);
}

schuler_status schuler_schema_read_value(const schuler_node *node, const char *what,
                                         const schuler_field *field, schuler_value *out,
                                         schuler_arena *arena, schuler_diagnostics *d)
{
    schuler_reading r = { .arena = arena, .d = d };
    const size_t before = d->errors;
    (void)schuler_read_value(&r, node, what, field, out);
    return status_of(&r, before);
}

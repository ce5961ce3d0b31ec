/* SPDX-License-Identifier: MIT */
/* Parts: files of the catalog, or of the user in the same form. */
#include "scenarios/part.h"
#include "core/document_private.h"
#include "sensors/catalog.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    schuler_place place;
    const char *sensor, *title, *maker, *grade, *technology, *notes;
    double rate_hz;
    const schuler_node *sources, *triad[SCHULER_INSTRUMENTS];
} part_file;

#define TEXT(name_, required_, example_, doc_)                                                     \
    {                                                                                              \
        .key = #name_, .kind = SCHULER_FIELD_TEXT, .offset = offsetof(part_file, name_),           \
        .required = required_, .example = example_, .doc = doc_                                    \
    }

static const schuler_field fields[] = {
    TEXT(sensor, true, "my-imu", "short name"),
    TEXT(title, false, "My IMU", "name for people"),
    TEXT(maker, false, "A Company", "who makes it"),
    TEXT(grade, false, "tactical", "consumer, industrial, tactical, navigation or strategic"),
    TEXT(technology, false, "MEMS", "how it works"),
    TEXT(notes, false, "not published: misalignment", "what a user must know"),
    { .key = "rate",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = offsetof(part_file, rate_hz),
      .dim = SCHULER_DIM_FREQUENCY,
      .def = 100.0,
      .min = 1.0,
      .max = 1e4,
      .example = "100 Hz",
      .doc = "samples of increments a second" },
    { .key = "sources",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(part_file, sources),
      .doc = "where the figures were read" },
    { .key = "accel",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(part_file, triad[SCHULER_ACCEL]),
      .example = "{model: linear, bias: 50 ug}",
      .doc = "the accelerometers" },
    { .key = "gyro",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(part_file, triad[SCHULER_GYRO]),
      .example = "{model: linear, bias: 0.01 deg/h}",
      .doc = "the gyros" },
    { .key = NULL },
};

static const schuler_object part_object = {
    .name = "part",
    .doc = "an IMU, or accelerometers or gyros alone: models and their figures",
    .size = sizeof(part_file),
    .fields = fields,
};

static void read_sources(schuler_reading *r, const schuler_node *node, schuler_part *part)
{
    if (!node) return;
    if (node->kind != SCHULER_NODE_MAP) {
        schuler_expected(r, node, "sources", "a map of names to texts");
        return;
    }
    schuler_source_text *sources = schuler_reading_alloc(r, node->count * sizeof *sources);
    if (!sources) return;
    for (size_t i = 0; i < node->count; i++) {
        const char *const key = node->pairs[i].key->text;
        const char *text = schuler_read_scalar(r, node->pairs[i].value,
                                               schuler_reading_path(r, "sources", key), "a text");
        if (text) sources[part->source_count++] = (schuler_source_text){ key, text };
    }
    part->sources = sources;
}

static void check_source(schuler_reading *r, const schuler_part *part, const schuler_value *v,
                         const char *what, const char *key)
{
    const char *names[64];
    size_t count = 0;
    for (size_t i = 0; i < part->source_count; i++) {
        if (strcmp(part->sources[i].key, v->source) == 0) return;
        if (count < 64) names[count++] = part->sources[i].key;
    }
    char lead[240];
    snprintf(lead, sizeof lead, "%.60s.%.40s: no source '%.60s' in the file's 'sources'", what, key,
             v->source);
    schuler_diagnose_unknown(r, &v->place, lead, v->source, names, count);
}

/* Where each figure comes from. */
static void check_provenance(schuler_reading *r, const schuler_part *part, const char *what,
                             schuler_instrument instrument, bool strict)
{
    const schuler_triad *const triad = &part->imu.triad[instrument];
    if (!triad->model) return;
    const schuler_param *const params = triad->params;
    for (int i = 0; params[i].key; i++) {
        const schuler_value *const v = &triad->values[i];
        if (!v->given) continue;
        if (v->source) check_source(r, part, v, what, params[i].key);
        if (!strict || params[i].choices) continue; /* a word says how a figure is meant */
        if (!v->source && !v->assumed)
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &v->place,
                             "%s.%s: a catalog value needs 'source: NAME', or 'assumed: true' with "
                             "a note",
                             what, params[i].key);
        else if (v->assumed && !v->note)
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &v->place,
                             "%s.%s: an assumed value needs 'note: WHY'", what, params[i].key);
    }
}

void schuler_part_read(schuler_reading *r, const schuler_document *doc, const char *name,
                       bool strict, schuler_part *part)
{
    part_file file;
    const schuler_status rc =
        schuler_schema_read(schuler_document_root(doc), "", &part_object, &file, r->arena, r->d);
    if (rc == SCHULER_ERR_MEMORY) return;
    if (rc == SCHULER_OK && !file.triad[SCHULER_ACCEL] && !file.triad[SCHULER_GYRO])
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file.place,
                         "part: 'accel', 'gyro' or both are needed");
    part->imu.name = name;
    part->imu.title = file.title ? file.title : name;
    part->imu.rate_hz = file.rate_hz;
    part->maker = file.maker;
    part->grade = file.grade;
    part->technology = file.technology;
    part->notes = file.notes;
    read_sources(r, file.sources, part);
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const char *const what = schuler_instrument_name((schuler_instrument)i);
        if (!file.triad[i]) continue;
        schuler_triad_read(r, file.triad[i], what, (schuler_instrument)i, &part->imu.triad[i]);
        check_provenance(r, part, what, (schuler_instrument)i, strict);
    }
}

static const schuler_catalog_entry *find_entry(const char *name)
{
    for (const schuler_catalog_entry *e = schuler_catalog; e->name; e++)
        if (strcmp(e->name, name) == 0) return e;
    return NULL;
}

static void not_found(schuler_reading *r, const schuler_place *place, const char *name)
{
    const char *names[256];
    size_t count = 0;
    for (const schuler_catalog_entry *e = schuler_catalog; e->name && count < 256; e++)
        names[count++] = e->name;
    char lead[240];
    snprintf(lead, sizeof lead, "no part '%.100s' in the catalog, and no such file", name);
    schuler_diagnose_unknown(r, place, lead, name, names, count);
}

schuler_status schuler_part_open(schuler_reading *r, const char *name_or_file, const char *folder,
                                 const schuler_place *place, schuler_document **out,
                                 const char **name, bool *strict)
{
    *out = NULL;
    const schuler_catalog_entry *const entry = find_entry(name_or_file);
    *strict = entry != NULL;
    if (entry) {
        *name = entry->name;
        const char *shown = schuler_arena_printf(r->arena, "catalog:%s", entry->name);
        return schuler_document_parse_lenient(out, shown ? shown : entry->name, entry->text,
                                              entry->length, r->d);
    }
    const char *path = name_or_file;
    if (folder && name_or_file[0] != '/') {
        path = schuler_arena_printf(r->arena, "%s/%s", folder, name_or_file);
        if (!path || access(path, F_OK) != 0) path = name_or_file;
    }
    if (access(path, F_OK) != 0) {
        not_found(r, place, name_or_file);
        return SCHULER_ERR_INPUT;
    }
    *name = schuler_arena_printf(r->arena, "%s", name_or_file);
    if (!*name) *name = "";
    return schuler_document_load_lenient(out, path, r->d);
}

/* The first error that was said since then is what the call returns. */
static schuler_status status_since(const schuler_diagnostics *d, size_t kept, size_t errors)
{
    if (d->errors == errors) return SCHULER_OK;
    for (size_t i = kept; i < d->kept; i++)
        if (!d->items[i].is_warning) return d->items[i].status;
    return SCHULER_ERR_INPUT;
}

schuler_status schuler_part_load(schuler_part **out, const char *name_or_file,
                                 schuler_diagnostics *d)
{
    return schuler_part_load_with(out, name_or_file, NULL, d);
}

schuler_status schuler_part_load_with(schuler_part **out, const char *name_or_file,
                                      const schuler_plugins *plugins, schuler_diagnostics *d)
{
    *out = NULL;
    const size_t kept = d->kept, errors = d->errors;
    schuler_arena *const arena = schuler_arena_create();
    schuler_part *const part = arena ? schuler_arena_alloc(arena, sizeof *part) : NULL;
    if (!part) {
        schuler_diagnose(d, SCHULER_ERR_MEMORY, NULL, "out of memory");
        schuler_arena_free(arena);
        return SCHULER_ERR_MEMORY;
    }
    part->arena = arena;
    schuler_reading r = { .arena = arena, .d = d, .plugins = plugins };
    const char *name;
    bool strict;
    const schuler_status rc =
        schuler_part_open(&r, name_or_file, NULL, NULL, &part->document, &name, &strict);
    if (rc == SCHULER_OK) {
        schuler_part_read(&r, part->document, name, strict, part);
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            schuler_triad_finish(&r, schuler_instrument_name((schuler_instrument)i),
                                 &part->imu.triad[i]);
        schuler_document_excerpts(part->document, d);
    }
    const schuler_status status = status_since(d, kept, errors);
    if (status != SCHULER_OK) {
        schuler_part_free(part);
        return status;
    }
    *out = part;
    return SCHULER_OK;
}

void schuler_part_free(schuler_part *part)
{
    if (!part) return;
    schuler_document_free(part->document);
    schuler_arena_free(part->arena); /* which holds part itself */
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/scenario.h"
#include "core/document_private.h"
#include "scenarios/part.h"
#include "scenarios/reader.h"
#include "scenarios/recorded_rows.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* libmd's header spells its types in the BSD manner. */
#include <sys/types.h>

#include <sha2.h>

static schuler_node *child(schuler_node *map, const char *key)
{
    if (!map || map->kind != SCHULER_NODE_MAP) return NULL;
    for (size_t i = 0; i < map->count; i++)
        if (strcmp(map->pairs[i].key->text, key) == 0) return map->pairs[i].value;
    return NULL;
}

/* --imu: the section as it would be written for that part; the rate stays. */
static void override_imu(schuler_document *doc, const char *imu, schuler_diagnostics *d)
{
    char shown[200];
    snprintf(shown, sizeof shown, "--imu %.150s", imu);
    schuler_node *const rate = child(child(doc->root, "imu"), "rate");
    schuler_node *const section = schuler_arena_alloc(doc->arena, sizeof *section);
    schuler_node *const use = schuler_document_scalar(doc, imu, shown);
    if (!section || !use) {
        schuler_diagnose(d, SCHULER_ERR_MEMORY, NULL, "out of memory");
        return;
    }
    section->kind = SCHULER_NODE_MAP;
    section->place = use->place;
    schuler_document_put(doc, "imu", section, shown, d);
    schuler_document_put(doc, "imu.use", use, shown, d);
    if (rate) schuler_document_put(doc, "imu.rate", rate, shown, d);
}

static void override_number(schuler_document *doc, const char *key, long long value,
                            schuler_diagnostics *d)
{
    char shown[64], text[32];
    snprintf(shown, sizeof shown, "--%s %lld", key, value);
    snprintf(text, sizeof text, "%lld", value);
    schuler_node *const node = schuler_document_scalar(doc, text, shown);
    if (!node)
        schuler_diagnose(d, SCHULER_ERR_MEMORY, NULL, "out of memory");
    else
        schuler_document_put(doc, key, node, shown, d);
}

static void apply_set(schuler_document *doc, const char *assignment, schuler_diagnostics *d)
{
    const char *const equals = strchr(assignment, '=');
    const char *const path =
        equals ? schuler_arena_printf(doc->arena, "%.*s", (int)(equals - assignment), assignment)
               : NULL;
    if (path && schuler_document_set(doc, path, equals + 1, d) == SCHULER_OK) return;
    if (equals) return; /* said by the setter */
    const schuler_place place = { "--set", 0, 0, 0 };
    schuler_diagnose(d, SCHULER_ERR_INPUT, &place,
                     "'%.100s': KEY=VALUE is expected, such as imu.gyro.bias='0.01 deg/h'",
                     assignment);
}

/* In the order of growing detail: --imu gives the section that --set may change. */
static void apply_overrides(schuler_document *doc, const schuler_overrides *o,
                            schuler_diagnostics *d)
{
    if (schuler_document_root(doc)->kind != SCHULER_NODE_MAP) return; /* said by the reader */
    if (o->imu) override_imu(doc, o->imu, d);
    for (size_t i = 0; i < o->count_set; i++) apply_set(doc, o->set[i], d);
    if (o->has_seed && o->seed > INT64_MAX) {
        const schuler_place place = { "--seed", 0, 0, 0 };
        schuler_diagnose(d, SCHULER_ERR_INPUT, &place, "the seed is out of range");
    } else if (o->has_seed) {
        override_number(doc, "seed", (long long)o->seed, d);
    }
    if (o->has_runs) override_number(doc, "runs", o->runs, d);
}

static void override_sources(schuler_reading *r, const schuler_overrides *o, schuler_scenario *s)
{
    const char *const shown_only =
        schuler_arena_printf(r->arena, "--only %s", o->only ? o->only : "");
    const char *const shown_without =
        schuler_arena_printf(r->arena, "--without %s", o->without ? o->without : "");
    if (o->only) schuler_split_words(r, o->only, shown_only, &s->only);
    if (o->without) schuler_split_words(r, o->without, shown_without, &s->without);
}

/* The keys of the trajectory that every kind has, or those that are its own. */
static schuler_node *keys_of(schuler_reading *r, const schuler_node *node, bool common)
{
    schuler_node *const copy = schuler_reading_alloc(r, sizeof *copy);
    schuler_pair *const pairs = schuler_reading_alloc(r, node->count * sizeof *pairs);
    if (!copy || !pairs) return NULL;
    *copy = *node;
    copy->pairs = pairs;
    copy->count = 0;
    for (size_t i = 0; i < node->count; i++) {
        const char *const key = node->pairs[i].key->text;
        if (strcmp(key, "kind") != 0 && (strcmp(key, "overlays") == 0) == common)
            pairs[copy->count++] = node->pairs[i];
    }
    return copy;
}

static const schuler_trajectory_kind *find_kind(schuler_reading *r, const schuler_node *node)
{
    const schuler_node *const kind = schuler_node_find(node, "kind");
    if (!kind) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                         "'trajectory' needs the key 'kind', for example: static");
        return NULL;
    }
    const char *text = schuler_read_scalar(r, kind, "trajectory.kind", "a kind of trajectory");
    if (!text) return NULL;
    const char *names[64];
    size_t count = 0;
    for (; schuler_trajectory_kinds[count] && count < 64; count++) {
        names[count] = schuler_trajectory_kinds[count]->name;
        if (strcmp(names[count], text) == 0) return schuler_trajectory_kinds[count];
    }
    char lead[160];
    snprintf(lead, sizeof lead, "trajectory.kind: there is no kind '%.60s'", text);
    schuler_diagnose_unknown(r, &kind->place, lead, text, names, count);
    return NULL;
}

static void read_trajectory(schuler_reading *r, const schuler_node *node, schuler_scenario *s)
{
    if (node->kind != SCHULER_NODE_MAP) {
        schuler_expected(r, node, "trajectory", "a map of keys");
        return;
    }
    s->trajectory = find_kind(r, node);
    schuler_node *const keys = keys_of(r, node, false), *const common = keys_of(r, node, true);
    if (!keys || !common) return;
    if (schuler_schema_read(common, "trajectory", &schuler_overlays_object, &s->overlays, r->arena,
                            r->d) != SCHULER_OK ||
        !s->trajectory)
        return;
    void *const spec = schuler_reading_alloc(r, s->trajectory->object->size);
    if (spec && schuler_schema_read(keys, "trajectory", s->trajectory->object, spec, r->arena,
                                    r->d) == SCHULER_OK)
        s->trajectory_spec = spec;
}

/* The trajectory's path; the rows of one that names a file are needed only until it is built. */
static schuler_status build_path(schuler_reading *r, schuler_scenario *s)
{
    const schuler_trajectory_kind *const kind = s->trajectory;
    const char *name = NULL;
    schuler_recorded_samples none = { 0 };
    schuler_recorded_samples *const rows =
        kind->samples ? kind->samples(s->trajectory_spec, &name) : &none;
    schuler_status status = SCHULER_OK;
    if (name) {
        const char *const path =
            name[0] == '/' ? name : schuler_arena_printf(r->arena, "%s%s", s->folder, name);
        status = path ? schuler_recorded_rows(rows, path, r->d) : SCHULER_ERR_MEMORY;
    }
    if (status == SCHULER_OK) status = kind->build(s->trajectory_spec, &s->path, r->d);
    free(rows->items);
    *rows = none;
    return status;
}

/* Everything from the document on; mistakes go to r->d. */
static void read_scenario(schuler_reading *r, const schuler_overrides *o, schuler_scenario *s)
{
    schuler_document *const doc = s->documents[0];
    const size_t errors = r->d->errors;
    apply_overrides(doc, o, r->d);
    schuler_scenario_file file;
    if (schuler_schema_read(schuler_document_root(doc), "", &schuler_scenario_object, &file,
                            r->arena, r->d) == SCHULER_ERR_MEMORY)
        return;
    if (schuler_document_root(doc)->kind != SCHULER_NODE_MAP) return;
    schuler_scenario_check(r, &file, s);
    override_sources(r, o, s);
    if (file.imu) {
        schuler_imu_read(r, file.imu, *s->folder ? s->folder : NULL, &s->imu, s->documents,
                         &s->document_count);
        schuler_scenario_check_sources(r, s);
    }
    if (file.trajectory) read_trajectory(r, file.trajectory, s);
    if (r->d->errors > errors || r->memory_failed || !s->trajectory_spec) return;
    if (build_path(r, s) != SCHULER_OK) {
        if (r->d->errors == errors)
            schuler_diagnose(r->d, SCHULER_ERR_NUMERIC, schuler_node_place(file.trajectory),
                             "the trajectory cannot be computed");
        return;
    }
    if (schuler_overlays_apply(&s->overlays.overlays, &s->path, &s->overlays.place, r->d) !=
        SCHULER_OK)
        return;
    schuler_scenario_check_duration(r, &file, s);
}

/* A scenario with its arena and document; NULL after an error. */
static schuler_scenario *create(const char *path, schuler_diagnostics *d)
{
    schuler_scenario *s = calloc(1, sizeof *s);
    if (s) {
        s->documents = calloc(SCHULER_DOCUMENTS_MAX, sizeof(schuler_document *));
        s->arena = schuler_arena_create();
        if (s->arena) s->file = schuler_arena_printf(s->arena, "%s", path);
        if (s->file) {
            const char *const slash = strrchr(s->file, '/');
            s->folder = schuler_arena_printf(s->arena, "%.*s",
                                             slash ? (int)(slash - s->file + 1) : 0, s->file);
        }
    }
    if (!s || !s->documents || !s->file || !s->folder) {
        schuler_diagnose(d, SCHULER_ERR_MEMORY, NULL, "out of memory");
        schuler_scenario_free(s);
        return NULL;
    }
    if (schuler_document_load_lenient(&s->documents[0], path, d) != SCHULER_OK) {
        schuler_scenario_free(s);
        return NULL;
    }
    s->document_count = 1;
    return s;
}

/* The status of the first error after the `kept` that were there. */
static schuler_status first_error(const schuler_diagnostics *d, size_t kept)
{
    for (size_t i = kept; i < d->kept; i++)
        if (!d->items[i].is_warning) return d->items[i].status;
    return SCHULER_ERR_INPUT;
}

schuler_status schuler_scenario_load(schuler_scenario **out, const char *path,
                                     const schuler_overrides *overrides, schuler_diagnostics *d)
{
    static const schuler_overrides none = { 0 };
    *out = NULL;
    const size_t kept = d->kept, errors = d->errors;
    schuler_scenario *s = create(path, d);
    if (!s) return first_error(d, kept);
    size_t length;
    const char *const text = schuler_document_text(s->documents[0], &length);
    SHA256Data((const unsigned char *)text, length, s->sha256);
    const schuler_overrides *const o = overrides ? overrides : &none;
    schuler_reading r = { .arena = s->arena, .d = d, .plugins = o->plugins };
    read_scenario(&r, o, s);
    for (size_t i = 0; i < s->document_count; i++) schuler_document_excerpts(s->documents[i], d);
    if (d->errors > errors) {
        schuler_scenario_free(s);
        return first_error(d, kept);
    }
    *out = s;
    return SCHULER_OK;
}

void schuler_scenario_free(schuler_scenario *s)
{
    if (!s) return;
    schuler_path_free(&s->path);
    for (size_t i = 0; i < s->document_count; i++) schuler_document_free(s->documents[i]);
    free(s->documents);
    schuler_arena_free(s->arena);
    free(s);
}

/* SPDX-License-Identifier: MIT */
#include "core/overlays.h"
#include "core/trajectory.h"
#include "mechanization/mechanization.h"
#include "tools/fields.h"
#include "tools/registry.h"

/* Frees both and gives NULL unless the item could be added. */
static json_t *append(json_t *list, json_t *item)
{
    if (list && item && json_array_append_new(list, item) == 0) return list;
    if (!list) json_decref(item);
    json_decref(list);
    return NULL;
}

static json_t *choices(const schuler_param *p)
{
    if (!p->choices) return json_null();
    json_t *list = json_array();
    for (int i = 0; list && p->choices[i]; i++) list = append(list, json_of_text(p->choices[i]));
    return list;
}

static json_t *limit(const schuler_param *p, double x)
{
    return (p->min == 0.0 && p->max == 0.0) || p->choices ? json_null() : json_of_number(x);
}

static json_t *param(schuler_instrument instrument, const schuler_param *p)
{
    char unit[FIELDS_UNIT_MAX], id[96];
    snprintf(id, sizeof id, "%s.%s", schuler_instrument_name(instrument), p->key);
    return json_pack("{s:o, s:o, s:o, s:s, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:s, s:b}",
                     "key", json_of_text(p->key), "doc", json_of_text(p->doc), "example",
                     json_of_text(p->example), "si_unit", fields_si_unit(p->dim, unit),
                     "components", p->components, "min", limit(p, p->min), "max", limit(p, p->max),
                     "default", p->number || p->choices ? json_null() : json_of_number(p->def),
                     "choices", choices(p), "formula", json_of_text(p->formula), "needs",
                     json_of_text(p->companion), "source", json_of_text(p->number ? id : NULL),
                     "number", p->number ? json_integer((json_int_t)p->number) : json_null(),
                     "acts", registry_acts(p->acts), "random_each_step", p->noisy != 0);
}

static json_t *params(const schuler_sensor_model *m, schuler_instrument instrument)
{
    const schuler_param *p = m->params[instrument];
    if (!p) return json_null();
    json_t *list = json_array();
    for (; list && p->key; p++) list = append(list, param(instrument, p));
    return list;
}

static json_t *sensor(const schuler_sensor_model *m, const char *plugin)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "name", json_of_text(m->name),
                     "summary", json_of_text(m->summary), "source", json_of_text(m->source),
                     "equation", json_of_text(m->equation), "departures",
                     json_of_text(m->departures), "plugin", json_of_text(plugin), "accel",
                     params(m, SCHULER_ACCEL), "gyro", params(m, SCHULER_GYRO));
}

static json_t *entry(const char *name, const char *summary, const char *source)
{
    return json_pack("{s:o, s:o, s:o}", "name", json_of_text(name), "summary",
                     json_of_text(summary), "source", json_of_text(source));
}

static json_t *entries(const registry_entry *from)
{
    json_t *list = json_array();
    for (; list && from->name; from++)
        list = append(list, entry(from->name, from->summary, from->source));
    return list;
}

json_t *registry_json(const schuler_plugins *plugins)
{
    const schuler_sensor_model *const *m = schuler_sensor_models(SCHULER_ISA_SCALAR);
    json_t *models = json_array(), *stages = json_array(), *kinds = json_array(),
           *frames = json_array();
    for (; models && *m; m++) models = append(models, sensor(*m, NULL));
    for (m = schuler_plugins_models(plugins); models && *m; m++)
        models = append(models, sensor(*m, schuler_plugins_path(plugins, *m)));
    for (m = schuler_sensor_stages(SCHULER_ISA_SCALAR); stages && *m; m++)
        stages = append(stages, sensor(*m, NULL));
    for (int i = 0; kinds && schuler_trajectory_kinds[i]; i++)
        kinds = append(kinds, entry(schuler_trajectory_kinds[i]->name,
                                    schuler_trajectory_kinds[i]->summary,
                                    schuler_trajectory_kinds[i]->source));
    json_t *overlays = json_array();
    for (int i = 0; overlays && schuler_overlay_kinds[i]; i++) {
        const schuler_object *const object = schuler_overlay_object(schuler_overlay_kinds[i]);
        overlays = append(overlays, entry(object->name, object->doc,
                                          schuler_overlay_source(schuler_overlay_kinds[i])));
    }
    const schuler_mechanization *const *f = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (; frames && *f; f++) {
        json_t *row = entry((*f)->name, (*f)->summary, (*f)->source);
        if (row) json_object_set_new(row, "equation", json_of_text((*f)->equation));
        if (row) json_object_set_new(row, "limits", json_of_text((*f)->limits));
        frames = append(frames, row);
    }
    json_t *algorithms = json_array();
    for (const schuler_coning_algorithm *a = schuler_coning_algorithms; algorithms && a->name;
         a++) {
        json_t *row = entry(a->name, a->summary, a->source);
        if (row) json_object_set_new(row, "error_law", json_of_text(a->law));
        algorithms = append(algorithms, row);
    }
    return json_pack("{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "format",
                     "schuler-models-1", "version", SCHULER_VERSION, "sensor_models", models,
                     "stages", stages, "spellings", entries(registry_spellings), "trajectories",
                     kinds, "overlays", overlays, "frames", frames, "coning", algorithms, "gravity",
                     registry_gravity_json());
}

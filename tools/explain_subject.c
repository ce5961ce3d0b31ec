/* SPDX-License-Identifier: MIT */
#include "tools/explain_subject.h"
#include "sensors/chain.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/registry.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const schuler_sensor_model *explain_model(const schuler_plugins *plugins, int i)
{
    const schuler_sensor_model *const *m = schuler_sensor_models(SCHULER_ISA_SCALAR);
    for (; *m && i > 0; m++) i--;
    if (*m) return *m;
    m = schuler_plugins_models(plugins);
    for (; *m && i > 0; m++) i--;
    return *m;
}

static int find(const schuler_param *params, const char *key)
{
    for (int i = 0; params && params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    return -1;
}

bool explain_model_has(const schuler_sensor_model *model, schuler_instrument instrument,
                       const char *key)
{
    return find(model->params[instrument], key) >= 0;
}

/* "gyro.bias" begins with an instrument: the key behind it, else NULL. */
static const char *key_of(const char *id, schuler_instrument *instrument)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const char *const group = schuler_instrument_name((schuler_instrument)i);
        const size_t length = strlen(group);
        if (strncmp(id, group, length) != 0 || id[length] != '.') continue;
        *instrument = (schuler_instrument)i;
        return id + length + 1;
    }
    return NULL;
}

static bool chain_has(const schuler_sensor_model *model, schuler_instrument instrument,
                      const char *key)
{
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    return model->params[instrument] && schuler_chain_params(model, instrument, params) > 0 &&
           find(params, key) >= 0;
}

/* Names of sources, each as often as it likes; owned. */
typedef struct {
    char **names;
    size_t count, room;
} name_list;

static void add_name(name_list *list, const char *group, const char *key)
{
    if (list->count == list->room) {
        const size_t room = list->room ? 2 * list->room : 256;
        char **const more = realloc(list->names, room * sizeof *more);
        if (!more) return;
        list->names = more;
        list->room = room;
    }
    char *name;
    if (asprintf(&name, "%s%s%s", group, *group ? "." : "", key) >= 0)
        list->names[list->count++] = name;
}

static void add_params(name_list *list, const schuler_sensor_model *m)
{
    for (int k = 0; k < SCHULER_INSTRUMENTS; k++)
        for (const schuler_param *p = m->params[k]; p && p->key; p++)
            if (p->number) add_name(list, schuler_instrument_name((schuler_instrument)k), p->key);
}

static name_list all_names(const schuler_plugins *plugins)
{
    name_list list = { NULL, 0, 0 };
    const schuler_sensor_model *m;
    for (int i = 0; (m = explain_model(plugins, i)) != NULL; i++) add_params(&list, m);
    for (const schuler_sensor_model *const *s = schuler_sensor_stages(SCHULER_ISA_SCALAR); *s; s++)
        add_params(&list, *s);
    for (const schuler_growth_other *o = schuler_growth_others(); o->id; o++)
        add_name(&list, "", o->id);
    return list;
}

/* A key without its group is meant in the first group that has it. */
static const char *with_group(const name_list *list, const char *written)
{
    for (size_t i = 0; i < list->count; i++) {
        const char *const dot = strchr(list->names[i], '.');
        if (dot && strcmp(dot + 1, written) == 0) return list->names[i];
    }
    return NULL;
}

static exit_code unknown_source(const char *id, const schuler_plugins *plugins)
{
    const name_list list = all_names(plugins);
    const char *nearest = with_group(&list, id);
    if (!nearest) nearest = schuler_nearest(id, (const char *const *)list.names, list.count);
    exit_code code;
    if (nearest)
        code = say_bad_input("unknown error source '%.60s'; did you mean '%s'?", id, nearest);
    else
        code = say_bad_input("unknown error source '%.60s'; it is GROUP.KEY, such as gyro.bias; "
                             "'schuler models' lists the models and their keys",
                             id);
    for (size_t i = 0; i < list.count; i++) free(list.names[i]);
    free(list.names);
    return code;
}

static exit_code unknown_model(const char *name, schuler_instrument instrument,
                               const schuler_plugins *plugins)
{
    const char *known[2 * NAMES_MAX];
    size_t count = 0;
    const schuler_sensor_model *m;
    for (int i = 0; (m = explain_model(plugins, i)) != NULL && count + 1 < 2 * NAMES_MAX; i++)
        if (m->params[instrument]) known[count++] = m->name;
    known[count] = NULL;
    char hint[NAMES_HINT_MAX];
    names_hint(hint, name, known);
    return say_bad_input("--model: there is no %s model '%.60s'%s",
                         schuler_instrument_name(instrument), name, hint);
}

/* The one that is asked for, else that of the IMU, else linear, else the first one: of those that have
 * the key. NULL: none has it. */
static const schuler_sensor_model *choose_model(const char *key, schuler_instrument instrument,
                                                const schuler_imu *imu,
                                                const schuler_plugins *plugins)
{
    const schuler_sensor_model *m = imu ? imu->triad[instrument].model : NULL;
    if (m && chain_has(m, instrument, key)) return m;
    for (int i = 0; (m = explain_model(plugins, i)) != NULL; i++)
        if (chain_has(m, instrument, key)) return m; /* linear is the first of the table */
    return NULL;
}

static exit_code wanted_model(const char *id, const char *key, const char *name,
                              schuler_instrument instrument, const schuler_plugins *plugins,
                              const schuler_sensor_model **out)
{
    const schuler_sensor_model *m;
    int i = 0;
    while ((m = explain_model(plugins, i)) != NULL && strcmp(m->name, name) != 0) i++;
    if (!m || !m->params[instrument]) return unknown_model(name, instrument, plugins);
    *out = m;
    if (chain_has(m, instrument, key)) return EXIT_DONE;
    const schuler_sensor_model *const other = choose_model(key, instrument, NULL, plugins);
    if (!other) return unknown_source(id, plugins);
    return say_bad_input("the %s model '%s' has no '%.60s'; '%s' has it",
                         schuler_instrument_name(instrument), m->name, key, other->name);
}

static exit_code find_sensor(explain_subject *out, const char *id, const char *key,
                             const char *wanted, const schuler_imu *imu,
                             const schuler_plugins *plugins)
{
    const schuler_sensor_model *model = NULL;
    if (wanted) {
        const exit_code code = wanted_model(id, key, wanted, out->instrument, plugins, &model);
        if (code != EXIT_DONE) return code;
    } else
        model = choose_model(key, out->instrument, imu, plugins);
    if (!model) return unknown_source(id, plugins);
    out->model = model;
    schuler_chain_params(model, out->instrument, out->params);
    out->index = find(out->params, key);
    out->owner = explain_model_has(model, out->instrument, key) ? model : registry_stage(key);
    if (imu && imu->triad[out->instrument].model == model)
        out->triad = &imu->triad[out->instrument];
    if (out->params[out->index].number == 0)
        return say_bad_input("'%s' is a setting, no error source; 'schuler models show %s' "
                             "explains it",
                             id, out->owner->name);
    out->text = schuler_growth_text_of(out->instrument, out->params[out->index].acts);
    return out->text ? EXIT_DONE : unknown_source(id, plugins);
}

exit_code explain_subject_find(explain_subject *out, const char *id, const char *model,
                               const schuler_imu *imu, const schuler_plugins *plugins)
{
    *out = (explain_subject){ .id = id };
    for (const schuler_growth_other *o = schuler_growth_others(); o->id; o++) {
        if (strcmp(o->id, id) != 0) continue;
        if (model) return say_bad_input("--model: '%s' is no error of a sensor model", id);
        out->other = o;
        out->text = &o->text;
        return EXIT_DONE;
    }
    const char *const key = key_of(id, &out->instrument);
    if (!key) return unknown_source(id, plugins);
    for (int i = 0; registry_spellings[i].name; i++)
        if (strcmp(registry_spellings[i].name, key) == 0)
            return say_bad_input("'%s' says an error source in the words of data sheets; "
                                 "'schuler models show %s' says which",
                                 id, key);
    return find_sensor(out, id, key, model, imu, plugins);
}

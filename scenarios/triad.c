/* SPDX-License-Identifier: MIT */
/* The keys of `accel` and `gyro`: a model of the registry and its parameters. */
#include "scenarios/part.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int find_param(const schuler_param *params, const char *key)
{
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    return -1;
}

static schuler_field field_of(const schuler_param *param)
{
    return (schuler_field){ .key = param->key,
                            .kind = SCHULER_FIELD_VALUE,
                            .dim = param->dim,
                            .components = param->components,
                            .min = param->min,
                            .max = param->max,
                            .example = param->example,
                            .doc = param->doc };
}

static void unknown_model(schuler_reading *r, const schuler_node *node, const char *what,
                          const char *written, schuler_instrument instrument)
{
    const schuler_sensor_model *const *models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    const char *names[64];
    size_t count = 0;
    for (size_t i = 0; models[i] && count < 64; i++)
        if (models[i]->params[instrument]) names[count++] = models[i]->name;
    char lead[240];
    snprintf(lead, sizeof lead, "%.100s.model: there is no %s model '%.60s'", what,
             schuler_instrument_name(instrument), written);
    schuler_diagnose_unknown(r, &node->place, lead, written, names, count);
}

/* The model that is asked for, or the one that is there; false when there is none. */
static bool choose_model(schuler_reading *r, const schuler_node *node, const char *what,
                         schuler_instrument instrument, schuler_triad *triad)
{
    const schuler_node *const named = schuler_node_find(node, "model");
    if (!named) {
        if (!triad->model)
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                             "'%.100s' needs the key 'model', for example: linear", what);
        return triad->model != NULL;
    }
    const char *text =
        schuler_read_scalar(r, named, schuler_reading_path(r, what, "model"), "a model's name");
    if (!text) return false;
    const int index = schuler_sensor_model_find(text);
    const schuler_sensor_model *model =
        index >= 0 ? schuler_sensor_models(SCHULER_ISA_SCALAR)[index] : NULL;
    if (!model || !model->params[instrument]) {
        unknown_model(r, named, what, text, instrument);
        return false;
    }
    if (model != triad->model) *triad = (schuler_triad){ .model = model, .model_index = index };
    return true;
}

static const char *walk_key(schuler_instrument instrument)
{
    return instrument == SCHULER_ACCEL ? "velocity_random_walk" : "angle_random_walk";
}

/* A data-sheet density, turned into the random walk N. With the two-sided convention N is the
 * density itself; a one-sided density holds twice the power, so N is smaller by sqrt(2). */
static void read_density(schuler_reading *r, const schuler_node *node, const char *what,
                         schuler_instrument instrument, const schuler_param *walk,
                         schuler_value *out)
{
    const schuler_node *const density = schuler_node_find(node, "noise_density");
    const schuler_node *const sided = schuler_node_find(node, "sided");
    if (schuler_node_find(node, walk->key)) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(density),
                         "'%.100s' has both 'noise_density' and '%s', which mean the same noise; "
                         "give one of them",
                         what, walk->key);
        return;
    }
    if (!sided) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(density),
                         "'%.100s' needs the key 'sided' beside 'noise_density': one or two; a "
                         "one-sided density, as most data sheets give, is sqrt(2) times the random "
                         "walk, a two-sided one is the random walk",
                         what);
        return;
    }
    const char *const text =
        schuler_read_scalar(r, sided, schuler_reading_path(r, what, "sided"), "one or two");
    const bool one = text && strcmp(text, "one") == 0, two = text && strcmp(text, "two") == 0;
    if (text && !one && !two)
        schuler_expected(r, sided, schuler_reading_path(r, what, "sided"), "one or two");
    schuler_field field = field_of(walk);
    field.example = instrument == SCHULER_ACCEL ? "100 ug/sqrt(Hz)" : "0.01 deg/s/sqrt(Hz)";
    schuler_value value;
    if (!schuler_read_value(r, density, schuler_reading_path(r, what, "noise_density"), &field,
                            &value) ||
        !(one || two))
        return;
    for (int i = 0; one && i < SCHULER_VALUE_MAX; i++) {
        value.a[i] /= sqrt(2.0);
        value.b[i] /= sqrt(2.0);
    }
    const char *spelled = schuler_arena_printf(r->arena, "%s %s-sided", value.text, text);
    if (spelled) value.text = spelled;
    *out = value;
}

static void unknown_param(schuler_reading *r, const schuler_node *key, const char *what,
                          const schuler_param *params)
{
    const char *names[SCHULER_PARAMS_MAX + 3] = { "model", "noise_density", "sided" };
    size_t count = 3;
    for (int i = 0; params[i].key && i < SCHULER_PARAMS_MAX; i++) names[count++] = params[i].key;
    char lead[240];
    snprintf(lead, sizeof lead, "unknown key '%.60s' in '%.100s'", key->text, what);
    schuler_diagnose_unknown(r, &key->place, lead, key->text, names, count);
}

void schuler_triad_read(schuler_reading *r, const schuler_node *node, const char *what,
                        schuler_instrument instrument, schuler_triad *triad)
{
    if (node->kind != SCHULER_NODE_MAP) {
        schuler_expected(r, node, what, "a map of keys");
        return;
    }
    if (!choose_model(r, node, what, instrument, triad)) return;
    const schuler_param *const params = triad->model->params[instrument];
    const int walk = find_param(params, walk_key(instrument));
    const bool has_density = schuler_node_find(node, "noise_density") != NULL;
    for (size_t i = 0; i < node->count; i++) {
        const schuler_node *const key = node->pairs[i].key;
        const bool is_noise =
            strcmp(key->text, "noise_density") == 0 || strcmp(key->text, "sided") == 0;
        if (strcmp(key->text, "model") == 0 || (is_noise && walk >= 0 && has_density)) continue;
        const int index = find_param(params, key->text);
        if (is_noise && walk >= 0) {
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &key->place,
                             "'%.100s' has 'sided' without 'noise_density'", what);
        } else if (index < 0) {
            unknown_param(r, key, what, params);
        } else if (schuler_node_find(node, key->text) == node->pairs[i].value) {
            const schuler_field field = field_of(&params[index]);
            (void)schuler_read_value(r, node->pairs[i].value,
                                     schuler_reading_path(r, what, key->text), &field,
                                     &triad->values[index]);
        }
    }
    if (has_density && walk >= 0)
        read_density(r, node, what, instrument, &params[walk], &triad->values[walk]);
}

void schuler_triad_finish(schuler_reading *r, const char *what, schuler_instrument instrument,
                          schuler_triad *triad)
{
    if (!triad->model) return;
    const schuler_param *const params = triad->model->params[instrument];
    for (int i = 0; params[i].key; i++) {
        schuler_value *const value = &triad->values[i];
        if (!value->given && params[i].number == 0)
            for (int k = 0; k < params[i].components; k++) value->a[k] = params[i].def;
        if (!value->given || !params[i].companion) continue;
        const int companion = find_param(params, params[i].companion);
        if (companion < 0 || triad->values[companion].given) continue;
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &value->place,
                         "'%.100s' needs the key '%s' beside '%s', for example: %s", what,
                         params[i].companion, params[i].key, params[companion].example);
    }
}

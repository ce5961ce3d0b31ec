/* SPDX-License-Identifier: MIT */
/* The keys of `accel` and `gyro`: a model of the registry and its parameters. */
#include "scenarios/part.h"
#include "sensors/chain.h"
#include "sensors/mounting.h"
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
    models = schuler_plugins_models(r->plugins);
    for (size_t i = 0; models[i] && count < 64; i++)
        if (models[i]->params[instrument]) names[count++] = models[i]->name;
    char lead[240];
    snprintf(lead, sizeof lead, "%.100s.model: there is no %s model '%.60s'", what,
             schuler_instrument_name(instrument), written);
    schuler_diagnose_unknown(r, &node->place, lead, written, names, count);
}

static bool take_model(schuler_reading *r, const schuler_node *named,
                       const schuler_sensor_model *model, int index, schuler_instrument instrument,
                       schuler_triad *triad)
{
    schuler_param *const params =
        schuler_reading_alloc(r, (SCHULER_PARAMS_MAX + 1) * sizeof *params);
    if (!params) return false;
    if (schuler_chain_params(model, instrument, params) < 0) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &named->place,
                         "the model '%.60s' has too many parameters", model->name);
        return false;
    }
    *triad = (schuler_triad){ .model = model, .model_index = index, .params = params };
    return true;
}

/* A built-in one or, index -1, a plug-in's; NULL when there is none of that name. */
static const schuler_sensor_model *find_model(const schuler_reading *r, const char *name,
                                              int *index)
{
    *index = schuler_sensor_model_find(name);
    if (*index >= 0) return schuler_sensor_models(SCHULER_ISA_SCALAR)[*index];
    const schuler_sensor_model *const *models = schuler_plugins_models(r->plugins);
    while (*models && strcmp((*models)->name, name) != 0) models++;
    return *models;
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
    int index;
    const schuler_sensor_model *const model = find_model(r, text, &index);
    if (!model || !model->params[instrument]) {
        unknown_model(r, named, what, text, instrument);
        return false;
    }
    return model == triad->model || take_model(r, named, model, index, instrument, triad);
}

/* The word of a setting that is one of a few. */
static void read_choice(schuler_reading *r, const schuler_node *node, const char *path,
                        const schuler_param *param, schuler_value *out)
{
    const char *const text = schuler_read_scalar(r, node, path, "a word");
    size_t count = 0;
    if (!text) return;
    for (; param->choices[count]; count++)
        if (strcmp(param->choices[count], text) == 0) {
            *out = (schuler_value){ .given = true, .place = node->place, .text = text };
            out->a[0] = (double)count;
            return;
        }
    char lead[240];
    snprintf(lead, sizeof lead, "%.100s: '%.60s' is not one of its words", path, text);
    schuler_diagnose_unknown(r, &node->place, lead, text, param->choices, count);
}

static void read_param(schuler_reading *r, const schuler_node *node, const char *path,
                       const schuler_param *param, schuler_value *out)
{
    const schuler_field field = field_of(param);
    if (param->choices)
        read_choice(r, node, path, param, out);
    else if (schuler_read_value(r, node, path, &field, out) && param->number == 0 &&
             out->draw != SCHULER_DRAW_FIXED) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place,
                         "%.100s: a setting, the same in every run; it cannot be drawn", path);
        out->given = false;
    }
}

static void divide(schuler_value *v, double by)
{
    for (int i = 0; i < SCHULER_VALUE_MAX; i++) {
        v->a[i] /= by;
        v->b[i] /= by;
    }
}

/* Keys that say another one in the words of data sheets. */
static const struct {
    const char *key;
    const char *stands_for[SCHULER_INSTRUMENTS], *example[SCHULER_INSTRUMENTS];
} spellings[] = {
    { "noise_density",
      { "velocity_random_walk", "angle_random_walk" },
      { "100 ug/sqrt(Hz)", "0.01 deg/s/sqrt(Hz)" } },
    { "allan_floor", { "bias_instability", "bias_instability" }, { "10 ug", "0.3 deg/h" } },
};
enum { DENSITY, FLOOR, SPELLINGS };

/* Whether a density is one-sided: 1, 0; -1 after an error. */
static int read_sided(schuler_reading *r, const schuler_node *node, const schuler_node *density,
                      const char *what)
{
    const schuler_node *const sided = schuler_node_find(node, "sided");
    if (!sided) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(density),
                         "'%.100s' needs the key 'sided' beside 'noise_density': one or two; a "
                         "one-sided density, as most data sheets give, is sqrt(2) times the random "
                         "walk, a two-sided one is the random walk",
                         what);
        return -1;
    }
    const char *const path = schuler_reading_path(r, what, "sided");
    const char *const text = schuler_read_scalar(r, sided, path, "one or two");
    const bool one = text && strcmp(text, "one") == 0, two = text && strcmp(text, "two") == 0;
    if (text && !one && !two) schuler_expected(r, sided, path, "one or two");
    return one ? 1 : two ? 0 : -1;
}

/* A density becomes the random walk N: with the two-sided convention N is the density itself; a
 * one-sided density holds twice the power, so N is smaller by sqrt(2). The floor of the Allan
 * deviation is sqrt(2 ln 2/pi) of the flicker coefficient B. */
static void read_spelling(schuler_reading *r, const schuler_node *node, const char *what,
                          schuler_instrument instrument, int which, schuler_triad *triad)
{
    const char *const key = spellings[which].key;
    const char *const meant = spellings[which].stands_for[instrument];
    const schuler_node *const written = schuler_node_find(node, key);
    const int index = find_param(triad->params, meant);
    if (!written || index < 0) return;
    if (schuler_node_find(node, meant)) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(written),
                         "'%.100s' has both '%s' and '%s', which mean the same; give one of them",
                         what, key, meant);
        return;
    }
    const int one_sided = which == DENSITY ? read_sided(r, node, written, what) : 0;
    schuler_field field = field_of(&triad->params[index]);
    field.example = spellings[which].example[instrument];
    schuler_value value;
    if (!schuler_read_value(r, written, schuler_reading_path(r, what, key), &field, &value) ||
        one_sided < 0)
        return;
    if (one_sided) divide(&value, sqrt(2.0));
    if (which == FLOOR) divide(&value, sqrt(2.0 * log(2.0) / M_PI));
    const char *const spelled = schuler_arena_printf(r->arena, "%s %s", value.text,
                                                     which == FLOOR ? "Allan floor"
                                                     : one_sided    ? "one-sided"
                                                                    : "two-sided");
    if (spelled) value.text = spelled;
    triad->values[index] = value;
}

static void unknown_param(schuler_reading *r, const schuler_node *key, const char *what,
                          const schuler_param *params)
{
    const char *names[SCHULER_PARAMS_MAX + 4] = { "model", "noise_density", "sided",
                                                  "allan_floor" };
    size_t count = 4;
    for (int i = 0; params[i].key && i < SCHULER_PARAMS_MAX; i++) names[count++] = params[i].key;
    char lead[240];
    snprintf(lead, sizeof lead, "unknown key '%.60s' in '%.100s'", key->text, what);
    schuler_diagnose_unknown(r, &key->place, lead, key->text, names, count);
}

/* Keys that are no parameters of their own. */
static bool is_special(const char *key)
{
    static const char *const special[] = { "model", "use", "noise_density", "sided",
                                           "allan_floor" };
    for (size_t i = 0; i < sizeof special / sizeof special[0]; i++)
        if (strcmp(key, special[i]) == 0) return true;
    return false;
}

void schuler_triad_read(schuler_reading *r, const schuler_node *node, const char *what,
                        schuler_instrument instrument, schuler_triad *triad)
{
    if (node->kind != SCHULER_NODE_MAP) {
        schuler_expected(r, node, what, "a map of keys");
        return;
    }
    if (!choose_model(r, node, what, instrument, triad)) return;
    const schuler_param *const params = triad->params;
    for (size_t i = 0; i < node->count; i++) {
        const schuler_node *const key = node->pairs[i].key;
        const int index = find_param(params, key->text);
        if (index >= 0 && schuler_node_find(node, key->text) == node->pairs[i].value)
            read_param(r, node->pairs[i].value, schuler_reading_path(r, what, key->text),
                       &params[index], &triad->values[index]);
        else if (index < 0 && !is_special(key->text))
            unknown_param(r, key, what, params);
    }
    const schuler_node *const sided = schuler_node_find(node, "sided");
    if (sided && !schuler_node_find(node, "noise_density"))
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(sided),
                         "'%.100s' has 'sided' without 'noise_density'", what);
    for (int k = 0; k < SPELLINGS; k++) read_spelling(r, node, what, instrument, k, triad);
}

/* The axes of the instruments must make a triad of each, and together see all of space. */
static void check_mounting(schuler_reading *r, const char *what, const schuler_triad *triad)
{
    const int input = find_param(triad->params, "input_axes");
    int second = find_param(triad->params, "pendulous_axes");
    if (second < 0) second = find_param(triad->params, "output_axes");
    if (input < 0 || second < 0) return;
    const schuler_value *const i = &triad->values[input], *const p = &triad->values[second];
    double axes[3][3][3], back[3][3];
    schuler_mounting_axes(i->a, p->a, axes);
    if (schuler_mounting_back(axes, back)) return;
    schuler_mounting_axes(i->a, (double[9]){ 0 }, axes);
    const bool flat = !schuler_mounting_back(axes, back) && i->given;
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, flat ? &i->place : &p->place, "%.100s.%s: %s", what,
                     triad->params[flat ? input : second].key,
                     flat ? "the three axes lie in a plane, so the input cannot be found from what "
                            "they measure"
                          : "an axis that is no direction, or the input axis itself");
}

void schuler_triad_finish(schuler_reading *r, const char *what, schuler_triad *triad)
{
    if (!triad->model) return;
    const schuler_param *const params = triad->params;
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
    check_mounting(r, what, triad);
}

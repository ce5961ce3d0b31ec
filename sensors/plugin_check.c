/* SPDX-License-Identifier: MIT */
#include "sensors/plugin_check.h"
#include "sensors/chain.h"
#include "sensors/plugin.h"
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { NAME_MAX_ = 40, NOISY_MAX = 100, SIGNALS_MAX = 1000, STATE_MAX = 1 << 24 };

typedef struct {
    const char *path;
    schuler_error *err;
    /* All tables there are: built-in models, stages, plug-ins before, this one's models. */
    const schuler_sensor_model *const *lists[4];
    const schuler_sensor_model *model; /* the one that is looked at */
    int index;
    schuler_instrument instrument;
} check;

static schuler_status wrong(const check *c, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static schuler_status wrong(const check *c, const char *format, ...)
{
    const schuler_place place = { c->path, 0, 0, 0 };
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return schuler_fail(c->err, SCHULER_ERR_INPUT, &place, "%s", text);
}

static bool is_word(const char *text)
{
    if (!isalpha((unsigned char)text[0]) || strlen(text) > NAME_MAX_) return false;
    for (; *text; text++)
        if (!isalnum((unsigned char)*text) && *text != '_') return false;
    return true;
}

static schuler_status check_name(const check *c)
{
    static const char *const whose[] = { "a built-in model", "a stage", "a plug-in before it",
                                         "another model of this one" };
    const char *const name = c->model->name;
    if (!name) return wrong(c, "a model without a name");
    if (!is_word(name))
        return wrong(c, "the name '%.60s' of a model: letters, digits and _ are expected", name);
    for (int i = 0; i < 4; i++)
        for (int k = 0; c->lists[i][k] && (i < 3 || k < c->index); k++)
            if (strcmp(c->lists[i][k]->name, name) == 0)
                return wrong(c, "the name '%s' is taken by %s", name, whose[i]);
    return SCHULER_OK;
}

static schuler_status check_functions(const check *c)
{
    const schuler_sensor_model *const m = c->model;
    if (!m->summary || !m->source)
        return wrong(c, "model '%s' has no %s", m->name, m->summary ? "source" : "summary");
    if (!m->setup || !m->apply)
        return wrong(c, "model '%s' has no function '%s'", m->name, m->setup ? "apply" : "setup");
    if (m->signals < 0 || m->signals > SIGNALS_MAX || (m->signals > 0) != (m->observe != NULL))
        return wrong(c, "model '%s': 'signals' and 'observe' go together", m->name);
    if (m->state_size == 0 || m->state_size > STATE_MAX)
        return wrong(c, "model '%s': a state_size of %zu bytes", m->name, m->state_size);
    return m->params[SCHULER_ACCEL] || m->params[SCHULER_GYRO]
               ? SCHULER_OK
               : wrong(c, "model '%s' has no parameters for accel or gyro", m->name);
}

static bool is_special(const char *key)
{
    static const char *const special[] = { "model", "use", "noise_density", "sided",
                                           "allan_floor" };
    for (size_t i = 0; i < sizeof special / sizeof special[0]; i++)
        if (strcmp(special[i], key) == 0) return true;
    return false;
}

/* What is wrong with the numbers of a parameter; NULL when nothing is. */
static const char *fault_of(const schuler_param *p)
{
    if (p->components != 1 && p->components != 3 && p->components != 6 && p->components != 9)
        return "components must be 1, 3, 6 or 9";
    if (!p->doc || !p->example) return "it needs a doc and an example";
    if (p->choices)
        return p->number || p->components != 1 || !p->choices[0]
                   ? "choices are for a setting of one component"
                   : NULL;
    if (!isfinite(p->min) || !isfinite(p->max) || p->min > p->max)
        return "min and max must be finite, and in this order";
    if (p->noisy < 0 || p->noisy > NOISY_MAX) return "noisy is out of range";
    if (p->acts < SCHULER_ACTS_NOT || p->acts > SCHULER_ACTS_RESPONSE) return "acts is unknown";
    if (p->number == 0) {
        const bool is_any = p->min == 0.0 && p->max == 0.0;
        if (!isfinite(p->def) || (!is_any && (p->def < p->min || p->def > p->max)))
            return "the default is out of its range";
        return p->acts == SCHULER_ACTS_NOT ? NULL : "a setting (no number) does not act";
    }
    if (p->acts == SCHULER_ACTS_NOT) return "an error source must say how it acts";
    return p->formula ? NULL : "an error source needs a formula";
}

static int find(const schuler_param *params, const char *key)
{
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    return -1;
}

static schuler_status check_params(const check *c)
{
    const char *const name = c->model->name;
    const char *const what = schuler_instrument_name(c->instrument);
    schuler_param all[SCHULER_PARAMS_MAX + 1];
    if (schuler_chain_params(c->model, c->instrument, all) < 0)
        return wrong(c,
                     "model '%s' has too many parameters for %s: %d is the limit, with those of "
                     "all stages",
                     name, what, SCHULER_PARAMS_MAX);
    const schuler_param *const params = c->model->params[c->instrument];
    int own = 0, count = 0;
    while (params[own].key) own++;
    for (; count < own; count++) {
        const schuler_param *const p = &params[count];
        if (!is_word(p->key) || is_special(p->key))
            return wrong(c,
                         "model '%s': '%.60s' cannot be a key: letters, digits and _, and not one "
                         "that means something else",
                         name, p->key);
        if (find(params, p->key) < count)
            return wrong(c, "model '%s' has the key '%s' twice", name, p->key);
        if (find(&all[own], p->key) >= 0)
            return wrong(c, "model '%s': the key '%s' is a stage's", name, p->key);
        const char *const fault = fault_of(p);
        if (fault) return wrong(c, "model '%s', key '%s': %s", name, p->key, fault);
        if (p->companion && find(all, p->companion) < 0)
            return wrong(c, "model '%s', key '%s': its companion '%.60s' is no key", name, p->key,
                         p->companion);
    }
    const schuler_param *const end = &params[count];
    if (end->number || end->components || end->doc || end->example)
        return wrong(c, "model '%s': parameter %d for %s has no key", name, count + 1, what);
    return count > 0 ? SCHULER_OK : wrong(c, "model '%s' has no parameters for %s", name, what);
}

/* A key that is known has its number, a number that is known has its key, whatever the model: they
 * are what random numbers are drawn by. */
static schuler_status check_number(const check *c, const schuler_param *p)
{
    const char *const name = c->model->name;
    bool is_known = false;
    for (int i = 0; i < 4 * SCHULER_INSTRUMENTS; i++) {
        const schuler_sensor_model *const *const list = c->lists[i / SCHULER_INSTRUMENTS];
        const schuler_instrument instrument = (schuler_instrument)(i % SCHULER_INSTRUMENTS);
        for (int k = 0; list[k]; k++)
            for (const schuler_param *q = list[k]->params[instrument]; q && q->key; q++) {
                const bool same_key = instrument == c->instrument && strcmp(q->key, p->key) == 0;
                if (same_key && q->number != p->number)
                    return wrong(c, "model '%s': the key '%s' has the number %u, but %u in '%s'",
                                 name, p->key, p->number, q->number, list[k]->name);
                if (!same_key && p->number && q->number == p->number)
                    return wrong(c, "model '%s': the number %u of the key '%s' belongs to '%s.%s'",
                                 name, p->number, p->key, schuler_instrument_name(instrument),
                                 q->key);
                is_known |= same_key && i / SCHULER_INSTRUMENTS < 2;
            }
    }
    if (is_known || p->number == 0 || p->number >= SCHULER_PLUGIN_NUMBERS) return SCHULER_OK;
    return wrong(c, "model '%s': the number of the key '%s' is %u; those of plug-ins begin at %d",
                 name, p->key, p->number, SCHULER_PLUGIN_NUMBERS);
}

schuler_status schuler_plugin_check(const char *path, const schuler_sensor_model *const *models,
                                    const schuler_sensor_model *const *loaded, schuler_error *err)
{
    check c = { .path = path,
                .err = err,
                .lists = { schuler_sensor_models(SCHULER_ISA_SCALAR),
                           schuler_sensor_stages(SCHULER_ISA_SCALAR), loaded, models } };
    schuler_status status = models[0] ? SCHULER_OK : wrong(&c, "a plug-in without models");
    for (int k = 0; status == SCHULER_OK && models[k]; k++) {
        c.model = models[k];
        c.index = k;
        status = check_name(&c);
        if (status == SCHULER_OK) status = check_functions(&c);
        for (int i = 0; status == SCHULER_OK && i < SCHULER_INSTRUMENTS; i++) {
            c.instrument = (schuler_instrument)i;
            if (c.model->params[i]) status = check_params(&c);
        }
    }
    /* Only now are all tables known to have an end. */
    for (int k = 0; status == SCHULER_OK && models[k]; k++)
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            c.model = models[k];
            c.instrument = (schuler_instrument)i;
            const schuler_param *p = c.model->params[i];
            for (; status == SCHULER_OK && p && p->key; p++) status = check_number(&c, p);
        }
    return status;
}

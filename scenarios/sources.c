/* SPDX-License-Identifier: MIT */
#include "scenarios/sources.h"
#include "sensors/barometer.h"
#include <stdio.h>
#include <string.h>

static bool listed(const schuler_text_list *list, const char *id, const char *group)
{
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->items[i], id) == 0 || strcmp(list->items[i], group) == 0) return true;
    return false;
}

static bool selected(const schuler_text_list *only, const schuler_text_list *without,
                     const char *id, const char *group)
{
    if (only->count > 0 && !listed(only, id, group)) return false;
    return !listed(without, id, group);
}

bool schuler_source_selected(const schuler_scenario *s, const char *id, const char *group)
{
    return selected(&s->only, &s->without, id, group);
}

static const struct {
    const char *key;
    unsigned number;
    bool noisy;
} baro_sources[SCHULER_BARO_ERRORS] = {
    [SCHULER_BARO_BIAS] = { "bias", BAROMETER_BIAS, false },
    [SCHULER_BARO_SCALE_FACTOR] = { "scale_factor", BAROMETER_SCALE_FACTOR, false },
    [SCHULER_BARO_LAG] = { "lag", BAROMETER_LAG, false },
    [SCHULER_BARO_NOISE] = { "noise", BAROMETER_NOISE, true },
    [SCHULER_BARO_GAUSS_MARKOV] = { "gauss_markov", BAROMETER_GAUSS_MARKOV, true },
};

/* The list so far, and who may get in. */
typedef struct {
    const schuler_text_list *only, *without;
    error_source *out;
    int count;
} source_list;

static void add(source_list *l, error_source source, const char *key)
{
    snprintf(source.id, sizeof(source.id), "%s.%s", source.group, key);
    if (source.value &&
        (!source.value->given || schuler_value_is_zero(source.value, source.components)))
        return;
    if (!selected(l->only, l->without, source.id, source.group)) return;
    if (source.value && source.value->draw != SCHULER_DRAW_FIXED) source.drawn = true;
    l->out[l->count++] = source;
}

static void add_triad(source_list *l, const schuler_imu *imu, schuler_instrument instrument)
{
    const schuler_triad *triad = &imu->triad[instrument];
    if (!triad->model) return;
    const schuler_param *params = triad->params;
    for (int p = 0; params && params[p].key; p++) {
        if (params[p].number == 0) continue;
        error_source source = {
            .kind = SOURCE_SENSOR,
            .instrument = instrument,
            .param = p,
            .number = params[p].number,
            .components = params[p].components,
            .unit = imu->unit,
            .value = &triad->values[p],
            /* The phase of a sinusoid is drawn, whatever its amplitude is. */
            .drawn = params[p].noisy != 0 || params[p].acts == SCHULER_ACTS_PERIODIC,
            .normals = 3 * params[p].noisy,
        };
        snprintf(source.group, sizeof(source.group), "%s", schuler_instrument_name(instrument));
        add(l, source, params[p].key);
    }
}

int schuler_sources_of_imu(const schuler_imu *imu, const schuler_text_list *only,
                           const schuler_text_list *without, error_source out[SOURCES_MAX])
{
    source_list l = { only, without, out, 0 };
    add_triad(&l, imu, SCHULER_ACCEL);
    add_triad(&l, imu, SCHULER_GYRO);
    return l.count;
}

const char *schuler_baro_key(schuler_baro_error error)
{
    return baro_sources[error].key;
}

/* They act through the loop alone. */
static void add_barometer(source_list *l, const schuler_scenario *s)
{
    if (s->vertical != SCHULER_VERTICAL_BARO) return;
    for (int i = 0; i < SCHULER_BARO_ERRORS; i++)
        add(l,
            (error_source){ .kind = SOURCE_BARO,
                            .group = "baro",
                            .param = i,
                            .number = baro_sources[i].number,
                            .components = 1,
                            .value = &s->baro[i],
                            .drawn = baro_sources[i].noisy },
            baro_sources[i].key);
}

int schuler_sources_list(const schuler_scenario *s, error_source out[SOURCES_MAX])
{
    /* Numbers 1 to 4 belong to the start; sensor parameters have theirs from 100 on. */
    const struct {
        source_kind kind;
        const char *key;
        unsigned number;
        int components;
        const schuler_value *value;
    } initial[] = {
        { SOURCE_POSITION, "position", 1, 3, &s->position },
        { SOURCE_VELOCITY, "velocity", 2, 3, &s->velocity },
        { SOURCE_TILT, "tilt", 3, 2, &s->tilt },
        { SOURCE_HEADING, "heading", 4, 1, &s->heading },
    };
    source_list l = { &s->only, &s->without, out,
                      schuler_sources_of_imu(&s->imu, &s->only, &s->without, out) };
    for (size_t i = 0; i < sizeof(initial) / sizeof(initial[0]); i++)
        add(&l,
            (error_source){ .kind = initial[i].kind,
                            .group = "initial",
                            .number = initial[i].number,
                            .components = initial[i].components,
                            .value = initial[i].value },
            initial[i].key);
    if (strcmp(s->truth_gravity, s->nav_gravity) != 0)
        add(&l, (error_source){ .kind = SOURCE_GRAVITY, .group = "gravity" }, "disturbance");
    add_barometer(&l, s);
    return l.count;
}

double schuler_source_draw(const error_source *source, int component, uint64_t seed, uint64_t run)
{
    const schuler_value *v = source->value;
    const bool fixed = v->per_unit && source->unit >= 0;
    const schuler_stream stream = { seed, fixed ? (uint64_t)source->unit : run, source->number,
                                    (unsigned)component, SCHULER_USE_DRAW };
    switch (v->draw) {
    case SCHULER_DRAW_NORMAL:
        return v->a[component] * schuler_stream_normal(stream, 0);
    case SCHULER_DRAW_UNIFORM:
        return v->a[component] + (v->b[component] - v->a[component]) * 0.5 *
                                     (1.0 + schuler_stream_uniform(stream, 0));
    default:
        return v->a[component];
    }
}

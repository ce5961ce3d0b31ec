/* SPDX-License-Identifier: MIT */
#include "scenarios/source_size.h"
#include "scenarios/sources.h"
#include <math.h>
#include <string.h>

/* The source of an id and its place in the list; NULL after an error. */
static const error_source *find(const schuler_scenario *s, const char *id,
                                error_source list[SOURCES_MAX], schuler_error *err)
{
    const int count = schuler_sources_list(s, list);
    const char *names[SOURCES_MAX];
    size_t known = 0;
    for (int i = 0; i < count; i++) {
        if (list[i].value && strcmp(list[i].id, id) == 0) return &list[i];
        if (list[i].value) names[known++] = list[i].id;
    }
    const char *const near = schuler_nearest(id, names, known);
    schuler_fail(err, SCHULER_ERR_INPUT, NULL, "'%.60s' is no source with a value here%s%s%s", id,
                 near    ? "; did you mean '"
                 : known ? "; there are '"
                         : "",
                 near    ? near
                 : known ? names[0]
                         : "",
                 near    ? "'?"
                 : known ? "' and others ('schuler run' lists them)"
                         : "");
    return NULL;
}

/* The value that the list points to, in the scenario itself. */
static schuler_value *value_of(schuler_scenario *s, const error_source *source)
{
    switch (source->kind) {
    case SOURCE_SENSOR:
        return &s->imu.triad[source->instrument].values[source->param];
    case SOURCE_POSITION:
        return &s->position;
    case SOURCE_VELOCITY:
        return &s->velocity;
    case SOURCE_TILT:
        return &s->tilt;
    case SOURCE_HEADING:
        return &s->heading;
    case SOURCE_BARO:
        return &s->baro[source->param];
    case SOURCE_GRAVITY:
        break;
    }
    return NULL;
}

static schuler_dim dim_of(const schuler_scenario *s, const error_source *source)
{
    static const schuler_dim start[] = {
        [SOURCE_POSITION] = SCHULER_DIM_LENGTH,
        [SOURCE_VELOCITY] = SCHULER_DIM_SPEED,
        [SOURCE_TILT] = SCHULER_DIM_ANGLE,
        [SOURCE_HEADING] = SCHULER_DIM_ANGLE,
    };
    static const schuler_dim baro[SCHULER_BARO_ERRORS] = {
        [SCHULER_BARO_BIAS] = SCHULER_DIM_LENGTH,
        [SCHULER_BARO_LAG] = SCHULER_DIM_TIME,
        [SCHULER_BARO_NOISE] = SCHULER_DIM_HEIGHT_NOISE,
        [SCHULER_BARO_GAUSS_MARKOV] = SCHULER_DIM_LENGTH,
    };
    if (source->kind == SOURCE_SENSOR)
        return s->imu.triad[source->instrument].params[source->param].dim;
    return source->kind == SOURCE_BARO ? baro[source->param] : start[source->kind];
}

schuler_status schuler_source_scale(schuler_scenario *s, const char *id, double factor,
                                    schuler_error *err)
{
    error_source list[SOURCES_MAX];
    const error_source *const source = find(s, id, list, err);
    if (!source) return SCHULER_ERR_INPUT;
    schuler_value *const v = value_of(s, source);
    for (int c = 0; c < source->components; c++) {
        v->a[c] *= factor;
        v->b[c] *= factor;
    }
    return SCHULER_OK;
}

schuler_status schuler_source_size(const schuler_scenario *s, const char *id, double *size,
                                   schuler_dim *dim, schuler_error *err)
{
    error_source list[SOURCES_MAX];
    const error_source *const source = find(s, id, list, err);
    if (!source) return SCHULER_ERR_INPUT;
    *size = 0.0;
    *dim = dim_of(s, source);
    for (int c = 0; c < source->components; c++) {
        const double a = source->value->a[c], b = source->value->b[c];
        const double half =
            source->value->draw == SCHULER_DRAW_UNIFORM ? fmax(fabs(a), fabs(b)) : fabs(a);
        *size = fmax(*size, half);
    }
    return SCHULER_OK;
}

double schuler_source_margin(const schuler_result *result, const schuler_budget_row *row)
{
    const schuler_requirement *const required = &result->scenario->requirement;
    const double drift_mps = result->judgement.value_mps;
    if (!required->given || !(drift_mps > 0.0) || result->rows_are != SCHULER_ROWS_SOURCES)
        return (double)NAN;
    double sum = 0.0;
    for (size_t i = 0; i < result->row_count; i++)
        sum += result->rows[i].rms_slope_mps * result->rows[i].rms_slope_mps;
    const double share = sum > 0.0 ? row->rms_slope_mps * row->rms_slope_mps / sum : 0.0;
    const double ratio = required->drift_mps / drift_mps, room = ratio * ratio - 1.0;
    if (!(share > 0.0)) return room >= 0.0 ? (double)INFINITY : -1.0;
    const double square = 1.0 + room / share;
    return square < 0.0 ? -1.0 : sqrt(square);
}

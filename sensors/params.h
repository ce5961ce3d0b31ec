/* SPDX-License-Identifier: MIT */
/* Short forms for tables of parameters. */
#ifndef SCHULER_SENSORS_PARAMS_H
#define SCHULER_SENSORS_PARAMS_H

#include "sensors/model.h"

/* An error source with a value for each axis; DIM_ is the end of a SCHULER_DIM_ name, ACTS_ of a
 * SCHULER_ACTS_ name; more members may follow. */
#define PARAM_SOURCE(KEY, NUMBER, DIM_, MIN, MAX, ACTS_, EXAMPLE, DOC, FORMULA, ...)               \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = SCHULER_DIM_##DIM_, .components = 3, .min = MIN,      \
        .max = MAX, .acts = SCHULER_ACTS_##ACTS_, .example = EXAMPLE, .doc = DOC,                  \
        .formula = FORMULA, __VA_ARGS__                                                            \
    }

/* The same with any dimension, DIM_ in braces, either sign up to MAX: a coefficient of a term. */
#define PARAM_TERM(KEY, NUMBER, DIM_, MAX, ACTS_, EXAMPLE, DOC, FORMULA)                           \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = DIM_, .components = 3, .min = -(MAX), .max = MAX,     \
        .acts = SCHULER_ACTS_##ACTS_, .example = EXAMPLE, .doc = DOC, .formula = FORMULA           \
    }

/* A setting with a value for each axis; after EXAMPLE its doc, more members may follow. */
#define PARAM_SETTING(KEY, DIM_, DEF, MIN, MAX, EXAMPLE, ...)                                      \
    {                                                                                              \
        .key = KEY, .dim = SCHULER_DIM_##DIM_, .components = 3, .def = DEF, .min = MIN,            \
        .max = MAX, .example = EXAMPLE, .doc = __VA_ARGS__                                         \
    }

/* A setting that is one of a few words; the first is what holds when nothing is said. */
#define PARAM_CHOICE(KEY, CHOICES, EXAMPLE, DOC)                                                   \
    {                                                                                              \
        .key = KEY, .components = 1, .choices = CHOICES, .example = EXAMPLE, .doc = DOC            \
    }

/* The table of a model, in its file. */
#define MODEL_NAME(NAME) SCHULER_LANE_NAME(schuler_model_##NAME)
#define MODEL(NAME)                                                                                \
    extern const schuler_sensor_model MODEL_NAME(NAME);                                            \
    const schuler_sensor_model MODEL_NAME(NAME)

/* The table of a stage, in its file. */
#define STAGE(NAME)                                                                                \
    extern const schuler_sensor_model SCHULER_LANE_NAME(schuler_stage_##NAME);                     \
    const schuler_sensor_model SCHULER_LANE_NAME(schuler_stage_##NAME)

/* Place of the angle of instrument `axis` toward its next axis (1) or the one after it (2) in xy, xz,
 * yx, yz, zx, zy. */
static inline int cross_component(int axis, int toward)
{
    const int other = (axis + toward) % 3;
    return 2 * axis + (other > axis ? other - 1 : other);
}

#endif

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

/* A setting with a value for each axis. */
#define PARAM_SETTING(KEY, DIM_, DEF, MIN, MAX, EXAMPLE, DOC, ...)                                 \
    {                                                                                              \
        .key = KEY, .dim = SCHULER_DIM_##DIM_, .components = 3, .def = DEF, .min = MIN,            \
        .max = MAX, .example = EXAMPLE, .doc = DOC, __VA_ARGS__                                    \
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

#endif

/* SPDX-License-Identifier: MIT */
/* Which error source a name means: a parameter of a sensor model or stage, or one of the others. */
#ifndef SCHULER_TOOLS_EXPLAIN_SUBJECT_H
#define SCHULER_TOOLS_EXPLAIN_SUBJECT_H

#include "scenarios/growth_text.h"
#include "scenarios/scenario.h"
#include "tools/verbs.h"
#include <stdbool.h>

typedef struct {
    const char *id;
    const schuler_growth_other *other; /* or NULL: a sensor's, and then: */
    schuler_instrument instrument;
    const schuler_sensor_model *model; /* of the triad                                     */
    const schuler_sensor_model *owner; /* the model or the stage that has the key          */
    const schuler_triad *triad;        /* whose values count; NULL: of no IMU that is given */
    schuler_param params[SCHULER_PARAMS_MAX + 1]; /* of the triad                                 */
    int index; /* of the source in them                            */
    const schuler_growth_text *text;
} explain_subject;

/** Find a source.
 *  Given      id       "gyro.bias"; borrowed
 *             model    that --model asks for, or NULL
 *             imu      of the scenario or of --imu: its models come first; or NULL
 *  Returned   out      borrows from all of them
 *  Errors     EXIT_INPUT, said: no such source, with the nearest name; a setting; not of that model */
exit_code explain_subject_find(explain_subject *out, const char *id, const char *model,
                               const schuler_imu *imu, const schuler_plugins *plugins);

/** Whether a model has a key of its own, and not from a stage. */
bool explain_model_has(const schuler_sensor_model *model, schuler_instrument instrument,
                       const char *key);
/** All models, the plug-ins' behind the built-in ones: 0, 1, ... until NULL. */
const schuler_sensor_model *explain_model(const schuler_plugins *plugins, int i);

#endif

/* SPDX-License-Identifier: MIT */
/* Error models that are not compiled in: shared objects made with sensors/plugin.h. */
#ifndef SCHULER_SENSORS_PLUGINS_H
#define SCHULER_SENSORS_PLUGINS_H

#include "sensors/model.h"

SCHULER_BEGIN_C

/* The plug-ins that a program has loaded. What borrows their models (a scenario, a result) must be
 * freed before it. */
typedef struct schuler_plugins schuler_plugins;

/** Load one and check its tables.
 *  Given      set    NULL at first
 *             path   of the file; without a slash it is in the working directory
 *  Returned   set    holds it too; owned by the caller; unchanged after an error
 *  Errors     SCHULER_ERR_INPUT: no such file, no plug-in, made for another interface, something
 *             wrong in its tables; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_plugins_load(schuler_plugins **set,
                                                                  const char *path,
                                                                  schuler_error *err);
SCHULER_API void schuler_plugins_free(schuler_plugins *set); /* NULL is fine */

/** All models of all of them, NULL-terminated; set NULL has none. */
SCHULER_API const schuler_sensor_model *const *schuler_plugins_models(const schuler_plugins *set);
/** The path that a model was loaded from, as it was given; NULL when it is not of this set. */
SCHULER_API const char *schuler_plugins_path(const schuler_plugins *set,
                                             const schuler_sensor_model *model);

SCHULER_END_C

#endif

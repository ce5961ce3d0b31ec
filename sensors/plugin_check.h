/* SPDX-License-Identifier: MIT */
/* Whether the tables of a plug-in can be used: what a test holds for the built-in ones. */
#ifndef SCHULER_SENSORS_PLUGIN_CHECK_H
#define SCHULER_SENSORS_PLUGIN_CHECK_H

#include "sensors/model.h"

/** Given      path     of the plug-in, for messages
 *             models   its models;  loaded  those of the plug-ins before; both NULL-terminated
 *  Errors     SCHULER_ERR_INPUT: the first thing that is wrong */
schuler_status schuler_plugin_check(const char *path, const schuler_sensor_model *const *models,
                                    const schuler_sensor_model *const *loaded, schuler_error *err);

#endif

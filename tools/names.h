/* SPDX-License-Identifier: MIT */
/* Lists of known names and the hint for a wrong one. */
#ifndef SCHULER_TOOLS_NAMES_H
#define SCHULER_TOOLS_NAMES_H

enum { NAMES_MAX = 256, NAMES_HINT_MAX = 512 };

/** "; did you mean 'x'?" or, when nothing is near, "; known: a, b, c" - for the end of a message.
 *  Given      known  NULL-terminated;  hint  NAMES_HINT_MAX bytes */
void names_hint(char *hint, const char *written, const char *const *known);

/* Names of the library's tables, NULL-terminated. names: NAMES_MAX entries. */
void names_of_sensors(const char **names);
void names_of_templates(const char **names);
void names_of_sensor_models(const char **names);
void names_of_trajectories(const char **names);
void names_of_overlays(const char **names);
void names_of_frames(const char **names);
void names_of_coning(const char **names);

#endif

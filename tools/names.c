/* SPDX-License-Identifier: MIT */
#include "tools/names.h"
#include "core/overlays.h"
#include "core/trajectory.h"
#include "mechanization/mechanization.h"
#include "scenarios/gallery.h"
#include "sensors/catalog.h"
#include "sensors/model.h"
#include <stdio.h>
#include <string.h>

void names_hint(char *hint, const char *written, const char *const *known)
{
    size_t count = 0;
    while (known[count]) count++;
    const char *nearest = schuler_nearest(written, known, count);
    if (nearest) {
        snprintf(hint, NAMES_HINT_MAX, "; did you mean '%s'?", nearest);
        return;
    }
    size_t at = (size_t)snprintf(hint, NAMES_HINT_MAX, "; known: ");
    for (size_t i = 0; i < count && at + strlen(known[i]) + 8 < NAMES_HINT_MAX; i++)
        at += (size_t)snprintf(hint + at, NAMES_HINT_MAX - at, "%s%s", i ? ", " : "", known[i]);
}

/* Copies the names of a table that ends with a NULL name. */
#define COLLECT(table_name)                                                                        \
    do {                                                                                           \
        int n = 0;                                                                                 \
        for (; n < NAMES_MAX - 1 && (table_name); n++) names[n] = (table_name);                    \
        names[n] = NULL;                                                                           \
    } while (0)

void names_of_sensors(const char **names)
{
    COLLECT(schuler_catalog[n].name);
}

void names_of_templates(const char **names)
{
    COLLECT(schuler_gallery[n].name);
}

void names_of_sensor_models(const char **names)
{
    const schuler_sensor_model *const *models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    COLLECT(models[n] ? models[n]->name : NULL);
}

void names_of_trajectories(const char **names)
{
    COLLECT(schuler_trajectory_kinds[n] ? schuler_trajectory_kinds[n]->name : NULL);
}

void names_of_overlays(const char **names)
{
    COLLECT(schuler_overlay_kinds[n] ? schuler_overlay_object(schuler_overlay_kinds[n])->name
                                     : NULL);
}

void names_of_frames(const char **names)
{
    const schuler_mechanization *const *frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    COLLECT(frames[n] ? frames[n]->name : NULL);
}

void names_of_coning(const char **names)
{
    COLLECT(schuler_coning_algorithms[n].name);
}

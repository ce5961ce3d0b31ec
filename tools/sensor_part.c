/* SPDX-License-Identifier: MIT */
#include "tools/sensor_part.h"
#include "tools/messages.h"
#include "tools/names.h"
#include <string.h>

/* A name that is neither in the catalog nor looks like a file gets a hint instead of "no such
 * file". */
static bool looks_like_file(const char *name)
{
    return strpbrk(name, "/.") != NULL;
}

exit_code sensor_part_load(schuler_part **part, const char *name, const schuler_plugins *plugins)
{
    const char *known[NAMES_MAX];
    names_of_sensors(known);
    bool found = looks_like_file(name);
    for (int i = 0; known[i]; i++) found |= strcmp(known[i], name) == 0;
    if (!found) {
        char hint[NAMES_HINT_MAX];
        names_hint(hint, name, known);
        return say_bad_input("unknown part '%.60s'%s", name, hint);
    }
    schuler_diagnostics d = { 0 };
    const schuler_status status = schuler_part_load_with(part, name, plugins, &d);
    say_diagnostics(&d, true);
    schuler_diagnostics_free(&d);
    if (status == SCHULER_OK) return EXIT_DONE;
    return status == SCHULER_ERR_MEMORY ? EXIT_FAILED : EXIT_INPUT;
}

const char *sensor_part_kind(const schuler_part *part)
{
    const bool accel = part->imu.triad[SCHULER_ACCEL].model != NULL;
    const bool gyro = part->imu.triad[SCHULER_GYRO].model != NULL;
    return accel && gyro ? "imu" : accel ? "accelerometer" : "gyro";
}

const schuler_value *sensor_part_figure(const schuler_part *part, schuler_instrument instrument,
                                        const char *const *keys)
{
    const schuler_triad *const triad = &part->imu.triad[instrument];
    for (; triad->model && *keys; keys++)
        for (int i = 0; triad->params[i].key; i++)
            if (strcmp(triad->params[i].key, *keys) == 0 && triad->values[i].given)
                return &triad->values[i];
    return NULL;
}

/* SPDX-License-Identifier: MIT */
#include "tools/registry.h"
#include "tools/messages.h"
#include "tools/names.h"
#include <string.h>

const registry_entry registry_spellings[] = {
    { "noise_density",
      "density of white noise as data sheets give it, such as 100 ug/sqrt(Hz) or 0.01 "
      "deg/s/sqrt(Hz); needs 'sided'. It becomes velocity_random_walk or angle_random_walk: the "
      "density itself when it is two-sided, the density divided by sqrt(2) when it is one-sided",
      "IEEE Std 952-1997 annex C: N^2 is the two-sided power spectral density" },
    { "sided",
      "one or two: the convention of noise_density. A one-sided density has all power at positive "
      "frequencies, as spectrum analysers and most data sheets have it; a two-sided one has half "
      "of it there",
      "IEEE Std 952-1997 annex C" },
    { "allan_floor",
      "lowest value of the Allan deviation, such as 10 ug or 0.3 deg/h, which data sheets call "
      "bias instability. It becomes bias_instability, the coefficient B: floor/0.664282, since "
      "the floor of flicker noise is sqrt(2 ln 2/pi) B",
      "IEEE Std 952-1997 annex C (bias instability)" },
    { 0 },
};

bool registry_is_response(const schuler_sensor_model *stage)
{
    const schuler_param *const params =
        stage->params[stage->params[SCHULER_ACCEL] ? SCHULER_ACCEL : SCHULER_GYRO];
    switch (params[0].acts) {
    case SCHULER_ACTS_NOT:
    case SCHULER_ACTS_NON_LINEAR: /* lever arms: another input */
    case SCHULER_ACTS_COUNTS:
    case SCHULER_ACTS_RESPONSE:
        return true;
    default:
        return false;
    }
}

const char *registry_acts(schuler_acts acts)
{
    static const char *const words[] = { "setting",   "constant",  "scale",   "cross", "nonlinear",
                                         "white",     "wandering", "walk",    "ramp",  "periodic",
                                         "transient", "counts",    "response" };
    return (size_t)acts < sizeof words / sizeof words[0] ? words[acts] : "other";
}

const schuler_sensor_model *registry_stage(const char *name)
{
    const schuler_sensor_model *const *const stages = schuler_sensor_stages(SCHULER_ISA_SCALAR);
    for (int i = 0; stages[i]; i++)
        if (strcmp(stages[i]->name, name) == 0) return stages[i];
    for (int i = 0; stages[i]; i++)
        for (int k = 0; k < SCHULER_INSTRUMENTS; k++)
            for (const schuler_param *p = stages[i]->params[k]; p && p->key; p++)
                if (strcmp(p->key, name) == 0) return stages[i];
    return NULL;
}

exit_code registry_unknown(const char *name, const schuler_plugins *plugins)
{
    const char *known[8 * NAMES_MAX + 1], **at = known;
    const char *const *const end = known + 8 * NAMES_MAX;
    names_of_sensor_models(at);
    while (*at) at++;
    names_of_trajectories(at);
    while (*at) at++;
    names_of_overlays(at);
    while (*at) at++;
    names_of_frames(at);
    while (*at) at++;
    names_of_coning(at);
    while (*at) at++;
    registry_gravity_names gravities;
    registry_gravity_known(&gravities);
    for (int i = 0; i < gravities.count && at < end; i++) *at++ = gravities.names[i];
    for (int i = 0; registry_spellings[i].name; i++) *at++ = registry_spellings[i].name;
    const schuler_sensor_model *const *list = schuler_plugins_models(plugins);
    for (; *list && at < end; list++) *at++ = (*list)->name;
    for (list = schuler_sensor_stages(SCHULER_ISA_SCALAR); *list && at < end; list++)
        *at++ = (*list)->name;
    *at = NULL;
    char hint[NAMES_HINT_MAX];
    names_hint(hint, name, known);
    return say_bad_input("unknown model '%.60s'%s", name, hint);
}

/* SPDX-License-Identifier: MIT */
#include "scenarios/lane_spec.h"
#include <string.h>

void schuler_lane_spec_start(const schuler_triad *triad, uint64_t run, schuler_lane_spec *spec)
{
    memset(spec, 0, sizeof *spec);
    spec->run = run;
    for (int k = 0; triad->params[k].key; k++) {
        if (triad->params[k].number != 0) continue;
        const schuler_value *v = &triad->values[k];
        for (int c = 0; c < triad->params[k].components; c++)
            spec->value[k][c] = v->given ? v->a[c] : triad->params[k].def;
    }
}

void schuler_lane_spec_draw(const error_source *source, uint64_t seed, schuler_lane_spec *spec)
{
    for (int c = 0; c < source->components; c++)
        spec->value[source->param][c] = schuler_source_draw(source, c, seed, spec->run);
}

schuler_chain_setup schuler_chain_setup_of(const schuler_imu *imu, schuler_instrument instrument,
                                           schuler_isa isa, double dt_s, uint64_t seed,
                                           chain_parts *parts)
{
    const schuler_triad *triad = &imu->triad[instrument];
    const bool is_plugin = triad->model_index < 0;
    schuler_lane_spec_start(triad, 0, &parts->settings);
    memset(parts->given, 0, sizeof parts->given);
    for (int k = 0; triad->params[k].key; k++) parts->given[k] = triad->values[k].given;
    return (schuler_chain_setup){
        .model = is_plugin ? triad->model : schuler_sensor_models(isa)[triad->model_index],
        .is_plugin = is_plugin,
        .instrument = instrument,
        .isa = isa,
        .dt_s = dt_s,
        .seed = seed,
        .settings = &parts->settings,
        .given = parts->given,
        .temperature = imu->has_temperature ? &imu->temperature : NULL,
    };
}

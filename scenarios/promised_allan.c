/* SPDX-License-Identifier: MIT */
/* What the noise figures of a part say about its Allan deviation. */
#include "scenarios/characterize.h"
#include "scenarios/sources.h"
#include "sensors/processes.h"
#include <math.h>
#include <string.h>

/* A setting of the first axis by its key: as given, or its default. */
static double setting(const schuler_triad *triad, const char *key)
{
    for (int k = 0; triad->params[k].key; k++)
        if (strcmp(triad->params[k].key, key) == 0)
            return triad->values[k].given ? triad->values[k].a[0] : triad->params[k].def;
    return 0.0;
}

/* Allan variance of one figure; 0 for what is no noise. */
static double of_figure(const schuler_triad *triad, const char *key, double x, double tau_s,
                        double dt_s)
{
    if (strcmp(key, "angle_random_walk") == 0 || strcmp(key, "velocity_random_walk") == 0)
        return schuler_process_white(x, tau_s);
    if (strcmp(key, "bias_random_walk") == 0) return schuler_process_random_walk(x, tau_s);
    if (strcmp(key, "bias_ramp") == 0) return schuler_process_ramp(x, tau_s);
    if (strcmp(key, "quantization") == 0)
        return schuler_process_quantization(x / sqrt(12.0), tau_s);
    if (strcmp(key, "gauss_markov") == 0)
        return schuler_process_gauss_markov(x, setting(triad, "gauss_markov_time"), tau_s);
    if (strcmp(key, "gauss_markov_2") == 0)
        return schuler_process_gauss_markov_2(x, setting(triad, "gauss_markov_2_time"), tau_s);
    if (strcmp(key, "sinusoid") == 0)
        return schuler_process_sinusoid(x, setting(triad, "sinusoid_frequency"), tau_s);
    if (strcmp(key, "bias_instability") == 0) {
        const schuler_flicker_bank bank =
            schuler_flicker_bank_of(setting(triad, "bias_instability_shortest"),
                                    setting(triad, "bias_instability_longest"), dt_s);
        return schuler_process_flicker_bank(&bank, x, tau_s);
    }
    return 0.0;
}

double schuler_promised_allan(const schuler_imu *imu, schuler_instrument instrument,
                              const schuler_characterize_options *o, double tau_s, double dt_s)
{
    const schuler_triad *const triad = &imu->triad[instrument];
    error_source sources[SOURCES_MAX];
    const int count = schuler_sources_of_imu(imu, &o->only, &o->without, sources);
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        if (sources[i].instrument == instrument)
            sum += of_figure(triad, triad->params[sources[i].param].key,
                             schuler_value_rms(sources[i].value, 0), tau_s, dt_s);
    return sum;
}

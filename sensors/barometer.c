/* SPDX-License-Identifier: MIT */
#include "sensors/barometer.h"
#include "core/random.h"
#include <math.h>

static double normal(const barometer *b, unsigned number, schuler_use use, uint64_t k)
{
    const schuler_stream stream = { b->setup.seed, b->setup.run, number, 0, use };
    return schuler_stream_normal(stream, k);
}

void schuler_barometer_start(barometer *b, const barometer_setup *setup,
                             const barometer_errors *errors, double height_m)
{
    const double T_s = setup->interval_s;
    *b = (barometer){ .setup = *setup, .errors = *errors };
    b->lag_stays = errors->lag_s > 0.0 ? exp(-T_s / errors->lag_s) : 0.0;
    b->start_m = b->before_m = height_m;
    if (errors->gauss_markov_m == 0.0) return;
    b->gauss_markov_stays = exp(-T_s / setup->gauss_markov_time_s);
    b->gauss_markov_drive = sqrt(-expm1(-2.0 * T_s / setup->gauss_markov_time_s));
    b->gauss_markov = normal(b, BAROMETER_GAUSS_MARKOV, SCHULER_USE_START, 0);
}

/* Exact for a height that is linear over the interval: behind a ramp the lag settles at -rate times
 * the time constant. */
static void follow_height(barometer *b, double height_m)
{
    const double settled_m = -(height_m - b->before_m) / b->setup.interval_s * b->errors.lag_s;
    b->lag_m = settled_m + (b->lag_m - settled_m) * b->lag_stays;
    b->before_m = height_m;
}

double schuler_barometer_read(barometer *b, uint64_t k, double height_m)
{
    const barometer_errors *const e = &b->errors;
    if (k > 0) {
        follow_height(b, height_m);
        if (e->gauss_markov_m != 0.0)
            b->gauss_markov =
                b->gauss_markov_stays * b->gauss_markov +
                b->gauss_markov_drive * normal(b, BAROMETER_GAUSS_MARKOV, SCHULER_USE_SLOW, k);
    }
    double error_m = e->bias_m + e->scale_factor * (height_m - b->start_m) + b->lag_m +
                     e->gauss_markov_m * b->gauss_markov;
    /* The mean of white noise over the interval. */
    if (e->noise_m_rts != 0.0)
        error_m += e->noise_m_rts / sqrt(b->setup.interval_s) *
                   normal(b, BAROMETER_NOISE, SCHULER_USE_WHITE, k);
    return height_m + error_m;
}

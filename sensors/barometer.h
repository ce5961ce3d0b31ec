/* SPDX-License-Identifier: MIT */
/* A barometer that reads height:
 *
 *     reading = h + b + s (h - h_start) + lag + p + w
 *
 * b bias, s scale factor, p the weather, a first-order Gauss-Markov process, w white noise, and lag
 * that of a first-order response to the true height, settled at the start. Errors add up, so each is
 * a source of its own; with all of them zero the reading is h, bit for bit. */
#ifndef SCHULER_SENSORS_BAROMETER_H
#define SCHULER_SENSORS_BAROMETER_H

#include <stdint.h>

/* In the random key (sensors/model.h has those of the inertial sensors); never changed. */
enum {
    BAROMETER_BIAS = 300,
    BAROMETER_SCALE_FACTOR = 301,
    BAROMETER_LAG = 302,
    BAROMETER_NOISE = 303,
    BAROMETER_GAUSS_MARKOV = 304,
};

typedef struct {
    double bias_m;
    double scale_factor;   /* of the height over the start           */
    double lag_s;          /* time constant, >= 0                    */
    double noise_m_rts;    /* root of the two-sided density, m sqrt(s) */
    double gauss_markov_m; /* sigma                                  */
} barometer_errors;

typedef struct {
    uint64_t seed, run;
    double interval_s;          /* between readings, > 0 */
    double gauss_markov_time_s; /* > 0; looked at where there is such a process */
} barometer_setup;

typedef struct {
    barometer_setup setup;
    barometer_errors errors;
    double lag_stays, gauss_markov_stays, gauss_markov_drive; /* over an interval */
    double start_m, before_m; /* true height at the start, at the last reading */
    double lag_m, gauss_markov;
} barometer;

/** At the start of the mission; true height there. */
void schuler_barometer_start(barometer *b, const barometer_setup *setup,
                             const barometer_errors *errors, double height_m);

/** Reading number k, 0 at the start and then one after the other; k is also the number of its random
 *  values in their streams. */
double schuler_barometer_read(barometer *b, uint64_t k, double height_m);

#endif

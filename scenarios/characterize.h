/* SPDX-License-Identifier: MIT */
/* One instrument on a test stand: many units of it at a constant input, their mean output, its spread
 * over the units, the noise, and the Allan deviation beside what the data sheet promises.
 *  Source  T. L. Grigorie, M. Lungu, I. R. Edu, R. Obreja, Concepts for error modeling of miniature
 *          accelerometers used in inertial navigation systems (the experiment of its figure 5) */
#ifndef SCHULER_SCENARIOS_CHARACTERIZE_H
#define SCHULER_SCENARIOS_CHARACTERIZE_H

#include "scenarios/scenario.h"
#include "sensors/allan.h"

SCHULER_BEGIN_C

enum { SCHULER_CHARACTERIZE_SAMPLES_MAX = 4000000, SCHULER_CHARACTERIZE_UNITS_MAX = 1000000 };

typedef struct {
    double along, across; /* input on the input axis and across it: m/s^2 or rad/s            */
    double duration_s;    /* > 0                                                              */
    double rate_hz;       /* 0: schuler_characterize_rate                                     */
    int units;            /* 1 .. SCHULER_CHARACTERIZE_UNITS_MAX                              */
    uint64_t seed;        /* unit k is the specimen that `imu.unit: k` takes                  */
    schuler_text_list only,
        without;              /* sources by id (accel.bias); empty: all                     */
    int threads;              /* 0: as many as processors; never changes the result               */
    const volatile int *stop; /* or NULL                                                          */
    void (*progress)(void *user,
                     double fraction); /* or NULL                                      */
    void *user;
} schuler_characterize_options;

/* Over the units. error: standard deviation of mean and of spread as estimates, 0 for one unit. */
typedef struct {
    double mean, mean_error, spread, spread_error, least, most;
} schuler_over_units;

/* m/s^2 or rad/s. */
typedef struct {
    schuler_instrument instrument;
    double dt_s;
    int64_t n;
    int units;
    double *unit_mean,
        *unit_noise; /* of each unit: mean, and standard deviation of its samples   */
    double *series;  /* n samples of the first unit                                 */
    schuler_over_units output, noise;
    int points;
    double tau_s[SCHULER_ALLAN_POINTS_MAX];
    double sigma2[SCHULER_ALLAN_POINTS_MAX]; /* Allan variance, mean over the units          */
    double
        sigma2_error[SCHULER_ALLAN_POINTS_MAX]; /* its standard deviation, 0 for one unit       */
    double promised[SCHULER_ALLAN_POINTS_MAX];  /* by the noise figures of the part             */
} schuler_characterized;

/** Samples a second that show the noise as it is printed: twice the bandwidth of the part, so that
 *  white samples carry its density up to the bandwidth; the part's own rate when it has none. */
SCHULER_API double schuler_characterize_rate(const schuler_imu *imu, schuler_instrument instrument);

/** Allan variance at tau of the noise figures of a triad's first axis: white, flicker, random walk,
 *  Gauss-Markov, quantization, sinusoid, ramp, as far as only/without let them. A figure that is
 *  drawn counts with its mean square. */
SCHULER_API double schuler_promised_allan(const schuler_imu *imu, schuler_instrument instrument,
                                          const schuler_characterize_options *o, double tau_s,
                                          double dt_s);

/** Simulate. Accelerometers see along on x, across on y; gyros see the rates so and 1 g upwards on z.
 *  Given      imu   must have the instrument
 *  Returned   out   owned by the caller: schuler_characterized_free
 *  Errors     SCHULER_ERR_INPUT too many or too few samples: said; SCHULER_ERR_MEMORY;
 *             SCHULER_ERR_INTERRUPTED; SCHULER_ERR_NUMERIC an output is not finite */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_characterize(
    schuler_characterized **out, const schuler_imu *imu, schuler_instrument instrument,
    const schuler_characterize_options *o, schuler_error *err);
SCHULER_API void schuler_characterized_free(schuler_characterized *c); /* NULL is fine */

SCHULER_END_C

#endif

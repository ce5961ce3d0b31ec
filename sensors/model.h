/* SPDX-License-Identifier: MIT */
/* What an error model of a triad of accelerometers or gyros is: one self-describing table with its
 * lane code. A triad is a chain of them: one model, chosen by name (sensors/models/), and then the
 * stages (sensors/stages/), which are always there and do nothing until they are asked to. A new
 * model or stage is one file and one word in CMakeLists.txt. */
#ifndef SCHULER_SENSORS_MODEL_H
#define SCHULER_SENSORS_MODEL_H

#include "core/isa.h"
#include "core/random.h"
#include "core/units.h"
#include <stddef.h>

SCHULER_BEGIN_C

typedef enum { SCHULER_ACCEL, SCHULER_GYRO, SCHULER_INSTRUMENTS } schuler_instrument;

enum {
    SCHULER_MODEL_API = 1, /* raised when anything here changes meaning: plug-ins are checked */
    SCHULER_PARAMS_MAX = 128,
    SCHULER_COMPONENTS_MAX = 9
};

/* How an error acts on the output, which decides how it grows in navigation (`schuler explain`). */
typedef enum {
    SCHULER_ACTS_NOT,        /* a setting, no source                                      */
    SCHULER_ACTS_CONSTANT,   /* a bias                                                    */
    SCHULER_ACTS_SCALE,      /* in proportion to the input on its own axis                */
    SCHULER_ACTS_CROSS,      /* in proportion to the input on another axis, or to f       */
    SCHULER_ACTS_NON_LINEAR, /* higher powers and products: rectifies vibration           */
    SCHULER_ACTS_WHITE,      /* white noise                                               */
    SCHULER_ACTS_WANDERING,  /* Gauss-Markov, flicker: a bias that wanders within limits  */
    SCHULER_ACTS_WALK,       /* a bias that wanders without limit                         */
    SCHULER_ACTS_RAMP,       /* grows with time                                           */
    SCHULER_ACTS_PERIODIC,   /* a sinusoid                                                */
    SCHULER_ACTS_TRANSIENT,  /* dies away after switch-on, or follows the temperature     */
    SCHULER_ACTS_COUNTS,     /* whole counts, the rest carried: bounded                   */
    SCHULER_ACTS_RESPONSE,   /* what the instrument does not follow                       */
} schuler_acts;

/* One parameter. When number is not 0 it is an error source of its own, id "<accel|gyro>.<key>".
 * Numbers are part of the random key and never change; the same key has the same number in every
 * model, so that two models are compared on the same luck. */
typedef struct {
    const char *key;
    unsigned number;
    schuler_dim dim;
    int components;  /* 1, 3 (x, y, z), 6 (xy, xz, yx, yz, zx, zy) or 9 (rows); one value = all */
    double def;      /* used by parameters that are not sources (a correlation time)            */
    double min, max; /* allowed range, SI; both 0 = any                                         */
    int noisy;       /* random numbers that it takes at each step and axis; 0 = drawn once      */
    const char *example, *doc;
    const char *formula;   /* what it adds, as plain text, for `models show` and `explain`        */
    const char *companion; /* key of a parameter that must be given with it, or NULL            */
    const char *const *choices; /* a setting that is one of these words, its value their index;
                                   NULL-terminated; components 1                                */
    schuler_acts acts;
} schuler_param;

/* What one lane is to be. Values are SI, already drawn for its run, zero where the source is off. */
typedef struct {
    uint64_t run;
    double noise_excess[3]; /* white noise is multiplied by 1 + this: set by the model */
    double value[SCHULER_PARAMS_MAX][SCHULER_COMPONENTS_MAX];
} schuler_lane_spec;

typedef struct {
    schuler_instrument instrument;
    uint64_t seed;
    double dt_s;
    int lanes; /* lanes in a vector; specs has as many                                          */
    const schuler_lane_spec *specs;
    int base; /* parameter p of this table is value[base + p] of the specs                      */
} schuler_model_setup;

/* The truth of a block as one triad sees it, the same for all lanes. Instrument k has an input
 * axis, a pendulous (gyro: output) axis and the third one, a right-handed triad "i, p, o" (gyro:
 * "i, o, s"); by default x: (x, y, z), y: (y, z, x), z: (z, x, y). Instantaneous values are at the
 * nodes of a quadrature, [node][step], SCHULER_BLOCK apart. */
typedef struct {
    int64_t first; /* steps done before this block                                              */
    int n;         /* steps in it                                                               */
    double dt_s;
    int nodes;                     /* in a step                                                */
    const double *weight;          /* of a node; they sum to 1                                 */
    const double *fraction;        /* of the step that has passed at the node                  */
    const double *f[3][3];         /* specific force on [instrument][i, p, o], m/s^2           */
    const double *omega[3][3];     /* angular rate, rad/s                                      */
    const double *omega_end[3][3]; /* n + 1 rates: before the first step, at the end of each   */
    const double *omega_b[3];      /* the same rates in body axes                              */
    const double *omega_end_b[3];
    double axes[3][3][3];           /* [instrument][i, p, o]: unit vectors in body axes         */
    const double *temperature;      /* above the reference temperature, K, [node][step]         */
    const double *temperature_rate; /* K/s                                                      */
} schuler_view;

/* One block for one vector of lanes. `own` are the true increments along the input axes (dtheta or
 * dv), [axis][step], scalars shared by all lanes. `out` is [axis][step][lane]: written by a model,
 * changed in place by a stage. */
typedef struct {
    int64_t first; /* steps done before this block                                              */
    int n, stride; /* steps in it; distance between axes in own, in doubles                     */
    double dt_s;
    const double *own;
    double *out; /* aligned to the vector; axes are stride*lanes doubles apart                  */
    const double *signals;    /* what observe found: [axis][signal][SCHULER_BLOCK], or NULL     */
    const schuler_view *view; /* NULL unless some table of the chain asks for it                */
} schuler_model_block;

typedef struct {
    const char *name, *summary, *source;
    const char *equation;   /* as text, lines separated by \n; NULL = the formulas say it all   */
    const char *departures; /* where this departs from the print of its source, and why; or NULL */
    const schuler_param
        *params[SCHULER_INSTRUMENTS]; /* ended by key NULL; NULL = not for this kind             */
    size_t state_size; /* bytes, aligned to 64, for one vector of lanes                          */
    int needs_view;    /* apply looks at the view                                                */
    int signals;       /* sums per axis that observe makes of the view                           */
    /** Once a block, for all lanes: integrals over each step of what coefficients multiply.
     *  Given      settings   of one lane, sources all zero;  signals   [axis][signal][SCHULER_BLOCK] */
    void (*observe)(const schuler_model_setup *settings, const schuler_view *view, double *signals);
    /** Returned: whether any lane needs it; 0 = apply need not be called (stages only). */
    int (*setup)(void *state, const schuler_model_setup *setup);
    void (*apply)(void *state, const schuler_model_block *block);
    /** Samples of a lane in which something happened that one must be told of (saturation). */
    double (*events)(const void *state, int lane);
    /** What this lane's white noise is multiplied by, less 1; NULL = 0 (models only). */
    double (*noise_excess)(const schuler_model_setup *setup, int lane, int axis);
} schuler_sensor_model;

/** All models as compiled for an instruction set, NULL-terminated. The tables (names, parameters)
 * are the same in each; only the functions differ. Use schuler_isa_available first. */
SCHULER_API const schuler_sensor_model *const *schuler_sensor_models(schuler_isa isa);
/** The stages that follow every model, in the order in which they act. */
SCHULER_API const schuler_sensor_model *const *schuler_sensor_stages(schuler_isa isa);
/** Index in the list of models, or -1. */
SCHULER_API int schuler_sensor_model_find(const char *name);
/** "accel", "gyro". */
SCHULER_API const char *schuler_instrument_name(schuler_instrument i);

SCHULER_END_C

#endif

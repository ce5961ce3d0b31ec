/* SPDX-License-Identifier: MIT */
/* What an error model of a triad of accelerometers or gyros is: one self-describing table with its
 * lane code. A new model is one file in sensors/models/ and one word in CMakeLists.txt. */
#ifndef SCHULER_SENSORS_MODEL_H
#define SCHULER_SENSORS_MODEL_H

#include "core/isa.h"
#include "core/random.h"
#include "core/units.h"
#include <stddef.h>

SCHULER_BEGIN_C

typedef enum { SCHULER_ACCEL, SCHULER_GYRO, SCHULER_INSTRUMENTS } schuler_instrument;

enum { SCHULER_PARAMS_MAX = 32, SCHULER_COMPONENTS_MAX = 6 };

/* One parameter. When number is not 0 it is an error source of its own, id "<accel|gyro>.<key>";
 * numbers are unique over all models, part of the random key, and never change. */
typedef struct {
    const char *key;
    unsigned number;
    schuler_dim dim;
    int components;  /* 1, 3 (x, y, z) or 6 (xy, xz, yx, yz, zx, zy); one value = all       */
    double def;      /* used by parameters that are not sources (a correlation time)         */
    double min, max; /* allowed range, SI; both 0 = any                                      */
    int noisy;       /* 1: draws random numbers all along the run                            */
    const char *example, *doc;
    const char *formula; /* what it adds, as plain text, for `models show` and `explain`         */
    const char *companion; /* key of a parameter that must be given with it, or NULL              */
} schuler_param;

/* What one lane is to be. Values are SI, already drawn for its run, zero where the source is off.
 */
typedef struct {
    uint64_t run;
    double value[SCHULER_PARAMS_MAX][SCHULER_COMPONENTS_MAX];
} schuler_lane_spec;

typedef struct {
    schuler_instrument instrument;
    uint64_t seed;
    double dt_s;
    int lanes; /* lanes in a vector; specs has as many                        */
    const schuler_lane_spec *specs;
} schuler_model_setup;

/* One block for one vector of lanes. Instrument axes = body axes here. `own` are the true
 * increments of this triad (dtheta or dv), `other` those of the other triad, [axis][step], scalars
 * shared by all lanes. `out` is [axis][step][lane]: written by the model. */
typedef struct {
    int64_t first; /* steps done before this block                               */
    int n, stride; /* steps in it; distance between axes in own/other, in doubles */
    double dt_s;
    const double *own, *other;
    double *out; /* aligned to the vector; axes are stride*lanes doubles apart  */
} schuler_model_block;

typedef struct {
    const char *name, *summary, *source;
    const schuler_param
        *params[SCHULER_INSTRUMENTS]; /* ended by key NULL; NULL = not for this kind */
    size_t state_size; /* bytes, aligned to 64, for one vector of lanes               */
    void (*setup)(void *state, const schuler_model_setup *setup);
    void (*apply)(void *state, const schuler_model_block *block);
} schuler_sensor_model;

/** All models as compiled for an instruction set, NULL-terminated. The tables (names, parameters)
 * are the same in each; only the functions differ. Use schuler_isa_available first. */
SCHULER_API const schuler_sensor_model *const *schuler_sensor_models(schuler_isa isa);
/** Index in that list, or -1. */
SCHULER_API int schuler_sensor_model_find(const char *name);
/** "accel", "gyro". */
SCHULER_API const char *schuler_instrument_name(schuler_instrument i);

SCHULER_END_C

#endif

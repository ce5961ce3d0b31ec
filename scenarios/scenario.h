/* SPDX-License-Identifier: MIT */
/* A scenario as read from its file: everything checked, SI units, defaults filled in. */
#ifndef SCHULER_SCENARIOS_SCENARIO_H
#define SCHULER_SCENARIOS_SCENARIO_H

#include "core/mooring.h"
#include "core/overlays.h"
#include "core/schema.h"
#include "core/trajectory.h"
#include "mechanization/algorithms.h"
#include "mechanization/vertical.h"
#include "sensors/plugins.h"
#include "sensors/temperature.h"

SCHULER_BEGIN_C

/* One triad: its model, the parameters of its chain (sensors/chain.h) and their values by index. */
typedef struct {
    const schuler_sensor_model *model; /* of the baseline instruction set, or a plug-in's         */
    int model_index;                   /* in schuler_sensor_models; -1: a plug-in's               */
    const schuler_param *params;       /* ended by key NULL; NULL when model is                   */
    schuler_value values[SCHULER_PARAMS_MAX];
} schuler_triad;

typedef struct {
    const char *name;  /* catalog name, file name or "custom"                                    */
    const char *title; /* for people                                                             */
    double rate_hz;
    int64_t unit;                    /* which specimen flies in every run; -1 = another in each */
    bool has_temperature;            /* else always at the reference temperature                */
    schuler_temperature temperature; /* at_s counted from the start of the mission              */
    schuler_triad triad[SCHULER_INSTRUMENTS];
} schuler_imu;

/* Errors of the barometer: sources baro.bias and so on, one component each. */
typedef enum {
    SCHULER_BARO_BIAS,         /* m                                                            */
    SCHULER_BARO_SCALE_FACTOR, /* of the height over the start                                  */
    SCHULER_BARO_LAG,          /* time constant, s                                              */
    SCHULER_BARO_NOISE,        /* white, m sqrt(s)                                              */
    SCHULER_BARO_GAUSS_MARKOV, /* sigma, m                                                      */
    SCHULER_BARO_ERRORS
} schuler_baro_error;

typedef enum {
    SCHULER_STAT_CEP,      /* median over the runs                               */
    SCHULER_STAT_R95,      /* 95th percentile                                    */
    SCHULER_STAT_RMS,      /* root mean square                                   */
    SCHULER_STAT_R99,      /* 99th percentile                                    */
    SCHULER_STAT_ONE_AXIS, /* 95th percentile of north and east by themselves */
    SCHULER_STATISTICS
} schuler_statistic;

/* What the drift of one run is, m/s. */
typedef enum {
    SCHULER_METRIC_SLOPE,    /* least squares through the origin of the radial error        */
    SCHULER_METRIC_FINAL,    /* radial error at the end over the time                        */
    SCHULER_METRIC_TRMS,     /* root mean square of radial error over time, from half an hour on */
    SCHULER_METRIC_HARMONIC, /* mean rate: what a line beside a Schuler oscillation says     */
    SCHULER_METRICS
} schuler_metric;

typedef struct {
    bool given;
    double drift_mps;
    double position_m; /* stated instead, at the end; drift_mps is that over the time; else 0 */
    schuler_statistic statistic;
    schuler_metric metric;
    double confidence; /* of the verdict; 0: 0.95 */
    schuler_place place;
} schuler_requirement;

/* Self-alignment before the mission begins. */
typedef struct {
    bool given, fine;
    schuler_place place;
    double for_s;
    schuler_sway sway;
} schuler_align_spec;

typedef struct schuler_scenario {
    const char *name;
    const char *file;
    const char *folder; /* of the file, with its last slash; "" without  */
    char sha256[65];    /* of the file's bytes, hex                                   */
    uint64_t seed;
    int runs;
    double report_s; /* interval of the error reports; a whole number of blocks is not needed */
    const char *truth_gravity; /* for schuler_field_open */
    const schuler_trajectory_kind *trajectory;
    void *trajectory_spec;
    schuler_overlays_spec overlays; /* on it                                                    */
    schuler_path path;              /* compiled from it                                           */
    schuler_imu imu;
    schuler_value position, velocity; /* initial errors, n-axes: 3 components, m and m/s */
    schuler_value tilt;       /* 2: phi_N, phi_E, rad (C_b_n computed = (I - [phi x]) C_b_n)  */
    schuler_value heading;    /* 1: computed minus true heading, rad                        */
    schuler_align_spec align; /* in place of tilt and heading                            */
    int frame;                /* index into schuler_mechanizations()                        */
    const char *nav_gravity;
    schuler_vertical vertical;
    double baro_time_s; /* time constant of the loop of SCHULER_VERTICAL_BARO                   */
    schuler_value baro[SCHULER_BARO_ERRORS];
    double gauss_markov_time_s; /* of SCHULER_BARO_GAUSS_MARKOV; NAN without                    */
    int order, samples_per_update;
    const schuler_coning_algorithm *coning; /* order is its recursion's                       */
    schuler_text_list only, without;
    schuler_requirement requirement;
    schuler_arena *arena;         /* owns what the members point to                             */
    schuler_document **documents; /* scenario and sensor files, owned                           */
    size_t document_count;
} schuler_scenario;

/* Changes from the command line. Zero-initialised = none. */
typedef struct {
    const char *const *set; /* "key.path=value", count_set of them, in order              */
    size_t count_set;
    const char *imu;            /* --imu                                                     */
    const char *only, *without; /* comma-separated, replace errors.only / errors.without      */
    int has_seed, has_runs;
    uint64_t seed;
    int runs;
    const schuler_plugins *plugins; /* models beside the built-in ones; borrowed by the scenario */
} schuler_overrides;

/** Read, check and compile a scenario file. Every mistake goes to d; nothing is printed or written.
 *  Returned   out   owned by the caller; NULL when there were errors (warnings alone do not count)
 *  Errors     SCHULER_ERR_INPUT, SCHULER_ERR_FILE, SCHULER_ERR_MEMORY, SCHULER_ERR_NUMERIC */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_scenario_load(schuler_scenario **out, const char *path, const schuler_overrides *overrides,
                      schuler_diagnostics *d);
SCHULER_API void schuler_scenario_free(schuler_scenario *s); /* NULL is fine */

/* A part as read from the catalog or a file, for `sensors show`. */
typedef struct {
    const char *key, *text;
} schuler_source_text;

typedef struct {
    schuler_imu imu;
    const char *maker, *grade, *technology, *notes; /* or NULL */
    const schuler_source_text *sources;             /* the file's `sources`                       */
    size_t source_count;
    schuler_arena *arena;
    schuler_document *document;
} schuler_part;

/** Read a part by catalog name or file path. Errors as above. */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_part_load(schuler_part **out,
                                                               const char *name_or_file,
                                                               schuler_diagnostics *d);
/** The same with models of plug-ins, which the part borrows; plugins NULL = none. */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_part_load_with(schuler_part **out,
                                                                    const char *name_or_file,
                                                                    const schuler_plugins *plugins,
                                                                    schuler_diagnostics *d);
SCHULER_API void schuler_part_free(schuler_part *part);

SCHULER_END_C

#endif

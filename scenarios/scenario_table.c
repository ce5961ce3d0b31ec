/* SPDX-License-Identifier: MIT */
/* The keys of a scenario file. */
#include "scenarios/reader.h"
#include <math.h>

#define AT(member) offsetof(schuler_scenario_file, member)
/* Offset within an object that is a member itself. */
#define IN(object, member)                                                                         \
    (offsetof(schuler_scenario_file, object.member) - offsetof(schuler_scenario_file, object))
#define SIZE(object) sizeof(((schuler_scenario_file *)0)->object)

static const schuler_field truth_fields[] = {
    { .key = "gravity",
      .kind = SCHULER_FIELD_NODE,
      .offset = IN(truth, gravity),
      .example = "wgs84",
      .doc = "gravity of the real world: wgs84, grs80, egm96, egm96:120 (to that degree), ..." },
    { .key = "gravity_path",
      .kind = SCHULER_FIELD_TEXT,
      .offset = IN(truth, gravity_path),
      .example = "data/gravity",
      .doc = "folder of the data sets, for the navigator's too; relative to the scenario" },
    { .key = NULL },
};
static const schuler_object truth_object = {
    .name = "truth",
    .doc = "the real world",
    .size = SIZE(truth),
    .fields = truth_fields,
};

#define VALUE(key_, member_, components_, dim_, example_, doc_)                                    \
    {                                                                                              \
        .key = key_, .kind = SCHULER_FIELD_VALUE, .offset = IN(initial, member_), .dim = dim_,     \
        .components = components_, .example = example_, .doc = doc_                                \
    }
#define SWAY(key_, member_, def_, max_, dim_, example_, doc_)                                      \
    {                                                                                              \
        .key = key_, .kind = SCHULER_FIELD_QUANTITY, .offset = IN(initial.align.sway, member_),    \
        .dim = dim_, .def = def_, .min = 0.0, .max = max_, .example = example_, .doc = doc_        \
    }
static const schuler_field sway_fields[] = {
    SWAY("roll", roll_rad, 0.0, 0.8, SCHULER_DIM_ANGLE, "3 deg", "amplitude"),
    SWAY("pitch", pitch_rad, 0.0, 0.8, SCHULER_DIM_ANGLE, "1 deg", "amplitude"),
    SWAY("heading", heading_rad, 0.0, 0.8, SCHULER_DIM_ANGLE, "0.5 deg", "amplitude"),
    SWAY("period", period_s, 8.0, 1e4, SCHULER_DIM_TIME, "8 s",
         "of the roll; pitch has 0.8 of it, heading 1.3"),
    { .key = NULL },
};
static const schuler_object sway_object = {
    .name = "sway",
    .doc = "sinusoidal swaying of the base",
    .size = SIZE(initial.align.sway),
    .fields = sway_fields,
};
static const char *const methods[] = { "fine", "coarse", NULL };
static const schuler_field align_fields[] = {
    { .key = "for",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(initial.align, for_s),
      .required = true,
      .dim = SCHULER_DIM_TIME,
      .min = 10.0,
      .max = 7200.0,
      .example = "10 min",
      .doc = "how long, before the mission begins" },
    { .key = "method",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = IN(initial.align, method),
      .choices = methods,
      .example = "fine",
      .doc = "coarse: a triad of gravity and its turn; fine: then a filter too" },
    { .key = "sway",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = IN(initial.align, sway),
      .object = &sway_object,
      .doc = "sinusoidal swaying of the base" },
    { .key = NULL },
};
static const schuler_object align_object = {
    .name = "align",
    .doc = "self-alignment from the simulated sensors, in place of tilt and heading",
    .size = SIZE(initial.align),
    .fields = align_fields,
};

static const schuler_field initial_fields[] = {
    VALUE("position", position, 3, SCHULER_DIM_LENGTH, "{normal: 10 m}", "north, east, down"),
    VALUE("velocity", velocity, 3, SCHULER_DIM_SPEED, "{normal: 0.1 m/s}", "north, east, down"),
    VALUE("tilt", tilt, 2, SCHULER_DIM_ANGLE, "{normal: 10 arcsec}",
          "phi about north and east: the computed attitude is (I - [phi x]) C_b_n"),
    VALUE("heading", heading, 1, SCHULER_DIM_ANGLE, "{normal: 1 arcmin}", "computed minus true"),
    { .key = "align",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = IN(initial, align),
      .object = &align_object,
      .doc = "self-alignment from the simulated sensors, in place of tilt and heading" },
    { .key = NULL },
};
static const schuler_object initial_object = {
    .name = "initial",
    .doc = "errors of the start",
    .size = SIZE(initial),
    .fields = initial_fields,
};

static const char *const verticals[] = { "truth", "free", "baro", NULL };
static const char *const sample_counts[] = { "1", "2", "4", "8", NULL };
static const schuler_field navigation_fields[] = {
    { .key = "frame",
      .kind = SCHULER_FIELD_NODE,
      .offset = IN(navigation, frame),
      .example = "ecef",
      .doc = "frame the navigator computes in" },
    { .key = "gravity",
      .kind = SCHULER_FIELD_NODE,
      .offset = IN(navigation, gravity),
      .example = "wgs84",
      .doc = "gravity model of the navigator" },
    { .key = "vertical",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = IN(navigation, vertical),
      .choices = verticals,
      .example = "truth",
      .doc = "how height is held" },
    { .key = "coning",
      .kind = SCHULER_FIELD_NODE,
      .offset = IN(navigation, coning),
      .example = "cubic",
      .doc = "attitude algorithm: what corrects for coning and sculling" },
    { .key = "baro_time",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(navigation, baro_time_s),
      .dim = SCHULER_DIM_TIME,
      .def = NAN,
      .min = 1.0,
      .max = 1e5,
      .example = "100 s",
      .doc = "time constant of the loop of vertical: baro" },
    { .key = "samples_per_update",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = IN(navigation, samples_per_update),
      .choices = sample_counts,
      .example = "1",
      .doc = "samples in a navigation update" },
    { .key = NULL },
};
static const schuler_object navigation_object = {
    .name = "navigation",
    .doc = "the navigator",
    .size = SIZE(navigation),
    .fields = navigation_fields,
};

#define BARO(key_, error_, dim_, min_, max_, example_, doc_)                                       \
    {                                                                                              \
        .key = key_, .kind = SCHULER_FIELD_VALUE, .offset = IN(baro, errors[error_]), .dim = dim_, \
        .components = 1, .min = min_, .max = max_, .example = example_, .doc = doc_                \
    }
static const schuler_field baro_fields[] = {
    BARO("bias", SCHULER_BARO_BIAS, SCHULER_DIM_LENGTH, -1e4, 1e4, "{normal: 30 m}",
         "reading less height"),
    BARO("scale_factor", SCHULER_BARO_SCALE_FACTOR, SCHULER_DIM_NONE, -0.5, 0.5, "{normal: 1 %}",
         "error of the height over the start, relative"),
    BARO("lag", SCHULER_BARO_LAG, SCHULER_DIM_TIME, 0.0, 1e4, "1 s",
         "time constant with which it follows"),
    BARO("noise", SCHULER_BARO_NOISE, SCHULER_DIM_HEIGHT_NOISE, 0.0, 1e4, "1 m/sqrt(Hz)",
         "white noise, root of the two-sided density"),
    BARO("gauss_markov", SCHULER_BARO_GAUSS_MARKOV, SCHULER_DIM_LENGTH, 0.0, 1e4, "20 m",
         "the weather, a first-order Gauss-Markov process, its sigma"),
    { .key = "gauss_markov_time",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(baro, gauss_markov_time_s),
      .dim = SCHULER_DIM_TIME,
      .def = NAN,
      .min = 1e-3,
      .max = 1e9,
      .example = "1 h",
      .doc = "correlation time of gauss_markov" },
    { .key = NULL },
};
static const schuler_object baro_object = {
    .name = "baro",
    .doc = "errors of the barometer",
    .size = SIZE(baro),
    .fields = baro_fields,
};

static const schuler_field errors_fields[] = {
    { .key = "only",
      .kind = SCHULER_FIELD_TEXTS,
      .offset = IN(errors, only),
      .example = "[gyro]",
      .doc = "error sources or groups that act; no others" },
    { .key = "without",
      .kind = SCHULER_FIELD_TEXTS,
      .offset = IN(errors, without),
      .example = "[gyro.bias]",
      .doc = "error sources or groups that do not act" },
    { .key = NULL },
};
static const schuler_object errors_object = {
    .name = "errors",
    .doc = "which error sources act",
    .size = SIZE(errors),
    .fields = errors_fields,
};

const char *const schuler_metric_names[] = { "slope", "final", "trms", "harmonic", NULL };

static const schuler_field requirement_fields[] = {
    { .key = "drift",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(requirement, drift_mps),
      .def = NAN,
      .dim = SCHULER_DIM_SPEED,
      .min = 1e-9,
      .max = 1e4,
      .example = "1 nmi/h",
      .doc = "largest allowed drift" },
    { .key = "position",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(requirement, position_m),
      .def = NAN,
      .dim = SCHULER_DIM_LENGTH,
      .min = 1e-6,
      .max = 1e7,
      .example = "10 nmi",
      .doc = "instead of a drift: largest allowed error at the end" },
    { .key = "statistic",
      .kind = SCHULER_FIELD_NODE,
      .offset = IN(requirement, statistic),
      .example = "CEP",
      .doc = "CEP, R95, R99, rms, or one_axis (95 % of north and east by themselves); no default" },
    { .key = "metric",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = IN(requirement, metric),
      .choices = schuler_metric_names,
      .example = "slope",
      .doc = "drift of a run: slope through the origin, final error over time, trms (of error over "
             "time), or "
             "the mean rate beside a Schuler oscillation" },
    { .key = NULL },
};
static const schuler_object requirement_object = {
    .name = "requirement",
    .doc = "what the navigator must meet",
    .size = SIZE(requirement),
    .fields = requirement_fields,
};

static const schuler_field report_fields[] = {
    { .key = "every",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = IN(report, every_s),
      .dim = SCHULER_DIM_TIME,
      .def = NAN,
      .min = 1e-3,
      .max = 1e6,
      .example = "10 s",
      .doc = "interval at which errors are looked at" },
    { .key = NULL },
};
static const schuler_object report_object = {
    .name = "report",
    .doc = "when errors are looked at",
    .size = SIZE(report),
    .fields = report_fields,
};

#define OBJECT(key_, doc_)                                                                         \
    {                                                                                              \
        .key = #key_, .kind = SCHULER_FIELD_OBJECT, .offset = AT(key_), .object = &key_##_object,  \
        .doc = doc_                                                                                \
    }
static const schuler_field scenario_fields[] = {
    { .key = "scenario",
      .kind = SCHULER_FIELD_TEXT,
      .offset = AT(name),
      .required = true,
      .example = "One hour at 45 N",
      .doc = "what it is, in a few words" },
    { .key = "seed",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = AT(seed),
      .def = 1,
      .min = 0,
      .max = 0x1p63,
      .example = "42",
      .doc = "of the random numbers" },
    { .key = "runs",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = AT(runs),
      .def = 100,
      .min = 1,
      .max = 100000,
      .example = "100",
      .doc = "draws of the random errors" },
    OBJECT(truth, "the real world"),
    { .key = "trajectory",
      .kind = SCHULER_FIELD_NODE,
      .offset = AT(trajectory),
      .required = true,
      .example = "{kind: static, start: {lat: 45 deg, lon: 7 deg}, for: 1 h}",
      .doc = "the true motion" },
    { .key = "imu",
      .kind = SCHULER_FIELD_NODE,
      .offset = AT(imu),
      .required = true,
      .example = "{use: hg9900}",
      .doc = "the inertial sensors" },
    OBJECT(initial, "errors of the start"),
    OBJECT(navigation, "the navigator"),
    OBJECT(baro, "errors of the barometer"),
    OBJECT(errors, "which error sources act"),
    OBJECT(requirement, "what the navigator must meet"),
    OBJECT(report, "when errors are looked at"),
    { .key = NULL },
};
const schuler_object schuler_scenario_object = {
    .name = "scenario",
    .doc = "a scenario file",
    .size = sizeof(schuler_scenario_file),
    .fields = scenario_fields,
};

/* SPDX-License-Identifier: MIT */
/* The `imu` section of a scenario: a part of the catalog or of a file, and what is changed in it.
 */
#include "core/earth.h"
#include "scenarios/part.h"
#include "sensors/response.h"
#include <math.h>
#include <string.h>

typedef struct {
    schuler_place place;
    const schuler_node *use, *triad[SCHULER_INSTRUMENTS];
    const schuler_node *temperature;
    double rate_hz; /* NAN = not given */
    int64_t unit;   /* -1 = not given  */
} imu_section;

static const schuler_field fields[] = {
    { .key = "use",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(imu_section, use),
      .example = "hg9900",
      .doc = "a part of the catalog, or a file of the same form" },
    { .key = "rate",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = offsetof(imu_section, rate_hz),
      .dim = SCHULER_DIM_FREQUENCY,
      .def = NAN,
      .min = 1.0,
      .max = 1e4,
      .example = "100 Hz",
      .doc = "samples of increments a second" },
    { .key = "unit",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = offsetof(imu_section, unit),
      .def = -1,
      .min = 0,
      .max = 4294967295.0,
      .example = "3",
      .doc = "which specimen flies in every run: values drawn 'per: unit' stay the same; default: "
             "another one in each run" },
    { .key = "temperature",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(imu_section, temperature),
      .example = "{reference: 25 degC, warm_up: {from: 20 degC, to: 60 degC, time: 10 min}}",
      .doc = "temperature of the instruments over the mission; default: always the reference" },
    { .key = "accel",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(imu_section, triad[SCHULER_ACCEL]),
      .example = "{model: linear, bias: 50 ug}",
      .doc = "the accelerometers" },
    { .key = "gyro",
      .kind = SCHULER_FIELD_NODE,
      .offset = offsetof(imu_section, triad[SCHULER_GYRO]),
      .example = "{model: linear, bias: 0.01 deg/h}",
      .doc = "the gyros" },
    { .key = NULL },
};

static const schuler_object imu_object = {
    .name = "imu",
    .doc = "the inertial sensors",
    .size = sizeof(imu_section),
    .fields = fields,
};

/* Usual size of the bias in a class, for a word of doubt about a value of another order. */
static const struct {
    const char *grade;
    double bias[SCHULER_INSTRUMENTS]; /* m/s^2, rad/s */
    const char *spelled[SCHULER_INSTRUMENTS];
} classes[] = {
    { "strategic", { 1e-6 * SCHULER_G0_MPS2, 5e-10 }, { "1 ug", "0.0001 deg/h" } },
    { "navigation", { 50e-6 * SCHULER_G0_MPS2, 5e-8 }, { "50 ug", "0.01 deg/h" } },
    { "tactical", { 1e-3 * SCHULER_G0_MPS2, 5e-6 }, { "1 mg", "1 deg/h" } },
    { "industrial", { 10e-3 * SCHULER_G0_MPS2, 2e-3 }, { "10 mg", "0.1 deg/s" } },
    { "consumer", { 30e-3 * SCHULER_G0_MPS2, 2e-2 }, { "30 mg", "1 deg/s" } },
};

static void doubt_bias(schuler_reading *r, const char *grade, const schuler_node *node,
                       const char *what, schuler_instrument instrument, const schuler_triad *triad)
{
    if (!grade || !triad->model || !schuler_node_find(node, "bias")) return;
    const schuler_param *const params = triad->params;
    int bias = 0;
    while (params[bias].key && strcmp(params[bias].key, "bias") != 0) bias++;
    if (!params[bias].key) return;
    const schuler_value *const v = &triad->values[bias];
    double largest = 0.0;
    for (int k = 0; v->given && k < params[bias].components; k++)
        largest = fmax(largest, fmax(fabs(v->a[k]), fabs(v->b[k])));
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++) {
        const double ratio = largest / classes[i].bias[instrument];
        if (strcmp(classes[i].grade, grade) != 0 || ratio < 100.0) continue;
        schuler_warn(r->d, &v->place,
                     "%s.bias: %.60s is about %.0f times what is usual in the class '%s' (%s); is "
                     "the unit right?",
                     what, v->text, ratio, grade, classes[i].spelled[instrument]);
    }
}

/* Another part's triad, for `imu.accel.use` and `imu.gyro.use`. */
static bool use_triad(schuler_reading *r, const schuler_node *use, const char *what,
                      schuler_instrument instrument, const char *folder, schuler_triad *triad,
                      schuler_document *documents[], size_t *count)
{
    schuler_part part = { 0 };
    if (!schuler_part_use(r, use, what, folder, &part, documents, count)) return false;
    if (!part.imu.triad[instrument].model) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &use->place, "%.60s: the part '%.60s' has no %ss",
                         what, part.imu.name, schuler_instrument_name(instrument));
        return false;
    }
    *triad = part.imu.triad[instrument];
    return true;
}

/* Layers: the part, if any, and then the section's own keys. */
static void read_triads(schuler_reading *r, const schuler_node *node, const imu_section *section,
                        const char *grade, const char *folder, schuler_imu *imu,
                        schuler_document *documents[], size_t *count)
{
    static const char *const paths[SCHULER_INSTRUMENTS] = { "imu.accel", "imu.gyro" };
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_instrument instrument = (schuler_instrument)i;
        const char *const key = schuler_instrument_name(instrument);
        const schuler_node *const own = section->triad[i];
        const schuler_node *const use = own ? schuler_node_find(own, "use") : NULL;
        const bool found = !use || use_triad(r, use, schuler_reading_path(r, paths[i], "use"),
                                             instrument, folder, &imu->triad[i], documents, count);
        if (own && found) {
            schuler_triad_read(r, own, paths[i], instrument, &imu->triad[i]);
            doubt_bias(r, grade, own, paths[i], instrument, &imu->triad[i]);
        } else if (!own && !imu->triad[i].model && !section->use) {
            schuler_diagnose(
                r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                "'imu' needs the key '%s' (or 'use: NAME', a part of the catalog), for "
                "example: %s",
                key,
                i == SCHULER_ACCEL ? "{model: linear, bias: 50 ug}"
                                   : "{model: linear, bias: 0.01 deg/h}");
        }
        schuler_triad_finish(r, paths[i], &imu->triad[i]);
    }
}

/* The delay stage keeps so many samples. */
static void check_delay(schuler_reading *r, const schuler_imu *imu, const char *what,
                        const schuler_triad *triad)
{
    for (int k = 0; triad->model && triad->params[k].key; k++) {
        const schuler_value *const v = &triad->values[k];
        if (strcmp(triad->params[k].key, "delay") != 0 || !v->given) continue;
        double longest_s = 0.0;
        for (int c = 0; c < triad->params[k].components; c++)
            longest_s = fmax(longest_s, fmax(v->a[c], v->b[c]));
        if (longest_s * imu->rate_hz > SCHULER_DELAY_STEPS_MAX)
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &v->place,
                             "%s.delay: at %g Hz at most %g s (%d samples) are allowed", what,
                             imu->rate_hz, SCHULER_DELAY_STEPS_MAX / imu->rate_hz,
                             SCHULER_DELAY_STEPS_MAX);
    }
}

bool schuler_part_use(schuler_reading *r, const schuler_node *use, const char *what,
                      const char *folder, schuler_part *part, schuler_document *documents[],
                      size_t *count)
{
    const char *name, *text = schuler_read_scalar(r, use, what, "a part's name");
    bool strict;
    /* From the command line, a file is meant as seen from where the command is given. */
    const char *const from = use->place.line > 0 ? folder : NULL;
    const size_t errors = r->d->errors;
    schuler_document *document = NULL;
    if (!text) return false;
    const schuler_status rc =
        schuler_part_open(r, text, from, &use->place, &document, &name, &strict);
    if (document) documents[(*count)++] = document;
    if (rc != SCHULER_OK) return false;
    schuler_part_read(r, document, name, strict, part);
    return r->d->errors == errors;
}

void schuler_imu_read(schuler_reading *r, const schuler_node *node, const char *folder,
                      schuler_imu *imu, schuler_document *documents[], size_t *count)
{
    imu_section section;
    if (schuler_schema_read(node, "imu", &imu_object, &section, r->arena, r->d) ==
            SCHULER_ERR_MEMORY ||
        node->kind != SCHULER_NODE_MAP)
        return;
    schuler_part part = { .imu = { .name = "custom", .title = "custom", .rate_hz = 100.0 } };
    const bool part_is_read = !section.use || schuler_part_use(r, section.use, "imu.use", folder,
                                                               &part, documents, count);
    *imu = part.imu;
    imu->unit = section.unit;
    if (section.temperature)
        imu->has_temperature = schuler_temperature_read(r, section.temperature, &imu->temperature);
    if (!isnan(section.rate_hz)) imu->rate_hz = section.rate_hz;
    if (!part_is_read) { /* its model is not known, so keys mean something only after one's own */
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            if (section.triad[i] && !schuler_node_find(section.triad[i], "model") &&
                !schuler_node_find(section.triad[i], "use"))
                section.triad[i] = NULL;
    }
    read_triads(r, node, &section, part.grade, folder, imu, documents, count);
    for (int i = 0; i < SCHULER_INSTRUMENTS && part_is_read && section.use; i++) {
        const schuler_instrument instrument = (schuler_instrument)i;
        if (imu->triad[i].model || section.triad[i]) continue;
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(section.use),
                         "the part '%.60s' has no %ss; add 'imu.%s' with 'model' or 'use'",
                         part.imu.name, schuler_instrument_name(instrument),
                         schuler_instrument_name(instrument));
    }
    check_delay(r, imu, "imu.accel", &imu->triad[SCHULER_ACCEL]);
    check_delay(r, imu, "imu.gyro", &imu->triad[SCHULER_GYRO]);
    if (section.use && (section.triad[SCHULER_ACCEL] || section.triad[SCHULER_GYRO])) {
        const char *title = schuler_arena_printf(r->arena, "%s (with changes)", imu->title);
        if (title) imu->title = title;
    }
}

/* SPDX-License-Identifier: MIT */
/* The `imu` section of a scenario: a part of the catalog or of a file, and what is changed in it.
 */
#include "core/earth.h"
#include "scenarios/part.h"
#include <math.h>
#include <string.h>

typedef struct {
    schuler_place place;
    const schuler_node *use, *triad[SCHULER_INSTRUMENTS];
    double rate_hz; /* NAN = not given */
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
    const schuler_param *const params = triad->model->params[instrument];
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

/* Layers: the part, if any, and then the section's own keys. */
static void read_triads(schuler_reading *r, const schuler_node *node, const imu_section *section,
                        const char *grade, schuler_imu *imu)
{
    static const char *const paths[SCHULER_INSTRUMENTS] = { "imu.accel", "imu.gyro" };
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_instrument instrument = (schuler_instrument)i;
        const char *const key = schuler_instrument_name(instrument);
        const schuler_node *const own = section->triad[i];
        if (own) {
            schuler_triad_read(r, own, paths[i], instrument, &imu->triad[i]);
            doubt_bias(r, grade, own, paths[i], instrument, &imu->triad[i]);
        } else if (!section->use) {
            schuler_diagnose(
                r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                "'imu' needs the key '%s' (or 'use: NAME', a part of the catalog), for "
                "example: %s",
                key, fields[2 + i].example);
        }
        schuler_triad_finish(r, paths[i], instrument, &imu->triad[i]);
    }
}

void schuler_imu_read(schuler_reading *r, const schuler_node *node, const char *folder,
                      schuler_imu *imu, schuler_document **document)
{
    *document = NULL;
    imu_section section;
    if (schuler_schema_read(node, "imu", &imu_object, &section, r->arena, r->d) ==
            SCHULER_ERR_MEMORY ||
        node->kind != SCHULER_NODE_MAP)
        return;
    schuler_part part = { .imu = { .name = "custom", .title = "custom", .rate_hz = 100.0 } };
    bool part_is_read = !section.use;
    if (section.use) {
        const char *name, *text = schuler_read_scalar(r, section.use, "imu.use", "a part's name");
        bool strict;
        /* From the command line, a file is meant as seen from where the command is given. */
        const char *const from = section.use->place.line > 0 ? folder : NULL;
        if (text && schuler_part_open(r, text, from, &section.use->place, document, &name,
                                      &strict) == SCHULER_OK) {
            const size_t errors = r->d->errors;
            schuler_part_read(r, *document, name, strict, &part);
            part_is_read = r->d->errors == errors;
        }
    }
    *imu = part.imu;
    if (!isnan(section.rate_hz)) imu->rate_hz = section.rate_hz;
    if (!part_is_read) { /* its model is not known, so keys mean something only after one's own */
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            if (!schuler_node_find(section.triad[i], "model")) section.triad[i] = NULL;
    }
    read_triads(r, node, &section, part.grade, imu);
    if (section.use && (section.triad[SCHULER_ACCEL] || section.triad[SCHULER_GYRO])) {
        const char *title = schuler_arena_printf(r->arena, "%s (with changes)", imu->title);
        if (title) imu->title = title;
    }
}

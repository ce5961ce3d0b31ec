/* SPDX-License-Identifier: MIT */
/* schuler models: everything pluggable, as its own tables describe it. */
#include "core/trajectory.h"
#include "mechanization/mechanization.h"
#include "sensors/model.h"
#include "tools/arguments.h"
#include "tools/fields.h"
#include "tools/list_show.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/page.h"
#include <string.h>

static const struct argp argp = {
    .parser = list_show_parse,
    .args_doc = "[list]\nshow NAME",
    .doc =
        "What a scenario can choose from: sensor error models, trajectories, navigation frames and "
        "gravity. 'show' prints the keys of one with units, ranges and formulas, and its source."
        "\vExamples:\n"
        "  schuler models\n"
        "  schuler models show linear\n"
        "  schuler models show segments\n" ARGUMENTS_EXIT_STATUS,
};

typedef struct {
    const char *name, *summary, *source;
} gravity_model;

static const gravity_model gravities[] = {
    { "wgs84", "normal gravity of the WGS84 ellipsoid, built in",
      "GeographicLib NormalGravity; NIMA TR8350.2" },
    { "grs80", "normal gravity of the GRS80 ellipsoid, built in",
      "GeographicLib NormalGravity; H. Moritz, Geodetic Reference System 1980" },
    { "egm96",
      "the real field to degree 360; the data set comes with 'geographiclib-get-gravity egm96'",
      "GeographicLib GravityModel; F. G. Lemoine et al., NASA/TP-1998-206861" },
    { "egm2008", "the real field to degree 2190; 'geographiclib-get-gravity egm2008'",
      "GeographicLib GravityModel; N. K. Pavlis et al., J. Geophys. Res. 117, 2012" },
    { 0 },
};

enum { NAME_COLUMNS = 12 };

static void list_row(FILE *out, const char *name, const char *summary)
{
    fputs("  ", out);
    page_cell(out, name, NAME_COLUMNS);
    page_wrap(out, summary, 2 + NAME_COLUMNS, 2 + NAME_COLUMNS);
}

static void list(FILE *out)
{
    fputs("Sensor error models (imu.accel.model, imu.gyro.model)\n", out);
    const schuler_sensor_model *const *models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    for (int i = 0; models[i]; i++) list_row(out, models[i]->name, models[i]->summary);
    fputs("\nTrajectories (trajectory.kind)\n", out);
    for (int i = 0; schuler_trajectory_kinds[i]; i++)
        list_row(out, schuler_trajectory_kinds[i]->name, schuler_trajectory_kinds[i]->summary);
    fputs("\nNavigation frames (navigation.frame)\n", out);
    const schuler_mechanization *const *frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (int i = 0; frames[i]; i++) list_row(out, frames[i]->name, frames[i]->summary);
    fputs("\nGravity (truth.gravity, navigation.gravity)\n", out);
    for (int i = 0; gravities[i].name; i++) list_row(out, gravities[i].name, gravities[i].summary);
    fputs("\n'schuler models show NAME' shows the keys of one.\n", out);
}

static void put_head(FILE *out, const char *what, const char *name, const char *summary,
                     const char *source)
{
    fprintf(out, "%s, %s\n  ", name, what);
    page_wrap(out, summary, 2, 2);
    fputs("  source: ", out);
    page_wrap(out, source, 10, 10);
}

static void put_params(FILE *out, schuler_instrument instrument, const schuler_param *params)
{
    enum { KEY = 4, TEXT = 8 };
    fprintf(out, "\n  %s\n", schuler_instrument_name(instrument));
    for (int i = 0; params[i].key; i++) {
        const schuler_param *p = &params[i];
        fields_key(out, KEY, p->key, p->example);
        fields_doc(out, TEXT, p->doc);
        if (p->formula) fprintf(out, "%*sformula: %s\n", TEXT, "", p->formula);
        fprintf(out, "%*s", TEXT, "");
        fields_unit(out, p->dim);
        fields_range(out, p->min, p->max, p->dim);
        if (!p->number) fields_default(out, p->def, p->dim);
        if (p->components > 1) fprintf(out, "; one value or %d", p->components);
        fputc('\n', out);
        if (p->companion) fprintf(out, "%*sneeds %s\n", TEXT, "", p->companion);
        if (p->number)
            fprintf(out, "%*serror source %s.%s\n", TEXT, "", schuler_instrument_name(instrument),
                    p->key);
    }
}

static bool show(FILE *out, const char *name)
{
    const schuler_sensor_model *const *models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    for (int i = 0; models[i]; i++) {
        if (strcmp(models[i]->name, name) != 0) continue;
        put_head(out, "a sensor error model", name, models[i]->summary, models[i]->source);
        for (int k = 0; k < SCHULER_INSTRUMENTS; k++)
            if (models[i]->params[k]) put_params(out, (schuler_instrument)k, models[i]->params[k]);
        return true;
    }
    for (int i = 0; schuler_trajectory_kinds[i]; i++) {
        const schuler_trajectory_kind *kind = schuler_trajectory_kinds[i];
        if (strcmp(kind->name, name) != 0) continue;
        put_head(out, "a kind of trajectory", name, kind->summary, kind->source);
        fputc('\n', out);
        fields_print(out, kind->object, 2);
        return true;
    }
    const schuler_mechanization *const *frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (int i = 0; frames[i]; i++) {
        if (strcmp(frames[i]->name, name) != 0) continue;
        put_head(out, "a navigation frame", name, frames[i]->summary, frames[i]->source);
        return true;
    }
    for (int i = 0; gravities[i].name; i++) {
        if (strcmp(gravities[i].name, name) != 0) continue;
        put_head(out, "a gravity model", name, gravities[i].summary, gravities[i].source);
        return true;
    }
    return false;
}

static exit_code unknown(const char *name)
{
    const char *known[4 * NAMES_MAX + 1], **at = known;
    names_of_sensor_models(at);
    while (*at) at++;
    names_of_trajectories(at);
    while (*at) at++;
    names_of_frames(at);
    while (*at) at++;
    for (int i = 0; gravities[i].name; i++) *at++ = gravities[i].name;
    *at = NULL;
    char hint[NAMES_HINT_MAX];
    names_hint(hint, name, known);
    return say_bad_input("unknown model '%.60s'%s", name, hint);
}

exit_code verb_models(int argc, char **argv)
{
    list_show_arguments a = { .what = "model" };
    arguments_parse(&argp, argc, argv, &a);
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    if (!a.name) {
        list(p.out);
    } else if (!show(p.out, a.name)) {
        page_drop(&p);
        return unknown(a.name);
    }
    return page_show(&p);
}

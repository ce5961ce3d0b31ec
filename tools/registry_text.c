/* SPDX-License-Identifier: MIT */
#include "core/overlays.h"
#include "core/trajectory.h"
#include "mechanization/mechanization.h"
#include "tools/fields.h"
#include "tools/page.h"
#include "tools/registry.h"
#include <string.h>

enum { NAME_COLUMNS = 18, KEY = 4, TEXT = 8 };

void registry_row(FILE *out, const char *name, const char *summary)
{
    fputs("  ", out);
    page_cell(out, name, NAME_COLUMNS);
    page_wrap(out, summary, 2 + NAME_COLUMNS, 2 + NAME_COLUMNS);
}

static void list_models(FILE *out, schuler_instrument instrument, const schuler_plugins *plugins)
{
    const schuler_sensor_model *const *list = schuler_sensor_models(SCHULER_ISA_SCALAR);
    for (; *list; list++)
        if ((*list)->params[instrument]) registry_row(out, (*list)->name, (*list)->summary);
    for (list = schuler_plugins_models(plugins); *list; list++) {
        if (!(*list)->params[instrument]) continue;
        registry_row(out, (*list)->name, (*list)->summary);
        fprintf(out, "%*splug-in %s\n", 2 + NAME_COLUMNS, "", schuler_plugins_path(plugins, *list));
    }
}

/* Words with commas, wrapped like list_row's second column. */
static void put_keys(FILE *out, const schuler_sensor_model *stage)
{
    char text[1000];
    size_t at = 0;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
        for (const schuler_param *p = stage->params[i]; p && p->key; p++) {
            const schuler_param *q = stage->params[1 - i];
            while (q && q->key && strcmp(q->key, p->key) != 0) q++;
            const bool of_both = q && q->key;
            if ((of_both && i > 0) || at + strlen(p->key) + 12 > sizeof text) continue;
            at += (size_t)snprintf(text + at, sizeof text - at, "%s%s", at ? ", " : "", p->key);
            if (!of_both)
                at += (size_t)snprintf(text + at, sizeof text - at, " (%s)",
                                       schuler_instrument_name((schuler_instrument)i));
        }
    fprintf(out, "%*s", 2 + NAME_COLUMNS, "");
    page_wrap(out, text, 2 + NAME_COLUMNS, 2 + NAME_COLUMNS);
}

static void list_stages(FILE *out, bool of_response)
{
    const schuler_sensor_model *const *list = schuler_sensor_stages(SCHULER_ISA_SCALAR);
    for (; *list; list++) {
        if (registry_is_response(*list) != of_response) continue;
        registry_row(out, (*list)->name, (*list)->summary);
        put_keys(out, *list);
    }
}

void registry_list(FILE *out, const schuler_plugins *plugins)
{
    fputs("Accelerometer models (imu.accel.model)\n", out);
    list_models(out, SCHULER_ACCEL, plugins);
    fputs("\nGyro models (imu.gyro.model)\n", out);
    list_models(out, SCHULER_GYRO, plugins);
    fputs("\nErrors that any model may have beside its own: keys of imu.accel and imu.gyro\n", out);
    list_stages(out, false);
    fputs("\nResponse and mounting of any model: keys of imu.accel and imu.gyro\n", out);
    list_stages(out, true);
    fputs("\nWords of data sheets: keys of imu.accel and imu.gyro\n", out);
    registry_row(out, "noise_density", "with sided: one or two; becomes the random walk");
    registry_row(out, "allan_floor", "becomes bias_instability");
    fputs("\nTrajectories (trajectory.kind)\n", out);
    for (int i = 0; schuler_trajectory_kinds[i]; i++)
        registry_row(out, schuler_trajectory_kinds[i]->name, schuler_trajectory_kinds[i]->summary);
    fputs("\nMotions that add to any trajectory (trajectory.overlays)\n", out);
    for (int i = 0; schuler_overlay_kinds[i]; i++) {
        const schuler_object *const object = schuler_overlay_object(schuler_overlay_kinds[i]);
        registry_row(out, object->name, object->doc);
    }
    fputs("\nNavigation frames (navigation.frame)\n", out);
    const schuler_mechanization *const *frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (int i = 0; frames[i]; i++) registry_row(out, frames[i]->name, frames[i]->summary);
    fputs("\nAttitude algorithms (navigation.coning)\n", out);
    for (const schuler_coning_algorithm *a = schuler_coning_algorithms; a->name; a++)
        registry_row(out, a->name, a->summary);
    fputs("\nGravity (truth.gravity, navigation.gravity)\n", out);
    registry_gravity_list(out);
    fputs("\n'schuler models show NAME' shows the keys of one.\n", out);
}

void registry_head(FILE *out, const char *what, const char *name, const char *summary,
                   const char *source)
{
    fprintf(out, "%s, %s\n  ", name, what);
    page_wrap(out, summary, 2, 2);
    fputs("  source: ", out);
    page_wrap(out, source, 10, 10);
}

static void put_param(FILE *out, schuler_instrument instrument, const schuler_param *p)
{
    fields_key(out, KEY, p->key, p->example);
    fields_doc(out, TEXT, p->doc);
    if (p->formula) {
        fprintf(out, "%*sformula: ", TEXT, "");
        page_wrap(out, p->formula, TEXT + 9, TEXT + 9);
    }
    fprintf(out, "%*s", TEXT, "");
    if (p->choices) {
        fputs("one of", out);
        for (int i = 0; p->choices[i]; i++) fprintf(out, "%s %s", i ? "," : "", p->choices[i]);
        fprintf(out, "; default %s", p->choices[0]);
    } else {
        fields_unit(out, p->dim);
        fields_range(out, p->min, p->max, p->dim);
        if (!p->number) fields_default(out, p->def, p->dim);
        if (p->components > 1) fprintf(out, "; one value or %d", p->components);
    }
    fputc('\n', out);
    if (p->companion) fprintf(out, "%*sneeds %s\n", TEXT, "", p->companion);
    if (p->number)
        fprintf(out, "%*serror source %s.%s, number %u; acts: %s\n", TEXT, "",
                schuler_instrument_name(instrument), p->key, p->number, registry_acts(p->acts));
}

static void put_equation(FILE *out, const char *equation)
{
    fputs("  equation:\n", out);
    while (*equation) {
        const size_t length = strcspn(equation, "\n");
        fprintf(out, "    %.*s\n", (int)length, equation);
        equation += length + (equation[length] != '\0');
    }
}

static void show_sensor(FILE *out, const char *what, const schuler_sensor_model *m)
{
    registry_head(out, what, m->name, m->summary, m->source);
    if (m->equation) put_equation(out, m->equation);
    if (m->departures) {
        fputs("  departs from the print: ", out);
        page_wrap(out, m->departures, 26, 4);
    }
    for (int k = 0; k < SCHULER_INSTRUMENTS; k++) {
        const schuler_instrument instrument = (schuler_instrument)k;
        const schuler_param *p = m->params[k];
        if (p) fprintf(out, "\n  %s\n", schuler_instrument_name(instrument));
        for (; p && p->key; p++) put_param(out, instrument, p);
    }
}

static const schuler_sensor_model *find(const schuler_sensor_model *const *list, const char *name)
{
    while (*list && strcmp((*list)->name, name) != 0) list++;
    return *list;
}

static bool show_sensor_named(FILE *out, const char *name, const schuler_plugins *plugins)
{
    static const char also[] =
        "\nBeside these a triad has the keys of all stages ('schuler models').\n";
    const schuler_sensor_model *m = find(schuler_sensor_models(SCHULER_ISA_SCALAR), name);
    if (m) {
        show_sensor(out, "a sensor error model", m);
        fputs(also, out);
        return true;
    }
    m = find(schuler_plugins_models(plugins), name);
    if (m) {
        show_sensor(out, "a sensor error model of a plug-in", m);
        fprintf(out, "\nPlug-in %s%s", schuler_plugins_path(plugins, m), also);
        return true;
    }
    m = registry_stage(name);
    if (m)
        show_sensor(out,
                    registry_is_response(m) ? "a stage that follows any sensor error model"
                                            : "an error beside those of any sensor error model",
                    m);
    return m != NULL;
}

static bool show_entry(FILE *out, const char *what, const char *name, const registry_entry *list)
{
    while (list->name && strcmp(list->name, name) != 0) list++;
    if (list->name) registry_head(out, what, name, list->summary, list->source);
    return list->name != NULL;
}

bool registry_show(FILE *out, const char *name, const schuler_plugins *plugins)
{
    if (show_sensor_named(out, name, plugins) ||
        show_entry(out, "a key of imu.accel and imu.gyro", name, registry_spellings) ||
        registry_gravity_show(out, name))
        return true;
    for (int i = 0; schuler_trajectory_kinds[i]; i++) {
        const schuler_trajectory_kind *kind = schuler_trajectory_kinds[i];
        if (strcmp(kind->name, name) != 0) continue;
        registry_head(out, "a kind of trajectory", name, kind->summary, kind->source);
        fputc('\n', out);
        fields_print(out, kind->object, 2);
        return true;
    }
    for (int i = 0; schuler_overlay_kinds[i]; i++) {
        const schuler_object *const object = schuler_overlay_object(schuler_overlay_kinds[i]);
        if (strcmp(object->name, name) != 0) continue;
        registry_head(out, "adds to any trajectory", name, object->doc,
                      schuler_overlay_source(schuler_overlay_kinds[i]));
        fputc('\n', out);
        fields_print(out, object, 2);
        return true;
    }
    const schuler_mechanization *const *frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (int i = 0; frames[i]; i++) {
        if (strcmp(frames[i]->name, name) != 0) continue;
        registry_head(out, "a navigation frame", name, frames[i]->summary, frames[i]->source);
        put_equation(out, frames[i]->equation);
        fputs("  limits: ", out);
        page_wrap(out, frames[i]->limits, 10, 10);
        return true;
    }
    for (const schuler_coning_algorithm *a = schuler_coning_algorithms; a->name; a++) {
        if (strcmp(a->name, name) != 0) continue;
        registry_head(out, "an attitude algorithm", name, a->summary, a->source);
        fputs("  error law: ", out);
        page_wrap(out, a->law, 13, 13);
        return true;
    }
    return false;
}

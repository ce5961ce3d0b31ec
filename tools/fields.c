/* SPDX-License-Identifier: MIT */
#include "tools/fields.h"
#include "core/earth.h"
#include "tools/page.h"
#include <math.h>

/* The unit that limits and defaults are shown in: SI, but degrees, which everybody reads. */
static const char *unit_of(schuler_dim dim)
{
    static const struct {
        schuler_dim dim;
        const char *unit;
    } units[] = {
        { SCHULER_DIM_LENGTH, " m" },
        { SCHULER_DIM_TIME, " s" },
        { SCHULER_DIM_FREQUENCY, " Hz" },
        { SCHULER_DIM_ANGLE, " deg" },
        { SCHULER_DIM_RATE, " deg/s" },
        { SCHULER_DIM_ANGULAR_ACCEL, " deg/s^2" },
        { SCHULER_DIM_SPEED, " m/s" },
        { SCHULER_DIM_ACCEL, " m/s^2" },
        { SCHULER_DIM_JERK, " m/s^3" },
        { SCHULER_DIM_ARW, " deg/sqrt(s)" },
        { SCHULER_DIM_VRW, " m/s/sqrt(s)" },
        { SCHULER_DIM_RRW, " deg/s/sqrt(s)" },
        { SCHULER_DIM_ACCEL_RW, " m/s^2/sqrt(s)" },
    };
    for (size_t i = 0; i < sizeof(units) / sizeof(units[0]); i++)
        if (schuler_dim_equal(units[i].dim, dim)) return units[i].unit;
    return schuler_dim_equal(dim, (schuler_dim)SCHULER_DIM_NONE) ? "" : " in SI units";
}

static double shown(double si, schuler_dim dim)
{
    return dim.angle2 == 2 ? si / SCHULER_RAD_PER_DEG : si;
}

void fields_key(FILE *out, int indent, const char *key, const char *example)
{
    fprintf(out, "%*s%s", indent, "", key);
    if (example) fprintf(out, ": %s", example);
    fputc('\n', out);
}

void fields_doc(FILE *out, int indent, const char *doc)
{
    if (!doc) return;
    fprintf(out, "%*s", indent, "");
    page_wrap(out, doc, indent, indent);
}

void fields_unit(FILE *out, schuler_dim dim)
{
    const char *name = schuler_dim_name(dim, NULL);
    fputs(name ? name : "quantity", out);
}

void fields_range(FILE *out, double min, double max, schuler_dim dim)
{
    if (min == 0.0 && max == 0.0) return;
    if (isfinite(min) && isfinite(max))
        fprintf(out, "; from %g to %g%s", shown(min, dim), shown(max, dim), unit_of(dim));
    else if (isfinite(min))
        fprintf(out, "; at least %g%s", shown(min, dim), unit_of(dim));
    else if (isfinite(max))
        fprintf(out, "; at most %g%s", shown(max, dim), unit_of(dim));
}

void fields_default(FILE *out, double def, schuler_dim dim)
{
    if (!isnan(def)) fprintf(out, "; default %g%s", shown(def, dim), unit_of(dim));
}

static void put_number(FILE *out, const schuler_field *f, int indent)
{
    fprintf(out, "%*s", indent, "");
    if (f->kind == SCHULER_FIELD_INTEGER)
        fputs("whole number", out);
    else if (f->kind == SCHULER_FIELD_NUMBER)
        fputs("number", out);
    else
        fields_unit(out, f->dim);
    if (f->components > 1) fprintf(out, ", %d components", f->components);
    fields_range(out, f->min, f->max, f->dim);
    if (f->required)
        fputs("; required", out);
    else if (f->kind != SCHULER_FIELD_VALUE)
        fields_default(out, f->def, f->dim);
    fputc('\n', out);
}

static void put_variants(FILE *out, const schuler_field *f, int indent)
{
    fprintf(out, "%*sa list; each entry is one of\n", indent, "");
    for (int i = 0; f->variants && f->variants[i]; i++) {
        fprintf(out, "%*s- %s\n", indent, "", f->variants[i]->name);
        fields_doc(out, indent + 4, f->variants[i]->doc);
        fields_print(out, f->variants[i], indent + 4);
    }
}

static void put_field(FILE *out, const schuler_field *f, int indent)
{
    const int inner = indent + 4;
    fields_key(out, indent, f->key, f->object || f->variants ? NULL : f->example);
    fields_doc(out, inner, f->doc);
    switch (f->kind) {
    case SCHULER_FIELD_QUANTITY:
    case SCHULER_FIELD_NUMBER:
    case SCHULER_FIELD_INTEGER:
    case SCHULER_FIELD_VALUE:
        put_number(out, f, inner);
        break;
    case SCHULER_FIELD_CHOICE:
        fprintf(out, "%*sone of", inner, "");
        for (int i = 0; f->choices && f->choices[i]; i++) fprintf(out, " %s", f->choices[i]);
        fputs(f->required ? "; required\n" : "; default is the first\n", out);
        break;
    case SCHULER_FIELD_OBJECT:
    case SCHULER_FIELD_LIST:
        if (f->kind == SCHULER_FIELD_LIST) fprintf(out, "%*sa list; each entry has\n", inner, "");
        if (f->object) fields_print(out, f->object, inner);
        break;
    case SCHULER_FIELD_VARIANTS:
        put_variants(out, f, inner);
        break;
    case SCHULER_FIELD_TEXT:
    case SCHULER_FIELD_TEXTS:
    case SCHULER_FIELD_NODE:
        break;
    }
}

void fields_print(FILE *out, const schuler_object *object, int indent)
{
    for (const schuler_field *f = object->fields; f && f->key; f++) put_field(out, f, indent);
}

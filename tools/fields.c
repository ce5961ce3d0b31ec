/* SPDX-License-Identifier: MIT */
#include "tools/fields.h"
#include "core/earth.h"
#include "tools/page.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Powers of the base units, numerator or denominator; halves as they are. Returns how many. */
static int put_powers(const schuler_dim *dim, int sign, const char *angle, char *text)
{
    const struct {
        const char *name;
        int doubled;
    } base[] = {
        { "kg", dim->mass2 },   { "T", dim->magnetic2 }, { "m", dim->length2 },
        { angle, dim->angle2 }, { "s", dim->time2 },     { "K", dim->temperature2 },
    };
    int count = 0;
    size_t at = 0;
    text[0] = '\0';
    for (size_t i = 0; i < sizeof base / sizeof base[0]; i++) {
        const int doubled = sign * base[i].doubled;
        if (doubled <= 0) continue;
        const char *const between = count++ == 0 ? "" : sign > 0 ? "*" : "/";
        const size_t rest = FIELDS_UNIT_MAX / 2 - at;
        at +=
            (size_t)(doubled == 2   ? snprintf(text + at, rest, "%s%s", between, base[i].name)
                     : doubled == 1 ? snprintf(text + at, rest, "%ssqrt(%s)", between, base[i].name)
                                    : snprintf(text + at, rest, "%s%s^%g", between, base[i].name,
                                               doubled / 2.0));
        if (at >= FIELDS_UNIT_MAX / 2) break;
    }
    return count;
}

static const char *unit_with(schuler_dim dim, const char *angle, char text[FIELDS_UNIT_MAX])
{
    char above[FIELDS_UNIT_MAX / 2], below[FIELDS_UNIT_MAX / 2];
    if (schuler_dim_equal(dim, (schuler_dim)SCHULER_DIM_FREQUENCY)) {
        snprintf(text, FIELDS_UNIT_MAX, "Hz");
        return text;
    }
    const int numerator = put_powers(&dim, 1, angle, above);
    const int denominator = put_powers(&dim, -1, angle, below);
    snprintf(text, FIELDS_UNIT_MAX, "%s%s%s", numerator || !denominator ? above : "1",
             denominator ? "/" : "", below);
    return text;
}

const char *fields_si_unit(schuler_dim dim, char text[FIELDS_UNIT_MAX])
{
    return unit_with(dim, "rad", text);
}

/* Limits and defaults are shown in SI, but degrees, which everybody reads. */
static double shown(double si, schuler_dim dim)
{
    double per_unit = 1.0;
    for (int i = 0; i < dim.angle2; i += 2) per_unit *= SCHULER_RAD_PER_DEG;
    for (int i = 0; i > dim.angle2; i -= 2) per_unit /= SCHULER_RAD_PER_DEG;
    return dim.angle2 % 2 == 0 ? si / per_unit : si;
}

static void put_unit(FILE *out, schuler_dim dim)
{
    char text[FIELDS_UNIT_MAX];
    unit_with(dim, dim.angle2 % 2 == 0 ? "deg" : "rad", text);
    if (text[0]) fprintf(out, " %s", text);
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
    fputs(name && strcmp(name, "another quantity") != 0 ? name : "quantity", out);
}

void fields_range(FILE *out, double min, double max, schuler_dim dim)
{
    if (min == 0.0 && max == 0.0) return;
    if (!isfinite(min) && !isfinite(max)) return;
    if (isfinite(min) && isfinite(max))
        fprintf(out, "; from %g to %g", shown(min, dim), shown(max, dim));
    else
        fprintf(out, "; at %s %g", isfinite(min) ? "least" : "most",
                shown(isfinite(min) ? min : max, dim));
    put_unit(out, dim);
}

void fields_default(FILE *out, double def, schuler_dim dim)
{
    if (isnan(def)) return;
    fprintf(out, "; default %g", shown(def, dim));
    put_unit(out, dim);
}

static void describe_number(FILE *out, const schuler_field *f)
{
    if (f->kind == SCHULER_FIELD_INTEGER)
        fputs("whole number", out);
    else if (f->kind == SCHULER_FIELD_NUMBER)
        fputs("number", out);
    else
        fields_unit(out, f->dim);
    if (f->kind == SCHULER_FIELD_QUANTITIES)
        fprintf(out, ", 1 to %d values", f->components);
    else if (f->components > 1)
        fprintf(out, ", %d components", f->components);
    fields_range(out, f->min, f->max, f->dim);
    if (f->required)
        fputs("; required", out);
    else if (f->kind != SCHULER_FIELD_VALUE && f->kind != SCHULER_FIELD_QUANTITIES)
        fields_default(out, f->def, f->dim);
}

static void put_number(FILE *out, const schuler_field *f, int indent)
{
    char *text = NULL;
    size_t length;
    FILE *const line = open_memstream(&text, &length);
    if (line) {
        describe_number(line, f);
        fclose(line);
        fields_doc(out, indent, text);
    }
    free(text);
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
    case SCHULER_FIELD_QUANTITIES:
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

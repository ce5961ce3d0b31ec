/* SPDX-License-Identifier: MIT */
/* One part in full, and two side by side. */
#include "tools/page.h"
#include "tools/sensor_part.h"
#include "tools/terminal.h"
#include <string.h>

static void put_labelled(FILE *out, const char *label, const char *text)
{
    enum { LABEL = 12 };
    if (!text || !*text) return;
    fprintf(out, "  %-*s", LABEL, label);
    page_wrap(out, text, 2 + LABEL, 2 + LABEL);
}

static void put_parameter(FILE *out, const schuler_param *p, const schuler_value *v)
{
    enum { KEY = 24, INDENT = 8 };
    fprintf(out, "    %-*s %s%s", KEY, p->key, v->text ? v->text : "", v->assumed ? " *" : "");
    if (v->qualifier) fprintf(out, " (%s)", v->qualifier);
    if (v->per_unit) fputs(", drawn once for each unit", out);
    fputc('\n', out);
    if (p->doc) {
        fprintf(out, "%*s", INDENT, "");
        page_wrap(out, p->doc, INDENT, INDENT);
    }
    if (v->source) fprintf(out, "%*ssource: %s\n", INDENT, "", v->source);
    if (v->note) {
        fprintf(out, "%*snote: ", INDENT, "");
        page_wrap(out, v->note, INDENT + 6, INDENT + 6);
    }
}

static void put_triad(FILE *out, const schuler_imu *imu, schuler_instrument instrument)
{
    const schuler_triad *triad = &imu->triad[instrument];
    if (!triad->model) return;
    fprintf(out, "\n  %s, model %s\n", schuler_instrument_name(instrument), triad->model->name);
    for (int i = 0; triad->params[i].key; i++)
        if (triad->values[i].given) put_parameter(out, &triad->params[i], &triad->values[i]);
}

/* What is assumed, once more and together: nobody should have to look for it. */
static void put_assumed(FILE *out, const schuler_imu *imu)
{
    bool any = false;
    for (int k = SCHULER_INSTRUMENTS - 1; k >= 0; k--) {
        const schuler_triad *const triad = &imu->triad[k];
        for (int i = 0; triad->model && triad->params[i].key; i++) {
            if (!triad->values[i].given || !triad->values[i].assumed) continue;
            if (!any)
                fputs("\n* Assumed: not a published figure of this part, or not as one\n", out);
            any = true;
            const int at =
                5 + fprintf(out, "  %s.%s: ", schuler_instrument_name((schuler_instrument)k),
                            triad->params[i].key);
            page_wrap(out, triad->values[i].note ? triad->values[i].note : "no reason is given", at,
                      6);
        }
    }
}

void sensor_part_show(FILE *out, const schuler_part *part)
{
    fprintf(out, "%s: %s\n", part->imu.name, part->imu.title ? part->imu.title : "");
    put_labelled(out, "kind", sensor_part_kind(part));
    put_labelled(out, "maker", part->maker);
    put_labelled(out, "grade", part->grade);
    put_labelled(out, "technology", part->technology);
    fprintf(out, "  %-12s%g Hz\n", "rate", part->imu.rate_hz);
    put_triad(out, &part->imu, SCHULER_GYRO);
    put_triad(out, &part->imu, SCHULER_ACCEL);
    put_assumed(out, &part->imu);
    if (part->source_count > 0) fputs("\nSources\n", out);
    for (size_t i = 0; i < part->source_count; i++) {
        const schuler_source_text *s = &part->sources[i];
        fprintf(out, "  %s: ", s->key);
        page_wrap(out, s->text, terminal_width(s->key) + 4, 6);
    }
    if (part->notes) {
        fputs("\nNotes\n  ", out);
        page_wrap(out, part->notes, 2, 2);
    }
}

static const schuler_value *value_of(const schuler_triad *triad, const char *key)
{
    for (int i = 0; triad->model && triad->params[i].key; i++)
        if (strcmp(triad->params[i].key, key) == 0)
            return triad->values[i].given ? &triad->values[i] : NULL;
    return NULL;
}

enum { DIFF_KEY = 22, DIFF_VALUE = 22 };

static void put_side(FILE *out, const schuler_value *v)
{
    char text[128];
    snprintf(text, sizeof text, "%s%s", v && v->text ? v->text : "-", v && v->assumed ? " *" : "");
    fputs("  ", out);
    page_cell(out, text, DIFF_VALUE);
}

/* The ratio of what the two are worth: the root mean square over the draws. */
static void put_row(FILE *out, const schuler_param *p, const schuler_value *a,
                    const schuler_value *b)
{
    fputs("    ", out);
    page_cell(out, p->key, DIFF_KEY);
    put_side(out, a);
    put_side(out, b);
    if (a && b && !p->choices && schuler_value_rms(a, 0) > 0.0)
        fprintf(out, " %#8.3g", schuler_value_rms(b, 0) / schuler_value_rms(a, 0));
    fputc('\n', out);
}

static bool diff_triad(FILE *out, const schuler_triad *a, const schuler_triad *b,
                       schuler_instrument instrument)
{
    bool assumed = false;
    if (!a->model && !b->model) return false;
    fprintf(out, "\n  %-*s  ", DIFF_KEY + 2, schuler_instrument_name(instrument));
    page_cell(out, a->model ? a->model->name : "none", DIFF_VALUE);
    fprintf(out, "  %s\n", b->model ? b->model->name : "none");
    /* What only the second has comes after: its model may have other keys. */
    for (int side = 0; side < 2; side++) {
        const schuler_triad *const t = side == 0 ? a : b;
        for (int i = 0; t->model && t->params[i].key; i++) {
            const schuler_param *const p = &t->params[i];
            const schuler_value *const x = value_of(a, p->key), *const y = value_of(b, p->key);
            if ((!x && !y) || (side == 1 && x) || (side == 0 && !x)) continue;
            put_row(out, p, x, y);
            assumed |= (x && x->assumed) || (y && y->assumed);
        }
    }
    return assumed;
}

void sensor_part_diff(FILE *out, const schuler_part *a, const schuler_part *b)
{
    fprintf(out, "  %-*s  ", DIFF_KEY + 2, "");
    page_cell(out, a->imu.name, DIFF_VALUE);
    fputs("  ", out);
    page_cell(out, b->imu.name, DIFF_VALUE);
    fputs("  second/first\n", out);
    const char *const rows[3][3] = {
        { "kind", sensor_part_kind(a), sensor_part_kind(b) },
        { "grade", a->grade, b->grade },
        { "maker", a->maker, b->maker },
    };
    for (int i = 0; i < 3; i++) {
        fprintf(out, "  %-*s  ", DIFF_KEY + 2, rows[i][0]);
        page_cell(out, rows[i][1] ? rows[i][1] : "-", DIFF_VALUE);
        fprintf(out, "  %s\n", rows[i][2] ? rows[i][2] : "-");
    }
    bool assumed = false;
    for (int k = SCHULER_INSTRUMENTS - 1; k >= 0; k--)
        assumed |= diff_triad(out, &a->imu.triad[k], &b->imu.triad[k], (schuler_instrument)k);
    if (assumed) fputs("\n  * assumed: not a published figure of the part, or not as one\n", out);
}

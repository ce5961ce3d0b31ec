/* SPDX-License-Identifier: MIT */
/* Physical values, fixed or drawn: V, [V, V, V], {normal: V}, {uniform: V}, {uniform: [V, V]}. */
#include "core/schema_private.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

bool schuler_value_is_zero(const schuler_value *v, int components)
{
    for (int i = 0; i < components; i++)
        if (v->a[i] != 0.0 || v->b[i] != 0.0) return false;
    return true;
}

double schuler_value_rms(const schuler_value *v, int component)
{
    const double a = v->a[component], b = v->b[component];
    return v->draw == SCHULER_DRAW_UNIFORM ? sqrt((a * a + a * b + b * b) / 3.0) : fabs(a);
}

/* A list as written: "[1 mg, 2 mg, 3 mg]"; a scalar as it is. */
static const char *spell(schuler_reading *r, const schuler_node *node)
{
    if (node->kind == SCHULER_NODE_SCALAR) return node->text;
    if (node->kind != SCHULER_NODE_LIST) return "";
    const char *text = "[";
    for (size_t i = 0; text && i < node->count; i++)
        text = schuler_arena_printf(r->arena, "%s%s%s", text, i > 0 ? ", " : "",
                                    spell(r, node->items[i]));
    if (text) text = schuler_arena_printf(r->arena, "%s]", text);
    return text ? text : "";
}

static bool wrong_count(schuler_reading *r, const schuler_node *node, const char *what, int wanted)
{
    if (node->kind != SCHULER_NODE_LIST) {
        schuler_expected(r, node, what, "a value");
    } else if (wanted == 1) {
        schuler_expected(r, node, what, "a single value");
    } else {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place,
                         "%.100s: one value or a list of %d is expected, found a list of %zu", what,
                         wanted, node->count);
    }
    return false;
}

static void fill(double out[SCHULER_VALUE_MAX], int components, double value)
{
    for (int i = 0; i < components; i++) out[i] = value;
}

/* One value for all components, or a list with one for each. */
static bool read_components(schuler_reading *r, const schuler_node *node, const char *what,
                            const schuler_field *f, double out[SCHULER_VALUE_MAX])
{
    double value;
    if (node->kind == SCHULER_NODE_SCALAR) {
        if (!schuler_read_quantity(r, node, what, f, &value)) return false;
        fill(out, f->components, value);
        return true;
    }
    if (node->kind != SCHULER_NODE_LIST || node->count != (size_t)f->components)
        return wrong_count(r, node, what, f->components);
    bool ok = true;
    for (size_t i = 0; i < node->count; i++)
        ok = schuler_read_quantity(r, node->items[i], schuler_reading_index(r, what, i), f,
                                   &out[i]) &&
             ok;
    return ok;
}

/* The field as it applies to a standard deviation or a half-width: not negative, and such that the
 * values themselves stay allowed. */
static bool read_width(schuler_reading *r, const schuler_node *node, const char *what,
                       const schuler_field *f, double out[SCHULER_VALUE_MAX])
{
    const bool any = f->min == 0.0 && f->max == 0.0;
    if (!any && f->min >= 0.0) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                         "%.100s: cannot be negative, so it cannot be drawn about zero; write one "
                         "value or {uniform: [LOW, HIGH]}",
                         what);
        return false;
    }
    schuler_field width = *f;
    width.min = 0.0;
    width.max = any ? HUGE_VAL : fmin(f->max, -f->min);
    return read_components(r, node, what, &width, out);
}

static bool is_scalar(const schuler_node *node)
{
    return node->kind == SCHULER_NODE_SCALAR;
}

/* [V, V] as limits. */
static bool read_limits(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *f, double *low, double *high)
{
    const bool ok = schuler_read_quantity(r, node->items[0], what, f, low);
    if (!schuler_read_quantity(r, node->items[1], what, f, high) || !ok) return false;
    if (*low <= *high) return true;
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place,
                     "%.100s: the lower limit '%.40s' is above the upper one '%.40s'", what,
                     node->items[0]->text, node->items[1]->text);
    return false;
}

static bool is_pair(const schuler_node *node)
{
    return node->kind == SCHULER_NODE_LIST && node->count == 2 && is_scalar(node->items[0]) &&
           is_scalar(node->items[1]);
}

static bool read_uniform(schuler_reading *r, const schuler_node *node, const char *what,
                         const schuler_field *f, schuler_value *out)
{
    if (is_pair(node)) {
        double low, high;
        if (!read_limits(r, node, what, f, &low, &high)) return false;
        fill(out->a, f->components, low);
        fill(out->b, f->components, high);
        out->text =
            schuler_arena_printf(r->arena, "%s .. %s", node->items[0]->text, node->items[1]->text);
        return true;
    }
    const bool pairs = node->kind == SCHULER_NODE_LIST && node->count == (size_t)f->components &&
                       node->count > 0 && is_pair(node->items[0]);
    if (pairs) {
        for (size_t i = 0; i < node->count; i++) {
            if (!is_pair(node->items[i])) return wrong_count(r, node->items[i], what, 2);
            if (!read_limits(r, node->items[i], what, f, &out->a[i], &out->b[i])) return false;
        }
        out->text = spell(r, node);
        return true;
    }
    if (!read_width(r, node, what, f, out->b)) return false;
    for (int i = 0; i < f->components; i++) out->a[i] = -out->b[i];
    out->text = schuler_arena_printf(r->arena, "\u00b1%s", spell(r, node));
    return true;
}

static bool read_normal(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *f, schuler_value *out)
{
    if (!read_width(r, node, what, f, out->a)) return false;
    out->text = schuler_arena_printf(r->arena, "%s 1\u03c3", spell(r, node));
    return true;
}

static bool read_fixed(schuler_reading *r, const schuler_node *node, const char *what,
                       const schuler_field *f, schuler_value *out)
{
    if (!read_components(r, node, what, f, out->a)) return false;
    out->text = spell(r, node);
    return true;
}

/* "yes" and "no" are not understood on purpose: everything else is exact, so this is too. */
static bool read_assumed(schuler_reading *r, const schuler_node *node, const char *what, bool *out)
{
    const bool yes = is_scalar(node) && strcmp(node->text, "true") == 0;
    const bool no = is_scalar(node) && strcmp(node->text, "false") == 0;
    if (!yes && !no) schuler_expected(r, node, what, "true or false");
    *out = yes;
    return yes || no;
}

/* What a drawn value belongs to. */
static bool read_per(schuler_reading *r, const schuler_node *node, const char *what, bool *unit)
{
    const bool is_unit = is_scalar(node) && strcmp(node->text, "unit") == 0;
    const bool is_run = is_scalar(node) && strcmp(node->text, "run") == 0;
    if (!is_unit && !is_run) schuler_expected(r, node, what, "unit or run");
    *unit = is_unit;
    return is_unit || is_run;
}

enum { FORMS = 3 };
static const char *const map_keys[] = { "value", "normal",  "uniform",   "source",
                                        "note",  "assumed", "qualifier", "per" };
enum { MAP_KEYS = sizeof map_keys / sizeof map_keys[0] };

/* The one of value, normal and uniform that is there; its index in form. */
static const schuler_node *find_form(schuler_reading *r, const schuler_node *node, const char *what,
                                     int *form)
{
    const schuler_node *found = NULL;
    for (int i = 0; i < FORMS; i++) {
        const schuler_node *one = schuler_node_find(node, map_keys[i]);
        if (one && found) {
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(one),
                             "%.100s: both '%s' and '%s'; give one of them", what, map_keys[*form],
                             map_keys[i]);
            return NULL;
        }
        if (!one) continue;
        found = one;
        *form = i;
    }
    if (!found)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                         "%.100s: a value is expected: V, [V, V, V], {normal: V}, {uniform: V} or "
                         "{uniform: [V, V]}",
                         what);
    return found;
}

static bool read_map(schuler_reading *r, const schuler_node *node, const char *what,
                     const schuler_field *f, schuler_value *out)
{
    bool ok = true, known = true;
    for (size_t i = 0; i < node->count; i++) {
        const schuler_node *key = node->pairs[i].key, *value = node->pairs[i].value;
        const char *const path = schuler_reading_path(r, what, key->text);
        int k = 0;
        while (k < MAP_KEYS && strcmp(map_keys[k], key->text) != 0) k++;
        if (k == 3)
            ok = (out->source = schuler_read_scalar(r, value, path, "the name of a source")) && ok;
        else if (k == 4)
            ok = (out->note = schuler_read_scalar(r, value, path, "a text")) && ok;
        else if (k == 5)
            ok = read_assumed(r, value, path, &out->assumed) && ok;
        else if (k == 6)
            ok = (out->qualifier = schuler_read_scalar(r, value, path, "a text")) && ok;
        else if (k == 7)
            ok = read_per(r, value, path, &out->per_unit) && ok;
        if (k < MAP_KEYS) continue;
        char lead[240];
        snprintf(lead, sizeof lead, "unknown key '%.60s' in '%.100s'", key->text, what);
        schuler_diagnose_unknown(r, &key->place, lead, key->text, map_keys, MAP_KEYS);
        known = false;
    }
    int form = 0;
    const schuler_node *value = known ? find_form(r, node, what, &form) : NULL;
    if (!value) return false;
    static const schuler_draw draws[FORMS] = { SCHULER_DRAW_FIXED, SCHULER_DRAW_NORMAL,
                                               SCHULER_DRAW_UNIFORM };
    out->draw = draws[form];
    if (form == 0) return read_fixed(r, value, what, f, out) && ok;
    if (form == 1) return read_normal(r, value, what, f, out) && ok;
    return read_uniform(r, value, what, f, out) && ok;
}

bool schuler_read_value(schuler_reading *r, const schuler_node *node, const char *what,
                        const schuler_field *f, schuler_value *out)
{
    schuler_value value = { .place = node->place };
    const bool ok = node->kind == SCHULER_NODE_MAP ? read_map(r, node, what, f, &value)
                                                   : read_fixed(r, node, what, f, &value);
    if (!ok) return false;
    value.given = true;
    if (!value.text) value.text = "";
    *out = value;
    return true;
}

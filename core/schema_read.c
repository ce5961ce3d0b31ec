/* SPDX-License-Identifier: MIT */
/* What the readers of objects and of values share: paths, scalars, quantities, messages. */
#include "core/schema_private.h"
#include "core/units_private.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void out_of_memory(schuler_reading *r)
{
    if (!r->memory_failed) schuler_diagnose(r->d, SCHULER_ERR_MEMORY, NULL, "out of memory");
    r->memory_failed = true;
}

void *schuler_reading_alloc(schuler_reading *r, size_t size)
{
    void *memory = schuler_arena_alloc(r->arena, size);
    if (!memory) out_of_memory(r);
    return memory;
}

const char *schuler_reading_path(schuler_reading *r, const char *what, const char *key)
{
    if (*what == '\0') return key;
    const char *path = schuler_arena_printf(r->arena, "%s.%s", what, key);
    if (!path) out_of_memory(r);
    return path ? path : key;
}

const char *schuler_reading_index(schuler_reading *r, const char *what, size_t index)
{
    const char *path = schuler_arena_printf(r->arena, "%s[%zu]", what, index);
    if (!path) out_of_memory(r);
    return path ? path : what;
}

const schuler_place *schuler_node_place(const schuler_node *node)
{
    return node->key ? &node->key->place : &node->place;
}

void schuler_expected(schuler_reading *r, const schuler_node *node, const char *what,
                      const char *wanted)
{
    char found[80];
    if (node->kind == SCHULER_NODE_LIST)
        snprintf(found, sizeof found, "%s list", node->count == 0 ? "an empty" : "a");
    else if (node->kind == SCHULER_NODE_MAP)
        snprintf(found, sizeof found, "a map");
    else if (node->text[0] == '\0')
        snprintf(found, sizeof found, "nothing");
    else
        snprintf(found, sizeof found, "'%.40s'", node->text);
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place, "%.100s%s%s is expected, found %s",
                     what, *what ? ": " : "", wanted, found);
}

const char *schuler_read_scalar(schuler_reading *r, const schuler_node *node, const char *what,
                                const char *wanted)
{
    if (node->kind == SCHULER_NODE_SCALAR && node->text[0] != '\0') return node->text;
    schuler_expected(r, node, what, wanted);
    return NULL;
}

void schuler_diagnose_unknown(schuler_reading *r, const schuler_place *place, const char *lead,
                              const char *written, const char *const *known, size_t count)
{
    const char *near = schuler_nearest(written, known, count);
    if (near) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, place, "%s; did you mean '%s'?", lead, near);
        return;
    }
    char list[260] = "";
    size_t used = 0;
    for (size_t i = 0; i < count; i++) {
        const char *const comma = i > 0 ? ", " : "";
        const size_t room = sizeof list - sizeof ", ..." - used;
        if (strlen(comma) + strlen(known[i]) > room) {
            snprintf(list + used, sizeof list - used, "%s...", comma);
            break;
        }
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", comma, known[i]);
    }
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, place, "%s; known: %s", lead, list);
}

/* The part of a scalar that a message about its text means. */
static schuler_place part_place(const schuler_node *node, const schuler_place *in_text)
{
    schuler_place place = node->place;
    if (node->text_column > 0 && in_text->column > 0) {
        place.column = node->text_column + in_text->column - 1;
        if (in_text->width > 0) place.width = in_text->width;
    }
    return place;
}

static void out_of_range(schuler_reading *r, const schuler_node *node, const char *what,
                         const schuler_field *f, const schuler_quantity *q)
{
    const char *unit = *q->unit ? " " : "";
    const double low = f->min / q->unit_si, high = f->max / q->unit_si;
    char allowed[160];
    if (isinf(f->max))
        snprintf(allowed, sizeof allowed, "at least %.6g%s%.40s", low, unit, q->unit);
    else if (isinf(f->min))
        snprintf(allowed, sizeof allowed, "at most %.6g%s%.40s", high, unit, q->unit);
    else
        snprintf(allowed, sizeof allowed, "%.6g to %.6g%s%.40s", low, high, unit, q->unit);
    schuler_diagnose(r->d, SCHULER_ERR_INPUT, &node->place,
                     "%.100s: %.40s is out of range; allowed: %s", what, node->text, allowed);
}

/* In the units people write, a bound is rarely a double: 90 deg is allowed where the table says
 * pi/2. */
static bool is_in_range(const schuler_field *f, double si)
{
    if (f->min == 0.0 && f->max == 0.0) return true;
    const double slack = 1e-12;
    return si >= f->min - slack * fabs(isinf(f->min) ? 0.0 : f->min) &&
           si <= f->max + slack * fabs(isinf(f->max) ? 0.0 : f->max);
}

bool schuler_read_quantity(schuler_reading *r, const schuler_node *node, const char *what,
                           const schuler_field *f, double *si)
{
    const schuler_dim none = SCHULER_DIM_NONE;
    char wanted[120];
    snprintf(wanted, sizeof wanted, "a single value%s%.60s%s", f->example ? " such as '" : "",
             f->example ? f->example : "", f->example ? "'" : "");
    const char *text = schuler_read_scalar(r, node, what, wanted);
    if (!text) return false;
    schuler_quantity q;
    schuler_error err = { 0 };
    const schuler_dim dim = f->kind == SCHULER_FIELD_NUMBER ? none : f->dim;
    const schuler_status rc = schuler_quantity_read(text, dim, f->example, &q, &err);
    if (rc != SCHULER_OK) {
        const schuler_place place = part_place(node, &err.place);
        schuler_diagnose(r->d, rc, &place, "%.100s: %.280s", what, err.message);
        return false;
    }
    if (!is_in_range(f, q.si)) {
        out_of_range(r, node, what, f, &q);
        return false;
    }
    *si = q.si;
    return true;
}

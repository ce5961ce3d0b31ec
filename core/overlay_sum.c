/* SPDX-License-Identifier: MIT */
#include "core/overlay_sum.h"
#include "core/overlay_lanes.h"
#include <math.h>
#include <stdlib.h>

/* Phases are reduced to a part of a turn in extended precision at base instants a few turns apart; from
 * there on double has the digits. */
static const double turns_from_base = 8.0;

struct overlay_sum {
    const schuler_overlay *o;
    const overlay_lanes *lanes;
    overlay_columns *columns; /* one per group of o */
    double *memory;
    double step_s, base_s; /* base instants are multiples of step_s, a power of two */
};

const overlay_lanes *schuler_overlay_lanes_for(schuler_isa isa)
{
#define X(name) extern const overlay_lanes schuler_overlay_lanes_##name;
#include "schuler_isas.def"
#undef X
    static const overlay_lanes *const all[] = {
#define X(name) &schuler_overlay_lanes_##name,
#include "schuler_isas.def"
#undef X
    };
    const size_t count = sizeof(all) / sizeof(all[0]);
    return all[(size_t)isa < count ? (size_t)isa : 0];
}

static size_t padded(size_t count)
{
    return (count + OVERLAY_COLUMNS - 1) / OVERLAY_COLUMNS * OVERLAY_COLUMNS;
}

/* Channels that some line acts in. */
static void find_channels(const overlay_group *group, overlay_columns *out)
{
    out->first = OVERLAY_CHANNELS;
    out->end = 0;
    for (size_t i = 0; i < group->count; i++)
        for (int c = 0; c < OVERLAY_CHANNELS; c++) {
            const overlay_line *const line = &group->lines[i];
            if (line->in_phase[c] == 0.0 && line->in_quadrature[c] == 0.0) continue;
            if (c < out->first) out->first = c;
            if (c + 1 > out->end) out->end = c + 1;
        }
    if (out->end == 0) out->first = 0;
}

/* Arrays after one another from `at`; returns what comes after them. */
static double *lay_out(const overlay_group *group, overlay_columns *out, double *at)
{
    const size_t each = padded(group->count);
    out->count = each;
    out->frequency_Hz = at, at += each;
    out->base_turns = at, at += each;
    for (int c = out->first; c < out->end; c++) {
        out->in_phase[c] = at, at += each;
        out->in_quadrature[c] = at, at += each;
    }
    for (size_t i = 0; i < group->count; i++) {
        out->frequency_Hz[i] = (double)group->lines[i].frequency_Hz;
        for (int c = out->first; c < out->end; c++) {
            out->in_phase[c][i] = group->lines[i].in_phase[c];
            out->in_quadrature[c][i] = group->lines[i].in_quadrature[c];
        }
    }
    return at;
}

overlay_sum *schuler_overlay_sum_create(const schuler_overlay *o)
{
    overlay_sum *const s = calloc(1, sizeof *s);
    if (s) s->columns = calloc(o->count + 1, sizeof *s->columns);
    if (!s || !s->columns) {
        schuler_overlay_sum_free(s);
        return NULL;
    }
    size_t places = 0;
    double fastest_Hz = 1.0;
    for (size_t g = 0; g < o->count; g++) {
        overlay_columns *const columns = &s->columns[g];
        find_channels(&o->groups[g], columns);
        places += padded(o->groups[g].count) * (size_t)(2 + 2 * (columns->end - columns->first));
        for (size_t i = 0; i < o->groups[g].count; i++)
            fastest_Hz = fmax(fastest_Hz, (double)o->groups[g].lines[i].frequency_Hz);
    }
    s->memory = aligned_alloc(64, (places + OVERLAY_COLUMNS) * sizeof(double));
    if (!s->memory) {
        schuler_overlay_sum_free(s);
        return NULL;
    }
    for (size_t i = 0; i < places; i++) s->memory[i] = 0.0;
    double *at = s->memory;
    for (size_t g = 0; g < o->count; g++) at = lay_out(&o->groups[g], &s->columns[g], at);
    s->o = o;
    s->lanes = schuler_overlay_lanes_for(schuler_isa_best());
    s->step_s = exp2(floor(log2(turns_from_base / fastest_Hz)));
    s->base_s = -1.0; /* none yet */
    return s;
}

void schuler_overlay_sum_free(overlay_sum *s)
{
    if (!s) return;
    free(s->memory);
    free(s->columns);
    free(s);
}

static void rebase(overlay_sum *s, double base_s)
{
    s->base_s = base_s;
    for (size_t g = 0; g < s->o->count; g++)
        for (size_t i = 0; i < s->o->groups[g].count; i++) {
            const long double turns = s->o->groups[g].lines[i].frequency_Hz * base_s;
            s->columns[g].base_turns[i] = (double)(turns - rintl(turns));
        }
}

void schuler_overlay_sum_at(overlay_sum *s, long double t_s, double x[OVERLAY_CHANNELS],
                            double x_dot[OVERLAY_CHANNELS])
{
    const double base_s = floor((double)t_s / s->step_s) * s->step_s;
    if (base_s != s->base_s) rebase(s, base_s);
    for (int c = 0; c < OVERLAY_CHANNELS; c++) x[c] = x_dot[c] = 0.0;
    for (size_t g = 0; g < s->o->count; g++) {
        const overlay_columns *const columns = &s->columns[g];
        double envelope, envelope_dot, value[OVERLAY_CHANNELS], slope[OVERLAY_CHANNELS];
        schuler_overlay_envelope(&s->o->groups[g].window, s->o->duration_s, t_s, &envelope,
                                 &envelope_dot);
        if (envelope == 0.0) continue;
        s->lanes->sum(columns, (double)(t_s - base_s), value, slope);
        for (int c = columns->first; c < columns->end; c++) {
            x[c] += envelope * value[c];
            x_dot[c] += envelope * slope[c] + envelope_dot * value[c];
        }
    }
}

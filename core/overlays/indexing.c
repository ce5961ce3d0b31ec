/* SPDX-License-Identifier: MIT */
/* The IMU turned in the vehicle from one rest position to the next, about one or two axes. */
#include "core/overlays/keys.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    schuler_place place;
    const char *about;
    double by_rad;
} move_spec;

typedef struct {
    schuler_place place;
    const char *inner, *outer;
    schuler_list moves;
    double dwell_s, rate_radps, ramp_s;
} indexing_spec;

static const char *const gimbals[] = { "inner", "outer", NULL };
static const char *const inner_axes[] = { "z", "x", "y", NULL };
static const char *const outer_axes[] = { "x", "y", "z", NULL };

static const schuler_field move_fields[] = {
    { .key = "about",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(move_spec, about),
      .choices = gimbals,
      .example = "inner",
      .doc = "which of the two axes" },
    FIELD_NEEDED("by", move_spec, by_rad, SCHULER_DIM_ANGLE, -40.0 * SCHULER_PI, 40.0 * SCHULER_PI,
                 "180 deg", "angle, negative the other way"),
    { 0 },
};

static const schuler_object move_object = {
    .name = "moves",
    .doc = "one turn of the IMU",
    .size = sizeof(move_spec),
    .fields = move_fields,
};

static const schuler_field fields[] = {
    { .key = "inner",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(indexing_spec, inner),
      .choices = inner_axes,
      .example = "z",
      .doc = "axis of the inner gimbal, which turns with the outer one" },
    { .key = "outer",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(indexing_spec, outer),
      .choices = outer_axes,
      .example = "x",
      .doc = "axis of the outer gimbal in the vehicle" },
    { .key = "moves",
      .kind = SCHULER_FIELD_LIST,
      .offset = offsetof(indexing_spec, moves),
      .required = true,
      .example = "[{by: 180 deg}, {about: outer, by: 180 deg}, {by: -180 deg}, {about: outer, by: "
                 "-180 deg}]",
      .doc = "turns, one after the other and again from the first",
      .object = &move_object },
    FIELD_NEEDED("dwell", indexing_spec, dwell_s, SCHULER_DIM_TIME, 0.0, 1e5, "5 min",
                 "rest before each turn"),
    FIELD_OPTIONAL("rate", indexing_spec, rate_radps, SCHULER_DIM_RATE, 0.34906585039886592, 1e-4,
                   20.0, "20 deg/s", "largest rate of a turn"),
    FIELD_OPTIONAL("ramp", indexing_spec, ramp_s, SCHULER_DIM_TIME, 1.0, 0.01, 100.0, "1 s",
                   "in which it is reached and given up"),
    { 0 },
};

extern const schuler_object schuler_overlay_indexing_object;
const schuler_object schuler_overlay_indexing_object = {
    .name = "indexing",
    .doc = "the IMU is turned from position to position in the vehicle, about one or two axes",
    .size = sizeof(indexing_spec),
    .fields = fields,
};

static schuler_status refuse(const schuler_place *place, schuler_status status, const char *message,
                             schuler_diagnostics *d)
{
    schuler_diagnose(d, status, place, "indexing: %s", message);
    return status;
}

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const indexing_spec *const s = spec;
    const move_spec *const moves = s->moves.items;
    if (o->has_gimbals)
        return refuse(&s->place, SCHULER_ERR_INPUT, "the IMU is turned by another overlay already",
                      d);
    o->has_gimbals = 1;
    o->gimbals[0].axis = s->outer[0] - 'x';
    o->gimbals[1].axis = s->inner[0] - 'x';
    for (int g = 0; g < 2; g++) {
        o->gimbals[g].moves = calloc(s->moves.count, sizeof(overlay_move));
        if (!o->gimbals[g].moves) return refuse(&s->place, SCHULER_ERR_MEMORY, "out of memory", d);
    }
    double t_s = 0.0;
    for (size_t i = 0; i < s->moves.count; i++) {
        overlay_gimbal *const g = &o->gimbals[strcmp(moves[i].about, "inner") == 0];
        t_s += schuler_tick(s->dwell_s);
        overlay_move *const move = &g->moves[g->count++];
        move->start_s = t_s;
        move->trapezoid = schuler_trapezoid_make(moves[i].by_rad, s->rate_radps, s->ramp_s);
        g->round_rad += moves[i].by_rad;
        t_s += schuler_trapezoid_duration(&move->trapezoid);
    }
    o->gimbals[0].round_s = o->gimbals[1].round_s = t_s;
    if (!(t_s > 0.0))
        return refuse(&s->place, SCHULER_ERR_INPUT, "the moves take no time; turn by an angle", d);
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_indexing;
const schuler_overlay_kind schuler_overlay_indexing = {
    .object = &schuler_overlay_indexing_object,
    .source = "closed form: smoothstep trapezoids of the gimbal angles",
    .add = add,
};

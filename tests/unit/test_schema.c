/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/schema.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A table with a field of every kind. */
typedef struct {
    schuler_place place;
    double for_s;
} hold;

typedef struct {
    schuler_place place;
    double by_rad;
} turn;

typedef struct {
    schuler_place place;
    double depth_m, ratio;
    int64_t count;
    const char *title, *mode;
    schuler_value bias, tilt;
    hold inner;
    schuler_list waits;
    schuler_variant_list moves;
    schuler_quantity_list speeds;
    schuler_text_list words;
    const schuler_node *rest;
} thing;

static const schuler_field hold_fields[] = {
    { .key = "for",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = offsetof(hold, for_s),
      .required = true,
      .dim = SCHULER_DIM_TIME,
      .min = 0.0,
      .max = 3600.0,
      .example = "10 min",
      .def = 7.0 },
    { .key = NULL },
};
static const schuler_object hold_object = { "hold", "", sizeof(hold), hold_fields };
static const schuler_field turn_fields[] = {
    { .key = "by",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = offsetof(turn, by_rad),
      .dim = SCHULER_DIM_ANGLE,
      .def = 0.5,
      .example = "90 deg" },
    { .key = NULL },
};
static const schuler_object turn_object = { "turn", "", sizeof(turn), turn_fields };
static const schuler_object *const moves[] = { &hold_object, &turn_object, NULL };
static const char *const modes[] = { "slow", "fast", NULL };
static const schuler_field thing_fields[] = {
    { .key = "depth",
      .kind = SCHULER_FIELD_QUANTITY,
      .offset = offsetof(thing, depth_m),
      .required = true,
      .dim = SCHULER_DIM_LENGTH,
      .min = -10.0,
      .max = 500.0,
      .example = "2 km" },
    { .key = "ratio",
      .kind = SCHULER_FIELD_NUMBER,
      .offset = offsetof(thing, ratio),
      .def = 0.25,
      .max = 1.0 },
    { .key = "count",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = offsetof(thing, count),
      .def = 3,
      .min = 1,
      .max = 9 },
    { .key = "title", .kind = SCHULER_FIELD_TEXT, .offset = offsetof(thing, title) },
    { .key = "mode",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(thing, mode),
      .choices = modes },
    { .key = "bias",
      .kind = SCHULER_FIELD_VALUE,
      .offset = offsetof(thing, bias),
      .components = 3,
      .dim = SCHULER_DIM_ACCEL,
      .min = -10.0,
      .max = 10.0,
      .example = "50 ug" },
    { .key = "tilt",
      .kind = SCHULER_FIELD_VALUE,
      .offset = offsetof(thing, tilt),
      .components = 2,
      .dim = SCHULER_DIM_ANGLE,
      .max = 1.0,
      .example = "1 mrad" },
    { .key = "inner",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(thing, inner),
      .object = &hold_object },
    { .key = "waits",
      .kind = SCHULER_FIELD_LIST,
      .offset = offsetof(thing, waits),
      .object = &hold_object },
    { .key = "moves",
      .kind = SCHULER_FIELD_VARIANTS,
      .offset = offsetof(thing, moves),
      .variants = moves },
    { .key = "speeds",
      .kind = SCHULER_FIELD_QUANTITIES,
      .offset = offsetof(thing, speeds),
      .components = 3,
      .dim = SCHULER_DIM_SPEED,
      .max = 100.0,
      .example = "5 m/s" },
    { .key = "words", .kind = SCHULER_FIELD_TEXTS, .offset = offsetof(thing, words) },
    { .key = "rest", .kind = SCHULER_FIELD_NODE, .offset = offsetof(thing, rest) },
    { .key = NULL },
};
static const schuler_object thing_object = { "thing", "", sizeof(thing), thing_fields };

typedef struct {
    schuler_document *doc;
    schuler_arena *arena;
    schuler_diagnostics d;
    schuler_status rc;
    thing spec;
} reading;

static void read_thing(reading *r, const char *text)
{
    memset(r, 0, sizeof *r);
    if (schuler_document_parse(&r->doc, "t.yaml", text, strlen(text), &r->d) != SCHULER_OK)
        fail_msg("%s", r->d.items[0].message);
    r->arena = schuler_arena_create();
    r->rc = schuler_schema_read(schuler_document_root(r->doc), "", &thing_object, &r->spec,
                                r->arena, &r->d);
}

static void end_reading(reading *r)
{
    schuler_document_free(r->doc);
    schuler_arena_free(r->arena);
    schuler_diagnostics_free(&r->d);
}

static void every_kind_of_field_is_read(void **state)
{
    (void)state;
    reading r;
    read_thing(&r, "depth: 0.2 km\nratio: 5e-1\ncount: 9\ntitle: a b\nmode: fast\n"
                   "bias: {normal: 1 mg}\ntilt: [1 mrad, 2 mrad]\ninner: {for: 1 h}\n"
                   "waits: [{for: 1 s}, {for: 2 s}]\n"
                   "moves:\n  - hold: {for: 3 s}\n  - turn: {by: 1 rad}\nwords: one\nspeeds: [1 "
                   "m/s, 36 km/h]\nrest: {x: y}\n");
    if (r.rc != SCHULER_OK) fail_msg("%s", r.d.items[0].message);
    CHECK_NEAR(r.spec.depth_m, 200.0, 0.0);
    CHECK_NEAR(r.spec.ratio, 0.5, 0.0);
    assert_int_equal(r.spec.count, 9);
    assert_string_equal(r.spec.title, "a b");
    assert_ptr_equal(r.spec.mode, modes[1]);
    assert_int_equal(r.spec.bias.draw, SCHULER_DRAW_NORMAL);
    CHECK_NEAR(r.spec.bias.a[2], 9.80665e-3, 1e-17);
    CHECK_NEAR(r.spec.tilt.a[1], 2e-3, 0.0);
    CHECK_NEAR(r.spec.inner.for_s, 3600.0, 0.0);
    assert_int_equal(r.spec.waits.count, 2);
    CHECK_NEAR(((hold *)r.spec.waits.items)[1].for_s, 2.0, 0.0);
    assert_int_equal(((hold *)r.spec.waits.items)[1].place.line, 9);
    assert_int_equal(r.spec.moves.count, 2);
    assert_ptr_equal(r.spec.moves.items[1].which, &turn_object);
    CHECK_NEAR(((turn *)r.spec.moves.items[1].spec)->by_rad, 1.0, 0.0);
    assert_int_equal(((turn *)r.spec.moves.items[1].spec)->place.line, 12);
    assert_int_equal(((turn *)r.spec.moves.items[1].spec)->place.column, 5);
    assert_int_equal(r.spec.speeds.count, 2);
    CHECK_NEAR(r.spec.speeds.items[0], 1.0, 0.0);
    CHECK_NEAR(r.spec.speeds.items[1], 10.0, 1e-15);
    assert_int_equal(r.spec.words.count, 1);
    assert_string_equal(r.spec.words.items[0], "one");
    assert_int_equal(r.spec.words.places[0].line, 13);
    assert_string_equal(schuler_node_find(r.spec.rest, "x")->text, "y");
    end_reading(&r);
}

static void absent_keys_have_their_defaults(void **state)
{
    (void)state;
    reading r;
    read_thing(&r, "depth: 1 m\n");
    assert_int_equal(r.rc, SCHULER_OK);
    CHECK_NEAR(r.spec.ratio, 0.25, 0.0);
    assert_int_equal(r.spec.count, 3);
    assert_null(r.spec.title);
    assert_ptr_equal(r.spec.mode, modes[0]);
    assert_false(r.spec.bias.given);
    CHECK_NEAR(r.spec.inner.for_s, 7.0, 0.0);
    assert_int_equal(r.spec.inner.place.line, 0);
    assert_int_equal(r.spec.waits.count + r.spec.moves.count + r.spec.words.count, 0);
    assert_null(r.spec.rest);
    end_reading(&r);
}

typedef struct {
    const char *text;
    int line, column, width;
    const char *message;
} mistake;

static void each_mistake_has_its_message_and_place(void **state)
{
    (void)state;
    static const mistake table[] = {
        { "ratio: 1\n", 1, 1, 1, "the file needs the key 'depth', for example: 2 km" },
        { "deph: 1 m\n", 1, 1, 4, "unknown key 'deph'; did you mean 'depth'?" },
        { "depth: 1 m\nzzzzzzzzz: 1\n", 2, 1, 9,
          "unknown key 'zzzzzzzzz'; known: depth, ratio, count, title, mode, bias, tilt, inner, "
          "waits, moves, speeds, words, rest" },
        { "depth: 1 m\ninner: {fro: 1 s}\n", 2, 9, 3,
          "unknown key 'fro' in 'inner'; did you mean 'for'?" },
        { "depth: 1 m\ninner: {}\n", 2, 1, 5, "'inner' needs the key 'for', for example: 10 min" },
        { "depth: 1 m\nwaits:\n  - for: 1 s\n  - {}\n", 4, 5, 1,
          "'waits[1]' needs the key 'for', for example: 10 min" },
        { "depth: 1 m\nmoves: [{hold: {}}]\n", 2, 10, 4,
          "'moves[0].hold' needs the key 'for', for example: 10 min" },
        { "depth: 501 m\n", 1, 8, 5, "depth: 501 m is out of range; allowed: -10 to 500 m" },
        { "depth: -0.02 km\n", 1, 8, 8,
          "depth: -0.02 km is out of range; allowed: -0.01 to 0.5 km" },
        { "depth: 5 deg\n", 1, 10, 3,
          "depth: 'deg' is a unit of angle, but length is expected (such as '5 km')" },
        { "depth: '5 deg'\n", 1, 11, 3,
          "depth: 'deg' is a unit of angle, but length is expected (such as '5 km')" },
        { "depth: \"5\\x20deg\"\n", 1, 8, 10,
          "depth: 'deg' is a unit of angle, but length is expected (such as '5 km')" },
        { "depth: 5\n", 1, 8, 1, "depth: unit missing; write for example '5 km'" },
        { "depth:\n", 1, 7, 1, "depth: a single value such as '2 km' is expected, found nothing" },
        { "depth: [1 m]\n", 1, 8, 1,
          "depth: a single value such as '2 km' is expected, found a list" },
        { "depth: {a: b}\n", 1, 8, 1,
          "depth: a single value such as '2 km' is expected, found a map" },
        { "depth: 1 m\nratio: 2\n", 2, 8, 1, "ratio: 2 is out of range; allowed: 0 to 1" },
        { "depth: 1 m\nratio: 1 m\n", 2, 10, 1,
          "ratio: 'm' is a unit of length, but a plain number is expected (such as '1 ppm')" },
        { "depth: 1 m\ncount: 10\n", 2, 8, 2, "count: 10 is out of range; allowed: 1 to 9" },
        { "depth: 1 m\ncount: 99999999999999999999\n", 2, 8, 20,
          "count: 99999999999999999999 is out of range; allowed: 1 to 9" },
        { "depth: 1 m\ncount: 1.5\n", 2, 8, 3, "count: '1.5' is not a whole number" },
        { "depth: 1 m\ncount: 1e1\n", 2, 8, 3, "count: '1e1' is not a whole number" },
        { "depth: 1 m\ncount: +\n", 2, 8, 1, "count: '+' is not a whole number" },
        { "depth: 1 m\ntitle: [a]\n", 2, 8, 1, "title: a text is expected, found a list" },
        { "depth: 1 m\nmode: fats\n", 2, 7, 4, "mode: unknown 'fats'; did you mean 'fast'?" },
        { "depth: 1 m\nmode: medium\n", 2, 7, 6, "mode: unknown 'medium'; known: slow, fast" },
        { "depth: 1 m\ninner: 5\n", 2, 8, 1, "inner: a map of keys is expected, found '5'" },
        { "depth: 1 m\nwaits: {for: 1 s}\n", 2, 8, 1,
          "waits: a list of maps is expected, found a map" },
        { "depth: 1 m\nwaits: []\n", 2, 8, 1,
          "waits: a list of maps is expected, found an empty list" },
        { "depth: 1 m\nmoves: [{hodl: {for: 1 s}}]\n", 2, 10, 4,
          "moves[0]: unknown 'hodl'; did you mean 'hold'?" },
        { "depth: 1 m\nmoves: [{hold: {for: 1 s}, turn: {}}]\n", 2, 9, 1,
          "moves[0]: a map with one key, such as 'hold: {...}', is expected, found a map" },
        { "depth: 1 m\nmoves: [hold]\n", 2, 9, 4,
          "moves[0]: a map with one key, such as 'hold: {...}', is expected, found 'hold'" },
        { "depth: 1 m\nspeeds: [1 m/s, 2 m/s, 3 m/s, 4 m/s]\n", 2, 9, 1,
          "speeds: a list of 1 to 3 values is expected, found a list" },
        { "depth: 1 m\nspeeds: [1 m/s, 200 m/s]\n", 2, 17, 7,
          "speeds: 200 m/s is out of range; allowed: 0 to 100 m/s" },
        { "depth: 1 m\nwords: [a, [b]]\n", 2, 12, 1,
          "words: a word or a list of words is expected, found a list" },
        { "just text\n", 1, 1, 9, "a map of keys is expected, found 'just text'" },
        { "[1, 2]\n", 1, 1, 1, "a map of keys is expected, found a list" },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        reading r;
        read_thing(&r, table[i].text);
        if (r.rc != SCHULER_ERR_INPUT) fail_msg("taken: %s", table[i].text);
        assert_string_equal(r.d.items[0].message, table[i].message);
        assert_int_equal(r.d.items[0].place.line, table[i].line);
        assert_int_equal(r.d.items[0].place.column, table[i].column);
        assert_int_equal(r.d.items[0].place.width, table[i].width);
        assert_int_equal(r.d.errors, 1);
        end_reading(&r);
    }
}

static void all_mistakes_are_found_at_once(void **state)
{
    (void)state;
    reading r;
    read_thing(&r, "dpeth: 1 m\nratio: x\ncount: 0\nbias: 5\ninner: {}\nmode: f\n");
    assert_int_equal(r.rc, SCHULER_ERR_INPUT);
    assert_int_equal(r.d.errors, 6);
    for (int i = 0; i < 6; i++) assert_int_equal(r.d.items[i].place.line, i + 1);
    end_reading(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_field_is_read),
        cmocka_unit_test(absent_keys_have_their_defaults),
        cmocka_unit_test(each_mistake_has_its_message_and_place),
        cmocka_unit_test(all_mistakes_are_found_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/schema.h"
#include <string.h>

static const schuler_field bias = { .key = "bias",
                                    .kind = SCHULER_FIELD_VALUE,
                                    .components = 3,
                                    .dim = SCHULER_DIM_ACCEL,
                                    .min = -10.0,
                                    .max = 10.0,
                                    .example = "50 ug" };
static const schuler_field tilt = { .key = "tilt",
                                    .kind = SCHULER_FIELD_VALUE,
                                    .components = 2,
                                    .dim = SCHULER_DIM_ANGLE,
                                    .max = 1.0,
                                    .example = "1 mrad" };

typedef struct {
    schuler_document *doc;
    schuler_arena *arena;
    schuler_diagnostics d;
    schuler_status rc;
    schuler_value value;
} reading;

static void read_value(reading *r, const char *what, const schuler_field *field, const char *text)
{
    memset(r, 0, sizeof *r);
    if (schuler_document_parse(&r->doc, "t.yaml", text, strlen(text), &r->d) != SCHULER_OK)
        fail_msg("%s", r->d.items[0].message);
    r->arena = schuler_arena_create();
    r->rc = schuler_schema_read_value(schuler_document_root(r->doc), what, field, &r->value,
                                      r->arena, &r->d);
}

static void end_reading(reading *r)
{
    schuler_document_free(r->doc);
    schuler_arena_free(r->arena);
    schuler_diagnostics_free(&r->d);
}

static void values_are_fixed_or_drawn(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        schuler_draw draw;
        double a[3], b[3]; /* in mg */
        const char *spelled;
    } table[] = {
        { "1 mg", SCHULER_DRAW_FIXED, { 1, 1, 1 }, { 0, 0, 0 }, "1 mg" },
        { "[1 mg, -2 mg, 0 ug]",
          SCHULER_DRAW_FIXED,
          { 1, -2, 0 },
          { 0, 0, 0 },
          "[1 mg, -2 mg, 0 ug]" },
        { "{value: 1 mg}", SCHULER_DRAW_FIXED, { 1, 1, 1 }, { 0, 0, 0 }, "1 mg" },
        { "{normal: 1 mg}", SCHULER_DRAW_NORMAL, { 1, 1, 1 }, { 0, 0, 0 }, "1 mg 1\u03c3" },
        { "{normal: [1 mg, 2 mg, 3 mg]}",
          SCHULER_DRAW_NORMAL,
          { 1, 2, 3 },
          { 0, 0, 0 },
          "[1 mg, 2 mg, 3 mg] 1\u03c3" },
        { "{uniform: 1 mg}", SCHULER_DRAW_UNIFORM, { -1, -1, -1 }, { 1, 1, 1 }, "\u00b11 mg" },
        { "{uniform: [-1 mg, 2 mg]}",
          SCHULER_DRAW_UNIFORM,
          { -1, -1, -1 },
          { 2, 2, 2 },
          "-1 mg .. 2 mg" },
        { "{uniform: [1 mg, 2 mg, 3 mg]}",
          SCHULER_DRAW_UNIFORM,
          { -1, -2, -3 },
          { 1, 2, 3 },
          "\u00b1[1 mg, 2 mg, 3 mg]" },
        { "{uniform: [[0 mg, 1 mg], [1 mg, 2 mg], [2 mg, 2 mg]]}",
          SCHULER_DRAW_UNIFORM,
          { 0, 1, 2 },
          { 1, 2, 2 },
          "[[0 mg, 1 mg], [1 mg, 2 mg], [2 mg, 2 mg]]" },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        reading r;
        read_value(&r, "bias", &bias, table[i].text);
        if (r.rc != SCHULER_OK) fail_msg("%s: %s", table[i].text, r.d.items[0].message);
        const schuler_value *v = &r.value;
        assert_true(v->given);
        assert_int_equal(v->draw, table[i].draw);
        assert_string_equal(v->text, table[i].spelled);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(v->a[k], table[i].a[k] * 9.80665e-3, 1e-16);
            CHECK_NEAR(v->b[k], table[i].b[k] * 9.80665e-3, 1e-16);
        }
        assert_false(schuler_value_is_zero(v, 3));
        end_reading(&r);
    }
    reading r;
    read_value(&r, "bias", &bias, "{normal: 0 ug, source: s1, note: why, assumed: true}");
    assert_int_equal(r.rc, SCHULER_OK);
    assert_true(schuler_value_is_zero(&r.value, 3));
    assert_string_equal(r.value.source, "s1");
    assert_string_equal(r.value.note, "why");
    assert_true(r.value.assumed);
    assert_int_equal(r.value.place.line, 1);
    end_reading(&r);
}

/* Two components and two scalars under `uniform` are limits, the same for both. */
static void two_scalars_are_limits(void **state)
{
    (void)state;
    reading r;
    read_value(&r, "tilt", &tilt, "{uniform: [1 mrad, 2 mrad]}");
    assert_int_equal(r.rc, SCHULER_OK);
    CHECK_NEAR(r.value.a[1], 1e-3, 0.0);
    CHECK_NEAR(r.value.b[0], 2e-3, 0.0);
    end_reading(&r);
}

static void mistaken_values_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        const schuler_field *field;
        int column, width;
        const char *message;
    } table[] = {
        { "[1 mg, 2 mg]", &bias, 1, 1,
          "bias: one value or a list of 3 is expected, found a list of 2" },
        { "[]", &bias, 1, 1, "bias: one value or a list of 3 is expected, found a list of 0" },
        { "[1 mg, 2, 3 mg]", &bias, 8, 1, "bias[1]: unit missing; write for example '2 ug'" },
        { "{normal: -1 mg}", &bias, 10, 5,
          "bias: -1 mg is out of range; allowed: 0 to 1019.72 mg" },
        { "{normal: 1.1 g}", &bias, 10, 5, "bias: 1.1 g is out of range; allowed: 0 to 1.01972 g" },
        { "{uniform: [2 mg, 1 mg]}", &bias, 11, 1,
          "bias: the lower limit '2 mg' is above the upper one '1 mg'" },
        { "{normla: 1 mg}", &bias, 2, 6, "unknown key 'normla' in 'bias'; did you mean 'normal'?" },
        { "{normal: 1 mg, uniform: 1 mg}", &bias, 16, 7,
          "bias: both 'normal' and 'uniform'; give one of them" },
        { "{note: x}", &bias, 1, 1,
          "bias: a value is expected: V, [V, V, V], {normal: V}, {uniform: V} or {uniform: [V, "
          "V]}" },
        { "{normal: {normal: 1 mg}}", &bias, 10, 1, "bias: a value is expected, found a map" },
        { "{value: 1 mg, assumed: yes}", &bias, 24, 3,
          "bias.assumed: true or false is expected, found 'yes'" },
        { "{normal: 1 mrad}", &tilt, 2, 6,
          "tilt: cannot be negative, so it cannot be drawn about zero; write one value or "
          "{uniform: [LOW, HIGH]}" },
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        reading r;
        read_value(&r, table[i].field->key, table[i].field, table[i].text);
        if (r.rc != SCHULER_ERR_INPUT) fail_msg("taken: %s", table[i].text);
        assert_string_equal(r.d.items[0].message, table[i].message);
        assert_int_equal(r.d.items[0].place.line, 1);
        assert_int_equal(r.d.items[0].place.column, table[i].column);
        assert_int_equal(r.d.items[0].place.width, table[i].width);
        assert_int_equal(r.d.errors, 1);
        assert_false(r.value.given);
        end_reading(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_fixed_or_drawn),
        cmocka_unit_test(two_scalars_are_limits),
        cmocka_unit_test(mistaken_values_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

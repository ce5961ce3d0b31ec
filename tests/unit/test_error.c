/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/error.h"
#include "core/schema.h"
#include <stdalign.h>
#include <stdio.h>
#include <string.h>

static void fail_fills_the_error_and_returns_the_status(void **state)
{
    (void)state;
    schuler_error err;
    memset(&err, 'x', sizeof err);
    const schuler_place place = { "a.yaml", 3, 7, 2 };
    assert_int_equal(schuler_fail(&err, SCHULER_ERR_FILE, &place, "no %s", "luck"),
                     SCHULER_ERR_FILE);
    assert_int_equal(err.status, SCHULER_ERR_FILE);
    assert_string_equal(err.message, "no luck");
    assert_string_equal(err.excerpt, "");
    assert_int_equal(err.place.line, 3);
    assert_int_equal(err.is_warning, 0);
    assert_int_equal(schuler_fail(NULL, SCHULER_ERR_MEMORY, NULL, "x"), SCHULER_ERR_MEMORY);
}

static void a_long_message_is_cut_between_characters(void **state)
{
    (void)state;
    char text[2 * SCHULER_MESSAGE_MAX + 1] = "";
    for (int i = 0; i < SCHULER_MESSAGE_MAX; i++) strcat(text, "\u00b5");
    schuler_error err;
    for (int shift = 0; shift < 2; shift++) {
        assert_int_equal(schuler_fail(&err, SCHULER_ERR_INPUT, NULL, "%s", text + 2 * shift), 10);
        const size_t n = strlen(err.message);
        assert_int_equal(n, SCHULER_MESSAGE_MAX - 1);
        assert_string_equal(err.message + n - 3, "...");
        assert_null(strstr(err.message, "\xc2."));
    }
}

static void messages_are_safe_to_print(void **state)
{
    (void)state;
    schuler_error err;
    schuler_fail(&err, SCHULER_ERR_INPUT, NULL, "a\x1b[31mb\nc\xff\xc2\x9b.\u00b0");
    assert_string_equal(err.message, "a?[31mb c???.\u00b0");
}

static void diagnostics_keep_a_hundred_and_count_all(void **state)
{
    (void)state;
    schuler_diagnostics d = { 0 };
    char name[] = "gone.yaml";
    const schuler_place place = { name, 1, 1, 1 };
    for (int i = 0; i < 250; i++) schuler_diagnose(&d, SCHULER_ERR_INPUT, &place, "mistake %d", i);
    schuler_warn(&d, NULL, "strange");
    assert_int_equal(d.kept, SCHULER_DIAGNOSTICS_MAX);
    assert_int_equal(d.errors, 250);
    assert_int_equal(d.warnings, 1);
    for (int i = 0; i < 100; i++) {
        char expected[32];
        snprintf(expected, sizeof expected, "mistake %d", i);
        assert_string_equal(d.items[i].message, expected);
    }
    memset(name, 'x', 4); /* the caller's name may go away */
    assert_string_equal(d.items[99].place.file, "gone.yaml");
    schuler_diagnostics_free(&d);
    assert_int_equal(d.errors, 0);
    schuler_warn(&d, &place, "again");
    assert_int_equal(d.items[0].is_warning, 1);
    assert_int_equal(d.errors, 0);
    schuler_diagnostics_free(&d);
}

static void nearest_finds_slips_and_refuses_strangers(void **state)
{
    (void)state;
    static const char *const known[] = { "bias", "scale_factor", "misalignment", "rate" };
    assert_string_equal(schuler_nearest("bais", known, 4), "bias");
    assert_string_equal(schuler_nearest("scalefactor", known, 4), "scale_factor");
    assert_string_equal(schuler_nearest("missalingment", known, 4), "misalignment");
    assert_string_equal(schuler_nearest("rates", known, 4), "rate");
    assert_null(schuler_nearest("temperature", known, 4));
    assert_null(schuler_nearest("x", known, 4));
    assert_null(schuler_nearest("", known, 4));
    assert_null(schuler_nearest("bias", known, 0));
    char huge[500];
    memset(huge, 'b', sizeof huge);
    huge[499] = '\0';
    assert_null(schuler_nearest(huge, known, 4));
    /* One letter out of two may be wrong, both may not. */
    static const char *const units[] = { "kt", "m" };
    assert_string_equal(schuler_nearest("kn", units, 2), "kt");
    assert_null(schuler_nearest("xy", units, 2));
}

static void arena_memory_is_zeroed_aligned_and_apart(void **state)
{
    (void)state;
    schuler_arena *arena = schuler_arena_create();
    unsigned char *blocks[300];
    for (size_t i = 0; i < 300; i++) {
        const size_t size = i * 7 % 400 + (i == 100 ? 100000 : 0);
        blocks[i] = schuler_arena_alloc(arena, size);
        assert_int_equal((uintptr_t)blocks[i] % alignof(max_align_t), 0);
        for (size_t k = 0; k < size; k++) assert_int_equal(blocks[i][k], 0);
        memset(blocks[i], (int)i % 250 + 1, size);
    }
    for (size_t i = 0; i < 300; i++) {
        const size_t size = i * 7 % 400 + (i == 100 ? 100000 : 0);
        for (size_t k = 0; k < size; k++) assert_int_equal(blocks[i][k], i % 250 + 1);
    }
    assert_string_equal(schuler_arena_printf(arena, "%d-%s", 7, "x"), "7-x");
    assert_null(schuler_arena_alloc(arena, SIZE_MAX));
    schuler_arena_free(arena);
    schuler_arena_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fail_fills_the_error_and_returns_the_status),
        cmocka_unit_test(a_long_message_is_cut_between_characters),
        cmocka_unit_test(messages_are_safe_to_print),
        cmocka_unit_test(diagnostics_keep_a_hundred_and_count_all),
        cmocka_unit_test(nearest_finds_slips_and_refuses_strangers),
        cmocka_unit_test(arena_memory_is_zeroed_aligned_and_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

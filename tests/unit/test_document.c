/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/document.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static schuler_document *parse(const char *text)
{
    schuler_diagnostics d = { 0 };
    schuler_document *doc = NULL;
    const schuler_status rc = schuler_document_parse(&doc, "t.yaml", text, strlen(text), &d);
    if (rc != SCHULER_OK) fail_msg("%s", d.kept > 0 ? d.items[0].message : "?");
    assert_int_equal(d.errors, 0);
    schuler_diagnostics_free(&d);
    return doc;
}

static void scalars_stay_text_and_know_their_place(void **state)
{
    (void)state;
    schuler_document *doc =
        parse("# c\na: no\nb: {c: 012, d: '5 ug'}\nl:\n  - \"x y\"\n  - \u00b5: 1e3\n");
    const schuler_node *root = schuler_document_root(doc);
    assert_int_equal(root->kind, SCHULER_NODE_MAP);
    assert_int_equal(root->count, 3);
    assert_string_equal(schuler_node_find(root, "a")->text, "no");
    const schuler_node *b = schuler_node_find(root, "b"), *c = schuler_node_find(b, "c"),
                       *d = schuler_node_find(b, "d");
    assert_string_equal(c->text, "012");
    assert_int_equal(c->place.line, 3);
    assert_int_equal(c->place.column, 8);
    assert_int_equal(c->place.width, 3);
    assert_int_equal(c->text_column, 8);
    assert_int_equal(d->place.column, 16);
    assert_int_equal(d->place.width, 6);
    assert_int_equal(d->text_column, 17);
    assert_string_equal(d->key->text, "d");
    assert_int_equal(d->key->place.column, 13);
    assert_string_equal(d->place.file, "t.yaml");
    const schuler_node *l = schuler_node_find(root, "l");
    assert_int_equal(l->kind, SCHULER_NODE_LIST);
    assert_int_equal(l->count, 2);
    assert_string_equal(l->items[0]->text, "x y");
    assert_null(l->items[0]->key);
    /* Columns count characters, not bytes. */
    assert_int_equal(schuler_node_find(l->items[1], "\u00b5")->place.column, 8);
    assert_null(schuler_node_find(root, "z"));
    assert_null(schuler_node_find(c, "z"));
    assert_null(schuler_node_find(NULL, "z"));
    schuler_document_free(doc);
    schuler_document_free(NULL);
}

static void text_that_is_spelled_otherwise_has_no_column(void **state)
{
    (void)state;
    schuler_document *doc = parse("a: \"5\\x20m\"\nb: >\n  5\n  m\nc: 5\n   m\n");
    const schuler_node *root = schuler_document_root(doc);
    assert_string_equal(schuler_node_find(root, "a")->text, "5 m");
    assert_int_equal(schuler_node_find(root, "a")->text_column, 0);
    assert_string_equal(schuler_node_find(root, "b")->text, "5 m\n");
    assert_int_equal(schuler_node_find(root, "b")->text_column, 0);
    assert_string_equal(schuler_node_find(root, "c")->text, "5 m");
    assert_int_equal(schuler_node_find(root, "c")->text_column, 0);
    schuler_document_free(doc);
}

/* Parse what must be refused; compares the first message (its beginning) and place. */
static void refused_n(const char *text, size_t length, int line, int column, const char *message)
{
    schuler_diagnostics d = { 0 };
    schuler_document *doc = (schuler_document *)&d;
    assert_int_equal(schuler_document_parse(&doc, "t.yaml", text, length, &d), SCHULER_ERR_INPUT);
    assert_null(doc);
    assert_true(d.kept >= 1);
    if (strncmp(d.items[0].message, message, strlen(message)) != 0)
        assert_string_equal(d.items[0].message, message);
    assert_int_equal(d.items[0].place.line, line);
    assert_int_equal(d.items[0].place.column, column);
    schuler_diagnostics_free(&d);
}

static void refused(const char *text, int line, int column, const char *message)
{
    refused_n(text, strlen(text), line, column, message);
}

static void mistakes_of_the_text_have_a_place(void **state)
{
    (void)state;
    refused("a: 1\nb: 2\na: 3\n", 3, 1, "duplicate key 'a' (first given on line 1)");
    refused("a: {b: 1, c: 2, b: 3}\n", 1, 17, "duplicate key 'b' (first given on line 1)");
    refused("a: [1, 2\n", 2, 1,
            "not valid YAML: did not find expected ',' or ']', while parsing a "
            "flow sequence (from line 1)");
    refused("a: 1\n b: 2\n", 2, 3,
            "not valid YAML: mapping values are not allowed in this context");
    refused("a:\n\tb: 2\n", 2, 1,
            "not valid YAML: found character that cannot start any token, while scanning for the "
            "next token; indent with spaces, not tabs");
    refused("a: &x 1\n", 1, 4, "anchors (&) and aliases (*)");
    refused("a: *x\n", 1, 4, "anchors (&) and aliases (*)");
    refused("a: &x [1]\n", 1, 4, "anchors (&) and aliases (*)");
    refused("a: !!int 1\n", 1, 4, "tags (!)");
    refused("? [a, b]\n: 1\n", 1, 3, "a key must be a single word, not a list or a map");
    refused("? {a: b}\n: 1\n", 1, 3, "a key must be a single word, not a list or a map");
    refused("a: 1\n---\nb: 2\n", 2, 1, "a second document (---); only one is read");
    refused("", 1, 1, "the file is empty");
    refused("# only a comment\n", 1, 1, "the file is empty");
    refused("a: \"x\\0y\"\n", 1, 4, "a NUL character in a text");
    refused_n("a: b\nc: \0d\n", 11, 2, 4, "control character U+0000; is this a text file?");
    refused("a: b\r\nc: \xff\n", 2, 4, "byte 0xff is not valid UTF-8; is this a text file?");
    refused("a: \xc2", 1, 4, "byte 0xc2 is not valid UTF-8");
    refused("a: \xed\xa0\x80", 1, 4, "byte 0xed is not valid UTF-8");
    refused("a: \xc0\x80", 1, 4, "byte 0xc0 is not valid UTF-8");
    refused("\x7f"
            "ELF\x02\x01",
            1, 1, "control character U+007F; is this a text file?");
    refused("\xff\xfe"
            "a\0",
            1, 1, "byte 0xff is not valid UTF-8");
}

static void a_byte_order_mark_and_any_line_end_are_fine(void **state)
{
    (void)state;
    const char *const texts[] = { "\xef\xbb\xbf\x61: 1\nb: 2\n", "a: 1\r\nb: 2\r\n", "a: 1\rb: 2",
                                  "---\na: 1\nb: 2\n...\n" };
    const int lines[] = { 2, 2, 2, 3 };
    for (int i = 0; i < 4; i++) {
        schuler_document *doc = parse(texts[i]);
        const schuler_node *b = schuler_node_find(schuler_document_root(doc), "b");
        assert_string_equal(b->text, "2");
        assert_int_equal(b->place.line, lines[i]);
        assert_int_equal(b->place.column, 4);
        size_t length;
        assert_string_equal(schuler_document_text(doc, &length), texts[i]);
        assert_int_equal(length, strlen(texts[i]));
        schuler_document_free(doc);
    }
}

static void depth_keys_and_size_are_limited(void **state)
{
    (void)state;
    const size_t room = 3 << 20;
    char *text = malloc(room);
    assert_non_null(text);
    memset(text, '[', 65);
    text[65] = '\0';
    refused(text, 1, 65, "more than 64 lists and maps inside one another");
    memset(text, '[', 64);
    memset(text + 64, ']', 64);
    text[128] = '\0';
    schuler_document_free(parse(text));
    memset(text, '[', room - 1);
    text[room - 1] = '\0';
    refused(text, 1, 65, "more than 64 lists and maps inside one another");
    size_t used = 0;
    for (int i = 0; i < 1001; i++)
        used += (size_t)snprintf(text + used, room - used, "k%d: 1\n", i);
    refused(text, 1001, 1, "more than 1000 keys in one map");
    used = 0;
    text[used++] = '[';
    for (int i = 0; i < 200000; i++, used += 2) memcpy(text + used, "a,", 2);
    text[used] = '\0';
    refused(text, 1, 2 + 2 * 199999, "more than 200000 values in one file");
    free(text);
}

static void excerpts_show_the_line_and_keep_the_place_in_sight(void **state)
{
    (void)state;
    char text[900];
    snprintf(text, sizeof text, "a: 1\nb:\t\u00b5 x\nc: %0300d %0300d # \u00b5\n", 1, 2);
    schuler_document *doc = parse(text);
    schuler_diagnostics d = { 0 };
    schuler_place place = { "t.yaml", 2, 4, 1 };
    schuler_diagnose(&d, SCHULER_ERR_INPUT, &place, "x");
    place = (schuler_place){ "t.yaml", 3, 304, 1 }; /* the blank between the numbers */
    schuler_diagnose(&d, SCHULER_ERR_INPUT, &place, "x");
    place.line = 99;
    schuler_diagnose(&d, SCHULER_ERR_INPUT, &place, "x");
    place = (schuler_place){ "other.yaml", 1, 1, 1 };
    schuler_diagnose(&d, SCHULER_ERR_INPUT, &place, "x");
    schuler_document_excerpts(doc, &d);
    schuler_document_free(doc);
    assert_string_equal(d.items[0].excerpt, "b: \u00b5 x");
    assert_int_equal(d.items[0].excerpt_column, 4);
    const int at = d.items[1].excerpt_column;
    assert_true(at >= 1 && at < SCHULER_EXCERPT_MAX);
    assert_int_equal(strlen(d.items[1].excerpt), SCHULER_EXCERPT_MAX - 1);
    assert_int_equal(d.items[1].excerpt[at - 1], ' ');
    assert_int_equal(d.items[1].excerpt[at - 2], '1');
    assert_string_equal(d.items[2].excerpt, "");
    assert_string_equal(d.items[3].excerpt, "");
    schuler_diagnostics_free(&d);
}

static void a_refused_text_shows_its_line(void **state)
{
    (void)state;
    schuler_diagnostics d = { 0 };
    schuler_document *doc;
    assert_int_equal(schuler_document_parse(&doc, "t.yaml", "a: 1\nb: *x\n", 11, &d), 10);
    assert_string_equal(d.items[0].excerpt, "b: *x");
    schuler_diagnostics_free(&d);
}

static void files_that_are_none_are_refused(void **state)
{
    (void)state;
    char dir[] = "/tmp/schuler-document-XXXXXX", path[64];
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/f.yaml", dir);
    schuler_diagnostics d = { 0 };
    schuler_document *doc;
    assert_int_equal(schuler_document_load(&doc, dir, &d), SCHULER_ERR_FILE);
    assert_int_equal(schuler_document_load(&doc, path, &d), SCHULER_ERR_FILE);
    assert_string_equal(d.items[0].message, "cannot read the file: it is a directory");
    assert_string_equal(d.items[0].place.file, dir);
    assert_string_equal(d.items[1].message, "cannot read the file: no such file");
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(schuler_document_load(&doc, path, &d), SCHULER_ERR_INPUT);
    assert_string_equal(d.items[2].message, "the file is empty");
    assert_int_equal(truncate(path, 1L << 30), 0);
    assert_int_equal(schuler_document_load(&doc, path, &d), SCHULER_ERR_INPUT);
    assert_string_equal(d.items[3].message, "cannot read the file: it is larger than 16 MiB");
    assert_int_equal(schuler_document_load(&doc, "/dev/zero", &d), SCHULER_ERR_INPUT);
    assert_string_equal(d.items[4].message, "cannot read the file: it is larger than 16 MiB");
    if (geteuid() != 0) {
        assert_int_equal(chmod(path, 0), 0);
        assert_int_equal(schuler_document_load(&doc, path, &d), SCHULER_ERR_FILE);
        assert_string_equal(d.items[5].message, "cannot read the file: permission denied");
    }
    assert_null(doc);
    schuler_diagnostics_free(&d);
    unlink(path);
    rmdir(dir);
}

static void set_changes_adds_and_replaces(void **state)
{
    (void)state;
    schuler_document *doc = parse("a: {b: 1}\nl: [{x: 1}, {x: 2}]\n");
    schuler_diagnostics d = { 0 };
    const schuler_node *root = schuler_document_root(doc);
    assert_int_equal(schuler_document_set(doc, "a.b", "5 ug", &d), SCHULER_OK);
    assert_int_equal(schuler_document_set(doc, "a.c.d", "{normal: [1, 2]}", &d), SCHULER_OK);
    assert_int_equal(schuler_document_set(doc, "l.1.x", "'q r'", &d), SCHULER_OK);
    assert_int_equal(schuler_document_set(doc, "l[0].y", "[]", &d), SCHULER_OK);
    const schuler_node *a = schuler_node_find(root, "a"), *b = schuler_node_find(a, "b");
    assert_string_equal(b->text, "5 ug");
    assert_string_equal(b->place.file, "--set a.b=5 ug");
    assert_int_equal(b->place.line, 0);
    assert_string_equal(b->key->text, "b");
    const schuler_node *cd = schuler_node_find(schuler_node_find(a, "c"), "d");
    assert_string_equal(schuler_node_find(cd, "normal")->items[1]->text, "2");
    assert_string_equal(cd->key->text, "d");
    const schuler_node *l = schuler_node_find(root, "l");
    assert_string_equal(schuler_node_find(l->items[1], "x")->text, "q r");
    assert_int_equal(schuler_node_find(l->items[0], "y")->kind, SCHULER_NODE_LIST);
    assert_int_equal(d.errors, 0);

    static const struct {
        const char *path, *value, *message;
    } bad[] = {
        { "", "1", "a key such as imu.gyro.bias is expected, not ''" },
        { "...", "1", "a key such as imu.gyro.bias is expected, not '...'" },
        { "a.b.c", "1", "a single value is there, so there can be no key 'c'" },
        { "l.9.x", "1", "the list is too short for the number '9'" },
        { "l.x", "1", "a list is there, so a number (from 0) is expected, not 'x'" },
        { "a.b", "", "no value is given for 'a.b'" },
        { "a.b", "{x: 1", NULL },
        { "a.b", "{x: 1, x: 2}", "duplicate key 'x'" },
        { "a.b", "\xff", "byte 0xff is not valid UTF-8; is this a text file?" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(schuler_document_set(doc, bad[i].path, bad[i].value, &d), 10);
        assert_int_equal(d.errors, i + 1);
        if (bad[i].message) assert_string_equal(d.items[i].message, bad[i].message);
    }
    assert_string_equal(schuler_node_find(a, "b")->text, "5 ug"); /* untouched by the failures */
    schuler_diagnostics_free(&d);
    schuler_document_free(doc);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scalars_stay_text_and_know_their_place),
        cmocka_unit_test(text_that_is_spelled_otherwise_has_no_column),
        cmocka_unit_test(mistakes_of_the_text_have_a_place),
        cmocka_unit_test(a_byte_order_mark_and_any_line_end_are_fine),
        cmocka_unit_test(depth_keys_and_size_are_limited),
        cmocka_unit_test(excerpts_show_the_line_and_keep_the_place_in_sight),
        cmocka_unit_test(a_refused_text_shows_its_line),
        cmocka_unit_test(files_that_are_none_are_refused),
        cmocka_unit_test(set_changes_adds_and_replaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

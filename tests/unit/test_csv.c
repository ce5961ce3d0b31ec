/* SPDX-License-Identifier: MIT */
/* Tables of numbers: what is written is read, across the blocks of the reader too, and what is wrong
 * has its line and column. */
#include "check.h"
#include "scenarios/csv.h"
#include "scenarios/digits.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define HEADER "a,b,c"

static char path[] = "/tmp/test_csv.XXXXXX";

static void put(const char *bytes, size_t length)
{
    FILE *const file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

/* The first thing that is wrong; SCHULER_OK at the end. rows counts those before it. */
static schuler_status read_all(int *rows, schuler_error *err)
{
    schuler_csv *csv = NULL;
    double x[SCHULER_CSV_COLUMNS_MAX];
    int got = 1;
    *rows = 0;
    schuler_status status = schuler_csv_open(&csv, path, HEADER, err);
    while (status == SCHULER_OK && got) {
        status = schuler_csv_next(csv, x, &got, err);
        *rows += status == SCHULER_OK && got;
    }
    schuler_csv_close(csv);
    return status;
}

/* 60000 rows of every length up to 57 characters are 2 MB: eight blocks, each ending within a row. */
static void rows_go_across_blocks(void **state)
{
    enum { ROWS = 60000 };
    (void)state;
    FILE *const file = fopen(path, "w");
    assert_non_null(file);
    fputs(HEADER "\n", file);
    for (int i = 0; i < ROWS; i++) {
        char text[3][SCHULER_DIGITS_MAX];
        for (int c = 0; c < 3; c++)
            text[c][schuler_digits(text[c], i % 3 ? (i + c) / 7.0 : i + c)] = '\0';
        fprintf(file, "%s,%s,%s%s\n", text[0], text[1], text[2], i % 5 ? "" : "\r");
    }
    fclose(file);
    schuler_csv *csv = NULL;
    double x[SCHULER_CSV_COLUMNS_MAX];
    int got;
    assert_int_equal(schuler_csv_open(&csv, path, HEADER, NULL), SCHULER_OK);
    for (int i = 0; i < ROWS; i++) {
        assert_int_equal(schuler_csv_next(csv, x, &got, NULL), SCHULER_OK);
        assert_int_equal(got, 1);
        for (int c = 0; c < 3; c++) CHECK_NEAR(x[c], i % 3 ? (i + c) / 7.0 : i + c, 0.0);
    }
    CHECK_NEAR(schuler_csv_fraction(csv), 1.0, 1e-12);
    schuler_error error = { 0 };
    schuler_csv_refuse(csv, 2, &error, "the third");
    assert_int_equal(error.place.line, ROWS + 1);
    assert_int_equal(schuler_csv_next(csv, x, &got, NULL), SCHULER_OK);
    assert_int_equal(got, 0);
    schuler_csv_close(csv);
}

static void a_column_is_refused_where_it_stands(void **state)
{
    static const char text[] = HEADER "\n 1 ,\t22.5e0 , 333\r\n";
    schuler_csv *csv = NULL;
    double x[SCHULER_CSV_COLUMNS_MAX];
    int got;
    (void)state;
    put(text, sizeof text - 1);
    assert_int_equal(schuler_csv_open(&csv, path, HEADER, NULL), SCHULER_OK);
    assert_int_equal(schuler_csv_next(csv, x, &got, NULL), SCHULER_OK);
    CHECK_NEAR(x[1], 22.5, 0.0);
    CHECK_NEAR(x[2], 333.0, 0.0);
    static const int column[] = { 2, 6, 15 }, width[] = { 1, 6, 3 };
    for (int c = 0; c < 3; c++) {
        schuler_error error = { 0 };
        schuler_csv_refuse(csv, c, &error, "no");
        assert_int_equal(error.place.line, 2);
        assert_int_equal(error.place.column, column[c]);
        assert_int_equal(error.place.width, width[c]);
        assert_string_equal(error.excerpt, " 1 ,\t22.5e0 , 333");
    }
    schuler_csv_close(csv);
}

static void hostile_bytes_have_a_place(void **state)
{
    static const struct {
        const char *rows;
        size_t length;
        int good, line, column;
        const char *message;
    } wrong[] = {
#define BYTES(text) text, sizeof(text) - 1
        { BYTES("1,2,3\n1,2\0,3\n"), 1, 3, 1, "NUL" },
        { BYTES("1,2,3\n1,2,3\0\n"), 1, 3, 1, "NUL" },
        { BYTES("1,2,3\0\r\n"), 0, 2, 1, "NUL" },
        { BYTES("1,2,3\n\0"), 1, 3, 1, "NUL" },
        { BYTES("1,2,3\n\n"), 1, 3, 1, "fewer" },
        { BYTES("1,2,3,4"), 0, 2, 6, "more" },
        { BYTES("1,2,3\r\r\n"), 0, 2, 5, "not a number" },
        { BYTES("1,,3"), 0, 2, 3, "not a number" },
        { BYTES("1,2,3 4"), 0, 2, 5, "not a number" },
        { BYTES("1,nan,3"), 0, 2, 3, "not a number" },
        { BYTES("1,-1e999,3"), 0, 2, 3, "not a finite number" },
        { BYTES("1,2,\xff"), 0, 2, 5, "not a number" },
#undef BYTES
    };
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char text[128];
        const size_t start = strlen(HEADER "\n");
        memcpy(text, HEADER "\n", start);
        memcpy(text + start, wrong[i].rows, wrong[i].length);
        put(text, start + wrong[i].length);
        schuler_error error = { 0 };
        int rows;
        assert_int_equal(read_all(&rows, &error), SCHULER_ERR_INPUT);
        assert_int_equal(rows, wrong[i].good);
        assert_int_equal(error.place.line, wrong[i].line);
        assert_int_equal(error.place.column, wrong[i].column);
        assert_non_null(strstr(error.message, wrong[i].message));
    }
}

/* Zeros in front count: 1024 characters are a line, 1025 are not, with or without an end, nor are a million. */
static void a_line_has_a_longest_length(void **state)
{
    static const struct {
        size_t length;
        const char *end;
        schuler_status status;
    } lines[] = {
        { SCHULER_CSV_LINE_MAX, "\n", SCHULER_OK },
        { SCHULER_CSV_LINE_MAX, "", SCHULER_OK },
        { SCHULER_CSV_LINE_MAX + 1, "\n", SCHULER_ERR_INPUT },
        { SCHULER_CSV_LINE_MAX + 1, "", SCHULER_ERR_INPUT },
        { 1000000, "\n", SCHULER_ERR_INPUT },
        { 1000000, "", SCHULER_ERR_INPUT },
    };
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        FILE *const file = fopen(path, "w");
        int rows;
        schuler_error error = { 0 };
        assert_non_null(file);
        fprintf(file, HEADER "\n1,2,%0*d%s", (int)lines[i].length - 4, 3, lines[i].end);
        fclose(file);
        assert_int_equal(read_all(&rows, &error), lines[i].status);
        assert_int_equal(rows, lines[i].status == SCHULER_OK);
        if (lines[i].status != SCHULER_OK) assert_int_equal(error.place.line, 2);
    }
}

static int make_file(void **state)
{
    (void)state;
    const int fd = mkstemp(path);
    return fd < 0 ? -1 : close(fd);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_go_across_blocks),
        cmocka_unit_test(a_column_is_refused_where_it_stands),
        cmocka_unit_test(hostile_bytes_have_a_place),
        cmocka_unit_test(a_line_has_a_longest_length),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}

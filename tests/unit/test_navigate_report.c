/* SPDX-License-Identifier: MIT */
/* What navigate tells beside the trajectory: growth of the errors, faults of the reference. */
#include "recorded_at_rest.h"
#include <string.h>

/* b t^2/2 at 1, 2, 5, 10, 20 s and, as the last row, at 24 s; reference rows every 0.5 s. */
static void growth_is_told_at_round_times(void **state)
{
    static const double times_s[] = { 1.0, 2.0, 5.0, 10.0, 20.0, 24.0 };
    const recording r = { .steps = 1200, .every = 25, .accel = { 0.0, 1e-3, 0.0 } };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_TRUTH, &result, NULL), SCHULER_OK);
    assert_int_equal(result.growth_times, 6);
    for (int i = 0; i < 6; i++) {
        const double t_s = times_s[i];
        CHECK_NEAR(result.growth[i].time_s, t_s, 1e-9);
        CHECK_REL(result.growth[i].errors.horizontal_m, 0.5e-3 * t_s * t_s, 2e-4);
        CHECK_REL(result.growth[i].errors.velocity_mps, 1e-3 * t_s, 2e-4);
    }
    CHECK_NEAR(result.growth[5].errors.horizontal_m, result.horizontal_m.final, 0.0);
}

/* Rows every 7 s: 7 (for 1 to 5), 14 (for 10), 21 (for 20), 28 s as the last one. */
static void growth_of_a_sparse_reference_has_its_times(void **state)
{
    const recording r = { .steps = 1400, .every = 350 };
    schuler_navigate_result result;
    record(*state, &r);
    assert_int_equal(navigate(*state, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    assert_int_equal(result.growth_times, 4);
    for (int i = 0; i < 4; i++) CHECK_NEAR(result.growth[i].time_s, 7.0 * (i + 1), 1e-9);
}

/* A row that says 1 m/s at rest: half of it is the mean of either interval beside it, where a quarter
 * and 0.05 m/s are allowed. */
static void a_reference_that_contradicts_itself_is_told(void **state)
{
    const files *f = *state;
    const recording r = { .steps = 100, .every = 10 };
    schuler_navigate_result result;
    record(f, &r);
    FILE *const file = fopen(f->reference, "r+");
    char text[16384];
    const size_t length = fread(text, 1, sizeof(text) - 1, file);
    text[length] = '\0';
    char *row = text;
    for (int line = 1; line < 5; line++) row = strchr(row, '\n') + 1;
    for (int column = 0; column < 4; column++) row = strchr(row, ',') + 1;
    assert_int_equal(*row, '0');
    *row = '1';
    rewind(file);
    fwrite(text, 1, length, file);
    fclose(file);
    assert_int_equal(navigate(f, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    const schuler_fault *const fault = &result.faults.of[SCHULER_FAULT_REFERENCE_VELOCITY];
    assert_int_equal(fault->count, 2);
    assert_int_equal(fault->first_line, 5);
    CHECK_NEAR(fault->worst, 0.5, 1e-6);
}

/* Increments end after 60 of 100 steps: rows of steps 70, 80, 90, 100 are left, from line 9 on. */
static void reference_rows_after_the_increments_are_counted(void **state)
{
    const files *f = *state;
    const recording r = { .steps = 100, .every = 10 };
    schuler_navigate_result result;
    record(f, &r);
    FILE *const file = fopen(f->imu, "r+");
    char line[512];
    for (int i = 0; i < 61; i++) assert_non_null(fgets(line, sizeof(line), file));
    assert_int_equal(ftruncate(fileno(file), ftell(file)), 0);
    fclose(file);
    assert_int_equal(navigate(f, "wgs84", SCHULER_VERTICAL_FREE, &result, NULL), SCHULER_OK);
    assert_int_equal(result.reference_goes_on, 1);
    assert_int_equal(result.rows, 7);
    assert_int_equal(result.rows_read, 60);
    assert_int_equal(result.faults.of[SCHULER_FAULT_REFERENCE_NOT_COVERED].count, 4);
    assert_int_equal(result.faults.of[SCHULER_FAULT_REFERENCE_NOT_COVERED].first_line, 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(growth_is_told_at_round_times),
        cmocka_unit_test(growth_of_a_sparse_reference_has_its_times),
        cmocka_unit_test(a_reference_that_contradicts_itself_is_told),
        cmocka_unit_test(reference_rows_after_the_increments_are_counted),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

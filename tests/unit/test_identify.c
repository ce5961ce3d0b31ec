/* SPDX-License-Identifier: MIT */
/* From a recording to its coefficients: four hours at 50 Hz, simulated. */
#include "check.h"
#include "core/earth.h"
#include "scenarios/identify.h"
#include "simulated_noise.h"
#include <stdlib.h>
#include <string.h>

enum { N = 720000 };
static const double DT_S = 0.02;
/* Of a good MEMS gyro: 0.15 deg/sqrt(h), 1.5 deg/h, 20 deg/h/sqrt(h). */
static const noise_coefficients gyro = { .N = 0.15 / 60 * SCHULER_RAD_PER_DEG,
                                         .B = 1.5 / 3600 * SCHULER_RAD_PER_DEG,
                                         .K = 20.0 / 3600 / 60 * SCHULER_RAD_PER_DEG,
                                         .dt_s = 0.02 };

/* Three gyros as increments and the third again as rates. */
static schuler_recording *recording(void)
{
    schuler_recording *const r = calloc(1, sizeof(*r));
    assert_non_null(r);
    r->n = N;
    r->dt_s = DT_S;
    r->columns = 4;
    for (int i = 0; i < 4; i++) {
        schuler_recording_column *const c = &r->column[i];
        c->instrument = SCHULER_GYRO;
        c->increments = i < 3;
        c->values = malloc((N + 1) * sizeof(double));
        assert_non_null(c->values);
        if (i < 3) noise_simulate(&gyro, (uint64_t)(100 + i), N, c->values);
        for (int k = 0; k < N; k++)
            if (i < 3)
                c->values[k] += 1e-2 * DT_S;
            else
                c->values[k] = 1.0; /* below */
    }
    for (int k = 0; k < N; k++) r->column[3].values[k] = r->column[2].values[k] / DT_S;
    return r;
}

static schuler_identified *identify(schuler_identify_options o)
{
    schuler_recording *const r = recording();
    schuler_identified *found;
    assert_int_equal(schuler_identify(&found, r, &o, NULL), SCHULER_OK);
    schuler_recording_free(r);
    return found;
}

static const schuler_identify_options usual = { .terms = 0x1f, .level = 0.95, .threads = 1 };

static void coefficients_lie_within_their_limits(void **state)
{
    static const int terms[3] = { SCHULER_ALLAN_WHITE, SCHULER_ALLAN_FLICKER,
                                  SCHULER_ALLAN_RANDOM_WALK };
    const double truth[3] = { gyro.N, gyro.B, gyro.K };
    schuler_identified *const found = identify(usual);
    int outside = 0;
    (void)state;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const schuler_allan_coefficient *const c = &found->column[i].fit.term[terms[k]];
            assert_int_equal(c->state, SCHULER_ALLAN_FITTED);
            outside += !(c->lower <= truth[k] && truth[k] <= c->upper);
            assert_true(c->upper <
                        4.0 * c->lower); /* a factor of two to either side: it is useful */
        }
    /* Of nine limits of 95 % more than two fail once in a hundred times; the seeds are fixed. */
    assert_true(outside <= 2);
    for (int i = 0; i < 3; i++) {
        /* The mean of a bias that walks for 4 h has sigma K sqrt(T/3) = 1.1e-4 rad/s; what the
         * flicker noise adds is below 3 B = 2e-5. Five sigma. */
        CHECK_NEAR(found->column[i].mean, 1e-2, 5.7e-4);
        assert_null(found->column[i].density);
        for (int p = 0; p < found->points; p++) {
            assert_true(found->column[i].limits[p][0] < found->column[i].sigma2[p]);
            assert_true(found->column[i].limits[p][1] > found->column[i].sigma2[p]);
        }
    }
    schuler_identified_free(found);
}

static void rates_and_increments_are_the_same_data(void **state)
{
    schuler_identify_options o = usual;
    o.segment = 1024;
    schuler_identified *const found = identify(o);
    const schuler_identified_column *const a = &found->column[2], *const b = &found->column[3];
    (void)state;
    for (int p = 0; p < found->points; p++) CHECK_REL(a->sigma2[p], b->sigma2[p], 1e-9);
    for (int k = 0; k <= 512; k++) CHECK_REL(a->density[k], b->density[k], 1e-4);
    schuler_identified_free(found);
}

static void threads_do_not_change_a_bit(void **state)
{
    schuler_identify_options o = usual;
    o.segment = -1;
    schuler_identified *const one = identify(o);
    o.threads = 3;
    schuler_identified *const three = identify(o);
    (void)state;
    for (int i = 0; i < one->columns; i++) {
        assert_memory_equal(one->column[i].density, three->column[i].density,
                            ((size_t)one->segment / 2 + 1) * sizeof(double));
        one->column[i].density[0] = three->column[i].density[0];
        assert_memory_equal(one->column[i].sigma2, three->column[i].sigma2,
                            sizeof one->column[i].sigma2);
        assert_memory_equal(&one->column[i].fit, &three->column[i].fit, sizeof one->column[i].fit);
    }
    schuler_identified_free(one);
    schuler_identified_free(three);
}

static void wrong_wishes_are_refused(void **state)
{
    static const int segments[] = { 7, 9, 6, N + 2 };
    const volatile int stop = 1;
    schuler_identified *found;
    schuler_error error = { 0 };
    (void)state;
    schuler_recording *const r = recording();
    for (int i = 0; i < 4; i++) {
        schuler_identify_options o = usual;
        o.segment = segments[i];
        assert_int_equal(schuler_identify(&found, r, &o, &error), SCHULER_ERR_INPUT);
        assert_null(found);
        assert_non_null(strstr(error.message, "segment"));
    }
    schuler_identify_options o = usual;
    o.stop = &stop;
    assert_int_equal(schuler_identify(&found, r, &o, &error), SCHULER_ERR_INTERRUPTED);
    for (int k = 0; k < N; k++) r->column[0].values[k] = k % 2 ? 1e300 : -1e300;
    assert_int_equal(schuler_identify(&found, r, &usual, &error), SCHULER_ERR_NUMERIC);
    schuler_recording_free(r);
    schuler_identified_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coefficients_lie_within_their_limits),
        cmocka_unit_test(rates_and_increments_are_the_same_data),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(wrong_wishes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

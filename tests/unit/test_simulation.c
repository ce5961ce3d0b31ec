/* SPDX-License-Identifier: MIT */
/* The engine: same bytes for any threads and any width, common random numbers, order of delivery.
 */
#include "mission.h"
#include "scenarios/metrics.h"
#include <malloc.h>

static const char mission[] =
    "scenario: short flight\nseed: 5\nruns: 70\n"
    "report: {every: 0.13 s}\n"
    "trajectory:\n  kind: segments\n"
    "  start: {lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 100 m/s}\n"
    "  segments:\n    - turn: {by: 40 deg, bank: 20 deg}\n    - hold: {for: 3.33 s}\n"
    "imu:\n  rate: 100 Hz\n"
    "  accel:\n    model: linear\n    bias: {normal: 50 ug}\n    scale_factor: 100 ppm\n"
    "    velocity_random_walk: 0.01 m/s/sqrt(h)\n    quantization: 0.0001 m/s\n"
    "  gyro:\n    model: linear\n    bias: {uniform: 0.01 deg/h}\n    angle_random_walk: 0.003 "
    "deg/sqrt(h)\n"
    "    gauss_markov: 0.02 deg/h\n    gauss_markov_time: 60 s\n    bias_random_walk: 0.1 "
    "deg/h/sqrt(h)\n    saturation: 1 deg/s\n"
    "initial: {tilt: {normal: 10 arcsec}}\n"
    "requirement: {drift: 1 nmi/h, statistic: CEP}\n";

static void assert_rows_equal(const schuler_budget_row *a, const schuler_budget_row *b, int runs,
                              size_t times)
{
    const size_t bytes = (size_t)runs * sizeof(double);
    assert_string_equal(a->id, b->id);
    assert_memory_equal(a->end_m, b->end_m, bytes);
    assert_memory_equal(a->max_m, b->max_m, bytes);
    assert_memory_equal(a->slope_mps, b->slope_mps, bytes);
    assert_memory_equal(a->v_rms_mps, b->v_rms_mps, bytes);
    if (times) assert_memory_equal(a->rms_curve_m, b->rms_curve_m, times * sizeof(double));
}

static void assert_same_bytes(const schuler_result *a, const schuler_result *b)
{
    assert_int_equal(a->row_count, b->row_count);
    assert_int_equal(a->time_count, b->time_count);
    for (size_t i = 0; i < a->row_count; i++)
        assert_rows_equal(&a->rows[i], &b->rows[i], a->rows[i].runs, a->time_count);
    assert_rows_equal(&a->all, &b->all, a->all.runs, a->time_count);
    assert_rows_equal(&a->none, &b->none, a->none.runs, a->time_count);
    assert_memory_equal(&a->judgement, &b->judgement, sizeof(a->judgement));
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        assert_int_equal(a->clipped[i].runs, b->clipped[i].runs);
        assert_int_equal(a->clipped[i].samples, b->clipped[i].samples);
    }
}

static void threads_and_widths_give_the_same_bytes(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    schuler_run_options options = { .threads = 1, .has_isa = 1, .isa = SCHULER_ISA_SCALAR };
    schuler_result *reference = mission_run(s, &options);
    assert_int_equal(reference->all.runs, 70);
    /* the bank rolls faster than the range, now and then */
    assert_int_equal(reference->clipped[SCHULER_GYRO].runs, 70);
    assert_int_equal(reference->clipped[SCHULER_ACCEL].runs, 0);
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++)
        for (int threads = 1; threads <= 3; threads++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            options.isa = (schuler_isa)isa;
            options.threads = threads;
            schuler_result *r = mission_run(s, &options);
            assert_same_bytes(reference, r);
            schuler_result_free(r);
        }
    schuler_result_free(reference);
    schuler_scenario_free(s);
}

/* Nothing may be computed from memory that was never written: fill what malloc gives with other
 * bytes. */
static void results_do_not_depend_on_what_memory_held(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    const schuler_run_options options = { .threads = 1 };
    schuler_result *results[2];
    for (int i = 0; i < 2; i++) {
        mallopt(M_PERTURB, i == 0 ? 0x11 : 0xbf);
        results[i] = mission_run(s, &options);
    }
    mallopt(M_PERTURB, 0);
    assert_same_bytes(results[0], results[1]);
    schuler_result_free(results[0]);
    schuler_result_free(results[1]);
    schuler_scenario_free(s);
}

/* Common random numbers: a source's errors in run r do not depend on which other sources are on,
 * nor on how many runs there are. */
static void a_source_alone_repeats_its_part_of_the_budget(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    const schuler_run_options options = { .threads = 2 };
    schuler_result *full = mission_run(s, &options);
    for (size_t i = 0; i < full->row_count; i++) {
        const char *only = full->rows[i].id;
        s->only = (schuler_text_list){ .items = &only, .count = 1 };
        s->runs = 31;
        schuler_result *r = mission_run(s, &options);
        assert_int_equal(r->row_count, 1);
        assert_rows_equal(&r->rows[0], &full->rows[i], full->rows[i].drawn ? 31 : 1, 0);
        /* With one source the joint run is that source. */
        if (strcmp(only, "numerical") != 0) {
            assert_int_equal(r->all.runs, r->rows[0].runs);
            assert_memory_equal(r->all.end_m, r->rows[0].end_m,
                                (size_t)r->all.runs * sizeof(double));
        }
        schuler_result_free(r);
    }
    schuler_result_free(full);
    schuler_scenario_free(s);
}

typedef struct {
    size_t calls, rows;
    char last_id[64];
    int last_run, ids;
    double end2_all;
    double slope_mps[128]; /* of `all`, from the rows alone */
} delivery;

static schuler_status take_delivery(void *user, const char *id, int run,
                                    const schuler_error_row *rows, size_t count)
{
    delivery *d = user;
    if (strcmp(id, d->last_id) != 0) {
        snprintf(d->last_id, sizeof(d->last_id), "%s", id);
        d->ids++;
        assert_int_equal(run, 0);
    } else {
        assert_int_equal(run, d->last_run + 1);
    }
    d->last_run = run;
    d->calls++;
    d->rows += count;
    assert_true(rows[0].time_s == 0.0);
    for (size_t i = 1; i < count; i++) assert_true(rows[i].time_s > rows[i - 1].time_s);
    if (strcmp(id, "all") == 0) {
        double t_s[512], r_m[512];
        assert_true(count <= 512 && run < 128);
        for (size_t i = 1; i < count; i++) {
            t_s[i - 1] = rows[i].time_s;
            r_m[i - 1] = hypot(rows[i].r_n[0] - rows[0].r_n[0], rows[i].r_n[1] - rows[0].r_n[1]);
        }
        d->slope_mps[run] = schuler_slope_through_origin(t_s, r_m, count - 1);
    }
    if (strcmp(id, "all") == 0)
        d->end2_all += rows[count - 1].r_n[0] * rows[count - 1].r_n[0] +
                       rows[count - 1].r_n[1] * rows[count - 1].r_n[1];
    return SCHULER_OK;
}

static void error_rows_come_in_order_and_agree_with_the_budget(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    delivery d = { 0 };
    const schuler_run_options options = { .threads = 3, .errors = take_delivery, .user = &d };
    schuler_result *r = mission_run(s, &options);
    assert_string_equal(d.last_id, "none");
    assert_int_equal(d.ids, (int)r->row_count - 1 + 2); /* `numerical` is `none` */
    assert_int_equal(d.rows, d.calls * (r->time_count + 1));
    CHECK_REL(sqrt(d.end2_all / r->runs), r->all.rms_end_m, 1e-13);
    /* A sum of a few hundred terms of one sign, in another order: some 1e-14. */
    for (int run = 0; run < r->runs; run++)
        CHECK_REL(r->all.slope_mps[run], d.slope_mps[run], 1e-13);
    assert_true(r->times_s[r->time_count - 1] == r->duration_s);
    schuler_result_free(r);
    schuler_scenario_free(s);
}

static schuler_status refuse(void *user, const char *id, int run, const schuler_error_row *rows,
                             size_t count)
{
    (void)user, (void)id, (void)run, (void)rows, (void)count;
    return SCHULER_ERR_FILE;
}

static void a_failing_receiver_stops_the_run(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    const schuler_run_options options = { .threads = 2, .errors = refuse };
    schuler_result *r = NULL;
    schuler_error err = { 0 };
    assert_int_equal(schuler_simulate(s, &options, &r, &err), SCHULER_ERR_FILE);
    assert_null(r);
    schuler_scenario_free(s);
}

/* At rest one axis of three feels gravity: beyond a range of 0.9 g in every sample of every run. */
static void what_is_cut_off_is_counted(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(
        "scenario: at rest\nseed: 5\nruns: 11\n"
        "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m, heading: 0 deg}, "
        "for: 20 s}\n"
        "imu:\n  rate: 50 Hz\n  accel: {model: linear, bias: {normal: 1 mg}, saturation: 0.9 g}\n"
        "  gyro: {model: linear, saturation: 1 deg/s}\n");
    const schuler_run_options options = { .threads = 2 };
    schuler_result *r = mission_run(s, &options);
    assert_int_equal(r->clipped[SCHULER_ACCEL].runs, 11);
    assert_int_equal(r->clipped[SCHULER_ACCEL].samples, 11 * 1000);
    assert_int_equal(r->clipped[SCHULER_GYRO].runs, 0);
    assert_int_equal(r->clipped[SCHULER_GYRO].samples, 0);
    schuler_result_free(r);
    schuler_scenario_free(s);
}

static void a_request_to_stop_is_heard(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    const volatile int stop = 1;
    const schuler_run_options options = { .threads = 2, .stop = &stop };
    schuler_result *r = NULL;
    schuler_error err = { 0 };
    assert_int_equal(schuler_simulate(s, &options, &r, &err), SCHULER_ERR_INTERRUPTED);
    schuler_scenario_free(s);
}

/* A state that leaves the numbers is an error that says where, never a nan in a table. */
static void divergence_is_an_error_with_source_and_time(void **state)
{
    (void)state;
    schuler_scenario *s = mission_text(mission);
    s->vertical = SCHULER_VERTICAL_FREE;
    for (int i = 0; i < 3; i++) s->velocity.a[i] = 1e200;
    s->velocity.given = true;
    s->velocity.draw = SCHULER_DRAW_FIXED;
    schuler_result *r = NULL;
    schuler_error err = { 0 };
    const schuler_run_options options = { .threads = 1 };
    assert_int_equal(schuler_simulate(s, &options, &r, &err), SCHULER_ERR_NUMERIC);
    assert_non_null(strstr(err.message, "initial.velocity"));
    schuler_scenario_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_and_widths_give_the_same_bytes),
        cmocka_unit_test(results_do_not_depend_on_what_memory_held),
        cmocka_unit_test(a_source_alone_repeats_its_part_of_the_budget),
        cmocka_unit_test(error_rows_come_in_order_and_agree_with_the_budget),
        cmocka_unit_test(a_failing_receiver_stops_the_run),
        cmocka_unit_test(what_is_cut_off_is_counted),
        cmocka_unit_test(a_request_to_stop_is_heard),
        cmocka_unit_test(divergence_is_an_error_with_source_and_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

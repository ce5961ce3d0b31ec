/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/profile.h"

static const double tick_s = 1.0 / SCHULER_TICKS_PER_S;

static long double value(const schuler_trapezoid *z, long double t_s)
{
    return schuler_trapezoid_value(z, (schuler_instant){ 0.0, t_s });
}

static long double rate(const schuler_trapezoid *z, long double t_s)
{
    return schuler_trapezoid_rate(z, (schuler_instant){ 0.0, t_s });
}

static void a_trapezoid_reaches_its_change_exactly_and_keeps_the_limit(void **state)
{
    (void)state;
    static const double changes[] = { 90.0, -90.0, 12.5, 1e-3, 1.0 / 3.0, -7777.7 };
    for (size_t i = 0; i < sizeof(changes) / sizeof(changes[0]); i++) {
        const schuler_trapezoid z = schuler_trapezoid_make(changes[i], 3.0, 2.0);
        const double T_s = schuler_trapezoid_duration(&z);
        assert_true((double)value(&z, T_s) == changes[i]);
        assert_true((double)value(&z, T_s + 5.0) == changes[i]);
        assert_true((double)value(&z, -1.0) == 0.0);
        assert_true(z.rate * changes[i] > 0.0L);
        /* Durations are rounded to ticks, so the rate may be over by that much of a second. */
        assert_true(fabs((double)z.rate) <= 3.0 * (1.0 + tick_s));
        assert_true(z.ramp_s == 2.0);
    }
}

static void a_large_change_uses_the_whole_rate_and_a_small_one_less(void **state)
{
    (void)state;
    const schuler_trapezoid large = schuler_trapezoid_make(30.0, 3.0, 2.0);
    CHECK_NEAR((double)large.rate, 3.0, 3.0 * tick_s);
    CHECK_NEAR(schuler_trapezoid_duration(&large), 30.0 / 3.0 + 2.0, tick_s);
    const schuler_trapezoid small = schuler_trapezoid_make(3.0, 3.0, 2.0);
    assert_true(small.plateau_s == 0.0);
    CHECK_NEAR((double)small.rate, 1.5, 1e-15);
    const schuler_trapezoid none = schuler_trapezoid_make(0.0, 3.0, 2.0);
    assert_true(schuler_trapezoid_duration(&none) == 0.0);
}

/* Simpson's rule is exact to degree 3; the rate has degree 5 in the ramps, so 2000 intervals of 6
 * ms leave (h/2)^4/180 times its fourth derivative (22.5 per ramp^4) times the length, below 1e-9.
 */
static void the_change_is_the_integral_of_the_rate(void **state)
{
    (void)state;
    const schuler_trapezoid z = schuler_trapezoid_make(-30.0, 3.0, 2.0);
    const double T_s = schuler_trapezoid_duration(&z);
    const int n = 2000;
    long double sum = 0.0L;
    for (int i = 0; i < n; i++) {
        const long double a = T_s * i / n, b = T_s * (i + 1) / n;
        sum += (b - a) / 6.0L * (rate(&z, a) + 4.0L * rate(&z, 0.5L * (a + b)) + rate(&z, b));
        CHECK_NEAR((double)value(&z, b), (double)sum, 1e-9);
    }
}

/* Across each joint value, rate and the rate's two derivatives are continuous: differences over a
 * small step on both sides agree to the step times the next derivative. */
static void the_rate_is_smooth_where_ramps_begin_and_end(void **state)
{
    (void)state;
    const schuler_trapezoid z = schuler_trapezoid_make(30.0, 3.0, 2.0);
    const double joints_s[] = { 0.0, z.ramp_s, z.ramp_s + z.plateau_s,
                                schuler_trapezoid_duration(&z) };
    const long double h = 1e-4L;
    for (int i = 0; i < 4; i++) {
        long double r[5];
        for (int k = 0; k < 5; k++) r[k] = rate(&z, joints_s[i] + (k - 2) * h);
        const long double slope =
            3.0L * 60.0L / (2.0L * 2.0L * 2.0L); /* jump of the third derivative */
        CHECK_NEAR((double)((r[4] - r[2]) / (2.0L * h)), (double)((r[2] - r[0]) / (2.0L * h)),
                   (double)(4.0L * slope * h * h));
        CHECK_NEAR((double)((r[4] - 2.0L * r[3] + r[2]) / (h * h)),
                   (double)((r[2] - 2.0L * r[1] + r[0]) / (h * h)), (double)(4.0L * slope * h));
    }
}

static void the_ramp_keeps_the_jerk_it_was_made_for(void **state)
{
    (void)state;
    const double acceleration = 2.0, jerk = 1.0;
    const schuler_trapezoid z =
        schuler_trapezoid_make(100.0, acceleration, SCHULER_SMOOTHSTEP_SLOPE * acceleration / jerk);
    double steepest = 0.0;
    const long double h = 1e-3L;
    for (long double t = 0.0L; t < schuler_trapezoid_duration(&z); t += h)
        steepest = fmax(steepest, fabs((double)((rate(&z, t + h) - rate(&z, t)) / h)));
    /* The chord of a step is less steep by h^2/24 times the third derivative: below 1e-6. */
    CHECK_NEAR(steepest, jerk, 1e-6);
}

/* The end of a change that took days is as smooth as its start: mirrored instants give mirrored
 * values, to the rounding of the rate itself. In one number, the instant would be off by 1e-14 s in
 * 10 ms. */
static void a_late_ramp_keeps_its_digits(void **state)
{
    (void)state;
    const schuler_trapezoid z = schuler_trapezoid_make(40000.0, 0.125, 0.01);
    const double end_s = schuler_trapezoid_duration(&z), ramp_s = z.ramp_s;
    for (int k = 1; k < 100; k++) {
        const long double t_s = ramp_s * k / 100.0L;
        const schuler_instant early = { 0.0, t_s }, late = { end_s - ramp_s, ramp_s - t_s };
        CHECK_NEAR((double)(schuler_trapezoid_rate(&z, late) - schuler_trapezoid_rate(&z, early)),
                   0.0, 1e-18);
    }
}

/* Plateau and falling ramp meet: just before and just after their joint. */
static void the_parts_of_a_trapezoid_add_up(void **state)
{
    (void)state;
    const schuler_trapezoid z = schuler_trapezoid_make(-20.5554, 0.0183, 0.12);
    const schuler_instant joint = { z.ramp_s + z.plateau_s, 0.0L };
    const schuler_instant after = { joint.joint_s, 1e-12L };
    const long double moved =
        schuler_trapezoid_value(&z, after) - schuler_trapezoid_value(&z, joint);
    /* Extended rounding of 20 is 1e-18. */
    CHECK_NEAR((double)(moved - z.rate * 1e-12L), 0.0, 1e-17);
}

static void durations_are_whole_ticks(void **state)
{
    (void)state;
    const schuler_trapezoid z = schuler_trapezoid_make(1.0 / 3.0, 0.0173, 0.1);
    const double ramp = z.ramp_s * SCHULER_TICKS_PER_S, plateau = z.plateau_s * SCHULER_TICKS_PER_S;
    assert_true(ramp == floor(ramp) && plateau == floor(plateau));
    assert_true(schuler_tick(600.0) == 600.0);
    CHECK_NEAR(schuler_tick(0.1), 0.1, 0.5 * tick_s);
}

static void joints_are_ascending_and_distinct(void **state)
{
    (void)state;
    schuler_phase phase = { .duration_s = 100.0 };
    phase.speed.trapezoid = schuler_trapezoid_make(30.0, 3.0, 2.0);   /* 0, 2, 10, 12 */
    phase.height.trapezoid = schuler_trapezoid_make(80.0, 2.0, 10.0); /* 50 s long */
    phase.height.start_s = 50.0;                                      /* 50, 60, 90, 100 */
    double joints_s[SCHULER_PHASE_JOINTS];
    assert_int_equal(schuler_phase_joints(&phase, joints_s), 8);
    const double expected_s[] = { 0.0, 2.0, 10.0, 12.0, 50.0, 60.0, 90.0, 100.0 };
    for (int i = 0; i < 8; i++) CHECK_NEAR(joints_s[i], expected_s[i], tick_s);
    const schuler_phase steady = { .duration_s = 7.0 };
    assert_int_equal(schuler_phase_joints(&steady, joints_s), 2);
    const schuler_phase nothing = { 0 };
    assert_int_equal(schuler_phase_joints(&nothing, joints_s), 1);
}

/* One point: the quintic smoothstep. More: the polynomial's derivative is what differences of it say. */
static void a_curve_starts_and_ends_smoothly(void **state)
{
    (void)state;
    const schuler_channel one = { .from = 3.0,
                                  .curve = { .count = 1, .to = { 8.0 }, .duration_s = 4.0 } };
    for (int k = 0; k <= 8; k++) {
        const double x = k / 8.0, step = x * x * x * (10.0 - x * (15.0 - 6.0 * x));
        const schuler_instant t = { 0.0, 4.0 * x };
        CHECK_NEAR((double)schuler_channel_value(&one, t), 3.0 + 5.0 * step, 2e-15);
        CHECK_NEAR((double)schuler_channel_rate(&one, t),
                   5.0 * 30.0 * x * x * (1.0 - x) * (1.0 - x) / 4.0, 2e-15);
    }
    assert_true(schuler_channel_end(&one) == 8.0);
    const schuler_channel many = {
        .from = -1.0, .curve = { .count = 4, .to = { 9.0, -7.0, 0.5, 2.0 }, .duration_s = 6.0 }
    };
    const long double h = 1e-5L;
    for (int k = 0; k <= 12; k++) {
        const schuler_instant t = { 0.0, 0.5L * k }, before = { 0.0, 0.5L * k - h },
                              after = { 0.0, 0.5L * k + h };
        if (k == 0 || k == 12) {
            CHECK_NEAR((double)schuler_channel_rate(&many, t), 0.0, 1e-17);
            continue;
        }
        /* The third derivative is below 1000 in size: a sixth of it times h^2. */
        CHECK_NEAR(
            (double)((schuler_channel_value(&many, after) - schuler_channel_value(&many, before)) /
                     (2.0L * h)),
            (double)schuler_channel_rate(&many, t), 2e-8);
    }
    assert_true((double)schuler_channel_value(&many, (schuler_instant){ 6.0, 1.0L }) == 2.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_trapezoid_reaches_its_change_exactly_and_keeps_the_limit),
        cmocka_unit_test(a_large_change_uses_the_whole_rate_and_a_small_one_less),
        cmocka_unit_test(the_change_is_the_integral_of_the_rate),
        cmocka_unit_test(the_rate_is_smooth_where_ramps_begin_and_end),
        cmocka_unit_test(the_ramp_keeps_the_jerk_it_was_made_for),
        cmocka_unit_test(a_late_ramp_keeps_its_digits),
        cmocka_unit_test(the_parts_of_a_trapezoid_add_up),
        cmocka_unit_test(durations_are_whole_ticks),
        cmocka_unit_test(joints_are_ascending_and_distinct),
        cmocka_unit_test(a_curve_starts_and_ends_smoothly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

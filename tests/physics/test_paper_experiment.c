/* SPDX-License-Identifier: MIT */
/* The experiment of T. L. Grigorie, M. Lungu, I. R. Edu, R. Obreja, "Concepts for error modeling of
 * miniature accelerometers used in inertial navigation systems", figure 5: its ten accelerometers at
 * 1 g along and 1 g across, 10 000 units of each. What must come out follows from its equation 21 and
 * table 1: with bias B g, scale factor D, cross axis k, misalignment N (as printed, on the input axis)
 *   mean = (1 + N + B + k)(1 + D),  noise = r v sqrt(bandwidth)(1 + D),  r from 0.8 to 1. */
#include "check.h"
#include "core/earth.h"
#include "scenarios/characterize.h"
#include <math.h>

enum { UNITS = 10000, SAMPLES = 1000 };

typedef struct {
    const char *name;
    double least_g, most_g, mean_g, sigma_g; /* of a unit's mean output */
    double noise_g, least_noise, most_noise; /* v sqrt(bandwidth); mg for the two limits */
} expected;

static const expected table[10] = {
    { "paper-adxl321", 0.64035, 1.47785, 1.0275, 0.18673, 16.000e-3, 11.520, 17.600 },
    { "paper-adxl78", 0.301625, 1.855875, 1.0425, 0.40569, 22.000e-3, 16.720, 23.100 },
    { "paper-cxl25lp1", 0.50825, 1.66425, 1.0600, 0.29077, 10.000e-3, 7.600, 10.500 },
    { "paper-ioa", 0.7695, 1.302, 1.0250, 0.11956, 3.000e-3, 2.280, 3.150 },
    { "paper-foa", 0.5795, 1.512, 1.0250, 0.23308, 1.200e-3, 0.912, 1.260 },
    { "paper-qa750", 0.978922, 1.035402, 1.0070, 0.012533, 1.5652e-3, 1.2272, 1.5966 },
    { "paper-qa3000-030", 0.9770404, 1.0251204, 1.0010, 0.011789, 1.5652e-3, 1.2272, 1.5966 },
    { "paper-a3022-050-p", 0.152, 1.9635, 1.0150, 0.48614, 11.068e-3, 8.412, 11.621 },
    { "paper-s1210l-025", 0.49, 1.5606, 1.0150, 0.28906, 4.9964e-3, 3.917, 5.096 },
    { "paper-s1221x-025", 0.49, 1.5606, 1.0150, 0.28906, 0.96825e-3, 0.759, 0.988 },
};

static schuler_characterized *measure(const char *name, const char *without, int samples)
{
    schuler_part *part;
    schuler_diagnostics d = { 0 };
    if (schuler_part_load(&part, name, &d) != SCHULER_OK) fail_msg("no part %s", name);
    assert_int_equal(d.kept, 0);
    const double rate_hz = schuler_characterize_rate(&part->imu, SCHULER_ACCEL);
    schuler_characterize_options o = { .along = SCHULER_G0_MPS2,
                                       .across = SCHULER_G0_MPS2,
                                       .duration_s = samples / rate_hz,
                                       .units = UNITS,
                                       .seed = 1 };
    if (without) o.without = (schuler_text_list){ .items = &without, .count = 1 };
    schuler_characterized *found;
    assert_int_equal(schuler_characterize(&found, &part->imu, SCHULER_ACCEL, &o, NULL), SCHULER_OK);
    schuler_part_free(part);
    return found;
}

/* 4.5 standard deviations of the estimate, and half of the last printed digit. The noise of the mean,
 * v sqrt(bandwidth/SAMPLES), adds its variance to that of the units: at most 0.8 % of the Q-Flex parts'
 * spread squared... taken into the expectation. */
static void mean_and_spread_are_those_of_the_table(void **state)
{
    (void)state;
    for (int i = 0; i < 10; i++) {
        const expected *const e = &table[i];
        schuler_characterized *const f = measure(e->name, NULL, SAMPLES);
        const double g = SCHULER_G0_MPS2;
        const double noise = 0.9 * e->noise_g / sqrt(SAMPLES);
        CHECK_NEAR(f->output.mean / g, e->mean_g, 4.5 * e->sigma_g / sqrt(UNITS));
        CHECK_NEAR(f->output.spread / g, hypot(e->sigma_g, noise),
                   4.5 * f->output.spread_error / g + 5e-6 * (e->sigma_g < 0.1 ? 0.1 : 1.0));
        /* r has the mean 0.9 and D none. */
        CHECK_NEAR(f->noise.mean / g, 0.9 * e->noise_g, 4.5 * f->noise.mean_error / g);
        /* One unit's estimate of its noise is off by 1/sqrt(2 SAMPLES); 5 of those in 10 000 units. */
        const double off = 5.0 / sqrt(2.0 * SAMPLES);
        assert_true(f->noise.least > 1e-3 * g * e->least_noise * (1.0 - off));
        assert_true(f->noise.most < 1e-3 * g * e->most_noise * (1.0 + off));
        /* and it does fill its range */
        assert_true(f->noise.least < 1e-3 * g * e->least_noise * 1.05);
        assert_true(f->noise.most > 1e-3 * g * e->most_noise * 0.95);
        schuler_characterized_free(f);
    }
}

/* Without the noise, which changes no other draw, the mean of a unit is exact. */
static void no_unit_is_outside_its_interval(void **state)
{
    (void)state;
    for (int i = 0; i < 10; i++) {
        const expected *const e = &table[i];
        schuler_characterized *const f = measure(e->name, "accel.velocity_random_walk", 3);
        assert_true(f->noise.most < 1e-12 * SCHULER_G0_MPS2);
        assert_true(f->output.least / SCHULER_G0_MPS2 > e->least_g - 5e-7);
        assert_true(f->output.most / SCHULER_G0_MPS2 < e->most_g + 5e-7);
        /* The corners are never reached, but the units come within a sigma of them. */
        assert_true(f->output.least / SCHULER_G0_MPS2 < e->least_g + e->sigma_g);
        assert_true(f->output.most / SCHULER_G0_MPS2 > e->most_g - e->sigma_g);
        schuler_characterized_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_and_spread_are_those_of_the_table),
        cmocka_unit_test(no_unit_is_outside_its_interval),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

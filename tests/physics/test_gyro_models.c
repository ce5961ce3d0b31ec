/* SPDX-License-Identifier: MIT */
/* Gyro models against numbers computed with 40 digits (B1 to B13), and what must come out of them by
 * itself: rectified vibration, the axes of other instruments, signs. */
#include "core/units.h"
#include "indicate.h"
#include "sensors/mounting.h"
#include "sensors/optics.h"
#include "sensors/response.h"
#include "sensors/rotor.h"

static const double g = 9.80665, deg = M_PI / 180.0, deg_h = M_PI / 180.0 / 3600.0;

/* Sums of about ten terms with rounding 1e-16 each. */
#define EXACT(actual, expected) CHECK_REL(actual, expected, 1e-14)

/* What the x gyro says of the rates about its axes i, o, s. */
static double sensed(indication *x, double i, double o, double s)
{
    x->omega[0] = i, x->omega[1] = o, x->omega[2] = s;
    return indicated(x, x->f[0], x->f[1], x->f[2]);
}

static double *value(indication *x, const char *key)
{
    return x->values.value[indication_param(x, key)];
}

static void b1_titterton(void **state)
{
    (void)state;
    indication x = indication_of("conventional", SCHULER_GYRO);
    give(&x, "scale_factor", 50e-6);
    value(&x, "misalignment")[0] = 1e-4; /* xy */
    value(&x, "misalignment")[1] = -5e-5;
    give(&x, "bias", 0.5 * deg_h);
    give(&x, "mass_unbalance", 0.3 * deg_h / g);
    give(&x, "quadrature_unbalance", -0.2 * deg_h / g);
    give(&x, "anisoelastic", 0.02 * deg_h / (g * g));
    x.f[0] = 2.0, x.f[1] = -1.0, x.f[2] = 9.8;
    EXACT(sensed(&x, 0.3, -0.1, 0.05), 0.300005339327788);
}

/* Half the difference of the slopes on either side; powers of the rate. */
static void scale_factors_bend(void **state)
{
    (void)state;
    static const char *const models[] = { "conventional", "vibratory" };
    for (int m = 0; m < 2; m++) {
        indication x = indication_of(models[m], SCHULER_GYRO);
        give(&x, "scale_asymmetry", 0.01);
        EXACT(sensed(&x, 2.0, 0.0, 0.0), 2.01);
        EXACT(sensed(&x, -2.0, 0.0, 0.0), -1.99);
        give(&x, "scale_asymmetry", 0.0);
        give(&x, "scale_quadratic", 0.01);
        give(&x, "scale_cubic", 0.001);
        EXACT(sensed(&x, -2.0, 0.0, 0.0), -2.0 + 0.04 - 0.008);
    }
}

static indication full_517(void)
{
    indication x = indication_of("spinning_mass", SCHULER_GYRO);
    const double a = deg_h / g, b = deg_h / (g * g);
    give(&x, "D_F", 0.2 * deg_h);
    give(&x, "D_I", 0.5 * a);
    give(&x, "D_S", -0.4 * a);
    give(&x, "D_O", 0.01 * a);
    give(&x, "D_II", 0.02 * b);
    give(&x, "D_SS", -0.03 * b);
    give(&x, "D_IS", 0.04 * b);
    give(&x, "D_IO", 0.005 * b);
    give(&x, "D_OS", -0.006 * b);
    return x;
}

/* Terms of up to 0.5 deg/h that cancel, each with three roundings of 1e-16: 2e-15 in all. The other
 * gyros have their axes in cyclic order. */
static void b2_ieee_517(void **state)
{
    (void)state;
    indication x = full_517();
    static const double a[3] = { 0.6, -0.8, 1.2 };
    for (int axis = 0; axis < 3; axis++) {
        for (int c = 0; c < 3; c++) x.f[(axis + c) % 3] = a[c] * g;
        (void)sensed(&x, 0.0, 0.0, 0.0);
        CHECK_NEAR(x.out[axis] / deg_h, 0.00816, 2e-15);
    }
    give(&x, "D_OO", 0.07 * deg_h / (g * g));
    CHECK_NEAR(sensed(&x, 0.0, 0.0, 0.0) / deg_h,
               0.2 + 0.5 * -0.8 - 0.4 * 0.6 + 0.01 * 1.2 + 0.02 * 0.64 - 0.03 * 0.36 - 0.04 * 0.48 -
                   0.005 * 0.96 - 0.006 * 0.72 + 0.07 * 1.44,
               2e-15);
}

/* B4. A difference of numbers of about 1: half a unit in the last place of each. */
static void b4_inertia(void **state)
{
    (void)state;
    indication x = indication_of("spinning_mass", SCHULER_GYRO);
    give(&x, "aniso_inertia", 0.5 / 1e5);
    CHECK_NEAR(sensed(&x, 1.0, 0.0, 1.0) - 1.0, 1.03132403123548 * deg_h, 3e-16);
    CHECK_NEAR(sensed(&x, 1.0, 0.0, -1.0) - 1.0, -1.03132403123548 * deg_h, 3e-16);
    give(&x, "aniso_inertia", 0.0);
    give(&x, "output_axis", 2e-3);
    x.alpha[1] = 3.0;
    EXACT(sensed(&x, 0.0, 0.0, 0.0), 6e-3);
}

/* The two channels of one rotor, in the words of IEEE 813; what y is given is not looked at. */
static void a_tuned_rotor_has_two_channels(void **state)
{
    (void)state;
    const double f[3] = { 3.0, -5.0, 7.0 }, D_x = 0.01, D_q = 0.002, D_xz = 3e-4, D_yz = 4e-4;
    indication x = indication_of("spinning_mass", SCHULER_GYRO);
    choose(&x, "kind", "tuned_rotor");
    give_axes(&x, "D_I", D_x, 9.0, 0.0);
    give_axes(&x, "D_O", D_q, 9.0, 0.0);
    give_axes(&x, "D_IS", D_xz, 9.0, 0.0);
    give_axes(&x, "D_OS", D_yz, 9.0, 0.0);
    give_axes(&x, "D_F", 1.0, 2.0, 3.0);
    EXACT(indicated(&x, f[0], f[1], f[2]),
          1.0 + D_x * f[0] + D_q * f[1] + D_xz * f[0] * f[2] + D_yz * f[1] * f[2]);
    EXACT(x.out[1], 2.0 + D_x * f[1] - D_q * f[0] + D_xz * f[1] * f[2] - D_yz * f[0] * f[2]);
    EXACT(x.out[2], 3.0);
    indication y = indication_of("conventional", SCHULER_GYRO);
    choose(&y, "kind", "tuned_rotor");
    give_axes(&y, "mass_unbalance", D_x, 9.0, 0.0);
    give_axes(&y, "quadrature_unbalance", D_q, 9.0, 0.0);
    give_axes(&y, "anisoelastic", D_xz, 9.0, 0.0);
    EXACT(indicated(&y, f[0], f[1], f[2]), D_x * f[0] + D_q * f[1] + D_xz * f[0] * f[2]);
    EXACT(y.out[1], D_x * f[1] - D_q * f[0] + D_xz * f[1] * f[2]);
    /* Inertia acts about the same axes, and misalignments are toward x and z as ever. */
    indication z = indication_of("spinning_mass", SCHULER_GYRO);
    choose(&z, "kind", "tuned_rotor");
    give(&z, "aniso_inertia", 0.1);
    give(&z, "output_axis", 0.01);
    for (int c = 0; c < 6; c++) value(&z, "misalignment")[c] = 0.01 * (c + 1);
    z.alpha[0] = 11.0, z.alpha[1] = 13.0;
    EXACT(sensed(&z, 2.0, 3.0, 5.0), 2.0 + 0.03 + 0.1 + 1.0 + 0.13);
    EXACT(z.out[1], 3.0 + 0.03 * 2.0 + 0.04 * 5.0 + 0.1 * 15.0 - 0.11);
}

/* With the input axes a little askew: the y channel's axes are a right-handed triad on its own input
 * axis, and its spin axis is the part of the rotor's that is square to it. */
static void a_rotor_may_be_mounted_askew(void **state)
{
    (void)state;
    static const double input[9] = { 1.0, 0.1, -0.05, -0.1, 1.0, 0.2, 0.0, 0.0, 1.0 };
    static const double second[9] = { 0.3, 1.0, 0.1, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0 };
    static schuler_view view;
    double i[3], axes[2][3];
    schuler_mounting_axes(input, second, view.axes);
    assert_true(rotor_axes(&view, axes));
    for (int c = 0; c < 3; c++) {
        i[c] = 0.0;
        for (int j = 0; j < 3; j++) i[c] += view.axes[1][0][j] * view.axes[0][c][j];
    }
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        CHECK_NEAR(i[a] * axes[0][b] - i[b] * axes[0][a], axes[1][c], 1e-15);
        CHECK_NEAR(axes[0][a] * axes[1][b] - axes[0][b] * axes[1][a], i[c], 1e-15);
    }
    CHECK_NEAR(axes[0][2], 0.0, 1e-15); /* no part of the output axis along the spin */
    assert_true(axes[1][2] > 0.9);
    for (int j = 0; j < 3; j++) view.axes[1][0][j] = view.axes[0][2][j];
    assert_false(rotor_axes(&view, axes));
}

static void the_ieee_bracket_is_inverse(void **state)
{
    (void)state;
    static const char *const models[] = { "ring_laser", "fibre_optic" };
    for (int m = 0; m < 2; m++) {
        indication x = indication_of(models[m], SCHULER_GYRO);
        give(&x, "epsilon_K", 1e-3);
        assert_true(sensed(&x, 1.0, 0.0, 0.0) < 1.0);
        EXACT(x.out[0], 1.0 / 1.001);
        give(&x, "D_F", 0.25);
        give(&x, "Theta_X", 0.02);
        give(&x, "Theta_Y", 0.03);
        EXACT(sensed(&x, 1.0, 5.0, 7.0), (1.25 + 5.0 * sin(0.03) - 7.0 * sin(0.02)) / 1.001);
        (void)sensed(&x, 5.0, 7.0, 1.0); /* the z gyro: x and y follow z */
        EXACT(x.out[2], (1.25 + 5.0 * sin(0.03) - 7.0 * sin(0.02)) / 1.001);
    }
}

/* B8b, and the other shapes of the scale factor. */
static void fibre_optic_scale_factors(void **state)
{
    (void)state;
    indication x = indication_of("fibre_optic", SCHULER_GYRO);
    give(&x, "open_loop", 1.0);
    /* ppm of a number near 1: 1e6 times 1e-16, three roundings */
    CHECK_NEAR(1e6 * (sensed(&x, 10.0 * deg, 0.0, 0.0) / (10.0 * deg) - 1.0), -9256.54583372516,
               5e-10);
    /* Half a turn of the phase is no signal. */
    const double half_turn = M_PI / schuler_fibre_gain(1000.0, 0.1, 1550e-9);
    CHECK_NEAR(sensed(&x, half_turn, 0.0, 0.0), 0.0, 4e-16 * half_turn);
    give(&x, "open_loop", 0.0);
    give(&x, "scale_rate", 0.1);
    give(&x, "scale_rate_2", 0.01);
    give(&x, "scale_rate_3", 0.001);
    EXACT(sensed(&x, -2.0, 0.0, 0.0), -2.0 * (1.0 + 0.2 + 0.04 - 0.008));
    indication y = indication_of("fibre_optic", SCHULER_GYRO);
    give(&y, "two_pi_error", 1e-3);
    EXACT(sensed(&y, 0.5 * half_turn, 0.0, 0.0), 1.001 * 0.5 * half_turn);
    give(&y, "two_pi_phase", 0.5 * M_PI);
    EXACT(sensed(&y, half_turn, 0.0, 0.0), 0.999 * half_turn);
    indication z = indication_of("fibre_optic", SCHULER_GYRO);
    for (int c = 0; c < 9; c++) value(&z, "magnetic_sensitivity")[c] = c + 1.0;
    give_axes(&z, "magnetic_field", 1e-3, 1e-4, 1e-5);
    EXACT(sensed(&z, 0.0, 0.0, 0.0), 1.23e-3);
    EXACT(z.out[1], 4.56e-3);
    EXACT(z.out[2], 7.89e-3);
}

/* B10; a gyro at rest has -1 g on the axis that points down. Rows of matrices are in body axes. */
static void b10_vibratory(void **state)
{
    (void)state;
    indication x = indication_of("vibratory", SCHULER_GYRO);
    give(&x, "vibration_rectification", deg_h / (g * g));
    give(&x, "vibration_rms", 4.0 * g);
    EXACT(sensed(&x, 0.0, 0.0, 0.0) / deg_h, 16.0);
    give(&x, "vibration_rectification", 0.0);
    value(&x, "g_sensitivity")[8] = 0.01 * deg / g; /* zz */
    (void)indicated(&x, 0.0, 0.0, -g);
    EXACT(x.out[2] / deg, -0.01);
    assert_true(x.out[0] == 0.0 && x.out[1] == 0.0);
    for (int c = 0; c < 9; c++) {
        value(&x, "g_sensitivity")[c] = c + 1.0;
        value(&x, "angular_acceleration")[c] = 0.1 * (c + 1.0);
    }
    x.f[0] = 1.0, x.f[1] = 0.1, x.f[2] = 0.01;
    x.alpha[0] = 1e-3, x.alpha[1] = 1e-4, x.alpha[2] = 1e-5;
    EXACT(sensed(&x, 0.0, 0.0, 0.0), 1.23 * 1.0001);
    EXACT(x.out[1], 4.56 * 1.0001);
    EXACT(x.out[2], 7.89 * 1.0001);
}

static void vibratory_terms(void **state)
{
    (void)state;
    indication x = indication_of("vibratory", SCHULER_GYRO);
    static const char *const keys[] = { "g2_ii", "g2_oo", "g2_ss", "g2_io", "g2_os", "g2_is" };
    for (int k = 0; k < 6; k++) give(&x, keys[k], 0.01 * (k + 1));
    give(&x, "bias", 0.5);
    give(&x, "scale_factor", 0.02);
    for (int c = 0; c < 6; c++) {
        value(&x, "misalignment")[c] = 0.01 * (c + 1);
        value(&x, "cross_axis")[c] = 0.001 * (c + 1);
    }
    x.f[0] = 2.0, x.f[1] = 3.0, x.f[2] = 5.0;
    EXACT(sensed(&x, 1.0, 7.0, 11.0),
          1.02 + 0.011 * 7.0 + 0.022 * 11.0 + 0.5 + 0.04 + 0.18 + 0.75 + 0.24 + 0.75 + 0.6);
    EXACT(x.out[1],
          1.02 * 7.0 + 0.033 * 1.0 + 0.044 * 11.0 + 0.5 + 0.09 + 0.5 + 0.12 + 0.6 + 0.5 + 0.36);
}

/* Largest at 1/sqrt(3) of the range, zero at its ends and beyond. */
static void integral_non_linearity_is_a_cubic(void **state)
{
    (void)state;
    static const char *const models[] = { "vibratory", "gyro_datasheet" };
    static const char *const range[] = { "full_scale", "range" };
    for (int m = 0; m < 2; m++) {
        indication x = indication_of(models[m], SCHULER_GYRO);
        give(&x, "nonlinearity", 0.01);
        give(&x, range[m], 2.0);
        const double top = 2.0 / sqrt(3.0);
        EXACT(sensed(&x, top, 0.0, 0.0), top + 0.02);
        EXACT(sensed(&x, -top, 0.0, 0.0), -top - 0.02);
        EXACT(sensed(&x, 2.0, 0.0, 0.0), 2.0);
        EXACT(sensed(&x, 5.0, 0.0, 0.0), 5.0);
        for (double w = 0.0; w < 2.0; w += 0.01)
            assert_true(sensed(&x, w, 0.0, 0.0) - w <= 0.02 * (1.0 + 1e-12));
    }
}

static void datasheet_figures(void **state)
{
    (void)state;
    indication x = indication_of("gyro_datasheet", SCHULER_GYRO);
    give(&x, "range", 8.0);
    give(&x, "bias_of_span", 0.01);
    give(&x, "scale_factor", -0.02);
    give(&x, "cross_axis", 0.03);
    give(&x, "misalignment", 0.04);
    value(&x, "g_sensitivity")[1] = 0.05; /* xy */
    give(&x, "vibration_rectification", 0.001);
    give(&x, "vibration_rms", 10.0);
    x.f[1] = 2.0;
    const double rest = 0.08 + 0.1 + 0.1, w = 9.0; /* outside the range: no curve, no clipping */
    EXACT(sensed(&x, w, 3.0, 4.0), 0.98 * (w * cos(0.04) + 3.0 * (sin(0.04) + 0.03) + rest));
    choose(&x, "cross_from", "both");
    EXACT(sensed(&x, w, 3.0, 4.0), 0.98 * (w * cos(0.04) + 5.0 * (sin(0.04) + 0.03) + rest));
    choose(&x, "span", "two_sided");
    choose(&x, "misalignment_form", "printed");
    EXACT(sensed(&x, w, 3.0, 4.0), 0.98 * (w * 1.04 + 5.0 * 0.03 + rest + 0.08));
}

/* B12 and B13 by the reader and by models; the small difference of two numbers of 2 pi. */
static void b12_b13_units_and_turns(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        schuler_dim dim;
        double si;
    } units[] = {
        { "1 deg/h", SCHULER_DIM_RATE, 4.84813681109536e-6 },
        { "1 deg/sqrt(h)", SCHULER_DIM_ARW, 0.000290888208665722 },
        { "1 deg/h/sqrt(h)", SCHULER_DIM_RRW, 8.08022801849227e-8 },
        { "1 deg/h/sqrt(Hz)", SCHULER_DIM_ARW, 0.0166666666666667 * 0.000290888208665722 },
    };
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
        double si = 0.0;
        assert_int_equal(schuler_quantity_parse(units[k].text, units[k].dim, &si, NULL),
                         SCHULER_OK);
        EXACT(si, units[k].si);
    }
    indication x = indication_of("conventional", SCHULER_GYRO);
    give(&x, "scale_factor", 10e-6);
    const double turn = 2.0 * M_PI; /* a second each */
    CHECK_REL(10.0 * (sensed(&x, turn, 0.0, 0.0) - turn) / (deg / 3600.0), 129.6,
              2.0 * 2.3e-16 / 10e-6);
    give(&x, "misalignment", 5.0 * deg / 3600.0);
    EXACT(sensed(&x, 0.0, 1.0, 0.0), 2.42406840554768e-5);
}

/* The filter of a gyro, held input. */
static void b9_bandwidth(void **state)
{
    (void)state;
    const schuler_response r = schuler_second_order(50.0, sqrt(0.5), 1.0 / 400.0);
    EXACT(r.phi[0][0], 0.790189750602037);
    EXACT(r.phi[0][1], 0.00136204480329263);
    EXACT(r.phi[1][0], -134.428433850578);
    EXACT(r.phi[1][1], 0.185049188846429);
    EXACT(r.gamma[0], 0.209810249397963);
    EXACT(r.gamma[1], 134.428433850578);
    EXACT(schuler_second_order_gain(50.0, sqrt(0.5), 20.0), 0.987440631916705);
    EXACT(1e3 * schuler_second_order_delay(50.0, sqrt(0.5)), 4.50158158078553);
    EXACT(schuler_second_order_minus_3_db(50.0, sqrt(0.5)), 50.0);
    EXACT(schuler_second_order_noise_bandwidth(50.0, sqrt(0.5)), 55.5360367269796);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(b1_titterton),
        cmocka_unit_test(scale_factors_bend),
        cmocka_unit_test(b2_ieee_517),
        cmocka_unit_test(b4_inertia),
        cmocka_unit_test(a_tuned_rotor_has_two_channels),
        cmocka_unit_test(a_rotor_may_be_mounted_askew),
        cmocka_unit_test(the_ieee_bracket_is_inverse),
        cmocka_unit_test(fibre_optic_scale_factors),
        cmocka_unit_test(b10_vibratory),
        cmocka_unit_test(vibratory_terms),
        cmocka_unit_test(integral_non_linearity_is_a_cubic),
        cmocka_unit_test(datasheet_figures),
        cmocka_unit_test(b12_b13_units_and_turns),
        cmocka_unit_test(b9_bandwidth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

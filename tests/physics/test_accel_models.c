/* SPDX-License-Identifier: MIT */
/* Accelerometer models against numbers computed with 40 digits from the published equations (A1 to
 * A10), and vibration rectification as it must come out of the instantaneous input. */
#include "indicate.h"
#include "sensors/pendulum.h"
#include "sensors/response.h"

static const double g = 9.80665;

/* Sums of ten terms of about 10 with rounding 1e-16 each. */
#define EXACT(actual, expected) CHECK_REL(actual, expected, 1e-14)

static void a1_titterton(void **state)
{
    (void)state;
    indication x = indication_of("titterton", SCHULER_ACCEL);
    give(&x, "bias", 0.002);
    give(&x, "scale_factor", 250e-6);
    x.values.value[indication_param(&x, "misalignment")][0] = 1e-4; /* xy */
    x.values.value[indication_param(&x, "misalignment")][1] = -2e-4;
    give(&x, "vibropendulous", 3e-6);
    EXACT(indicated(&x, 9.8, -3.2, 1.5), 9.80373592);
}

static void a2_grewal(void **state)
{
    (void)state;
    indication x = indication_of("grewal", SCHULER_ACCEL);
    give_axes(&x, "scale_factor", 300e-6, -200e-6, 150e-6);
    give_axes(&x, "scale_asymmetry", 20e-6, 30e-6, -10e-6);
    give_axes(&x, "scale_quadratic", 1e-6, 2e-6, -1e-6);
    give_axes(&x, "non_orthogonality", 1e-3, 2e-3, -1.5e-3);
    give_axes(&x, "rotation", 0.5e-3, -1e-3, 2e-3);
    give_axes(&x, "bias", 0.01, -0.02, 0.005);
    EXACT(indicated(&x, 4.0, -6.0, -9.81), 3.97886604426998);
    EXACT(x.out[1], -6.04726296589856);
    EXACT(x.out[2], -9.80566583664167);
    /* A2b: directions of the sensing axes x and y from the response to unit inputs. */
    indication y = indication_of("grewal", SCHULER_ACCEL);
    give_axes(&y, "non_orthogonality", 1e-3, 2e-3, -1.5e-3);
    give_axes(&y, "rotation", 0.5e-3, -1e-3, 2e-3);
    double row[2][3], dot = 0.0, xx = 0.0, yy = 0.0;
    for (int j = 0; j < 3; j++) {
        (void)indicated(&y, j == 0, j == 1, j == 2);
        for (int i = 0; i < 2; i++) row[i][j] = y.out[i];
    }
    for (int j = 0; j < 3; j++) {
        dot += row[0][j] * row[1][j];
        xx += row[0][j] * row[0][j];
        yy += row[1][j] * row[1][j];
    }
    CHECK_REL(acos(dot / sqrt(xx * yy)) * 180.0 / M_PI, 90.1716273183813, 1e-14);
}

static void a3_ieee337(void **state)
{
    (void)state;
    indication x = indication_of("ieee337", SCHULER_ACCEL);
    give(&x, "K0", 100e-6 * g);
    give(&x, "K2", 20e-6 / g);
    give(&x, "K3", -5e-6 / (g * g));
    give(&x, "delta_o", 2e-4);
    give(&x, "delta_p", -3e-4);
    give(&x, "K_ip", 15e-6 / g);
    give(&x, "K_io", -8e-6 / g);
    EXACT(indicated(&x, 0.8 * g, 0.5 * g, -0.3 * g) / g, 0.80012816);
    EXACT(1.3 * x.out[0] / g, 1.040166608); /* A3b: times K1 = 1.3 mA/g */
}

static void a4_ieee530(void **state)
{
    (void)state;
    static const char *const switches[] = { "input", "output" };
    for (int k = 0; k < 2; k++) {
        indication x = indication_of("ieee530", SCHULER_ACCEL);
        give(&x, "K0", 1e-4 * g);
        give(&x, "delta_o", 2e-4);
        give(&x, "delta_p", 1e-4);
        give(&x, "K1_minus", 0.002); /* 1002 over the nominal 1000 pulses/s/g */
        choose(&x, "switch", switches[k]);
        EXACT(1000.0 * indicated(&x, 0.9 * g, 0.4 * g, 0.2 * g) / g, 900.16);
        EXACT(1000.0 * indicated(&x, -0.9 * g, 0.4 * g, 0.2 * g) / g, -901.63968);
        /* Between zero and the bias the two switches differ: at zero the input counts as positive,
         * just below it the input is negative and the output is not. */
        const double net = -0.5e-4 * g + 1e-4 * g;
        EXACT(indicated(&x, 0.0, 0.0, 0.0), 1e-4 * g);
        EXACT(indicated(&x, -0.5e-4 * g, 0.0, 0.0), k == 0 ? 1.002 * net : net);
    }
}

static void a5_ieee836(void **state)
{
    (void)state;
    indication x = indication_of("ieee836", SCHULER_ACCEL);
    give(&x, "K0", 1e-3);
    give(&x, "K2", 2e-6);
    give(&x, "K3", -1e-8);
    give(&x, "K_ip", 3e-6);
    give(&x, "K_io", -2e-6);
    give(&x, "K_po", 1e-6);
    give(&x, "delta_o", 1e-4);
    give(&x, "delta_p", 2e-4);
    give(&x, "K_pp", 4e-7);
    give(&x, "K_ppp", 1e-9);
    give(&x, "K_oo", -3e-7);
    give(&x, "K_ooo", 2e-9);
    EXACT(indicated(&x, 20.0, -7.0, 4.0), 19.999626585);
}

static indication full_1293(void)
{
    indication x = indication_of("ieee1293", SCHULER_ACCEL);
    give(&x, "K0", 50e-6 * g);
    give(&x, "K0_asymmetry", 8e-6 * g);
    give(&x, "K1_asymmetry", 30e-6);
    give(&x, "K_oq", 4e-6 / g);
    give(&x, "K2", 10e-6 / g);
    give(&x, "K3", -3e-6 / (g * g));
    give(&x, "K4", 1e-7 / (g * g * g));
    give(&x, "delta_o", 1.5e-4);
    give(&x, "delta_p", -0.5e-4);
    give(&x, "K_ip", 12e-6 / g);
    give(&x, "K_io", -6e-6 / g);
    give(&x, "K_po", 2e-6 / g);
    give(&x, "K_pp", 3e-6 / g);
    give(&x, "K_oo", -1e-6 / g);
    give(&x, "K_spin", -2e-5 * g);
    give(&x, "K_ang", 4e-5 * g);
    x.omega[0] = 0.6;
    x.omega[1] = -0.4;
    x.alpha[2] = 2.0;
    return x;
}

static void a6_ieee1293(void **state)
{
    (void)state;
    indication x = full_1293();
    EXACT(indicated(&x, 2.0 * g, 0.5 * g, -1.5 * g) / g, 2.0002294);
    EXACT(indicated(&x, -2.0 * g, 0.5 * g, -1.5 * g) / g, -1.9998226);
    /* The direction-cosine form is the same misalignment in other words. */
    give(&x, "delta_o", 0.0);
    give(&x, "delta_p", 0.0);
    give(&x, "delta_toward_p", 1.5e-4);
    give(&x, "delta_toward_o", 0.5e-4);
    EXACT(indicated(&x, 2.0 * g, 0.5 * g, -1.5 * g) / g, 2.0002294);
    /* k1 multiplies everything. */
    give(&x, "K1", 1e-3);
    EXACT(indicated(&x, 2.0 * g, 0.5 * g, -1.5 * g) / g, 1.001 * 2.0002294);
    /* The y instrument has z as its pendulous and x as its output axis. */
    x = full_1293();
    x.omega[1] = 0.6, x.omega[2] = -0.4, x.omega[0] = 0.0;
    x.alpha[0] = 2.0, x.alpha[2] = 0.0;
    (void)indicated(&x, -1.5 * g, 2.0 * g, 0.5 * g);
    EXACT(x.out[1] / g, 2.0002294);
}

/* IEEE 530(b) is 1293 with two-sided coefficients. */
static void the_two_sided_form_is_the_same_model(void **state)
{
    (void)state;
    const schuler_two_sided_form two = { 120e-6 * g, 80e-6 * g, 1.3002, 1.2998 };
    const schuler_symmetric_form one = schuler_to_symmetric(two);
    CHECK_REL(one.K0 / g, 1e-4, 1e-14); /* A8 */
    CHECK_REL(one.K0_asymmetry / g, 4e-5, 1e-12);
    EXACT(one.K1, 1.3);
    CHECK_REL(one.K1_asymmetry, 0.000307692307692308, 1e-12);
    const schuler_two_sided_form back = schuler_to_two_sided(one);
    EXACT(back.K0_plus, two.K0_plus);
    EXACT(back.K1_minus, two.K1_minus);
    indication x = indication_of("ieee1293", SCHULER_ACCEL);
    give(&x, "K1_asymmetry", one.K1_asymmetry);
    indication y = indication_of("ieee530", SCHULER_ACCEL);
    give(&y, "K1_plus", 0.5 * one.K1_asymmetry);
    give(&y, "K1_minus", -0.5 * one.K1_asymmetry);
    for (int sign = -1; sign <= 1; sign += 2)
        EXACT(indicated(&x, sign * 7.0, 0.0, 0.0), indicated(&y, sign * 7.0, 0.0, 0.0));
}

static void a7_pendulum(void **state)
{
    (void)state;
    /* g cm^2 and g cm to SI. */
    const schuler_pendulum p = { 0.0125e-7, 0.0035e-7, 0.0110e-7, 0.025e-5, 0.40e-2 };
    double spin, ang;
    schuler_pendulum_coefficients(&p, SCHULER_PA_TOWARD_MASS, &spin, &ang);
    CHECK_REL(spin, -0.04e-2, 1e-13); /* differences that lose two digits */
    CHECK_REL(ang, -0.04e-2, 1e-13);
    CHECK_REL(spin / g, -4.07886485191171e-5, 1e-13);
    schuler_pendulum_coefficients(&p, SCHULER_PA_TOWARD_HINGE, &spin, &ang);
    CHECK_REL(spin, 0.04e-2, 1e-13);
    CHECK_REL(ang, 0.04e-2, 1e-13);
    EXACT(schuler_pendulum_percussion(&p), 0.44e-2);
    indication x = indication_of("ieee1293", SCHULER_ACCEL);
    give(&x, "J_i", p.J_i);
    give(&x, "J_p", p.J_p);
    give(&x, "J_o", p.J_o);
    give(&x, "pendulosity", p.pendulosity);
    give(&x, "r_c", p.r_c);
    give(&x, "pendulum", 1.0);
    x.omega[0] = 2.0, x.omega[1] = 3.0, x.alpha[2] = 5.0;
    CHECK_REL(indicated(&x, 0.0, 0.0, 0.0), 0.04e-2 * (6.0 + 5.0), 1e-12);
    choose(&x, "pa_sense", "toward_mass");
    CHECK_REL(indicated(&x, 0.0, 0.0, 0.0), -0.04e-2 * (6.0 + 5.0), 1e-12);
}

static void a9_datasheet(void **state)
{
    (void)state;
    indication x = indication_of("datasheet", SCHULER_ACCEL);
    give(&x, "range", 30.0 * g);
    give(&x, "bias_of_span", 0.5 * 0.027e-2);
    give(&x, "scale_factor", -0.01);
    give(&x, "misalignment", 0.007);
    choose(&x, "misalignment_form", "printed");
    EXACT(indicated(&x, g, g, 0.0), 9.815863347675);
    choose(&x, "misalignment_form", "geometric");
    EXACT(indicated(&x, g, g, 0.0), 9.81562493334451);
    /* The conservative cross axis, and the two-sided span. */
    indication y = indication_of("datasheet", SCHULER_ACCEL);
    give(&y, "cross_axis", 0.02);
    choose(&y, "cross_from", "both");
    EXACT(indicated(&y, 1.0, 3.0, -4.0), 1.0 + 0.02 * 5.0);
    give(&y, "cross_axis", 0.0);
    give(&y, "range", 10.0);
    give(&y, "bias_of_span", 0.02);
    EXACT(indicated(&y, 0.0, 0.0, 0.0), 0.2);
    choose(&y, "span", "two_sided");
    EXACT(indicated(&y, 0.0, 0.0, 0.0), 0.4);
}

static void el_diasty_is_a_matrix(void **state)
{
    (void)state;
    indication x = indication_of("el_diasty", SCHULER_ACCEL);
    const int S = indication_param(&x, "misalignment"),
              dS = indication_param(&x, "misalignment_residual");
    for (int c = 0; c < 6; c++) {
        x.values.value[S][c] = 1e-3 * (c + 1);
        x.values.value[dS][c] = 1e-5 * (c + 1);
    }
    give_axes(&x, "scale_factor", 1e-3, 2e-3, 3e-3);
    give_axes(&x, "scale_residual", 1e-5, 2e-5, 3e-5);
    give_axes(&x, "bias", 0.1, 0.2, 0.3);
    give_axes(&x, "bias_residual", 0.01, 0.02, 0.03);
    const double f[3] = { 2.0, -3.0, 5.0 };
    static const double M[3][3] = { { 1, 1, 2 }, { 3, 2, 4 }, { 5, 6, 3 } }; /* in 1.01e-3 */
    (void)indicated(&x, f[0], f[1], f[2]);
    for (int i = 0; i < 3; i++) {
        double expected = f[i] + 0.11 * (i + 1);
        for (int j = 0; j < 3; j++) expected += 1.01e-3 * M[i][j] * f[j];
        EXACT(x.out[i], expected);
    }
}

/* 5 g of 20 Hz on the input axis and 3 g on the pendulous axis, chi = 60 deg later. */
typedef struct {
    double A_i, A_p, chi, f_hz;
} shaking;

static void shake(void *user, double t_s, double f[3], double omega[3])
{
    const shaking *const s = user;
    const double w = 2.0 * M_PI * s->f_hz;
    f[0] = s->A_i * sin(w * t_s);
    f[1] = s->A_p * sin(w * t_s + s->chi);
    f[2] = 0.0;
    for (int a = 0; a < 3; a++) omega[a] = 0.0;
}

static double mean_shaken(const indication *x, shaking s)
{
    return indicated_mean(x, shake, &s);
}

/* A step of 10 ms holds a fifth of a period. The integral of sin^2 over whole periods by three nodes in
 * each fifth: the rule's error is that of harmonics aliased to zero, those of order 5: none. So only
 * rounding is left, while the square of the mean would lose 13 %. */
static void vibration_is_rectified_by_itself(void **state)
{
    (void)state;
    const shaking s = { 5.0 * g, 3.0 * g, M_PI / 3.0, 20.0 };
    indication x = indication_of("ieee337", SCHULER_ACCEL);
    give(&x, "K2", 10e-6 / g);
    CHECK_REL(mean_shaken(&x, s) / g, 10e-6 * 0.5 * 25.0, 1e-9);
    give(&x, "K2", 0.0);
    give(&x, "K_ip", 10e-6 / g);
    CHECK_REL(mean_shaken(&x, s) / g, 0.5 * 10e-6 * 15.0 * 0.5, 1e-9);
    indication y = indication_of("titterton", SCHULER_ACCEL);
    give(&y, "vibropendulous", 10e-6 / g);
    CHECK_REL(mean_shaken(&y, s) / g, 0.5 * 10e-6 * 15.0 * 0.5, 1e-9);
}

/* A11: 70 ug/sqrt(Hz) one-sided. */
static void a11_noise_bandwidths(void **state)
{
    (void)state;
    const double v_d = 70e-3; /* mg */
    CHECK_REL(v_d * sqrt(500.0), 1.56524758424985, 1e-14);
    CHECK_REL(v_d * sqrt(0.5 * M_PI * 500.0), 1.96174692573928, 1e-14);
    CHECK_REL(v_d * sqrt(schuler_second_order_noise_bandwidth(500.0, sqrt(0.5))), 1.64962595748915,
              1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a1_titterton),
        cmocka_unit_test(a2_grewal),
        cmocka_unit_test(a3_ieee337),
        cmocka_unit_test(a4_ieee530),
        cmocka_unit_test(a5_ieee836),
        cmocka_unit_test(a6_ieee1293),
        cmocka_unit_test(the_two_sided_form_is_the_same_model),
        cmocka_unit_test(a7_pendulum),
        cmocka_unit_test(a9_datasheet),
        cmocka_unit_test(el_diasty_is_a_matrix),
        cmocka_unit_test(vibration_is_rectified_by_itself),
        cmocka_unit_test(a11_noise_bandwidths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

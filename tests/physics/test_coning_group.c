/* SPDX-License-Identifier: MIT */
/* Attitude algorithms of several samples: their drift in coning, sculling and other motion, against the
 * theory of each. */
#define SCHULER_LANES      1
#define SCHULER_ISA_SUFFIX test
#include "check.h"
#include "mechanization/coning_group.h"
#include "strapdown.h"
#include <stdio.h>
#include <string.h>

static const double W = 2.0 * SCHULER_PI * 5.0;

typedef coning_sample (*motion)(double t1, double t2);

static double half_angle;

static coning_sample coning(double t1, double t2)
{
    return coning_increment(half_angle, W, t1, t2);
}

static coning_sample sculling(double t1, double t2)
{
    return sculling_increment(2e-3, 10.0, W, t1, t2);
}

typedef struct {
    lanes_quat q;
    lanes3 v;
} navigator;

/* As the frames do it: attitude and velocity at each sample, corrected when a group is complete. */
static navigator navigate(const schuler_coning_algorithm *a, motion m, lanes_quat start, double h,
                          int steps)
{
    navigator n = { start, { 0, 0, 0 } };
    lanes3 past_d[SCHULER_PRIME], past_u[SCHULER_PRIME];
    coning_group group = { 0 };
    for (int p = 0; p < SCHULER_PRIME; p++) {
        const coning_sample s = m(-(p + 1) * h, -p * h);
        past_d[p] = s.d;
        past_u[p] = s.u;
    }
    for (int k = 0; k < steps; k++) {
        const coning_sample s = m(k * h, (k + 1) * h);
        const coning_sums sums = coning_first(s, coning_look_back(past_d, a->order),
                                              coning_look_back(past_u, a->order), a->order);
        past_d[2] = past_d[1], past_d[1] = past_d[0], past_d[0] = s.d;
        past_u[2] = past_u[1], past_u[1] = past_u[0], past_u[0] = s.u;
        const lanes3 dv = lanes3_add(rotation_velocity(sums.alpha, sums.upsilon), sums.scul);
        n.v = lanes3_add(n.v, lanes_quat_rotate(n.q, dv));
        n.q = multiply_increment(n.q, rotation_increment(lanes3_add(sums.alpha, sums.beta)));
        coning_correction c;
        if (a->samples > 1 && coning_group_take(&group, a, s, sums, &c)) {
            n.v = lanes3_add(n.v, lanes_quat_rotate(n.q, c.scul));
            n.q = multiply_increment(n.q, rotation_increment(c.beta));
        }
    }
    return n;
}

/* Drift about z, rad/s: whole periods of the cone and whole groups, so its start is its end. */
static double drift(const schuler_coning_algorithm *a, double h, int seconds)
{
    const lanes_quat start = { cos(0.5 * half_angle), sin(0.5 * half_angle), 0.0, 0.0 };
    const navigator n = navigate(a, coning, start, h, (int)lround(seconds / h));
    return turned_about_z(start, n.q) / seconds;
}

static const schuler_coning_algorithm *named(const char *name)
{
    const int i = schuler_coning_algorithm_find(name);
    if (i < 0) fail_msg("no algorithm %s", name);
    return &schuler_coning_algorithms[i];
}

/* What the coefficients of a group leave of the correction a^2/2 (X - sin X), X = N W h: products of
 * samples s apart have z = 4 a^2 sin^2(Wh/2) sin(s W h). */
static double left_by_group(const schuler_coning_algorithm *a, double h)
{
    const double x = W * h, X = a->samples * x, a2 = half_angle * half_angle;
    double made = 0.0;
    for (int j = 1; j < a->samples; j++)
        for (int i = 0; i < j; i++)
            made += a->pair[j][i] * 4.0 * a2 * sin(0.5 * x) * sin(0.5 * x) * sin((j - i) * x);
    return (0.5 * a2 * (X - sin(X)) - made) / (a->samples * h);
}

/* Small cones, so that terms of a^4 are 4e-8 of those of a^2; 1e-14 rad for each of some hundred
 * roundings of a quaternion in a second. */
static void coning_leaves_what_the_coefficients_leave(void **state)
{
    static const char *const names[] = { "optimal_2", "optimal_3", "optimal_4",
                                         "optimal_5", "taylor_3",  "taylor_4" };
    (void)state;
    half_angle = 2e-4;
    for (int i = 0; i < 6; i++) {
        const schuler_coning_algorithm *const a = named(names[i]);
        /* N samples in a group: 60 N in a second of five periods */
        const double h = 1.0 / (60.0 * a->samples);
        CHECK_NEAR(fabs(drift(a, h, 1)), fabs(left_by_group(a, h)),
                   1e-5 * fabs(left_by_group(a, h)) + 1e-13);
    }
}

/* Reference section 6: rho a^2 W (W h)^(2N), h the group's time; the next term is of order (W h)^2. */
static void optimal_coefficients_have_their_order(void **state)
{
    static const double rho[] = { 1.0 / 960, 1.0 / 204120, 1.0 / 82575360, 1.0 / 54140625000.0 };
    (void)state;
    half_angle = 1.0;
    for (int n = 2; n <= 5; n++) {
        char name[16];
        snprintf(name, sizeof name, "optimal_%d", n);
        const schuler_coning_algorithm *const a = named(name);
        const double X = n < 4 ? 0.2 : 0.8, h = X / W / n;
        /* 1e-16 of the terms that cancel, X^3/12 each */
        CHECK_NEAR(fabs(left_by_group(a, h)) / (W * rho[n - 2] * pow(X, 2 * n)), 1.0,
                   0.1 * X * X + 1e-15 * X * X / rho[n - 2] / pow(X, 2 * n));
    }
    /* D6c, deg/h at a = 1 deg and groups of 0.01 s */
    half_angle = SCHULER_RAD_PER_DEG;
    const double degph = SCHULER_RAD_PER_DEG / 3600.0, a2 = half_angle * half_angle;
    CHECK_REL(a2 * W * pow(W * 0.01, 4) / 960 / degph, 0.0200289415328188, 1e-12);
    CHECK_REL(a2 * W * pow(W * 0.01, 6) / 204120 / degph, 9.29701255738837e-6, 1e-12);
    CHECK_REL(a2 * W * pow(W * 0.01, 8) / 82575360 / degph, 2.26818381357545e-9, 1e-12);
}

/* 1 deg, 5 Hz, 100 Hz, an hour: the best public toolbox comes to 82 arc seconds of heading. */
static void a_strong_cone_for_an_hour(void **state)
{
    (void)state;
    half_angle = SCHULER_RAD_PER_DEG;
    /* Beside the terms of a^2 there are some of a^4, 3e-4 of them and of order (W h)^2 or so: 3 arc
     * seconds; a minute of whole groups shows the drift, which is constant. */
    for (const schuler_coning_algorithm *a = schuler_coning_algorithms; a->name; a++) {
        const double found = fabs(drift(a, 0.01, 60));
        const double arcsec = 3600.0 * found / (SCHULER_RAD_PER_DEG / 3600.0);
        print_message("%-10s %10.2f arc seconds in an hour\n", a->name, arcsec);
        if (strcmp(a->name, "optimal_4") == 0 || strcmp(a->name, "optimal_5") == 0)
            assert_true(arcsec < 4.0);
        if (a->samples > 1) CHECK_NEAR(found, fabs(left_by_group(a, 0.01)), 2e-8);
    }
}

/* Duality: mean f_z = D J1(A) of sculling, by groups as by samples. A = 2e-3 rad: terms of third order
 * are A^2/8 = 5e-7 of it; the rest is the residual of coning with D/W for a. */
static void sculling_is_the_dual_of_coning(void **state)
{
    (void)state;
    const double A = 2e-3, D = 10.0;
    for (const schuler_coning_algorithm *a = schuler_coning_algorithms; a->name; a++) {
        if (a->samples == 1) continue;
        const double h = 1.0 / (60.0 * a->samples);
        const lanes_quat start = { 1, 0, 0, 0 };
        const navigator n = navigate(a, sculling, start, h, (int)lround(1.0 / h));
        half_angle = 1.0;
        const double residual =
            fabs(left_by_group(a, h)) / W; /* per a^2 W, of a sine and a cosine */
        CHECK_NEAR(n.v.z / (0.5 * D * A), 1.0, 2.0 * residual + 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coning_leaves_what_the_coefficients_leave),
        cmocka_unit_test(optimal_coefficients_have_their_order),
        cmocka_unit_test(a_strong_cone_for_an_hour),
        cmocka_unit_test(sculling_is_the_dual_of_coning),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Coning, sculling and rotation of one cycle against closed forms, by the scalar build of the
 * headers. */
#define SCHULER_LANES      1
#define SCHULER_ISA_SUFFIX test
#include "check.h"
#include "strapdown.h"

/* A motion gives its increments over [t1, t2]: closed forms. */
typedef coning_sample (*motion)(double t1, double t2);

static const double coning_rad = 2e-3, coning_rps = 2.0 * SCHULER_PI * 5.0;

static coning_sample pure_coning(double t1, double t2)
{
    return coning_increment(coning_rad, coning_rps, t1, t2);
}

static const double sculling_rad = 0.01, sculling_mps2 = 10.0;

static coning_sample sculling(double t1, double t2)
{
    return sculling_increment(sculling_rad, sculling_mps2, coning_rps, t1, t2);
}

/* Savage's SPIN-CONE: section 9.6. */
static coning_sample spin_cone(double t1, double t2)
{
    const double ws = 1.0, wc = 0.1, beta = SCHULER_PI / 4.0, p = ws - wc * cos(beta);
    const double k = wc * sin(beta) / p;
    return (coning_sample){ .d = { ws * (t2 - t1), k * (cos(p * t2) - cos(p * t1)),
                                   -k * (sin(p * t2) - sin(p * t1)) } };
}

typedef struct {
    lanes_quat q;
    lanes3 v; /* in the frame of the start */
} navigator;

/* Attitude and velocity after `cycles` cycles of `samples` samples of h each; primed. */
static navigator navigate(motion m, lanes_quat start, double h, int cycles, int samples, int order)
{
    navigator n = { start, { 0, 0, 0 } };
    lanes3 past_d[SCHULER_PRIME], past_u[SCHULER_PRIME];
    for (int p = 0; p < SCHULER_PRIME; p++) {
        const coning_sample s = m(-(p + 1) * h, -p * h);
        past_d[p] = s.d;
        past_u[p] = s.u;
    }
    for (int c = 0; c < cycles; c++) {
        coning_sums sums = { 0 };
        for (int l = 0; l < samples; l++) {
            const int k = c * samples + l;
            const coning_sample s = m(k * h, (k + 1) * h);
            const coning_before d = coning_look_back(past_d, order);
            const coning_before u = coning_look_back(past_u, order);
            sums = l == 0 ? coning_first(s, d, u, order) : coning_next(sums, s, d, u, order);
            past_d[2] = past_d[1], past_d[1] = past_d[0], past_d[0] = s.d;
            past_u[2] = past_u[1], past_u[1] = past_u[0], past_u[0] = s.u;
        }
        const lanes3 dv = lanes3_add(rotation_velocity(sums.alpha, sums.upsilon), sums.scul);
        n.v = lanes3_add(n.v, lanes_quat_rotate(n.q, dv));
        n.q = multiply_increment(n.q, rotation_increment(lanes3_add(sums.alpha, sums.beta)));
    }
    return n;
}

/* Reference D9, 15 digits. The series stop at alpha^6: the next term, alpha^8/3628800 of alpha x
 * upsilon, is 4e-12 of it for |alpha| = 0.247. */
static void constant_rate_and_force_are_integrated_exactly(void **state)
{
    (void)state;
    const lanes3 v = rotation_velocity((lanes3){ 0.12, -0.08, 0.2 }, (lanes3){ 0.4, 0.8, -3.6 });
    CHECK_NEAR(v.x, 0.444960044853506, 5e-12);
    CHECK_NEAR(v.y, 1.05640704510729, 5e-12);
    CHECK_NEAR(v.z, -3.52441320886919, 5e-12);
}

static void quaternion_increment_is_the_rotation(void **state)
{
    (void)state;
    const lanes_quat d = rotation_increment((lanes3){ 0.1, -0.2, 0.05 });
    const double angle = sqrt(0.01 + 0.04 + 0.0025);
    CHECK_NEAR(1.0 + d.w, cos(0.5 * angle), 1e-15);
    /* First term left out: p^8/(2^9 9!) of the half, 4e-14 of 0.1 here. */
    CHECK_NEAR(d.y, -0.2 / angle * sin(0.5 * angle), 1e-14);
}

/* Published in the reference as D6: increments of coning at 1 deg, 5 Hz (the formula of this file).
 */
static void coning_increments_are_the_reference_values(void **state)
{
    (void)state;
    const coning_sample s = coning_increment(SCHULER_PI / 180.0, coning_rps, 0.10, 0.11);
    CHECK_REL(s.d.x, 0.000854181570073543, 1e-12);
    CHECK_REL(s.d.y, -0.00539309018185934, 1e-12);
    CHECK_REL(s.d.z, -4.78479777787425e-5, 1e-12);
}

/* Coefficients of kappa collected by lag: in pure coning d_j x d_i depends on j - i only. */
static const double coning_two[SCHULER_PRIME] = { 1.0 / 12.0, 0.0, 0.0 };
static const double coning_four[SCHULER_PRIME] = {
    473.0 / 1890.0 + 2.0 / 315.0 + 1.0 / 3780.0,
    -1919.0 / 15120.0 - 29.0 / 15120.0,
    53.0 / 1890.0,
};

/* Drift about z in pure coning, of small a. A step of h has the correction a^2/2 (Wh - sin Wh);
 * products of samples s apart have z = 4 a^2 sin^2(Wh/2) sin(s W h) (sign of the cone). What the
 * coefficients leave is the difference: a closed form for any set. a^4 terms are a^2 = 4e-6 of it.
 */
static double coning_left(double h, const double c[SCHULER_PRIME])
{
    const double x = coning_rps * h, a2 = coning_rad * coning_rad;
    double made = 0.0;
    for (int s = 0; s < SCHULER_PRIME; s++)
        made += c[s] * 4.0 * a2 * sin(0.5 * x) * sin(0.5 * x) * sin((s + 1) * x);
    return (0.5 * a2 * (x - sin(x)) - made) / h; /* rad/s */
}

static double coning_drift(double h, int samples, int order)
{
    /* One second: whole periods of the cone, so the start's attitude is the end's. */
    const int cycles = (int)lround(1.0 / (h * samples));
    const lanes_quat start = { cos(0.5 * coning_rad), sin(0.5 * coning_rad), 0.0, 0.0 };
    const navigator n = navigate(pure_coning, start, h, cycles, samples, order);
    return turned_about_z(start, n.q);
}

static void coning_leaves_what_the_theory_says(void **state)
{
    (void)state;
    for (double h = 0.02; h > 0.002; h *= 0.5) {
        /* 1e-14: a hundred to five hundred roundings of a quaternion of 1. */
        CHECK_NEAR(fabs(coning_drift(h, 1, 2)), fabs(coning_left(h, coning_two)),
                   4e-6 * fabs(coning_left(h, coning_two)) + 1e-14);
        CHECK_NEAR(fabs(coning_drift(h, 1, 4)), fabs(coning_left(h, coning_four)),
                   4e-6 * fabs(coning_left(h, coning_four)) + 1e-14);
    }
    /* Reference section 6: one sample and the previous one leave a^2 W (Wh)^4/60, to the next
     * order. */
    const double h = 0.0025, x = coning_rps * h;
    CHECK_REL(coning_left(h, coning_two), coning_rad * coning_rad * coning_rps * pow(x, 4) / 60.0,
              x * x);
    /* Without any correction: the reference's a^2/2 W (1 - sin(Wh)/(Wh)). */
    const double none[SCHULER_PRIME] = { 0 };
    CHECK_REL(coning_left(h, none), 0.5 * coning_rad * coning_rad * coning_rps * (1.0 - sin(x) / x),
              1e-9);
}

static void halving_the_step_divides_coning_by_sixteen(void **state)
{
    (void)state;
    /* Order four; the next term is (Wh)^2/21 of it or so: 2 % at h = 0.0025 s. */
    const double ratio = coning_drift(0.005, 1, 2) / coning_drift(0.0025, 1, 2);
    CHECK_REL(ratio, 16.0, 0.03);
}

static void a_cycle_of_several_samples_is_as_good(void **state)
{
    (void)state;
    /* The two-speed form moves the products about but leaves the same drift: the sample's own. */
    for (int samples = 2; samples <= 5; samples += 3)
        CHECK_REL(coning_drift(0.01, samples, 2), coning_drift(0.01, 1, 2), 1e-4);
}

/* Mean f_z = D J1(A): D8, exact. Left: the recursion's (Wh)^4 error, as for coning (duality), about
 * (Wh)^4/30 of the rectified 0.05 m/s^2. */
static void sculling_rectifies_to_the_bessel_value(void **state)
{
    (void)state;
    const lanes_quat start = { 1, 0, 0, 0 };
    for (int order = 2; order <= 4; order += 2) {
        const double h = 0.0025, x = coning_rps * h;
        const navigator n = navigate(sculling, start, h, 400, 1, order);
        CHECK_REL(n.v.z, 0.0499993750026042, pow(x, 4) / 15.0);
        CHECK_NEAR(n.v.y, 0.0, 1e-9);
    }
}

/* D7, D7c: attitude after 10 s of SPIN-CONE. */
static void spin_cone_ends_at_the_reference_attitude(void **state)
{
    (void)state;
    /* Start: roll 0, pitch 45 deg, yaw 0. */
    const lanes_quat start = { cos(SCHULER_PI / 8.0), 0.0, sin(SCHULER_PI / 8.0), 0.0 };
    const navigator n = navigate(spin_cone, start, 0.01, 1000, 1, 4);
    const lanes3 x = lanes_quat_rotate(n.q, (lanes3){ 1, 0, 0 });
    const lanes3 y = lanes_quat_rotate(n.q, (lanes3){ 0, 1, 0 });
    const lanes3 z = lanes_quat_rotate(n.q, (lanes3){ 0, 0, 1 });
    /* The rate is 1 rad/s, so a step's Taylor terms fall by (0.01)^k: the cubic leaves (0.01)^4 of
     * a coning of 0.1 rad/s, a fraction of 1e-2 of it: 1e-11 rad/s, 1e-10 rad in 10 s. Two samples
     * leave 1e-8 rad. */
    CHECK_NEAR(x.x, 0.38205142437009, 1e-10);
    CHECK_NEAR(y.x, -0.783922674591793, 1e-10);
    CHECK_NEAR(z.x, -0.489389363797004, 1e-10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_rate_and_force_are_integrated_exactly),
        cmocka_unit_test(quaternion_increment_is_the_rotation),
        cmocka_unit_test(coning_increments_are_the_reference_values),
        cmocka_unit_test(coning_leaves_what_the_theory_says),
        cmocka_unit_test(halving_the_step_divides_coning_by_sixteen),
        cmocka_unit_test(a_cycle_of_several_samples_is_as_good),
        cmocka_unit_test(sculling_rectifies_to_the_bessel_value),
        cmocka_unit_test(spin_cone_ends_at_the_reference_attitude),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

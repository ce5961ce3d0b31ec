/* SPDX-License-Identifier: MIT */
/* The one-noise filter against the covariances of the increments that it stands for. */
#include "check.h"
#include "sensors/markov_filter.h"
#include "sensors/processes.h"
#include <math.h>

enum { MAX = SCHULER_MARKOV_MAX };

/* Covariance of two increments n steps apart, of sigma^2 T^2 times: 2 (x - 1 + e^-x) for n = 0, and
 * (1 - e^-x)^2 e^-((n - 1) x) after that. The first cancels for small x: Taylor below 1e-3. */
static double increments(const schuler_markov_process *p, int members, double dt_s, double n)
{
    double sum = 0.0;
    for (int i = 0; i < members; i++) {
        const double x = dt_s / p[i].T_s, variance = p[i].sigma * p[i].sigma * p[i].T_s * p[i].T_s;
        const double ramp =
            x < 1e-3 ? x * x * (0.5 - x * (1.0 / 6 - x * (1.0 / 24 - x / 120))) : x + expm1(-x);
        sum += variance * (n == 0.0 ? 2.0 * ramp : expm1(-x) * expm1(-x) * exp(-(n - 1.0) * x));
    }
    return sum;
}

/* The same of the filter: the covariance P of its states at the start is l l^T; the sample is
 * direct e + sum x, and after it the states correlate with it by phi P 1 + feed direct. */
static double filtered(const schuler_markov_filter *f, double l[MAX][MAX], double n)
{
    double sum = n == 0.0 ? f->direct * f->direct : 0.0;
    for (int i = 0; i < f->members; i++) {
        double row = 0.0;
        for (int j = 0; j < f->members; j++)
            for (int k = 0; k <= i && k <= j; k++) row += l[i][k] * l[j][k];
        sum +=
            n == 0.0 ? row : exp(-(n - 1.0) * f->x[i]) * (f->phi[i] * row + f->feed[i] * f->direct);
    }
    return sum;
}

/* P is kept by the filter: P = phi P phi + feed feed^T. */
static void check_stationary(const schuler_markov_filter *f, double l[MAX][MAX])
{
    for (int i = 0; i < f->members; i++)
        for (int j = 0; j <= i; j++) {
            double P = 0.0;
            for (int k = 0; k <= j; k++) P += l[i][k] * l[j][k];
            CHECK_REL(P * -expm1(-f->x[i] - f->x[j]), f->feed[i] * f->feed[j], 1e-9);
        }
}

/* Sums of some hundred terms: rounding stays far below 1e-11. */
static void check(const schuler_markov_process *p, int members, double dt_s)
{
    double l[MAX][MAX];
    const schuler_markov_filter f = schuler_markov_filter_of(p, members, dt_s);
    assert_int_equal(f.members, members);
    schuler_markov_filter_start(&f, l);
    check_stationary(&f, l);
    const double variance = increments(p, members, dt_s, 0.0);
    for (double n = 0.0; n < 1e7; n = n < 4.0 ? n + 1.0 : floor(3.0 * n))
        CHECK_NEAR(filtered(&f, l, n) / variance, increments(p, members, dt_s, n) / variance,
                   1e-11);
}

static void one_process_of_any_time(void **state)
{
    (void)state;
    for (double T_s = 1e-4; T_s < 1e9; T_s *= 7.0) {
        const schuler_markov_process p = { T_s, 3.0 };
        check(&p, 1, 0.01);
    }
}

static void processes_of_any_ratio(void **state)
{
    (void)state;
    const schuler_markov_process near[3] = { { 1.0, 1.0 }, { 1.001, 2.0 }, { 1.3, 0.1 } };
    const schuler_markov_process far[3] = { { 1e-3, 1.0 }, { 1.0, 1e-3 }, { 1e6, 50.0 } };
    for (double dt_s = 1e-3; dt_s < 2.0; dt_s *= 10.0) {
        check(near, 3, dt_s);
        check(far, 3, dt_s < 0.1 ? dt_s : 0.1);
    }
}

static void banks_of_flicker_noise(void **state)
{
    (void)state;
    for (double dt_s = 1e-4; dt_s < 20.0; dt_s *= 10.0)
        for (double shortest_s = 0.0; shortest_s < 5.0; shortest_s += 2.0) {
            const schuler_flicker_bank bank = schuler_flicker_bank_of(shortest_s, 1e5, dt_s);
            schuler_markov_process p[MAX];
            for (int i = 0; i < bank.members; i++) p[i] = schuler_flicker_bank_member(&bank, 1, i);
            check(p, bank.members, dt_s);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_process_of_any_time),
        cmocka_unit_test(processes_of_any_ratio),
        cmocka_unit_test(banks_of_flicker_noise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

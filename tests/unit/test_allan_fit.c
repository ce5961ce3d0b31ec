/* SPDX-License-Identifier: MIT */
/* The fit: what is put in comes back, and its limits hold what they promise. */
#include "check.h"
#include "sensors/allan_covariance.h"
#include "sensors/allan_fit.h"
#include "simulated_noise.h"
#include <stdlib.h>
#include <string.h>

enum { TERMS = SCHULER_ALLAN_TERMS, ALL = (1 << TERMS) - 1 };
static const double DT_S = 0.01;

typedef struct {
    int64_t n, m[SCHULER_ALLAN_POINTS_MAX];
    int count;
    schuler_flicker_bank bank;
    schuler_allan_design *design;
} bench;

static bench bench_of(int64_t n, int ideal)
{
    bench b = { .n = n };
    b.count = schuler_allan_factors(n, 10, b.m, SCHULER_ALLAN_POINTS_MAX);
    b.bank = schuler_flicker_bank_of(SCHULER_FLICKER_SHORTEST_S, SCHULER_FLICKER_LONGEST_S, DT_S);
    if (ideal) b.bank.members = 0;
    assert_int_equal(schuler_allan_design_create(&b.design, n, DT_S, b.m, b.count, &b.bank),
                     SCHULER_OK);
    return b;
}

static double theory(const bench *b, const noise_coefficients *c, int i)
{
    const double tau_s = (double)b->m[i] * DT_S;
    return schuler_process_quantization(c->Q, tau_s) + schuler_process_white(c->N, tau_s) +
           (b->bank.members ? schuler_process_flicker_bank(&b->bank, c->B, tau_s)
                            : schuler_process_flicker(c->B, tau_s)) +
           schuler_process_random_walk(c->K, tau_s) + schuler_process_ramp(c->R, tau_s);
}

/* Of exact variances nothing is left to chance; the coefficients return as well as the weighted normal
 * equations, of condition below 1e6, let them. */
static void exact_variances_give_exact_coefficients(void **state)
{
    static const noise_coefficients c = { 2e-3, 1.0, 0.8, 0.3, 0.05, 0.0 };
    const double *const wanted = &c.Q;
    (void)state;
    for (int ideal = 0; ideal < 2; ideal++) {
        bench b = bench_of(1000000, ideal);
        double sigma2[SCHULER_ALLAN_POINTS_MAX];
        schuler_allan_fit fit;
        for (int i = 0; i < b.count; i++) sigma2[i] = theory(&b, &c, i);
        assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, ALL, 0.95, &fit), SCHULER_OK);
        for (int k = 0; k < TERMS; k++) {
            CHECK_REL(fit.term[k].value, wanted[k], 1e-8);
            assert_true(fit.term[k].lower <= wanted[k] && wanted[k] <= fit.term[k].upper);
        }
        CHECK_NEAR(fit.worst, 0.0, 1e-6);
        for (int i = 0; i < b.count; i++)
            CHECK_REL(schuler_allan_fit_at(b.design, &fit, i), sigma2[i], 1e-8);
        schuler_allan_design_free(b.design);
    }
}

/* The variance of one sigma^2 is 2 sigma^4/edf; the tables' edf are good to 5 %, and theirs are for long
 * records: compared where n/m is 30 at least, within 12 %. */
static void variances_agree_with_the_degrees_of_freedom(void **state)
{
    static const int terms[3] = { SCHULER_ALLAN_WHITE, SCHULER_ALLAN_FLICKER,
                                  SCHULER_ALLAN_RANDOM_WALK };
    static const schuler_noise_kind kinds[3] = { SCHULER_NOISE_WHITE, SCHULER_NOISE_FLICKER,
                                                 SCHULER_NOISE_RANDOM_WALK };
    const int64_t n = 20000;
    const schuler_flicker_bank ideal = { 0 };
    int64_t m[SCHULER_ALLAN_POINTS_MAX];
    allan_covariance v;
    (void)state;
    const int count = schuler_allan_factors(n, 10, m, SCHULER_ALLAN_POINTS_MAX);
    assert_int_equal(allan_covariance_create(&v, n, 1.0, m, count, &ideal), SCHULER_OK);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < count && m[i] < n / 30; i++) {
            double c[TERMS] = { 0 };
            c[terms[k]] = 1.0;
            const double sigma2 = k == 0   ? schuler_process_white(1.0, (double)m[i])
                                  : k == 1 ? schuler_process_flicker(1.0, (double)m[i])
                                           : schuler_process_random_walk(1.0, (double)m[i]);
            const double dof = 2.0 * sigma2 * sigma2 / allan_covariance_at(&v, i, i, c);
            CHECK_REL(dof, schuler_allan_dof(kinds[k], n + 1, m[i]), 0.12);
        }
    allan_covariance_free(&v);
}

/* Covariances between different tau against their own sum over all pairs, by the definition, for white
 * noise and quantization of a record short enough for that. */
static void covariances_are_the_sums_that_define_them(void **state)
{
    enum { N = 400 };
    static const int64_t m[4] = { 1, 3, 25, 60 };
    const schuler_flicker_bank ideal = { 0 };
    allan_covariance v;
    (void)state;
    assert_int_equal(allan_covariance_create(&v, N, 0.5, m, 4, &ideal), SCHULER_OK);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j <= i; j++) {
            /* Var of the sum of products: 2 R^2 for each pair, R = covariance of two second
             * differences of phase: of white noise min over overlaps, here by summing increments. */
            double sum = 0.0;
            for (int64_t a = 0; a + 2 * m[i] <= N; a++)
                for (int64_t b = 0; b + 2 * m[j] <= N; b++) {
                    double R = 0.0;
                    for (int64_t t = a > b ? a : b; t < a + 2 * m[i] && t < b + 2 * m[j]; t++)
                        R += ((t < a + m[i]) == (t < b + m[j]) ? 1.0 : -1.0) * 0.5;
                    sum += 2.0 * R * R;
                }
            const double ti = 0.5 * (double)m[i], tj = 0.5 * (double)m[j];
            sum /=
                4.0 * ti * ti * tj * tj * (double)(N - 2 * m[i] + 1) * (double)(N - 2 * m[j] + 1);
            const double c[TERMS] = { 0.0, 1.0, 0.0, 0.0, 0.0 };
            CHECK_REL(allan_covariance_at(&v, i, j, c), sum, 0.01);
            CHECK_NEAR(allan_covariance_at(&v, i, j, c), allan_covariance_at(&v, j, i, c), 0.0);
        }
    allan_covariance_free(&v);
}

/* In each of the runs the limits either hold the true value or not: of RUNS with probability 0.95 the
 * number inside has a sigma of sqrt(RUNS 0.05 0.95). Demanded is 0.9, which 0.95 misses by chance once in
 * a thousand times. A term that is not there has an upper limit to stay above 0 and no lower one. */
static void coverage(const noise_coefficients *c, int64_t n, unsigned terms)
{
    enum { RUNS = 200 };
    bench b = bench_of(n, 0);
    double *const phase = malloc((size_t)(n + 1) * sizeof(double));
    const double *const truth = &c->Q;
    int inside[TERMS] = { 0 }, seen[TERMS] = { 0 };
    double worst = 0.0;
    assert_non_null(phase);
    for (int run = 0; run < RUNS; run++) {
        double sigma2[SCHULER_ALLAN_POINTS_MAX];
        schuler_allan_fit fit;
        noise_simulate(c, (uint64_t)run, n, phase);
        schuler_allan_phase(phase, n, 1.0, phase);
        assert_int_equal(schuler_allan_overlapping(phase, n, DT_S, b.m, b.count, sigma2, NULL),
                         SCHULER_OK);
        assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, terms, 0.95, &fit), SCHULER_OK);
        for (int k = 0; k < TERMS; k++) {
            inside[k] += fit.term[k].lower <= truth[k] && truth[k] <= fit.term[k].upper;
            seen[k] += fit.term[k].state == SCHULER_ALLAN_FITTED;
        }
        worst = fmax(worst, fit.worst);
    }
    for (int k = 0; k < TERMS; k++) {
        if (!(terms >> k & 1)) continue;
        if (inside[k] < 0.9 * RUNS) {
            print_error("term %d of value %g: %d of %d limits hold it\n", k, truth[k], inside[k],
                        RUNS);
            fail();
        }
        /* What is not there is not reported, but for the tail of the limits. */
        if (truth[k] == 0.0) assert_true(seen[k] <= 0.1 * RUNS);
    }
    /* The normal tail beyond 5 sigma is 6e-7, that of a chi-square of two degrees of freedom, as the last
     * tau have, 2.5e-3: among 36 correlated tau and 200 runs a few are expected, none far beyond. */
    assert_true(worst < 8.0);
    free(phase);
    schuler_allan_design_free(b.design);
}

static void limits_hold_each_process_alone(void **state)
{
    (void)state;
    coverage(&(noise_coefficients){ .N = 1.0, .dt_s = DT_S }, 20000, ALL);
    coverage(&(noise_coefficients){ .B = 1.0, .dt_s = DT_S }, 20000, ALL);
    coverage(&(noise_coefficients){ .K = 1.0, .dt_s = DT_S }, 20000, ALL);
    coverage(&(noise_coefficients){ .Q = 1.0, .dt_s = DT_S }, 20000, ALL);
    coverage(&(noise_coefficients){ .N = 1.0, .R = 0.1, .dt_s = DT_S }, 20000, ALL);
}

static void limits_hold_all_processes_together(void **state)
{
    (void)state;
    coverage(&(noise_coefficients){ 2e-3, 1.0, 0.8, 0.15, 0.0, DT_S }, 20000, ALL);
    coverage(&(noise_coefficients){ 0.0, 0.1, 0.3, 0.3, 0.0, DT_S }, 20000, 0xe);
}

/* A term that is asked for alone takes all there is; the others have no value. */
static void terms_that_were_not_asked_for_are_left_out(void **state)
{
    bench b = bench_of(5000, 0);
    double sigma2[SCHULER_ALLAN_POINTS_MAX];
    schuler_allan_fit fit;
    (void)state;
    for (int i = 0; i < b.count; i++) sigma2[i] = schuler_process_white(2.0, (double)b.m[i] * DT_S);
    assert_int_equal(
        schuler_allan_fit_terms(b.design, sigma2, 1u << SCHULER_ALLAN_WHITE, 0.95, &fit),
        SCHULER_OK);
    for (int k = 0; k < TERMS; k++)
        assert_int_equal(fit.term[k].state,
                         k == SCHULER_ALLAN_WHITE ? SCHULER_ALLAN_FITTED : SCHULER_ALLAN_NOT_ASKED);
    CHECK_REL(fit.term[SCHULER_ALLAN_WHITE].value, 2.0, 1e-12);
    schuler_allan_design_free(b.design);
}

/* A sinusoid is none of the five terms: the fit says so. */
static void what_the_terms_do_not_explain_is_told(void **state)
{
    bench b = bench_of(100000, 0);
    double sigma2[SCHULER_ALLAN_POINTS_MAX];
    schuler_allan_fit fit;
    (void)state;
    for (int i = 0; i < b.count; i++) {
        const double tau_s = (double)b.m[i] * DT_S;
        sigma2[i] = schuler_process_white(1.0, tau_s) + schuler_process_sinusoid(2.0, 0.5, tau_s);
    }
    assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, ALL, 0.95, &fit), SCHULER_OK);
    assert_true(fit.worst > 10.0);
    assert_true(fit.worst_tau_s > 0.1 && fit.worst_tau_s < 5.0);
    schuler_allan_design_free(b.design);
}

static void odd_records_are_no_trouble(void **state)
{
    double sigma2[SCHULER_ALLAN_POINTS_MAX] = { 0 };
    schuler_allan_fit fit;
    schuler_allan_design *none;
    const int64_t too_long = 6;
    (void)state;
    bench b = bench_of(16, 0); /* four tau for five terms */
    for (int all = 0; all < 2; all++) {
        assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, ALL, 0.95, &fit), SCHULER_OK);
        for (int k = 0; k < TERMS; k++) {
            assert_true(isfinite(fit.term[k].value) && isfinite(fit.term[k].lower));
            assert_true(isfinite(fit.term[k].upper));
        }
        for (int i = 0; i < b.count; i++) sigma2[i] = 1.0 / (1.0 + i); /* the second time */
    }
    sigma2[1] = 0.0; /* whole counts that did not move */
    assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, ALL, 0.95, &fit), SCHULER_OK);
    sigma2[1] = nan("");
    assert_int_equal(schuler_allan_fit_terms(b.design, sigma2, ALL, 0.95, &fit),
                     SCHULER_ERR_NUMERIC);
    schuler_allan_design_free(b.design);
    assert_int_equal(schuler_allan_design_create(&none, 16, DT_S, &too_long, 1, &b.bank),
                     SCHULER_ERR_INPUT);
    schuler_allan_design_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_variances_give_exact_coefficients),
        cmocka_unit_test(variances_agree_with_the_degrees_of_freedom),
        cmocka_unit_test(covariances_are_the_sums_that_define_them),
        cmocka_unit_test(limits_hold_each_process_alone),
        cmocka_unit_test(limits_hold_all_processes_together),
        cmocka_unit_test(terms_that_were_not_asked_for_are_left_out),
        cmocka_unit_test(what_the_terms_do_not_explain_is_told),
        cmocka_unit_test(odd_records_are_no_trouble),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

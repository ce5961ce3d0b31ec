/* SPDX-License-Identifier: MIT */
/* What every sensor model and every stage must do. The loops run over the tables: each parameter is
 * set to its own example, read as a user would write it. */
#include "specimen.h"
#include <ctype.h>
#include <float.h>

static measured a, b, c, d;

/* So that sums over all of it may run in one loop. */
static const double *flat(measured x)
{
    return (const double *)x;
}

static void assert_true_increments(const specimen *s, double measured_increments[3][STEPS])
{
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < STEPS; k++)
            if (measured_increments[axis][k] != true_increment(s->instrument, axis, k))
                fail_msg("%s, %s: axis %d, step %d: %.17g", s->model->name,
                         schuler_instrument_name(s->instrument), axis, k,
                         measured_increments[axis][k]);
}

static void off_is_identity(const specimen *s)
{
    schuler_lane_spec spec = s->on;
    for (int k = 0; s->params[k].key; k++)
        if (s->params[k].number) memset(spec.value[k], 0, sizeof spec.value[k]);
    measure(s, &s->off, 1, a);
    measure(s, &spec, 1, b);
    for (int r = 0; r < RUNS; r++) {
        assert_true_increments(s, a[r]);
        assert_true_increments(s, b[r]);
    }
}

static void errors_off_is_the_identity_bit_for_bit(void **state)
{
    (void)state;
    for_each(off_is_identity);
}

/* Lanes of one vector differ in what is on: every fourth has nothing. */
static void widths_agree(const specimen *s)
{
    static schuler_lane_spec specs[RUNS];
    for (int r = 0; r < RUNS; r++) {
        specs[r] = s->on;
        for (int k = 0; s->params[k].key; k++)
            for (int i = 0; i < s->params[k].components && s->params[k].number; i++)
                specs[r].value[k][i] *= r % 4 == 3 ? 0.0 : 1.0 - 0.03 * r - 0.01 * i;
    }
    memset(a, 0, sizeof a);
    measure_each(SCHULER_ISA_SCALAR, s, specs, 11, a);
    for (int at = 0; at < RUNS * 3 * STEPS; at++) assert_true(isfinite(flat(a)[at]));
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
        if (!schuler_isa_available((schuler_isa)isa)) continue;
        memset(b, 0, sizeof b);
        measure_each((schuler_isa)isa, s, specs, 11, b);
        assert_memory_equal(a, b, sizeof a);
        for (int r = 3; r < RUNS; r += 4) assert_true_increments(s, b[r]);
    }
}

static void every_width_gives_the_same_bits_and_lanes_do_not_see_each_other(void **state)
{
    (void)state;
    for_each(widths_agree);
}

static int find(const specimen *s, const char *key)
{
    for (int k = 0; s->params[k].key; k++)
        if (strcmp(s->params[k].key, key) == 0) return k;
    return -1;
}

/* Settings and what one source needs beside it at their examples; the source itself where it is
 * `with`. */
static schuler_lane_spec just(const specimen *s, int source, bool with)
{
    schuler_lane_spec spec = s->on;
    const char *const needs = s->params[source].companion;
    for (int k = 0; s->params[k].key; k++)
        if (s->params[k].number && !(k == source && with) && (!needs || k != find(s, needs)))
            memset(spec.value[k], 0, sizeof spec.value[k]);
    return spec;
}

static void sources_act(const specimen *s)
{
    for (int k = 0; s->params[k].key; k++) {
        if (!s->params[k].number) continue;
        const schuler_lane_spec with = just(s, k, true), without = just(s, k, false);
        measure(s, &with, 5, a);
        measure(s, &without, 5, b);
        measure(s, &with, 6, c);
        bool acts = false;
        for (int axis = 0; axis < 3; axis++)
            acts |= memcmp(a[0][axis], b[0][axis], sizeof a[0][axis]) != 0;
        if (!acts) fail_msg("%s: %s does nothing", s->model->name, s->params[k].key);
        /* Another seed moves what is random at each step; what is drawn once is drawn elsewhere. */
        if (s->params[k].noisy) {
            assert_memory_not_equal(a, c, sizeof a);
            assert_memory_not_equal(a[0], a[1], sizeof a[0]);
        }
        measure(s, &with, 5, c);
        assert_memory_equal(a, c, sizeof a);
    }
}

static void every_source_does_something_and_repeats(void **state)
{
    (void)state;
    for_each(sources_act);
}

static bool is_additive(const schuler_param *p)
{
    return p->acts != SCHULER_ACTS_NOT && p->acts != SCHULER_ACTS_RESPONSE &&
           p->acts != SCHULER_ACTS_COUNTS;
}

/* What noise A adds, with and without B. A sum has at most as many roundings as the chain has
 * parameters, half a unit of the largest increment each; four sums are compared. The noise itself is
 * millions of times that. */
static void noise_is_its_own(const specimen *s)
{
    int own = 0;
    while (s->model->params[s->instrument][own].key) own++;
    for (int noise = 0; s->params[noise].key; noise++) {
        if (!s->params[noise].noisy || !is_additive(&s->params[noise])) continue;
        const schuler_lane_spec alone = just(s, noise, true);
        measure(s, &alone, 3, a);
        for (int other = 0; s->params[other].key; other++) {
            if (!is_additive(&s->params[other]) || other == noise) continue;
            /* Such a model says itself how much white noise there is. */
            if (other < own && s->model->noise_excess) continue;
            schuler_lane_spec both = just(s, other, true), rest = just(s, other, true);
            memcpy(both.value[noise], s->on.value[noise], sizeof both.value[noise]);
            memset(rest.value[noise], 0, sizeof rest.value[noise]);
            measure(s, &both, 3, b);
            measure(s, &rest, 3, d);
            double largest = 0.0;
            for (int at = 0; at < RUNS * 3 * STEPS; at++)
                largest = fmax(largest, fabs(flat(b)[at]));
            for (int at = 0; at < RUNS * 3 * STEPS; at++) {
                const double x = true_increment(s->instrument, at / STEPS % 3, at % STEPS);
                const double added = flat(b)[at] - flat(d)[at], expected = flat(a)[at] - x;
                if (fabs(added - expected) > 4 * SCHULER_PARAMS_MAX * 0.5 * DBL_EPSILON * largest)
                    fail_msg("%s: %s is other noise when %s is on", s->model->name,
                             s->params[noise].key, s->params[other].key);
            }
        }
    }
}

static void a_source_changes_no_sample_of_another(void **state)
{
    (void)state;
    for_each(noise_is_its_own);
}

static void check_param(const specimen *s, const schuler_param *p)
{
    static const char *const taken[] = { "model", "use", "noise_density", "sided", "allan_floor" };
    assert_true(isalpha((unsigned char)p->key[0]));
    for (const char *at = p->key; *at; at++) assert_true(isalnum((unsigned char)*at) || *at == '_');
    for (size_t k = 0; k < sizeof taken / sizeof taken[0]; k++)
        assert_string_not_equal(p->key, taken[k]);
    assert_true(p->doc && p->example);
    assert_true(p->components == 1 || p->components == 3 || p->components == 6 ||
                p->components == 9);
    if (p->choices)
        assert_true(p->number == 0 && p->components == 1 && p->choices[0]);
    else
        assert_true(isfinite(p->min) && isfinite(p->max) && p->min < p->max);
    if (p->companion) assert_true(find(s, p->companion) >= 0);
    assert_int_equal(p->number != 0, p->acts != SCHULER_ACTS_NOT);
    if (p->number) {
        assert_non_null(p->formula);
        assert_true(p->number >= 100 && p->number < 1000);
        assert_true(p->def == 0.0);
    } else if (!p->choices) {
        assert_true(p->def >= p->min && p->def <= p->max);
    }
}

typedef struct {
    schuler_instrument instrument;
    unsigned number;
    char key[64];
} named;

static named seen[4096];
static int seen_count;

static void tables_hold(const specimen *s)
{
    assert_true(s->model->name && s->model->summary && s->model->source);
    for (int k = 0; s->params[k].key; k++) {
        const schuler_param *const p = &s->params[k];
        check_param(s, p);
        assert_int_equal(find(s, p->key), k); /* no key twice */
        if (!p->number) continue;
        bool known = false;
        for (int i = 0; i < seen_count; i++) {
            const bool same_key =
                seen[i].instrument == s->instrument && strcmp(seen[i].key, p->key) == 0;
            if (same_key != (seen[i].number == p->number))
                fail_msg("%s.%s has number %u, %s has %u", s->model->name, p->key, p->number,
                         seen[i].key, seen[i].number);
            known |= same_key;
        }
        if (known) continue;
        assert_true(seen_count < (int)(sizeof seen / sizeof seen[0]));
        seen[seen_count] = (named){ .instrument = s->instrument, .number = p->number };
        snprintf(seen[seen_count++].key, sizeof seen[0].key, "%s", p->key);
    }
}

static void tables_are_complete_and_a_key_has_one_number(void **state)
{
    (void)state;
    seen_count = 0;
    for_each(tables_hold);
    assert_true(seen_count > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_off_is_the_identity_bit_for_bit),
        cmocka_unit_test(every_width_gives_the_same_bits_and_lanes_do_not_see_each_other),
        cmocka_unit_test(every_source_does_something_and_repeats),
        cmocka_unit_test(a_source_changes_no_sample_of_another),
        cmocka_unit_test(tables_are_complete_and_a_key_has_one_number),
    };
    return cmocka_run_group_tests(tests, move, NULL);
}

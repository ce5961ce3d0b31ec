/* SPDX-License-Identifier: MIT */
/* What every sensor model must do, and that lane code gives the same bits at every width. */
#include "check.h"
#include "core/truth.h"
#include "sensors/model.h"
#include <stdlib.h>
#include <string.h>

enum { RUNS = 16, BLOCKS = 5 };

/* True increments that look like flight, all different, none of them zero. */
static double truth_sample(int instrument, int axis, int64_t step)
{
    const double t = (double)step * 0.01;
    return (instrument == SCHULER_GYRO ? 1e-3 : 0.1) * sin(1.0 + axis + (0.7 + 0.3 * axis) * t);
}

/* Measured increments of RUNS lanes, [run][axis][step]. */
typedef double measured[RUNS][3][BLOCKS * SCHULER_BLOCK];

static void measure(schuler_isa isa, int model, schuler_instrument instrument,
                    const schuler_lane_spec *common, uint64_t seed, measured out)
{
    const schuler_sensor_model *m = schuler_sensor_models(isa)[model];
    const int width = schuler_isa_lanes(isa);
    const size_t bytes = (m->state_size + 63) / 64 * 64;
    void *state = aligned_alloc(64, bytes);
    double *y = aligned_alloc(64, (size_t)3 * SCHULER_BLOCK * 8 * sizeof(double));
    assert_non_null(state);
    assert_non_null(y);
    for (int first_run = 0; first_run < RUNS; first_run += width) {
        schuler_lane_spec specs[8];
        for (int l = 0; l < width; l++) {
            specs[l] = *common;
            specs[l].run = (uint64_t)(first_run + l);
        }
        const schuler_model_setup setup = { instrument, seed, 0.01, width, specs };
        m->setup(state, &setup);
        for (int b = 0; b < BLOCKS; b++) {
            double own[3][SCHULER_BLOCK], other[3][SCHULER_BLOCK];
            const int64_t first = (int64_t)b * SCHULER_BLOCK;
            /* The last block is a short one, as at the end of a mission. */
            const int n = b == BLOCKS - 1 ? 13 : SCHULER_BLOCK;
            for (int i = 0; i < 3; i++)
                for (int k = 0; k < n; k++) {
                    own[i][k] = truth_sample((int)instrument, i, first + k);
                    other[i][k] = truth_sample(1 - (int)instrument, i, first + k);
                }
            const schuler_model_block block = { first,        n, SCHULER_BLOCK, 0.01, &own[0][0],
                                                &other[0][0], y };
            m->apply(state, &block);
            for (int i = 0; i < 3; i++)
                for (int k = 0; k < n; k++)
                    for (int l = 0; l < width; l++)
                        out[first_run + l][i][first + k] = y[(i * SCHULER_BLOCK + k) * width + l];
        }
    }
    free(state);
    free(y);
}

/* Settings at their defaults, sources at zero. */
static schuler_lane_spec quiet(const schuler_param *params)
{
    schuler_lane_spec spec = { 0 };
    for (int k = 0; params[k].key; k++)
        for (int c = 0; params[k].number == 0 && c < params[k].components; c++)
            spec.value[k][c] = params[k].def;
    return spec;
}

/* A value of each source that has an effect, a thousandth of its range or less. */
static double loud(const schuler_param *p)
{
    if (strcmp(p->key, "quantization") == 0) return 1e-4;
    return p->noisy ? 1e-3 : 2e-3;
}

#define FOR_EACH_MODEL(m, i)                                                                       \
    for (int m = 0; schuler_sensor_models(SCHULER_ISA_SCALAR)[m]; m++)                             \
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)                                              \
            if (schuler_sensor_models(SCHULER_ISA_SCALAR)[m]->params[i])

static measured a, b;

static void errors_off_is_the_identity_bit_for_bit(void **state)
{
    (void)state;
    FOR_EACH_MODEL(m, i)
    {
        const schuler_lane_spec spec =
            quiet(schuler_sensor_models(SCHULER_ISA_SCALAR)[m]->params[i]);
        measure(schuler_isa_best(), m, (schuler_instrument)i, &spec, 1, a);
        for (int r = 0; r < RUNS; r++)
            for (int axis = 0; axis < 3; axis++)
                for (int k = 0; k < 4 * SCHULER_BLOCK + 13; k++)
                    assert_true(a[r][axis][k] == truth_sample(i, axis, k));
    }
}

static void every_width_gives_the_same_bits(void **state)
{
    (void)state;
    FOR_EACH_MODEL(m, i)
    {
        const schuler_param *params = schuler_sensor_models(SCHULER_ISA_SCALAR)[m]->params[i];
        schuler_lane_spec spec = quiet(params);
        for (int k = 0; params[k].key; k++)
            for (int c = 0; params[k].number != 0 && c < params[k].components; c++)
                spec.value[k][c] = loud(&params[k]) * (1.0 + 0.1 * c);
        memset(a, 0, sizeof(a));
        measure(SCHULER_ISA_SCALAR, m, (schuler_instrument)i, &spec, 11, a);
        for (int isa = 1; isa < SCHULER_ISA_COUNT; isa++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            memset(b, 0, sizeof(b));
            measure((schuler_isa)isa, m, (schuler_instrument)i, &spec, 11, b);
            assert_memory_equal(a, b, sizeof(a));
        }
    }
}

static void every_source_does_something_and_repeats(void **state)
{
    (void)state;
    FOR_EACH_MODEL(m, i)
    {
        const schuler_param *params = schuler_sensor_models(SCHULER_ISA_SCALAR)[m]->params[i];
        for (int k = 0; params[k].key; k++) {
            if (params[k].number == 0) continue;
            schuler_lane_spec spec = quiet(params);
            for (int c = 0; c < params[k].components; c++) spec.value[k][c] = loud(&params[k]);
            memset(a, 0, sizeof(a));
            memset(b, 0, sizeof(b));
            measure(schuler_isa_best(), m, (schuler_instrument)i, &spec, 5, a);
            measure(schuler_isa_best(), m, (schuler_instrument)i, &spec, 5, b);
            assert_memory_equal(a, b, sizeof(a));
            for (int axis = 0; axis < 3; axis++)
                assert_true(a[0][axis][0] != truth_sample(i, axis, 0));
            /* Another seed moves what is random and nothing else; runs differ likewise. */
            memset(b, 0, sizeof(b));
            measure(schuler_isa_best(), m, (schuler_instrument)i, &spec, 6, b);
            assert_int_equal(memcmp(a, b, sizeof(a)) != 0, params[k].noisy);
            assert_int_equal(memcmp(a[0], a[1], sizeof(a[0])) != 0, params[k].noisy);
        }
    }
}

static void tables_are_complete_and_numbers_unique(void **state)
{
    (void)state;
    unsigned seen[4096];
    int count = 0;
    FOR_EACH_MODEL(m, i)
    {
        const schuler_sensor_model *model = schuler_sensor_models(SCHULER_ISA_SCALAR)[m];
        const schuler_param *params = model->params[i];
        assert_true(model->name && model->summary && model->source);
        for (int k = 0; params[k].key; k++) {
            assert_true(k < SCHULER_PARAMS_MAX);
            assert_true(params[k].doc && params[k].example);
            assert_in_range(params[k].components, 1, SCHULER_COMPONENTS_MAX);
            assert_true(params[k].min < params[k].max);
            double si;
            schuler_error err;
            assert_int_equal(schuler_quantity_parse(params[k].example, params[k].dim, &si, &err),
                             SCHULER_OK);
            assert_true(si >= params[k].min && si <= params[k].max);
            if (params[k].number == 0) continue;
            assert_non_null(params[k].formula);
            assert_true(params[k].number >= 100);
            for (int s = 0; s < count; s++) assert_int_not_equal(seen[s], params[k].number);
            seen[count++] = params[k].number;
        }
    }
    assert_true(count > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_off_is_the_identity_bit_for_bit),
        cmocka_unit_test(every_width_gives_the_same_bits),
        cmocka_unit_test(every_source_does_something_and_repeats),
        cmocka_unit_test(tables_are_complete_and_numbers_unique),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

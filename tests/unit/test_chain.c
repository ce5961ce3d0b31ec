/* SPDX-License-Identifier: MIT */
/* The chain of a triad: mounting, order of parameters, tables for one lane, the test stand. */
#include "check.h"
#include "sensors/mounting.h"
#include "sensors/stand.h"
#include <string.h>

enum { LANES = 5, BLOCKS = 3 };

typedef double record[BLOCKS][LANES][3][SCHULER_BLOCK];

static schuler_param params[SCHULER_PARAMS_MAX + 1];

static int param(const char *key)
{
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    fail_msg("no parameter %s", key);
    return -1;
}

/* A turn and a swing, all axes different. */
static void motion(void *user, double t_s, double f[3], double omega[3])
{
    (void)user;
    for (int a = 0; a < 3; a++) {
        f[a] = 9.0 * cos(0.3 + a + 2.0 * t_s);
        omega[a] = 0.2 * sin(1.0 + a - 3.0 * t_s);
    }
}

/* Every lane alike but for its run. */
static void fly(schuler_isa isa, bool one_lane, schuler_instrument instrument,
                const schuler_lane_spec *common, record out)
{
    const int linear = schuler_sensor_model_find("linear");
    schuler_lane_spec specs[LANES];
    bool given[SCHULER_PARAMS_MAX];
    for (int k = 0; k < SCHULER_PARAMS_MAX; k++) {
        given[k] = false;
        for (int c = 0; c < SCHULER_COMPONENTS_MAX; c++) given[k] |= common->value[k][c] != 0.0;
    }
    for (int l = 0; l < LANES; l++) {
        specs[l] = *common;
        specs[l].run = (uint64_t)l;
    }
    const schuler_stand_setup setup = {
        .chain = { .model = schuler_sensor_models(one_lane ? SCHULER_ISA_SCALAR : isa)[linear],
                   .is_plugin = one_lane,
                   .instrument = instrument,
                   .isa = isa,
                   .dt_s = 0.01,
                   .seed = 9,
                   .settings = common,
                   .given = given },
        .specs = specs,
        .specimens = LANES,
        .input = motion,
    };
    schuler_stand *stand = NULL;
    assert_int_equal(schuler_stand_create(&stand, &setup, NULL), SCHULER_OK);
    for (int b = 0; b < BLOCKS; b++) schuler_stand_next(stand, SCHULER_BLOCK, out[b][0][0]);
    schuler_stand_free(stand);
}

static record a, b;

static void a_table_for_one_lane_gives_the_same_bits(void **state)
{
    (void)state;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const int linear = schuler_sensor_model_find("linear");
        const schuler_instrument instrument = (schuler_instrument)i;
        assert_true(schuler_chain_params(schuler_sensor_models(SCHULER_ISA_SCALAR)[linear],
                                         instrument, params) > 8);
        schuler_lane_spec spec = { 0 };
        for (int c = 0; c < 6; c++) {
            spec.value[param("bias")][c] = 1e-3 * (c + 1);
            spec.value[param("misalignment")][c] = 1e-4 * (c + 1);
            spec.value[param("scale_factor")][c] = -1e-4 * (c + 1);
            spec.value[param(i == SCHULER_ACCEL ? "velocity_random_walk" : "angle_random_walk")]
                      [c] = 1e-3;
        }
        memset(a, 0, sizeof a);
        memset(b, 1, sizeof b);
        fly(schuler_isa_best(), false, instrument, &spec, a);
        fly(schuler_isa_best(), true, instrument, &spec, b);
        assert_memory_equal(a, b, sizeof a);
        fly(SCHULER_ISA_SCALAR, true, instrument, &spec, b);
        assert_memory_equal(a, b, sizeof a);
        assert_true(a[2][0][0][7] != a[2][1][0][7]);
    }
}

/* Three accelerometers on the edges of a cube stood on its corner, and one turned round. */
static const double skewed[9] = { 0.8, 0.1, -0.2, 0.3, -0.9, 0.1, 2.0, 2.0, 2.0 };

static void skewed_axes_are_turned_back(void **state)
{
    (void)state;
    const int linear = schuler_sensor_model_find("linear");
    (void)schuler_chain_params(schuler_sensor_models(SCHULER_ISA_SCALAR)[linear], SCHULER_ACCEL,
                               params);
    schuler_lane_spec plain = { 0 }, spec = { 0 };
    memcpy(spec.value[param("input_axes")], skewed, sizeof skewed);
    fly(schuler_isa_best(), false, SCHULER_ACCEL, &plain, a);
    fly(schuler_isa_best(), false, SCHULER_ACCEL, &spec, b);
    /* Increments of 0.1 m/s through two 3 x 3 products, the second with elements up to 3. */
    for (int k = 0; k < SCHULER_BLOCK; k++)
        for (int axis = 0; axis < 3; axis++) CHECK_NEAR(b[1][2][axis][k], a[1][2][axis][k], 1e-15);
    /* A bias of the second instrument: x_body = A^-1 e_2 b, that is A x_body = e_2 b. */
    spec.value[param("bias")][1] = 1e-2;
    fly(schuler_isa_best(), false, SCHULER_ACCEL, &spec, b);
    for (int k = 0; k < 3; k++) {
        const double length =
            sqrt(skewed[3 * k] * skewed[3 * k] + skewed[3 * k + 1] * skewed[3 * k + 1] +
                 skewed[3 * k + 2] * skewed[3 * k + 2]);
        double sum = 0.0;
        for (int j = 0; j < 3; j++)
            sum += skewed[3 * k + j] / length * (b[0][0][j][5] - a[0][0][j][5]) / 0.01;
        CHECK_NEAR(sum, k == 1 ? 1e-2 : 0.0, 1e-13);
    }
}

static void the_axes_of_an_instrument_are_a_right_handed_triad(void **state)
{
    (void)state;
    static const double none[9] = { 0 };
    double axes[3][3][3], back[3][3];
    schuler_mounting_axes(none, none, axes);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                assert_true(axes[k][i][j] == (j == (k + i) % 3 ? 1.0 : 0.0));
    assert_true(schuler_mounting_back(axes, back));
    static const double second[9] = { 1, 1, 0, 0, 0, 1, 0, 1, 0.5 };
    schuler_mounting_axes(skewed, second, axes);
    for (int k = 0; k < 3; k++) {
        double i_p = 0.0, i_o = 0.0, o_o = 0.0;
        for (int j = 0; j < 3; j++) {
            i_p += axes[k][0][j] * axes[k][1][j];
            i_o += axes[k][0][j] * axes[k][2][j];
            o_o += axes[k][2][j] * axes[k][2][j];
        }
        CHECK_NEAR(i_p, 0.0, 1e-15);
        CHECK_NEAR(i_o, 0.0, 1e-15);
        CHECK_NEAR(o_o, 1.0, 1e-15);
    }
    static const double plane[9] = { 1, 0, 0, 0, 1, 0, 1, 1, 0 };
    static const double nothing[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 0 };
    schuler_mounting_axes(plane, none, axes);
    assert_false(schuler_mounting_back(axes, back));
    schuler_mounting_axes(nothing, none, axes);
    assert_false(schuler_mounting_back(axes, back));
    static const double same[9] = { 1, 0, 0, 0, 0, 1, 1, 0, 0 };
    schuler_mounting_axes(none, same, axes); /* a pendulous axis along the input axis */
    assert_false(schuler_mounting_back(axes, back));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_for_one_lane_gives_the_same_bits),
        cmocka_unit_test(skewed_axes_are_turned_back),
        cmocka_unit_test(the_axes_of_an_instrument_are_a_right_handed_triad),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

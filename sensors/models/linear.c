/* SPDX-License-Identifier: MIT */
/* The linear model of a triad: y = (I + S + M) x + b + noise, on increments. Each term is an error
 * source of its own. Accelerometers and gyros differ in units only. */
#include "core/lanes.h"
#include "sensors/drift.h"
#include "sensors/model.h"
#include "sensors/quantizer.h"
#include "sensors/white.h"

enum {
    BIAS,
    SCALE_FACTOR,
    MISALIGNMENT,
    RANDOM_WALK,
    GAUSS_MARKOV,
    GAUSS_MARKOV_TIME,
    BIAS_RANDOM_WALK,
    QUANTIZATION,
};

#define GM_TIME_PARAM                                                                              \
    {                                                                                              \
        .key = "gauss_markov_time", .dim = { 0, 2, 0, 0 }, .components = 3, .def = 100.0,          \
        .min = 1e-3, .max = 1e9, .example = "100 s", .doc = "correlation time of gauss_markov",    \
        .companion = "gauss_markov"                                                                \
    }

static const schuler_param accel_params[] = {
    [BIAS] = { .key = "bias",
               .number = 100,
               .dim = { 2, -4, 0, 0 },
               .components = 3,
               .min = -1e3,
               .max = 1e3,
               .example = "50 ug",
               .doc = "constant bias of each axis",
               .formula = "y = x + b dt" },
    [SCALE_FACTOR] = { .key = "scale_factor",
                       .number = 101,
                       .components = 3,
                       .min = -0.5,
                       .max = 0.5,
                       .example = "100 ppm",
                       .doc = "scale-factor error of each axis",
                       .formula = "y = (1 + s) x" },
    [MISALIGNMENT] = { .key = "misalignment",
                       .number = 102,
                       .dim = { 0, 0, 2, 0 },
                       .components = 6,
                       .min = -0.5,
                       .max = 0.5,
                       .example = "10 arcsec",
                       .doc = "small angles xy, xz, yx, yz, zx, zy toward the other axes",
                       .formula = "y_x = x_x + M_xy x_y + M_xz x_z, and cyclic" },
    [RANDOM_WALK] = { .key = "velocity_random_walk",
                      .number = 103,
                      .dim = { 2, -3, 0, 0 },
                      .components = 3,
                      .max = 1e3,
                      .noisy = 1,
                      .example = "0.003 m/s/sqrt(h)",
                      .doc = "white noise of the specific force, as its velocity random walk N",
                      .formula = "y = x + N sqrt(dt) w" },
    [GAUSS_MARKOV] = { .key = "gauss_markov",
                       .number = 104,
                       .dim = { 2, -4, 0, 0 },
                       .components = 3,
                       .max = 1e3,
                       .noisy = 1,
                       .example = "10 ug",
                       .doc = "bias that wanders as a first-order Gauss-Markov process, its sigma",
                       .formula = "db/dt = -b/T + sigma sqrt(2/T) w",
                       .companion = "gauss_markov_time" },
    [GAUSS_MARKOV_TIME] = GM_TIME_PARAM,
    [BIAS_RANDOM_WALK] = { .key = "bias_random_walk",
                           .number = 105,
                           .dim = { 2, -5, 0, 0 },
                           .components = 3,
                           .max = 1e3,
                           .noisy = 1,
                           .example = "1 ug/sqrt(h)",
                           .doc = "bias that wanders without limit, its coefficient K",
                           .formula = "db/dt = K w" },
    [QUANTIZATION] = { .key = "quantization",
                       .number = 106,
                       .dim = { 2, -2, 0, 0 },
                       .components = 3,
                       .max = 1e3,
                       .noisy = 1,
                       .example = "0.0001 m/s",
                       .doc = "velocity of one count; the remainder is carried",
                       .formula = "y = round((x + r)/lsb) lsb" },
    { 0 },
};

static const schuler_param gyro_params[] = {
    [BIAS] = { .key = "bias",
               .number = 200,
               .dim = { 0, -2, 2, 0 },
               .components = 3,
               .min = -1e2,
               .max = 1e2,
               .example = "0.01 deg/h",
               .doc = "constant drift of each axis",
               .formula = "y = x + b dt" },
    [SCALE_FACTOR] = { .key = "scale_factor",
                       .number = 201,
                       .components = 3,
                       .min = -0.5,
                       .max = 0.5,
                       .example = "5 ppm",
                       .doc = "scale-factor error of each axis",
                       .formula = "y = (1 + s) x" },
    [MISALIGNMENT] = { .key = "misalignment",
                       .number = 202,
                       .dim = { 0, 0, 2, 0 },
                       .components = 6,
                       .min = -0.5,
                       .max = 0.5,
                       .example = "10 arcsec",
                       .doc = "small angles xy, xz, yx, yz, zx, zy toward the other axes",
                       .formula = "y_x = x_x + M_xy x_y + M_xz x_z, and cyclic" },
    [RANDOM_WALK] = { .key = "angle_random_walk",
                      .number = 203,
                      .dim = { 0, -1, 2, 0 },
                      .components = 3,
                      .max = 1e2,
                      .noisy = 1,
                      .example = "0.003 deg/sqrt(h)",
                      .doc = "white noise of the rate, as its angle random walk N",
                      .formula = "y = x + N sqrt(dt) w" },
    [GAUSS_MARKOV] = { .key = "gauss_markov",
                       .number = 204,
                       .dim = { 0, -2, 2, 0 },
                       .components = 3,
                       .max = 1e2,
                       .noisy = 1,
                       .example = "0.003 deg/h",
                       .doc = "drift that wanders as a first-order Gauss-Markov process, its sigma",
                       .formula = "db/dt = -b/T + sigma sqrt(2/T) w",
                       .companion = "gauss_markov_time" },
    [GAUSS_MARKOV_TIME] = GM_TIME_PARAM,
    [BIAS_RANDOM_WALK] = { .key = "bias_random_walk",
                           .number = 205,
                           .dim = { 0, -3, 2, 0 },
                           .components = 3,
                           .max = 1e2,
                           .noisy = 1,
                           .example = "0.001 deg/h/sqrt(h)",
                           .doc = "drift that wanders without limit (rate random walk), K",
                           .formula = "db/dt = K w" },
    [QUANTIZATION] = { .key = "quantization",
                       .number = 206,
                       .dim = { 0, 0, 2, 0 },
                       .components = 3,
                       .max = 1.0,
                       .noisy = 1,
                       .example = "1 arcsec",
                       .doc = "angle of one count; the remainder is carried",
                       .formula = "y = round((x + r)/lsb) lsb" },
    { 0 },
};

typedef struct {
    lanes gain[3][3]; /* I + S + M                            */
    lanes offset[3];  /* bias over one step: m/s or rad       */
    white_noise white;
    bias_drift gauss_markov, walk;
    quantizer quantizer;
} linear;

static void setup(void *state, const schuler_model_setup *s)
{
    linear *m = state;
    const schuler_param *p = s->instrument == SCHULER_ACCEL ? accel_params : gyro_params;
    int angle = 0; /* xy, xz, yx, yz, zx, zy */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            m->gain[i][j] = i == j ? lanes_set(1.0) + setup_value(s, SCALE_FACTOR, i)
                                   : setup_value(s, MISALIGNMENT, angle++);
        m->offset[i] = setup_value(s, BIAS, i) * lanes_set(s->dt_s);
    }
    white_setup(&m->white, s, RANDOM_WALK, p[RANDOM_WALK].number);
    gauss_markov_setup(&m->gauss_markov, s, GAUSS_MARKOV, GAUSS_MARKOV_TIME,
                       p[GAUSS_MARKOV].number);
    random_walk_setup(&m->walk, s, BIAS_RANDOM_WALK, p[BIAS_RANDOM_WALK].number);
    quantizer_setup(&m->quantizer, s, QUANTIZATION, p[QUANTIZATION].number);
}

static void apply(void *state, const schuler_model_block *b)
{
    linear *m = state;
    const int stride = b->stride;
    for (int i = 0; i < 3; i++) {
        const lanes gx = m->gain[i][0], gy = m->gain[i][1], gz = m->gain[i][2], c = m->offset[i];
        double *out = b->out + i * stride * SCHULER_LANES;
        for (int k = 0; k < b->n; k++)
            lanes_store(out + k * SCHULER_LANES, c + gx * lanes_set(b->own[k]) +
                                                     gy * lanes_set(b->own[stride + k]) +
                                                     gz * lanes_set(b->own[2 * stride + k]));
    }
    drift_add(&m->gauss_markov, b);
    drift_add(&m->walk, b);
    white_add(&m->white, b);
    quantizer_apply(&m->quantizer, b);
}

extern const schuler_sensor_model SCHULER_LANE_NAME(schuler_model_linear);
const schuler_sensor_model SCHULER_LANE_NAME(schuler_model_linear) = {
    .name = "linear",
    .summary = "bias, scale factor, misalignment, white noise, wandering bias, quantization",
    .source = "D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd ed., "
              "chs 4-6; noise terms IEEE Std 952-1997 annex C",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(linear),
    .setup = setup,
    .apply = apply,
};

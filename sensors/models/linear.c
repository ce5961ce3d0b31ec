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

/* An error source of three components; dim is a SCHULER_DIM_ name. */
#define SOURCE(KEY, NUMBER, DIM, MIN, MAX, EXAMPLE, DOC, FORMULA, ...)                             \
    {                                                                                              \
        .key = KEY, .number = NUMBER, .dim = SCHULER_DIM_##DIM, .components = 3, .min = MIN,       \
        .max = MAX, .example = EXAMPLE, .doc = DOC, .formula = FORMULA, __VA_ARGS__                \
    }

/* What accelerometers and gyros have in the same units, numbers from FIRST on. */
#define SHARED_PARAMS(FIRST, SCALE_EXAMPLE)                                                        \
    [SCALE_FACTOR] = SOURCE("scale_factor", (FIRST) + 1, NONE, -0.5, 0.5, SCALE_EXAMPLE,           \
                            "scale-factor error of each axis", "y = (1 + s) x", .noisy = 0),       \
    [MISALIGNMENT] = { .key = "misalignment",                                                      \
                       .number = (FIRST) + 2,                                                      \
                       .dim = SCHULER_DIM_ANGLE,                                                   \
                       .components = 6,                                                            \
                       .min = -0.5,                                                                \
                       .max = 0.5,                                                                 \
                       .example = "10 arcsec",                                                     \
                       .doc = "small angles xy, xz, yx, yz, zx, zy toward the other axes",         \
                       .formula = "y_x = x_x + M_xy x_y + M_xz x_z, and cyclic" },                 \
    [GAUSS_MARKOV_TIME] = { .key = "gauss_markov_time",                                            \
                            .dim = SCHULER_DIM_TIME,                                               \
                            .components = 3,                                                       \
                            .def = 100.0,                                                          \
                            .min = 1e-3,                                                           \
                            .max = 1e9,                                                            \
                            .example = "100 s",                                                    \
                            .doc = "correlation time of gauss_markov",                             \
                            .companion = "gauss_markov" }

#define WHITE_FORMULA  "y = x + N sqrt(dt) w"
#define MARKOV_FORMULA "db/dt = -b/T + sigma sqrt(2/T) w"
#define COUNT_FORMULA  "y = round((x + r)/lsb) lsb"

static const schuler_param accel_params[] = {
    [BIAS] = SOURCE("bias", 100, ACCEL, -1e3, 1e3, "50 ug", "constant bias of each axis",
                    "y = x + b dt", .noisy = 0),
    SHARED_PARAMS(100, "100 ppm"),
    [RANDOM_WALK] = SOURCE("velocity_random_walk", 103, VRW, 0, 1e3, "0.003 m/s/sqrt(h)",
                           "white noise of the specific force, as its velocity random walk N",
                           WHITE_FORMULA, .noisy = 1),
    [GAUSS_MARKOV] = SOURCE("gauss_markov", 104, ACCEL, 0, 1e3, "10 ug",
                            "bias that wanders as a first-order Gauss-Markov process, its sigma",
                            MARKOV_FORMULA, .noisy = 1, .companion = "gauss_markov_time"),
    [BIAS_RANDOM_WALK] =
        SOURCE("bias_random_walk", 105, ACCEL_RW, 0, 1e3, "1 ug/sqrt(h)",
               "bias that wanders without limit, its coefficient K", "db/dt = K w", .noisy = 1),
    [QUANTIZATION] =
        SOURCE("quantization", 106, SPEED, 0, 1e3, "0.0001 m/s",
               "velocity of one count; the remainder is carried", COUNT_FORMULA, .noisy = 1),
    { 0 },
};

static const schuler_param gyro_params[] = {
    [BIAS] = SOURCE("bias", 200, RATE, -1e2, 1e2, "0.01 deg/h", "constant drift of each axis",
                    "y = x + b dt", .noisy = 0),
    SHARED_PARAMS(200, "5 ppm"),
    [RANDOM_WALK] =
        SOURCE("angle_random_walk", 203, ARW, 0, 1e2, "0.003 deg/sqrt(h)",
               "white noise of the rate, as its angle random walk N", WHITE_FORMULA, .noisy = 1),
    [GAUSS_MARKOV] = SOURCE("gauss_markov", 204, RATE, 0, 1e2, "0.003 deg/h",
                            "drift that wanders as a first-order Gauss-Markov process, its sigma",
                            MARKOV_FORMULA, .noisy = 1, .companion = "gauss_markov_time"),
    [BIAS_RANDOM_WALK] =
        SOURCE("bias_random_walk", 205, RRW, 0, 1e2, "0.001 deg/h/sqrt(h)",
               "drift that wanders without limit (rate random walk), K", "db/dt = K w", .noisy = 1),
    [QUANTIZATION] =
        SOURCE("quantization", 206, ANGLE, 0, 1.0, "1 arcsec",
               "angle of one count; the remainder is carried", COUNT_FORMULA, .noisy = 1),
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

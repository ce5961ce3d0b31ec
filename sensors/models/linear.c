/* SPDX-License-Identifier: MIT */
/* The linear model of a triad: y = (I + S + M) x + b, on increments. Accelerometers and gyros differ
 * in units only. */
#include "sensors/params.h"
#include "sensors/setup.h"

enum { BIAS, SCALE_FACTOR, MISALIGNMENT };

#define PARAMS(FIRST, DIM_, MAX, BIAS_EXAMPLE, BIAS_DOC, SCALE_EXAMPLE)                            \
    {                                                                                              \
        [BIAS] = PARAM_SOURCE("bias", FIRST, DIM_, -MAX, MAX, CONSTANT, BIAS_EXAMPLE, BIAS_DOC,    \
                              "y = x + b dt", .noisy = 0),                                         \
        [SCALE_FACTOR] =                                                                           \
            PARAM_SOURCE("scale_factor", (FIRST) + 1, NONE, -0.5, 0.5, SCALE, SCALE_EXAMPLE,       \
                         "scale-factor error of each axis", "y = (1 + s) x", .noisy = 0),          \
        [MISALIGNMENT] = { .key = "misalignment",                                                  \
                           .number = (FIRST) + 2,                                                  \
                           .dim = SCHULER_DIM_ANGLE,                                               \
                           .components = 6,                                                        \
                           .min = -0.5,                                                            \
                           .max = 0.5,                                                             \
                           .acts = SCHULER_ACTS_CROSS,                                             \
                           .example = "10 arcsec",                                                 \
                           .doc = "small angles xy, xz, yx, yz, zx, zy toward the other axes",     \
                           .formula = "y_x = x_x + M_xy x_y + M_xz x_z, and cyclic" },             \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] =
    PARAMS(100, ACCEL, 1e3, "50 ug", "constant bias of each axis", "100 ppm");
static const schuler_param gyro_params[] =
    PARAMS(200, RATE, 1e2, "0.01 deg/h", "constant drift of each axis", "5 ppm");

typedef struct {
    lanes gain[3][3]; /* I + S + M                            */
    lanes offset[3];  /* bias over one step: m/s or rad       */
} linear;

static int setup(void *state, const schuler_model_setup *s)
{
    linear *m = state;
    int angle = 0; /* xy, xz, yx, yz, zx, zy */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            m->gain[i][j] = i == j ? lanes_set(1.0) + setup_value(s, SCALE_FACTOR, i)
                                   : setup_value(s, MISALIGNMENT, angle++);
        m->offset[i] = setup_value(s, BIAS, i) * lanes_set(s->dt_s);
    }
    return 1;
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
}

extern const schuler_sensor_model SCHULER_LANE_NAME(schuler_model_linear);
const schuler_sensor_model SCHULER_LANE_NAME(schuler_model_linear) = {
    .name = "linear",
    .summary = "bias, scale factor, misalignment",
    .source = "D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd ed., "
              "chs 4-6",
    .equation = "y = (I + S + M) x + b",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(linear),
    .setup = setup,
    .apply = apply,
};

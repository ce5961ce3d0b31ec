/* SPDX-License-Identifier: MIT */
/* Input axes that are not the body axes: the navigation computer knows how the instruments are meant
 * to point and turns their outputs back into body axes. Errors of the mounting belong to the model
 * (misalignment). */
#include "sensors/mounting.h"
#include "sensors/params.h"
#include "sensors/setup.h"

enum { INPUT, SECOND };

#define INPUT_AXES                                                                                 \
    [INPUT] = { .key = "input_axes",                                                               \
                .components = 9,                                                                   \
                .min = -1.0,                                                                       \
                .max = 1.0,                                                                        \
                .example = "[1, 0, 0, 0, 1, 0, 0, 0, 1]",                                          \
                .doc = "directions of the three input axes in body axes, one after the other; "    \
                       "default: the body axes" }

static const schuler_param accel_params[] = {
    INPUT_AXES,
    [SECOND] = { .key = "pendulous_axes",
                 .components = 9,
                 .min = -1.0,
                 .max = 1.0,
                 .example = "[0, 1, 0, 0, 0, 1, 1, 0, 0]",
                 .doc = "directions of the three pendulous axes in body axes; output axis = input "
                        "x pendulous; default: the next body axis (x: y, y: z, z: x)" },
    { 0 },
};

static const schuler_param gyro_params[] = {
    INPUT_AXES,
    [SECOND] = { .key = "output_axes",
                 .components = 9,
                 .min = -1.0,
                 .max = 1.0,
                 .example = "[0, 1, 0, 0, 0, 1, 1, 0, 0]",
                 .doc = "directions of the three output axes in body axes; spin axis = input x "
                        "output; default: the next body axis (x: y, y: z, z: x)" },
    { 0 },
};

typedef struct {
    lanes back[3][3]; /* from instruments to body axes */
} mounting;

static int setup(void *state, const schuler_model_setup *s)
{
    mounting *m = state;
    double input[9], second[9], axes[3][3][3], back[3][3];
    int is_body = 1;
    for (int i = 0; i < 9; i++) {
        input[i] = setup_setting(s, INPUT, i);
        second[i] = setup_setting(s, SECOND, i);
    }
    schuler_mounting_axes(input, second, axes);
    if (!schuler_mounting_back(axes, back)) return 0; /* refused when it was read */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            is_body &= axes[i][0][j] == (i == j ? 1.0 : 0.0);
            m->back[i][j] = lanes_set(back[i][j]);
        }
    return !is_body;
}

static void apply(void *state, const schuler_model_block *b)
{
    const mounting *m = state;
    double *const x = b->out, *const y = x + b->stride * SCHULER_LANES,
                  *const z = y + b->stride * SCHULER_LANES;
    for (int k = 0; k < b->n; k++) {
        const lanes u = lanes_load(x + k * SCHULER_LANES), v = lanes_load(y + k * SCHULER_LANES),
                    w = lanes_load(z + k * SCHULER_LANES);
        lanes_store(x + k * SCHULER_LANES,
                    m->back[0][0] * u + m->back[0][1] * v + m->back[0][2] * w);
        lanes_store(y + k * SCHULER_LANES,
                    m->back[1][0] * u + m->back[1][1] * v + m->back[1][2] * w);
        lanes_store(z + k * SCHULER_LANES,
                    m->back[2][0] * u + m->back[2][1] * v + m->back[2][2] * w);
    }
}

STAGE(mounting) = {
    .name = "mounting",
    .summary = "where the instruments' axes point",
    .source = "geometry",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(mounting),
    .setup = setup,
    .apply = apply,
};

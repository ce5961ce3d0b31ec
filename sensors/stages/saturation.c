/* SPDX-License-Identifier: MIT */
/* The output ends at the range: the instantaneous value is clipped, at the nodes of the step, since an
 * over-range shorter than a sample would not show in its mean. The errors of the stages before are
 * taken as constant within a step. */
#include "sensors/instant.h"
#include "sensors/params.h"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("saturation", 116, ACCEL, 0, 1e5, RESPONSE, "10 g",
                 "largest specific force either way; beyond it the output stays there",
                 "max(-R, min(x, R))", .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("saturation", 216, RATE, 0, 1e4, RESPONSE, "300 deg/s",
                 "largest rate either way; beyond it the output stays there", "max(-R, min(x, R))",
                 .noisy = 0),
    { 0 },
};

typedef struct {
    schuler_instrument instrument;
    lanes range[3]; /* huge in lanes that do not saturate */
    lanes clipped;  /* samples                            */
} saturation;

static int setup(void *state, const schuler_model_setup *s)
{
    saturation *m = state;
    m->instrument = s->instrument;
    m->clipped = lanes_set(0.0);
    for (int i = 0; i < 3; i++) {
        double range[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) {
            const double r = setup_lane(s, l, 0, i);
            range[l] = r != 0.0 ? r : 1e300;
        }
        m->range[i] = lanes_load(range);
    }
    return setup_any(s, 0, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    saturation *m = state;
    const lanes zero = lanes_set(0.0), one = lanes_set(1.0);
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        const lanes range = m->range[axis];
        for (int k = 0; k < b->n; k++) {
            const lanes y = lanes_load(out + k * SCHULER_LANES);
            const lanes error = instant_error(b, m->instrument, axis, k, y);
            lanes over = zero, any = zero;
            for (int j = 0; j < b->view->nodes; j++) {
                const lanes x = instant_value(b, m->instrument, axis, k, j, error);
                const lanes excess = lanes_max(x - range, zero) + lanes_min(x + range, zero);
                over += lanes_set(b->view->weight[j] * b->dt_s) * excess;
                any = lanes_max(any, lanes_abs(excess));
            }
            m->clipped += lanes_select(lanes_greater(any, zero), one, zero);
            lanes_store(out + k * SCHULER_LANES, y - over);
        }
    }
}

static double events(const void *state, int lane)
{
    double clipped[SCHULER_LANES];
    const saturation *m = state;
    memcpy(clipped, &m->clipped, sizeof clipped);
    return clipped[lane];
}

STAGE(saturation) = {
    .name = "saturation",
    .summary = "the output ends at the range",
    .source = "IEEE Std 528 (input range, saturation)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(saturation),
    .needs_view = 1,
    .events = events,
    .setup = setup,
    .apply = apply,
};

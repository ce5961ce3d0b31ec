/* SPDX-License-Identifier: MIT */
/* Inputs nearer to zero than the threshold give nothing; looked at instant by instant, like
 * saturation. */
#include "sensors/instant.h"
#include "sensors/params.h"

#define FORMULA "0 where |x| < D"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("dead_band", 117, ACCEL, 0, 1e3, RESPONSE, "5 ug",
                 "specific force below which the output is zero (threshold)", FORMULA, .noisy = 0),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("dead_band", 217, RATE, 0, 1e2, RESPONSE, "0.01 deg/h",
                 "rate below which the output is zero (threshold)", FORMULA, .noisy = 0),
    { 0 },
};

typedef struct {
    schuler_instrument instrument;
    lanes threshold[3];
} dead_band;

static int setup(void *state, const schuler_model_setup *s)
{
    dead_band *m = state;
    m->instrument = s->instrument;
    for (int i = 0; i < 3; i++) m->threshold[i] = setup_value(s, 0, i);
    return setup_any(s, 0, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    const dead_band *m = state;
    const lanes zero = lanes_set(0.0);
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        for (int k = 0; k < b->n; k++) {
            const lanes y = lanes_load(out + k * SCHULER_LANES);
            const lanes error = instant_error(b, m->instrument, axis, k, y);
            lanes lost = zero;
            for (int j = 0; j < b->view->nodes; j++) {
                const lanes x = instant_value(b, m->instrument, axis, k, j, error);
                const lanes_u64 inside = lanes_greater(m->threshold[axis], lanes_abs(x));
                lost += lanes_set(b->view->weight[j] * b->dt_s) * lanes_select(inside, x, zero);
            }
            lanes_store(out + k * SCHULER_LANES, y - lost);
        }
    }
}

STAGE(dead_band) = {
    .name = "dead_band",
    .summary = "no output below a threshold",
    .source = "IEEE Std 528 (threshold, dead band)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(dead_band),
    .needs_view = 1,
    .setup = setup,
    .apply = apply,
};

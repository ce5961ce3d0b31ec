/* SPDX-License-Identifier: MIT */
/* Output in whole counts: sensors/quantizer.h. */
#include "sensors/params.h"
#include "sensors/quantizer.h"

#define FORMULA "y = round((x + r)/lsb) lsb, r carried"

static const schuler_param accel_params[] = {
    PARAM_SOURCE("quantization", 106, SPEED, 0, 1e3, COUNTS, "0.0001 m/s",
                 "velocity of one count; the remainder is carried", FORMULA, .noisy = 1),
    { 0 },
};

static const schuler_param gyro_params[] = {
    PARAM_SOURCE("quantization", 206, ANGLE, 0, 1.0, COUNTS, "1 arcsec",
                 "angle of one count; the remainder is carried", FORMULA, .noisy = 1),
    { 0 },
};

static int setup(void *state, const schuler_model_setup *s)
{
    quantizer *q = state;
    quantizer_setup(q, s, 0,
                    (s->instrument == SCHULER_ACCEL ? accel_params : gyro_params)[0].number);
    return q->active;
}

static void apply(void *state, const schuler_model_block *b)
{
    quantizer_apply(state, b);
}

STAGE(quantization) = {
    .name = "quantization",
    .summary = "whole counts, the remainder carried",
    .source = "IEEE Std 952-1997 annex C (quantization)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(quantizer),
    .setup = setup,
    .apply = apply,
};

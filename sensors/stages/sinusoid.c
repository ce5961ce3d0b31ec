/* SPDX-License-Identifier: MIT */
/* A sinusoidal bias of random phase: A sin(2 pi f t + p), its integral over a step is exact. The two
 * quadratures are signals of the block, a lane has their amplitudes A cos p and A sin p. */
#include "core/random.h"
#include "sensors/params.h"
#include "sensors/terms.h"
#include <math.h>

enum { AMPLITUDE, FREQUENCY };
enum { SIGNALS = 2 };

#define PARAMS(NUMBER, DIM_, MAX, EXAMPLE, DOC)                                                    \
    {                                                                                              \
        [AMPLITUDE] = PARAM_SOURCE("sinusoid", NUMBER, DIM_, 0, MAX, PERIODIC, EXAMPLE, DOC,       \
                                   "A sin(2 pi f t + p), p uniform per run and axis",              \
                                   .companion = "sinusoid_frequency"),                             \
        [FREQUENCY] = PARAM_SETTING("sinusoid_frequency", FREQUENCY, 1.0, 1e-9, 1e5, "0.01 Hz",    \
                                    "frequency of sinusoid", .companion = "sinusoid"),             \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] =
    PARAMS(114, ACCEL, 1e3, "10 ug", "amplitude of a sinusoidal bias");
static const schuler_param gyro_params[] =
    PARAMS(214, RATE, 1e2, "0.01 deg/h", "amplitude of a sinusoidal drift");

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    for (int axis = 0; axis < 3; axis++) {
        const double w = 2.0 * M_PI * setup_setting(s, FREQUENCY, axis);
        const double half = 0.5 * w * v->dt_s;
        const double width_s = v->dt_s * (half < 1e-4 ? 1.0 - half * half / 6.0 : sin(half) / half);
        double *const sine = signals + axis * SIGNALS * SCHULER_BLOCK;
        double *const cosine = sine + SCHULER_BLOCK;
        for (int k = 0; k < v->n; k++) {
            const double angle = w * (((double)(v->first + k) + 0.5) * v->dt_s);
            sine[k] = width_s * sin(angle);
            cosine[k] = width_s * cos(angle);
        }
    }
}

static int setup(void *state, const schuler_model_setup *s)
{
    terms *const t = state;
    const schuler_param *const p = s->instrument == SCHULER_ACCEL ? accel_params : gyro_params;
    for (int axis = 0; axis < 3; axis++) {
        double along[SCHULER_LANES] __attribute__((aligned(64)));
        double across[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) {
            const schuler_stream stream = { s->seed, s->specs[l].run, p[AMPLITUDE].number,
                                            (unsigned)axis, SCHULER_USE_START };
            const double phase = M_PI * schuler_stream_uniform(stream, 0);
            const double amplitude = setup_lane(s, l, AMPLITUDE, axis);
            along[l] = amplitude * cos(phase);
            across[l] = amplitude * sin(phase);
        }
        t->count[axis] = SIGNALS;
        for (int q = 0; q < SIGNALS; q++) t->which[axis][q] = q;
        t->c[axis][0] = lanes_load(along);
        t->c[axis][1] = lanes_load(across);
    }
    return setup_any(s, AMPLITUDE, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    terms_apply(state, b, SIGNALS, 0);
}

STAGE(sinusoid) = {
    .name = "sinusoid",
    .summary = "sinusoidal bias of random phase",
    .source = "IEEE Std 952-1997 annex C (sinusoidal noise)",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(terms),
    .signals = SIGNALS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

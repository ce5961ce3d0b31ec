/* SPDX-License-Identifier: MIT */
/* The instrument follows its input like a second-order (or first-order) low-pass, exact for an input
 * that is constant within a sample. What comes out is the integral of the filtered rate:
 *
 *     integral y = integral u - (2 zeta/omega_n) (y2 - y1) - (y2' - y1')/omega_n^2
 *
 * so that no angle is lost for good. It begins settled on its first input. */
#include "sensors/params.h"
#include "sensors/response.h"
#include "sensors/setup.h"

enum { FREQUENCY, ORDER, DAMPING };

static const char *const orders[] = { "second", "first", NULL };

#define PARAMS(NUMBER)                                                                             \
    {                                                                                              \
        [FREQUENCY] =                                                                              \
            PARAM_SOURCE("bandwidth", NUMBER, FREQUENCY, 0, 1e6, RESPONSE, "100 Hz",               \
                         "natural frequency of the second-order response, -3 dB frequency of "     \
                         "the first-order one",                                                    \
                         "y'' + 2 zeta w y' + w^2 y = w^2 x, w = 2 pi f", .noisy = 0),             \
        [ORDER] = PARAM_CHOICE("bandwidth_order", orders, "first", "order of the response"),       \
        [DAMPING] = PARAM_SETTING("damping", NONE, 0.70710678118654752440, 0.01, 100.0, "0.7",     \
                                  "damping zeta of the second-order response"),                    \
        { 0 },                                                                                     \
    }

static const schuler_param accel_params[] = PARAMS(109);
static const schuler_param gyro_params[] = PARAMS(209);

typedef struct {
    lanes phi[3][2][2], gamma[3][2], keep[3][2];
    lanes y[3], y_dot[3];
    double rate_per_increment;
    int started;
} bandwidth;

static int setup(void *state, const schuler_model_setup *s)
{
    bandwidth *m = state;
    m->started = 0;
    m->rate_per_increment = 1.0 / s->dt_s;
    const int is_first = setup_setting(s, ORDER, 0) == 1.0;
    for (int i = 0; i < 3; i++) {
        double x[8][SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) {
            const double f_hz = setup_lane(s, l, FREQUENCY, i);
            schuler_response r = { 0 };
            if (f_hz > 0.0)
                r = is_first ? schuler_first_order(f_hz, s->dt_s)
                             : schuler_second_order(f_hz, setup_setting(s, DAMPING, i), s->dt_s);
            const double all[8] = { r.phi[0][0], r.phi[0][1], r.phi[1][0], r.phi[1][1],
                                    r.gamma[0],  r.gamma[1],  r.keep[0],   r.keep[1] };
            for (int q = 0; q < 8; q++) x[q][l] = all[q];
        }
        for (int q = 0; q < 4; q++) m->phi[i][q / 2][q % 2] = lanes_load(x[q]);
        for (int q = 0; q < 2; q++) {
            m->gamma[i][q] = lanes_load(x[4 + q]);
            m->keep[i][q] = lanes_load(x[6 + q]);
        }
    }
    return setup_any(s, FREQUENCY, 3);
}

static void apply(void *state, const schuler_model_block *b)
{
    bandwidth *m = state;
    const lanes rate = lanes_set(m->rate_per_increment);
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        lanes y = m->y[axis], y_dot = m->y_dot[axis];
        if (!m->started) {
            y = lanes_load(out) * rate;
            y_dot = lanes_set(0.0);
        }
        const lanes p00 = m->phi[axis][0][0], p01 = m->phi[axis][0][1];
        const lanes p10 = m->phi[axis][1][0], p11 = m->phi[axis][1][1];
        const lanes g0 = m->gamma[axis][0], g1 = m->gamma[axis][1];
        const lanes keep = m->keep[axis][0], keep_dot = m->keep[axis][1];
        for (int k = 0; k < b->n; k++) {
            const lanes increment = lanes_load(out + k * SCHULER_LANES), u = increment * rate;
            const lanes next = p00 * y + p01 * y_dot + g0 * u;
            const lanes next_dot = p10 * y + p11 * y_dot + g1 * u;
            lanes_store(out + k * SCHULER_LANES,
                        increment - (keep * (next - y) + keep_dot * (next_dot - y_dot)));
            y = next;
            y_dot = next_dot;
        }
        m->y[axis] = y;
        m->y_dot[axis] = y_dot;
    }
    m->started = 1;
}

STAGE(bandwidth) = {
    .name = "bandwidth",
    .summary = "low-pass response of the instrument",
    .source = "second-order step response, exact for an input held over a sample",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(bandwidth),
    .equation = "y'' + 2 zeta w y' + w^2 y = w^2 x;  first order: y' = w (x - y)",
    .setup = setup,
    .apply = apply,
};

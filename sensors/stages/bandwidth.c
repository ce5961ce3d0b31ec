/* SPDX-License-Identifier: MIT */
/* The instrument follows its input like a second-order (or first-order) low-pass, exact for an input
 * that is a parabola within a sample. What comes out is the integral of the filtered rate:
 *
 *     integral y = integral u - (2 zeta/omega_n) (y2 - y1) - (y2' - y1')/omega_n^2
 *
 * so that no angle is lost for good. It begins settled on its first input. */
#include "sensors/instant.h"
#include "sensors/params.h"
#include "sensors/response.h"

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

/* Coefficients of one axis: of schuler_response, over one part of a step. */
typedef struct {
    lanes phi[2][2], node[3][2], keep[2];
    lanes y, y_dot;
} axis_state;

typedef struct {
    schuler_instrument instrument;
    axis_state axis[3];
    double f_hz[3][SCHULER_LANES], zeta[3]; /* zeta < 0: first order */
    int started;
} bandwidth;

static int setup(void *state, const schuler_model_setup *s)
{
    bandwidth *m = state;
    m->started = 0;
    m->instrument = s->instrument;
    const int is_first = setup_setting(s, ORDER, 0) == 1.0;
    for (int i = 0; i < 3; i++) {
        m->zeta[i] = is_first ? -1.0 : setup_setting(s, DAMPING, i);
        for (int l = 0; l < SCHULER_LANES; l++) m->f_hz[i][l] = setup_lane(s, l, FREQUENCY, i);
    }
    return setup_any(s, FREQUENCY, 3);
}

/* All zero where there is no bandwidth: then nothing is kept back. */
static void set_axis(axis_state *a, const double f_hz[SCHULER_LANES], double zeta, double dt_s)
{
    double x[12][SCHULER_LANES] __attribute__((aligned(64)));
    schuler_response r = { 0 };
    double known_hz = 0.0;
    for (int l = 0; l < SCHULER_LANES; l++) {
        if (f_hz[l] != known_hz) {
            known_hz = f_hz[l];
            r = known_hz == 0.0 ? (schuler_response){ 0 }
                : zeta < 0.0    ? schuler_first_order(known_hz, dt_s)
                                : schuler_second_order(known_hz, zeta, dt_s);
        }
        const double all[12] = { r.phi[0][0],  r.phi[0][1],  r.phi[1][0],  r.phi[1][1],
                                 r.node[0][0], r.node[0][1], r.node[1][0], r.node[1][1],
                                 r.node[2][0], r.node[2][1], r.keep[0],    r.keep[1] };
        for (int q = 0; q < 12; q++) x[q][l] = all[q];
    }
    for (int q = 0; q < 4; q++) a->phi[q / 2][q % 2] = lanes_load(x[q]);
    for (int q = 0; q < 6; q++) a->node[q / 2][q % 2] = lanes_load(x[4 + q]);
    for (int q = 0; q < 2; q++) a->keep[q] = lanes_load(x[10 + q]);
}

/* The input within a step is the truth at its nodes, three in each part; what stages before have added
 * is constant in it. */
static void apply(void *state, const schuler_model_block *b)
{
    bandwidth *m = state;
    const int parts = b->view->nodes / 3;
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        axis_state *const a = &m->axis[axis];
        if (!m->started) {
            set_axis(a, m->f_hz[axis], m->zeta[axis], b->dt_s / parts);
            a->y = lanes_load(out) * lanes_set(1.0 / b->dt_s);
            a->y_dot = lanes_set(0.0);
        }
        lanes y = a->y, y_dot = a->y_dot;
        for (int k = 0; k < b->n; k++) {
            const lanes increment = lanes_load(out + k * SCHULER_LANES);
            const lanes error = instant_error(b, m->instrument, axis, k, increment);
            const lanes before = y, before_dot = y_dot;
            for (int p = 0; p < parts; p++) {
                lanes next = a->phi[0][0] * y + a->phi[0][1] * y_dot;
                lanes next_dot = a->phi[1][0] * y + a->phi[1][1] * y_dot;
                for (int j = 0; j < 3; j++) {
                    const lanes u = instant_value(b, m->instrument, axis, k, 3 * p + j, error);
                    next += a->node[j][0] * u;
                    next_dot += a->node[j][1] * u;
                }
                y = next;
                y_dot = next_dot;
            }
            lanes_store(out + k * SCHULER_LANES, increment - (a->keep[0] * (y - before) +
                                                              a->keep[1] * (y_dot - before_dot)));
        }
        a->y = y;
        a->y_dot = y_dot;
    }
    m->started = 1;
}

STAGE(bandwidth) = {
    .name = "bandwidth",
    .summary = "low-pass response of the instrument",
    .source = "second-order response, exact for an input that is a parabola within a sample",
    .params = { [SCHULER_ACCEL] = accel_params, [SCHULER_GYRO] = gyro_params },
    .state_size = sizeof(bandwidth),
    .needs_view = 1,
    .equation = "y'' + 2 zeta w y' + w^2 y = w^2 x;  first order: y' = w (x - y)",
    .setup = setup,
    .apply = apply,
};

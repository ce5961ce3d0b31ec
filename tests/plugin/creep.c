/* SPDX-License-Identifier: MIT */
/* Creep of the flexure of an accelerometer: a part c of the input comes late, by a first-order lag,
 *
 *     y = x + c m,   dm/dt = (x - m)/tau,   m = 0 at the start
 *
 * so that a cycle of the input leaves a loop whose width depends on its rate. Exact for an input that
 * is constant within a sample: the integral of m is that of x less tau times the change of m. */
#include "sensors/params.h"
#include "sensors/plugin.h"
#include "sensors/setup.h"
#include <math.h>

enum { CREEP, TIME };

static const schuler_param params[] = {
    [CREEP] = PARAM_SOURCE("creep", 1000, NONE, -0.1, 0.1, SCALE, "100 ppm",
                           "part of the specific force that is indicated late",
                           "y = x + c m, dm/dt = (x - m)/tau", .companion = "creep_time"),
    [TIME] = PARAM_SETTING("creep_time", TIME, 60.0, 1e-3, 1e6, "60 s", "time constant of creep",
                           .companion = "creep"),
    { 0 },
};

typedef struct {
    lanes c[3], m[3];               /* m: rate of the lagging part, m/s^2 */
    double phi[3], tau_s[3], per_s; /* settings: the same in every lane   */
} creep;

static int setup(void *state, const schuler_model_setup *s)
{
    creep *const it = state;
    it->per_s = 1.0 / s->dt_s;
    for (int i = 0; i < 3; i++) {
        it->c[i] = setup_value(s, CREEP, i);
        it->m[i] = lanes_set(0.0);
        it->tau_s[i] = setup_setting(s, TIME, i);
        it->phi[i] = exp(-s->dt_s / it->tau_s[i]);
    }
    return 1;
}

static void apply(void *state, const schuler_model_block *b)
{
    creep *const it = state;
    for (int i = 0; i < 3; i++) {
        double *const out = b->out + i * b->stride * SCHULER_LANES;
        lanes m = it->m[i];
        for (int k = 0; k < b->n; k++) {
            const lanes dv = lanes_set(b->own[i * b->stride + k]);
            const lanes x = dv * lanes_set(it->per_s);
            const lanes next = x + lanes_set(it->phi[i]) * (m - x);
            const lanes late = dv - lanes_set(it->tau_s[i]) * (next - m);
            lanes_store(out + k * SCHULER_LANES, dv + it->c[i] * late);
            m = next;
        }
        it->m[i] = m;
    }
}

MODEL(creep) = {
    .name = "creep",
    .summary = "specific force that is indicated late in part",
    .source = "standard linear solid",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(creep),
    .setup = setup,
    .apply = apply,
};

SCHULER_PLUGIN(&MODEL_NAME(creep));

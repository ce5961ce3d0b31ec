/* SPDX-License-Identifier: MIT */
/* Accelerometers that are not where the navigator is thought to be:
 *
 *     f(r) = f + omega' x r + omega x (omega x r)
 *
 * lever_arm is r of the whole triad, size_effect what each instrument has beside it. Linear in r; the
 * integral of omega' over a step is the difference of omega at its ends. */
#include "sensors/params.h"
#include "sensors/terms.h"

enum { LEVER, SIZE };
enum { SIGNALS = 3 }; /* what a metre along x, y, z does */

static const schuler_param accel_params[] = {
    [LEVER] = PARAM_SOURCE("lever_arm", 107, LENGTH, -1e3, 1e3, NON_LINEAR, "[0.1 m, 0 m, -0.05 m]",
                           "position of the triad from the point that is navigated, body axes",
                           "omega' x r + omega x (omega x r)", .noisy = 0),
    [SIZE] = { .key = "size_effect",
               .number = 108,
               .dim = SCHULER_DIM_LENGTH,
               .components = 9,
               .min = -10.0,
               .max = 10.0,
               .acts = SCHULER_ACTS_NON_LINEAR,
               .example = "[2 cm, 0 m, 0 m, 0 m, 2 cm, 0 m, 0 m, 0 m, 2 cm]",
               .doc = "position of each instrument from the triad's centre, body axes, x y z of "
                      "one after the other",
               .formula = "omega' x r_k + omega x (omega x r_k)" },
    { 0 },
};

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    (void)s;
    for (int axis = 0; axis < 3; axis++) {
        const double *const i = v->axes[axis][0];
        for (int k = 0; k < v->n; k++) {
            double turn[3], sum[3] = { 0 };
            for (int j = 0; j < 3; j++) turn[j] = v->omega_end_b[j][k + 1] - v->omega_end_b[j][k];
            for (int q = 0; q < v->nodes; q++) {
                double w[3];
                for (int j = 0; j < 3; j++) w[j] = v->omega_b[j][q * SCHULER_BLOCK + k];
                const double along = w[0] * i[0] + w[1] * i[1] + w[2] * i[2];
                const double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
                for (int j = 0; j < 3; j++) sum[j] += v->weight[q] * (along * w[j] - square * i[j]);
            }
            /* i . (turn x e_j) = e_j . (i x turn) */
            for (int j = 0; j < 3; j++)
                signals[(axis * SIGNALS + j) * SCHULER_BLOCK + k] =
                    i[(j + 1) % 3] * turn[(j + 2) % 3] - i[(j + 2) % 3] * turn[(j + 1) % 3] +
                    v->dt_s * sum[j];
        }
    }
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    (void)s;
    for (int j = 0; j < 3; j++) c[j] = v[LEVER][j] + v[SIZE][3 * axis + j];
}

TERMS_STAGE(SIGNALS, coefficients)

STAGE(lever_arm) = {
    .name = "lever_arm",
    .summary = "lever arm of the triad and of each accelerometer (size effect)",
    .source = "rigid-body kinematics",
    .params = { [SCHULER_ACCEL] = accel_params },
    .state_size = sizeof(terms),
    .signals = SIGNALS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};

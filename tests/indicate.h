/* SPDX-License-Identifier: MIT */
/* A model's parameters by name, and what it indicates for a constant input. */
#ifndef SCHULER_TESTS_INDICATE_H
#define SCHULER_TESTS_INDICATE_H

#include "check.h"
#include "sensors/stand.h"
#include <string.h>

typedef struct {
    const schuler_sensor_model *model;
    schuler_instrument instrument;
    schuler_lane_spec values;
    double f[3], omega[3], alpha[3], out[3];
} indication;

static inline int indication_param(const indication *x, const char *key)
{
    const schuler_param *params = x->model->params[x->instrument];
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    fail_msg("%s has no parameter %s", x->model->name, key);
    return 0;
}

/* Settings at their defaults, no error, at rest in free fall. */
static inline indication indication_of(const char *model, schuler_instrument instrument)
{
    const int index = schuler_sensor_model_find(model);
    assert_true(index >= 0);
    indication x = { .model = schuler_sensor_models(SCHULER_ISA_SCALAR)[index],
                     .instrument = instrument };
    const schuler_param *params = x.model->params[instrument];
    assert_non_null(params);
    for (int i = 0; params[i].key; i++)
        for (int c = 0; params[i].number == 0 && c < params[i].components; c++)
            x.values.value[i][c] = params[i].def;
    return x;
}

/* The same on all axes. */
static inline void give(indication *x, const char *key, double value)
{
    const int i = indication_param(x, key);
    for (int c = 0; c < SCHULER_COMPONENTS_MAX; c++) x->values.value[i][c] = value;
}

static inline void give_axes(indication *x, const char *key, double a, double b, double c)
{
    double *const value = x->values.value[indication_param(x, key)];
    value[0] = a, value[1] = b, value[2] = c;
}

static inline void choose(indication *x, const char *key, const char *word)
{
    const int i = indication_param(x, key);
    const char *const *choices = x->model->params[x->instrument][i].choices;
    for (int c = 0; choices[c]; c++)
        if (strcmp(choices[c], word) == 0) {
            x->values.value[i][0] = c;
            return;
        }
    fail_msg("%s is no choice of %s", word, key);
}

/* What the x instrument says of (a_i, a_p, a_o). */
static inline double indicated(indication *x, double i, double p, double o)
{
    x->f[0] = i, x->f[1] = p, x->f[2] = o;
    assert_int_equal(
        schuler_indicate(x->model, x->instrument, &x->values, x->f, x->omega, x->alpha, x->out),
        SCHULER_OK);
    return x->out[0];
}

/* The mean output of the x instrument over 800 samples at 100 Hz. */
static inline double indicated_mean(const indication *x, schuler_stand_input input, void *user)
{
    static const bool none[SCHULER_PARAMS_MAX];
    enum { BLOCKS = 25 };
    const schuler_stand_setup setup = { .chain = { .model = x->model,
                                                   .is_plugin = true,
                                                   .isa = SCHULER_ISA_SCALAR,
                                                   .dt_s = 0.01,
                                                   .settings = &x->values,
                                                   .given = none,
                                                   .instrument = x->instrument },
                                        .specs = &x->values,
                                        .specimens = 1,
                                        .input = input,
                                        .user = user };
    schuler_stand *stand = NULL;
    assert_int_equal(schuler_stand_create(&stand, &setup, NULL), SCHULER_OK);
    double out[3][SCHULER_BLOCK], sum = 0.0;
    for (int b = 0; b < BLOCKS; b++) {
        schuler_stand_next(stand, SCHULER_BLOCK, out[0]);
        for (int k = 0; k < SCHULER_BLOCK; k++) sum += out[0][k];
    }
    schuler_stand_free(stand);
    return sum / (BLOCKS * SCHULER_BLOCK * 0.01);
}

#endif

/* SPDX-License-Identifier: MIT */
/* One triad on a test stand, set up by the keys of its table: increments for an input of one's choice. */
#ifndef SCHULER_TESTS_ONE_TRIAD_H
#define SCHULER_TESTS_ONE_TRIAD_H

#include "check.h"
#include "sensors/stand.h"
#include <stdlib.h>
#include <string.h>

/* all: of each component; NULL: value for all of them. */
typedef struct {
    const char *key;
    double value;
    const double *all;
} triad_key;

typedef struct {
    const char *model;
    schuler_instrument instrument;
    const triad_key *keys;
    int count, specimens;
    double dt_s;
    int64_t n;
    schuler_stand_input input;
    void *user;
    const schuler_temperature *temperature; /* or NULL */
} triad_job;

/* Increments [specimen][axis][n], to be freed. Specimen r is run r. */
static inline double *triad_measure(const triad_job *j)
{
    enum { SPECIMENS_MAX = 8 };
    const schuler_isa isa = schuler_isa_best();
    const int index = schuler_sensor_model_find(j->model);
    assert_true(index >= 0);
    const schuler_sensor_model *const model = schuler_sensor_models(isa)[index];
    static schuler_param params[SCHULER_PARAMS_MAX + 1];
    static schuler_lane_spec settings, specs[SPECIMENS_MAX];
    bool given[SCHULER_PARAMS_MAX] = { false };
    int found = 0;
    assert_true(j->specimens <= SPECIMENS_MAX);
    assert_true(schuler_chain_params(model, j->instrument, params) > 0);
    memset(&settings, 0, sizeof(settings));
    for (int k = 0; params[k].key; k++)
        for (int c = 0; c < params[k].components; c++) {
            settings.value[k][c] = params[k].number ? 0.0 : params[k].def;
            for (int i = 0; i < j->count; i++) {
                if (strcmp(j->keys[i].key, params[k].key) != 0) continue;
                settings.value[k][c] = j->keys[i].all ? j->keys[i].all[c] : j->keys[i].value;
                found += !given[k];
                given[k] = true;
            }
        }
    assert_int_equal(found, j->count);
    for (int r = 0; r < j->specimens; r++) {
        specs[r] = settings;
        specs[r].run = (uint64_t)r;
    }
    const schuler_stand_setup setup = { .chain = { .model = model,
                                                   .instrument = j->instrument,
                                                   .isa = isa,
                                                   .dt_s = j->dt_s,
                                                   .seed = 20,
                                                   .settings = &settings,
                                                   .given = given,
                                                   .temperature = j->temperature },
                                        .specs = specs,
                                        .specimens = (size_t)j->specimens,
                                        .input = j->input,
                                        .user = j->user };
    schuler_stand *stand = NULL;
    assert_int_equal(schuler_stand_create(&stand, &setup, NULL), SCHULER_OK);
    const int series = 3 * j->specimens;
    double *const y = malloc((size_t)(series * j->n) * sizeof(double));
    assert_non_null(y);
    static double block[3 * SPECIMENS_MAX][SCHULER_BLOCK];
    for (int64_t k = 0; k < j->n; k += SCHULER_BLOCK) {
        const int some = j->n - k < SCHULER_BLOCK ? (int)(j->n - k) : SCHULER_BLOCK;
        schuler_stand_next(stand, some, block[0]);
        for (int s = 0; s < series; s++)
            memcpy(&y[s * j->n + k], block[s], (size_t)some * sizeof(double));
    }
    schuler_stand_free(stand);
    return y;
}

#endif

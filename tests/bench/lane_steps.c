/* SPDX-License-Identifier: MIT */
/* A known number of lane-steps of sensors and mechanization, for counting instructions:
 *     lane_steps ISA NORMALS FRAME      NORMALS 0, 6 or 18 a step; prints the number of lane-steps
 * The work is done in the function `counted`, so that a profiler can count it alone. */
#include "core/isa.h"
#include "core/truth.h"
#include "mechanization/mechanization.h"
#include "sensors/chain.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GROUPS = 4, BLOCKS = 50, LANES_MAX = 8 };

typedef struct {
    schuler_isa isa;
    schuler_chain *chain[SCHULER_INSTRUMENTS];
    const schuler_mechanization *frame;
    void *state[GROUPS][SCHULER_INSTRUMENTS], *nav[GROUPS];
    double *measured[SCHULER_INSTRUMENTS];
    schuler_truth_block truth;
} work;

void counted(work *w); /* a name that callgrind finds */

__attribute__((noinline)) void counted(work *w)
{
    for (int b = 0; b < BLOCKS; b++) {
        w->truth.first = (int64_t)b * SCHULER_BLOCK;
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
            schuler_chain_observe(w->chain[i], &w->truth, NULL);
        for (int g = 0; g < GROUPS; g++) {
            for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
                schuler_chain_apply(w->chain[i], w->state[g][i], w->measured[i]);
            const schuler_nav_block nav = {
                SCHULER_BLOCK, SCHULER_BLOCK, w->measured[SCHULER_GYRO], w->measured[SCHULER_ACCEL],
                NULL,          NULL
            };
            w->frame->advance(w->nav[g], &nav);
            w->frame->hold_vertical(w->nav[g], 0.0, 0.0);
        }
    }
}

static void *aligned(size_t bytes)
{
    void *p = aligned_alloc(64, (bytes + 63) / 64 * 64);
    if (!p) exit(3);
    return p;
}

static const schuler_sensor_model *linear(schuler_isa isa)
{
    return schuler_sensor_models(isa)[schuler_sensor_model_find("linear")];
}

static void give(const schuler_param *params, const char *key, double value,
                 schuler_lane_spec *spec, bool *given)
{
    for (int k = 0; params[k].key; k++) {
        if (strcmp(params[k].key, key) != 0) continue;
        given[k] = true;
        for (int c = 0; c < params[k].components; c++) spec->value[k][c] = value;
    }
}

static void make_chain(work *w, schuler_instrument i, int normals, schuler_lane_spec *spec)
{
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    bool given[SCHULER_PARAMS_MAX] = { false };
    if (schuler_chain_params(linear(w->isa), i, params) < 0) exit(3);
    give(params, "bias", 1e-4, spec, given);
    if (normals >= 6)
        give(params, i == SCHULER_ACCEL ? "velocity_random_walk" : "angle_random_walk", 1e-5, spec,
             given);
    if (normals >= 18) {
        give(params, "gauss_markov", 1e-5, spec, given);
        give(params, "gauss_markov_time", 100.0, spec, given);
        give(params, "bias_random_walk", 1e-7, spec, given);
    }
    const schuler_chain_setup setup = { .model = linear(w->isa),
                                        .instrument = i,
                                        .isa = w->isa,
                                        .dt_s = w->truth.dt_s,
                                        .seed = 1,
                                        .settings = spec,
                                        .given = given };
    if (schuler_chain_create(&w->chain[i], &setup, NULL) != SCHULER_OK) exit(3);
}

static void set_up(work *w, int normals, const schuler_gravity_table *gravity)
{
    const int lanes = schuler_isa_lanes(w->isa);
    schuler_lane_spec spec[SCHULER_INSTRUMENTS] = { { 0 } };
    schuler_nav_state start[LANES_MAX];
    double knows_dg[LANES_MAX];
    for (int l = 0; l < lanes; l++) {
        start[l] =
            (schuler_nav_state){ .r_e = schuler_ecef_from_llh((schuler_llh){ 0.8, 0.1, 0.0 }),
                                 .q_b_e = { 1, 0, 0, 0 } };
        knows_dg[l] = 1.0;
    }
    w->truth.n = SCHULER_BLOCK;
    w->truth.dt_s = 0.01;
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        make_chain(w, (schuler_instrument)i, normals, &spec[i]);
        w->measured[i] = aligned((size_t)3 * SCHULER_BLOCK * LANES_MAX * sizeof(double));
    }
    for (int g = 0; g < GROUPS; g++) {
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            schuler_lane_spec specs[LANES_MAX];
            for (int l = 0; l < lanes; l++) {
                specs[l] = spec[i];
                specs[l].run = (uint64_t)(g * lanes + l);
            }
            w->state[g][i] = aligned(schuler_chain_state_size(w->chain[i]));
            schuler_chain_start(w->chain[i], w->state[g][i], specs);
        }
        const schuler_nav_setup nav = { .dt_s = 0.01,
                                        .samples_per_update = 1,
                                        .order = 4,
                                        .gravity = gravity,
                                        .lanes = lanes,
                                        .start = start,
                                        .dg_coefficient = knows_dg };
        w->nav[g] = aligned(w->frame->state_size);
        w->frame->init(w->nav[g], &nav);
    }
}

int main(int argc, char **argv)
{
    const schuler_isa isa = argc == 4 ? schuler_isa_find(argv[1]) : SCHULER_ISA_COUNT;
    const int frame = argc == 4 ? schuler_mechanization_find(argv[3]) : -1;
    if (isa == SCHULER_ISA_COUNT || frame < 0) return 2;
    if (!schuler_isa_available(isa)) return 77;
    static work w;
    schuler_field_model *field = NULL;
    schuler_gravity_table gravity;
    if (schuler_field_open(&field, "wgs84", NULL) != SCHULER_OK ||
        schuler_gravity_fit(&gravity, field, NULL) != SCHULER_OK)
        return 3;
    w.isa = isa;
    w.frame = schuler_mechanizations(isa)[frame];
    set_up(&w, atoi(argv[2]), &gravity);
    counted(&w);
    printf("%d\n", BLOCKS * GROUPS * SCHULER_BLOCK * schuler_isa_lanes(isa));
    schuler_field_close(field);
    return 0;
}

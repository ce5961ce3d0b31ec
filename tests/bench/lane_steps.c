/* SPDX-License-Identifier: MIT */
/* A known number of lane-steps of sensors and mechanization, for counting instructions:
 *     lane_steps ISA NORMALS      NORMALS 0, 6 or 18 a step; prints the number of lane-steps
 * The work is done in the function `counted`, so that a profiler can count it alone. */
#include "core/isa.h"
#include "core/truth.h"
#include "mechanization/mechanization.h"
#include "sensors/model.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GROUPS = 4, BLOCKS = 50, LANES_MAX = 8 };

typedef struct {
    const schuler_sensor_model *model;
    const schuler_mechanization *frame;
    void *state[GROUPS][SCHULER_INSTRUMENTS], *nav[GROUPS];
    double *measured[SCHULER_INSTRUMENTS];
    schuler_truth_block truth;
} work;

void counted(work *w); /* a name that callgrind finds */

__attribute__((noinline)) void counted(work *w)
{
    for (int b = 0; b < BLOCKS; b++)
        for (int g = 0; g < GROUPS; g++) {
            w->truth.first = (int64_t)b * SCHULER_BLOCK;
            for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
                const schuler_model_block block = { w->truth.first,
                                                    SCHULER_BLOCK,
                                                    SCHULER_BLOCK,
                                                    w->truth.dt_s,
                                                    i == SCHULER_ACCEL
                                                        ? &w->truth.dv_ib_b[0][0]
                                                        : &w->truth.dtheta_ib_b[0][0],
                                                    NULL,
                                                    w->measured[i] };
                w->model->apply(w->state[g][i], &block);
            }
            const schuler_nav_block nav = {
                SCHULER_BLOCK, SCHULER_BLOCK, w->measured[SCHULER_GYRO], w->measured[SCHULER_ACCEL],
                NULL,          NULL
            };
            w->frame->advance(w->nav[g], &nav);
            w->frame->hold_vertical(w->nav[g], 0.0, 0.0);
        }
}

static void *aligned(size_t bytes)
{
    void *p = aligned_alloc(64, (bytes + 63) / 64 * 64);
    if (!p) exit(3);
    return p;
}

static void give(const work *w, schuler_instrument i, const char *key, double value,
                 schuler_lane_spec *spec)
{
    const schuler_param *params = w->model->params[i];
    for (int k = 0; params[k].key; k++)
        for (int c = 0; strcmp(params[k].key, key) == 0 && c < params[k].components; c++)
            spec->value[k][c] = value;
}

static void set_up(work *w, schuler_isa isa, int normals, const schuler_gravity_table *gravity)
{
    const int lanes = schuler_isa_lanes(isa);
    schuler_nav_state start[LANES_MAX];
    double knows_dg[LANES_MAX];
    for (int l = 0; l < lanes; l++) {
        start[l] =
            (schuler_nav_state){ .r_e = schuler_ecef_from_llh((schuler_llh){ 0.8, 0.1, 0.0 }),
                                 .q_b_e = { 1, 0, 0, 0 } };
        knows_dg[l] = 1.0;
    }
    w->truth.dt_s = 0.01;
    for (int g = 0; g < GROUPS; g++) {
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            schuler_lane_spec specs[LANES_MAX] = { { 0 } };
            for (int l = 0; l < lanes; l++) {
                specs[l].run = (uint64_t)(g * lanes + l);
                give(w, (schuler_instrument)i, "bias", 1e-4, &specs[l]);
                /* So short that the drives are needed at every step. */
                give(w, (schuler_instrument)i, "gauss_markov_time", 0.01, &specs[l]);
                if (normals >= 6)
                    give(w, (schuler_instrument)i,
                         i == SCHULER_ACCEL ? "velocity_random_walk" : "angle_random_walk", 1e-5,
                         &specs[l]);
                if (normals >= 18) give(w, (schuler_instrument)i, "gauss_markov", 1e-5, &specs[l]);
            }
            const schuler_model_setup setup = { (schuler_instrument)i, 1, 0.01, lanes, specs };
            w->state[g][i] = aligned(w->model->state_size);
            w->model->setup(w->state[g][i], &setup);
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
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
        w->measured[i] = aligned((size_t)3 * SCHULER_BLOCK * LANES_MAX * sizeof(double));
}

int main(int argc, char **argv)
{
    const schuler_isa isa = argc == 3 ? schuler_isa_find(argv[1]) : SCHULER_ISA_COUNT;
    if (isa == SCHULER_ISA_COUNT) return 2;
    if (!schuler_isa_available(isa)) return 77;
    static work w;
    schuler_field_model *field = NULL;
    schuler_gravity_table gravity;
    if (schuler_field_open(&field, "wgs84", NULL) != SCHULER_OK ||
        schuler_gravity_fit(&gravity, field, NULL) != SCHULER_OK)
        return 3;
    w.model = schuler_sensor_models(isa)[schuler_sensor_model_find("linear")];
    w.frame = schuler_mechanizations(isa)[schuler_mechanization_find("ecef")];
    set_up(&w, isa, atoi(argv[2]), &gravity);
    counted(&w);
    printf("%d\n", BLOCKS * GROUPS * SCHULER_BLOCK * schuler_isa_lanes(isa));
    schuler_field_close(field);
    return 0;
}

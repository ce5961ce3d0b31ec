/* SPDX-License-Identifier: MIT */
/* Models of the registry as a user would set them up by the examples of their tables, on a motion that
 * shows every error. */
#ifndef SCHULER_TESTS_SPECIMEN_H
#define SCHULER_TESTS_SPECIMEN_H

#include "sensors/chain.h"
#include "unit/scenario_text.h"

enum { RUNS = 16, BLOCKS = 5, LAST = 13, STEPS = (BLOCKS - 1) * SCHULER_BLOCK + LAST };
#define DT_S 0.01

/* Increments of RUNS lanes. */
typedef double measured[RUNS][3][STEPS];

static schuler_truth_block truth[BLOCKS];
static schuler_truth_nodes nodes[BLOCKS];

/* Almost at rest at first, so that thresholds are seen; then a swing through 15 g and 8 rad/s, so
 * that ranges are. All axes differ. */
static inline double input(int instrument, int axis, double t_s)
{
    const double size = instrument == SCHULER_GYRO ? 8.0 : 150.0;
    return size * (t_s < 0.08 ? 1e-9 : 1.0) * sin(1.0 + axis + (7.0 + 3.0 * axis) * t_s);
}

/* The last block is a short one, as at the end of a mission. */
static inline int move(void **state)
{
    static const double x[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    static const double w[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    (void)state;
    for (int i = 0; i < BLOCKS; i++) {
        const int n = i == BLOCKS - 1 ? LAST : SCHULER_BLOCK;
        const double start = i * SCHULER_BLOCK;
        truth[i].first = (int64_t)i * SCHULER_BLOCK;
        truth[i].n = n;
        truth[i].dt_s = DT_S;
        nodes[i].nodes = 3;
        memcpy(nodes[i].fraction, x, sizeof x);
        memcpy(nodes[i].weight, w, sizeof w);
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k <= n; k++)
                nodes[i].omega_end_b[axis][k] = input(SCHULER_GYRO, axis, (start + k) * DT_S);
            for (int k = 0; k < n; k++)
                for (int j = 0; j < 3; j++) {
                    const double t_s = (start + k + x[j]) * DT_S;
                    const double f = input(SCHULER_ACCEL, axis, t_s);
                    const double omega = input(SCHULER_GYRO, axis, t_s);
                    nodes[i].f_ib_b[axis][j][k] = f;
                    nodes[i].omega_ib_b[axis][j][k] = omega;
                    truth[i].dv_ib_b[axis][k] += w[j] * DT_S * f;
                    truth[i].dtheta_ib_b[axis][k] += w[j] * DT_S * omega;
                }
        }
    }
    return 0;
}

static inline double true_increment(schuler_instrument instrument, int axis, int step)
{
    const schuler_truth_block *const block = &truth[step / SCHULER_BLOCK];
    return (instrument == SCHULER_GYRO ? block->dtheta_ib_b
                                       : block->dv_ib_b)[axis][step % SCHULER_BLOCK];
}

/* A model of an instrument and what its table says of itself. */
typedef struct {
    const schuler_sensor_model *model;
    int index;
    schuler_instrument instrument;
    schuler_part *part;
    const schuler_param *params; /* of the model and of all stages */
    schuler_lane_spec off, on;   /* settings at their defaults; everything at its example */
} specimen;

static inline void make(specimen *s, int model, schuler_instrument instrument)
{
    *s = (specimen){ .index = model, .instrument = instrument };
    s->model = schuler_sensor_models(SCHULER_ISA_SCALAR)[model];
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    assert_true(schuler_chain_params(s->model, instrument, params) > 0);
    static char text[64 * 1024];
    size_t at = 0;
    at += (size_t)snprintf(text, sizeof text, "sensor: test\n%s: {model: linear}\n%s: {model: %s",
                           schuler_instrument_name((schuler_instrument)(1 - (int)instrument)),
                           schuler_instrument_name(instrument), s->model->name);
    for (int k = 0; params[k].key; k++)
        at += (size_t)snprintf(text + at, sizeof text - at, ",\n  %s: %s", params[k].key,
                               params[k].example);
    at += (size_t)snprintf(text + at, sizeof text - at, "}\n");
    assert_true(at < sizeof text);
    loaded l;
    make_folder(&l);
    write_file(l.dir, "s.yaml", text, at);
    const schuler_status status = schuler_part_load(&s->part, l.path, &l.d);
    for (size_t i = 0; i < l.d.kept; i++) print_error("%s\n", l.d.items[i].message);
    assert_int_equal(status, SCHULER_OK);
    unload(&l);
    const schuler_triad *const triad = &s->part->imu.triad[instrument];
    s->params = triad->params;
    for (int k = 0; params[k].key; k++)
        for (int i = 0; i < params[k].components; i++) {
            const schuler_value *const v = &triad->values[k];
            s->on.value[k][i] = v->draw == SCHULER_DRAW_UNIFORM ? v->b[i] : v->a[i];
            s->off.value[k][i] = params[k].number ? 0.0 : params[k].def;
        }
}

/* Any test over all models of both instruments. */
static inline void for_each(void (*test)(const specimen *s))
{
    static specimen s;
    for (int m = 0; schuler_sensor_models(SCHULER_ISA_SCALAR)[m]; m++)
        for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
            if (!schuler_sensor_models(SCHULER_ISA_SCALAR)[m]->params[i]) continue;
            make(&s, m, (schuler_instrument)i);
            test(&s);
            schuler_part_free(s.part);
        }
}

/* All stages are made to look, also those that have nothing to do. */
static inline void measure_each(schuler_isa isa, const specimen *s, const schuler_lane_spec *specs,
                                uint64_t seed, measured out)
{
    static const schuler_temperature warm_up = {
        .reference_K = 298.0, .start_K = 290.0, .end_K = 330.0, .time_s = 5.0
    };
    bool given[SCHULER_PARAMS_MAX];
    for (int k = 0; k < SCHULER_PARAMS_MAX; k++) given[k] = true;
    const schuler_chain_setup setup = { .model = schuler_sensor_models(isa)[s->index],
                                        .instrument = s->instrument,
                                        .isa = isa,
                                        .dt_s = DT_S,
                                        .seed = seed,
                                        .settings = &specs[0],
                                        .given = given,
                                        .temperature = &warm_up };
    const int width = schuler_isa_lanes(isa);
    schuler_chain *chain = NULL;
    assert_int_equal(schuler_chain_create(&chain, &setup, NULL), SCHULER_OK);
    void *const state = aligned_alloc(64, schuler_chain_state_size(chain));
    double *const y = aligned_alloc(64, (size_t)3 * SCHULER_BLOCK * 8 * sizeof(double));
    assert_non_null(state);
    assert_non_null(y);
    for (int first = 0; first < RUNS; first += width) {
        schuler_lane_spec mine[8];
        for (int l = 0; l < width; l++) {
            mine[l] = specs[first + l];
            mine[l].run = (uint64_t)(first + l);
        }
        schuler_chain_start(chain, state, mine);
        for (int i = 0; i < BLOCKS; i++) {
            schuler_chain_observe(chain, &truth[i], &nodes[i]);
            schuler_chain_apply(chain, state, y);
            for (int at = 0; at < 3 * SCHULER_BLOCK; at++)
                for (int l = 0; l < width && at % SCHULER_BLOCK < truth[i].n; l++)
                    out[first + l][at / SCHULER_BLOCK][i * SCHULER_BLOCK + at % SCHULER_BLOCK] =
                        y[at * width + l];
        }
    }
    free(state);
    free(y);
    schuler_chain_free(chain);
}

/* Every lane alike but for its run. */
static inline void measure(const specimen *s, const schuler_lane_spec *spec, uint64_t seed,
                           measured out)
{
    static schuler_lane_spec specs[RUNS];
    for (int r = 0; r < RUNS; r++) specs[r] = *spec;
    measure_each(schuler_isa_best(), s, specs, seed, out);
}

#endif

/* SPDX-License-Identifier: MIT */
#include "sensors/chain.h"
#include "sensors/mounting.h"
#include <stdlib.h>
#include <string.h>

enum { LINKS_MAX = 64, ALIGN = 64 };

/* A table of the chain that some lane may need. */
typedef struct {
    const schuler_sensor_model *table;
    int base;            /* of its parameters            */
    size_t offset, size; /* of its state, and of one lane's when it is for one lane */
    int lanes;           /* it works on so many at once  */
    double *signals;     /* [axis][signal][step], or NULL */
} link;

struct schuler_chain {
    schuler_instrument instrument;
    double dt_s;
    uint64_t seed;
    int width, count;
    bool needs_nodes, own_is_body;
    link links[LINKS_MAX];
    size_t state_size;
    schuler_lane_spec settings;
    const schuler_temperature *temperature;
    double start_s;
    double axes[3][3][3]; /* [instrument][i, p, o][body] */
    /* Of the block that was observed last. */
    schuler_view view;
    const double *own_body;
    double own[3][SCHULER_BLOCK];
    double f[3][3][SCHULER_NODES_MAX][SCHULER_BLOCK], omega[3][3][SCHULER_NODES_MAX][SCHULER_BLOCK];
    double omega_end[3][3][SCHULER_BLOCK + 1];
    double temperature_K[SCHULER_NODES_MAX][SCHULER_BLOCK];
    double temperature_rate[SCHULER_NODES_MAX][SCHULER_BLOCK];
    double *one_lane; /* for a table of one lane: [axis][step] */
};

int schuler_chain_params(const schuler_sensor_model *model, schuler_instrument instrument,
                         schuler_param out[SCHULER_PARAMS_MAX + 1])
{
    const schuler_sensor_model *const *stages = schuler_sensor_stages(SCHULER_ISA_SCALAR);
    int count = 0;
    for (const schuler_sensor_model *t = model; t; t = *stages++) {
        const schuler_param *const params = t->params[instrument];
        for (int i = 0; params && params[i].key; i++) {
            if (count == SCHULER_PARAMS_MAX) return -1;
            out[count++] = params[i];
        }
    }
    out[count] = (schuler_param){ 0 };
    return count;
}

static size_t padded(size_t size)
{
    return (size + ALIGN - 1) / ALIGN * ALIGN;
}

/* Whether a table does anything; a model always does. */
static bool is_wanted(const schuler_chain_setup *s, const schuler_sensor_model *table, int base)
{
    const schuler_param *const params = table->params[s->instrument];
    bool wanted = table == s->model;
    for (int i = 0; params && params[i].key; i++) wanted |= s->given[base + i];
    return wanted;
}

static schuler_status add_link(schuler_chain *c, const schuler_chain_setup *s,
                               const schuler_sensor_model *table, int base)
{
    link *const l = &c->links[c->count++];
    *l = (link){ .table = table, .base = base, .lanes = c->width };
    l->size = padded(table->state_size);
    if (table == s->model && s->is_plugin) l->lanes = 1;
    l->offset = c->state_size;
    c->state_size += l->size * (size_t)(c->width / l->lanes);
    c->needs_nodes |= table->needs_view || table->observe;
    if (!table->observe) return SCHULER_OK;
    l->signals = calloc((size_t)table->signals * 3 * SCHULER_BLOCK, sizeof(double));
    return l->signals ? SCHULER_OK : SCHULER_ERR_MEMORY;
}

/* Values of a setting by its key, NULL when the chain has none of that name. */
static const double *setting(const schuler_chain *c, const schuler_param *params, const char *key)
{
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return c->settings.value[i];
    return NULL;
}

static schuler_status mount(schuler_chain *c, const schuler_param *params, schuler_error *err)
{
    static const double none[9] = { 0 };
    const double *const input = setting(c, params, "input_axes");
    const double *const second =
        setting(c, params, c->instrument == SCHULER_ACCEL ? "pendulous_axes" : "output_axes");
    double back[3][3];
    schuler_mounting_axes(input ? input : none, second ? second : none, c->axes);
    if (!schuler_mounting_back(c->axes, back))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "the input axes of the %ss lie in a plane",
                            schuler_instrument_name(c->instrument));
    c->own_is_body = true;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) c->own_is_body &= c->axes[k][0][j] == (j == k ? 1.0 : 0.0);
    return SCHULER_OK;
}

schuler_status schuler_chain_create(schuler_chain **out, const schuler_chain_setup *s,
                                    schuler_error *err)
{
    schuler_param params[SCHULER_PARAMS_MAX + 1];
    schuler_chain *const c = calloc(1, sizeof *c);
    if (!c) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    c->instrument = s->instrument;
    c->dt_s = s->dt_s;
    c->seed = s->seed;
    c->width = schuler_isa_lanes(s->isa);
    c->settings = *s->settings;
    c->temperature = s->temperature;
    c->start_s = s->start_s;
    c->state_size = padded((size_t)LINKS_MAX); /* which links are active */
    schuler_status status = SCHULER_OK;
    if (schuler_chain_params(s->model, s->instrument, params) < 0)
        status = schuler_fail(err, SCHULER_ERR_INPUT, NULL, "'%s' has too many parameters",
                              s->model->name);
    if (status == SCHULER_OK) status = mount(c, params, err);

    const schuler_sensor_model *const *stages = schuler_sensor_stages(s->isa);
    int base = 0;
    for (const schuler_sensor_model *t = s->model; t && status == SCHULER_OK; t = *stages++) {
        if (is_wanted(s, t, base)) status = add_link(c, s, t, base);
        for (int i = 0; t->params[s->instrument] && t->params[s->instrument][i].key; i++) base++;
    }
    c->one_lane = aligned_alloc(ALIGN, 3 * SCHULER_BLOCK * sizeof(double));
    if (status == SCHULER_OK && !c->one_lane) status = SCHULER_ERR_MEMORY;
    if (status == SCHULER_ERR_MEMORY) schuler_fail(err, status, NULL, "out of memory");
    if (status != SCHULER_OK) {
        schuler_chain_free(c);
        return status;
    }
    *out = c;
    return SCHULER_OK;
}

void schuler_chain_free(schuler_chain *c)
{
    if (!c) return;
    for (int i = 0; i < c->count; i++) free(c->links[i].signals);
    free(c->one_lane);
    free(c);
}

size_t schuler_chain_state_size(const schuler_chain *c)
{
    return c->state_size;
}

bool schuler_chain_needs_nodes(const schuler_chain *c)
{
    return c->needs_nodes;
}

static schuler_model_setup setup_for(const schuler_chain *c, const link *l,
                                     const schuler_lane_spec *specs)
{
    return (schuler_model_setup){ .instrument = c->instrument,
                                  .seed = c->seed,
                                  .dt_s = c->dt_s,
                                  .lanes = l->lanes,
                                  .specs = specs,
                                  .base = l->base };
}

void schuler_chain_start(const schuler_chain *c, void *state, schuler_lane_spec *specs)
{
    char *const active = state;
    const link *const model = &c->links[0];
    for (int k = 0; k < c->width && model->table->noise_excess; k++) {
        const schuler_model_setup one = setup_for(c, model, &specs[k]);
        for (int axis = 0; axis < 3; axis++)
            specs[k].noise_excess[axis] = model->table->noise_excess(&one, 0, axis);
    }
    for (int i = 0; i < c->count; i++) {
        const link *const l = &c->links[i];
        active[i] = 0;
        for (int k = 0; k < c->width; k += l->lanes) {
            const schuler_model_setup setup = setup_for(c, l, &specs[k]);
            char *const at = active + l->offset + l->size * (size_t)(k / l->lanes);
            if (l->table->setup(at, &setup) || i == 0) active[i] = 1;
        }
    }
}

/* x along an axis of body components given at count points; the body axes themselves are copied. */
static void project(const double axis[3], const double *x, const double *y, const double *z,
                    int count, double *out)
{
    for (int k = 0; k < count; k++) out[k] = axis[0] * x[k] + axis[1] * y[k] + axis[2] * z[k];
}

static bool is_body_axis(const double axis[3], int *which)
{
    for (int j = 0; j < 3; j++)
        if (axis[j] == 1.0 && axis[(j + 1) % 3] == 0.0 && axis[(j + 2) % 3] == 0.0) {
            *which = j;
            return true;
        }
    return false;
}

static void see_instants(schuler_chain *c, const schuler_truth_nodes *nodes)
{
    schuler_view *const v = &c->view;
    v->nodes = nodes->nodes;
    v->weight = nodes->weight;
    v->fraction = nodes->fraction;
    for (int j = 0; j < 3; j++) {
        v->omega_b[j] = nodes->omega_ib_b[j][0];
        v->omega_end_b[j] = nodes->omega_end_b[j];
    }
    for (int k = 0; k < 3; k++)
        for (int a = 0; a < 3; a++) {
            int j;
            if (is_body_axis(c->axes[k][a], &j)) {
                v->f[k][a] = nodes->f_ib_b[j][0];
                v->omega[k][a] = nodes->omega_ib_b[j][0];
                v->omega_end[k][a] = nodes->omega_end_b[j];
                continue;
            }
            const double *const axis = c->axes[k][a];
            for (int q = 0; q < nodes->nodes; q++) {
                project(axis, nodes->f_ib_b[0][q], nodes->f_ib_b[1][q], nodes->f_ib_b[2][q], v->n,
                        c->f[k][a][q]);
                project(axis, nodes->omega_ib_b[0][q], nodes->omega_ib_b[1][q],
                        nodes->omega_ib_b[2][q], v->n, c->omega[k][a][q]);
            }
            project(axis, nodes->omega_end_b[0], nodes->omega_end_b[1], nodes->omega_end_b[2],
                    v->n + 1, c->omega_end[k][a]);
            v->f[k][a] = c->f[k][a][0];
            v->omega[k][a] = c->omega[k][a][0];
            v->omega_end[k][a] = c->omega_end[k][a];
        }
    for (int q = 0; q < nodes->nodes && c->temperature; q++)
        for (int k = 0; k < v->n; k++) {
            const double t_s = c->start_s + ((double)(v->first + k) + nodes->fraction[q]) * c->dt_s;
            c->temperature_K[q][k] =
                schuler_temperature_at(c->temperature, t_s, &c->temperature_rate[q][k]);
        }
    v->temperature = c->temperature_K[0];
    v->temperature_rate = c->temperature_rate[0];
}

void schuler_chain_observe(schuler_chain *c, const schuler_truth_block *truth,
                           const schuler_truth_nodes *nodes)
{
    const double(*const body)[SCHULER_BLOCK] =
        c->instrument == SCHULER_ACCEL ? truth->dv_ib_b : truth->dtheta_ib_b;
    c->view.first = truth->first;
    c->view.n = truth->n;
    c->view.dt_s = c->dt_s;
    memcpy(c->view.axes, c->axes, sizeof c->axes);
    c->own_body = body[0];
    if (!c->own_is_body) {
        for (int k = 0; k < 3; k++)
            project(c->axes[k][0], body[0], body[1], body[2], truth->n, c->own[k]);
        c->own_body = c->own[0];
    }
    if (!c->needs_nodes) return;
    see_instants(c, nodes);
    for (int i = 0; i < c->count; i++) {
        const link *const l = &c->links[i];
        const schuler_model_setup settings = setup_for(c, l, &c->settings);
        if (l->signals) l->table->observe(&settings, &c->view, l->signals);
    }
}

/* A table for one lane, for lane k of the vector: its output is gathered and scattered. */
static void apply_one(const schuler_chain *c, const link *l, schuler_model_block block, int k,
                      void *state, double *out)
{
    block.out = c->one_lane;
    l->table->apply(state, &block);
    for (int axis = 0; axis < 3; axis++)
        for (int step = 0; step < block.n; step++)
            out[(axis * SCHULER_BLOCK + step) * c->width + k] =
                c->one_lane[axis * SCHULER_BLOCK + step];
}

void schuler_chain_apply(const schuler_chain *c, void *state, double *out)
{
    char *const active = state;
    for (int i = 0; i < c->count; i++) {
        const link *const l = &c->links[i];
        if (!active[i]) continue;
        const schuler_model_block block = {
            .first = c->view.first,
            .n = c->view.n,
            .stride = SCHULER_BLOCK,
            .dt_s = c->dt_s,
            .own = c->own_body,
            .out = out,
            .signals = l->signals,
            .view = c->needs_nodes ? &c->view : NULL,
        };
        if (l->lanes == c->width) {
            l->table->apply(active + l->offset, &block);
            continue;
        }
        for (int k = 0; k < c->width; k++)
            apply_one(c, l, block, k, active + l->offset + l->size * (size_t)k, out);
    }
}

static double events_of(const link *l, const char *states, int lane)
{
    const char *const at = states + l->offset + l->size * (size_t)(lane / l->lanes);
    return l->table->events(at, lane % l->lanes);
}

double schuler_chain_events(const schuler_chain *c, const void *state, int lane)
{
    const char *const active = state;
    double count = 0.0;
    for (int i = 0; i < c->count; i++)
        if (active[i] && c->links[i].table->events) count += events_of(&c->links[i], active, lane);
    return count;
}

/* SPDX-License-Identifier: MIT */
#include "sensors/stand.h"
#include <stdlib.h>
#include <string.h>

enum { ALIGN = 64, LANES_MAX = 8 };

struct schuler_stand {
    schuler_chain *chain;
    schuler_stand_input input;
    void *user;
    double dt_s;
    int64_t done;
    size_t specimens, groups, state_size;
    int width;
    char *states;
    double *measured; /* of one vector of lanes */
    schuler_truth_block truth;
    schuler_truth_nodes nodes;
};

schuler_status schuler_stand_create(schuler_stand **out, const schuler_stand_setup *setup,
                                    schuler_error *err)
{
    schuler_stand *const s = calloc(1, sizeof *s);
    if (!s) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    s->input = setup->input;
    s->user = setup->user;
    s->dt_s = setup->chain.dt_s;
    s->specimens = setup->specimens;
    s->width = schuler_isa_lanes(setup->chain.isa);
    s->groups = (setup->specimens + (size_t)s->width - 1) / (size_t)s->width;
    schuler_status status = schuler_chain_create(&s->chain, &setup->chain, err);
    if (status == SCHULER_OK) {
        s->state_size = schuler_chain_state_size(s->chain);
        s->states = aligned_alloc(ALIGN, s->groups * s->state_size);
        s->measured = aligned_alloc(ALIGN, sizeof(double) * 3 * SCHULER_BLOCK * LANES_MAX);
        if (!s->states || !s->measured)
            status = schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    }
    if (status != SCHULER_OK) {
        schuler_stand_free(s);
        return status;
    }
    for (size_t g = 0; g < s->groups; g++) {
        schuler_lane_spec specs[LANES_MAX];
        for (int k = 0; k < s->width; k++) {
            const size_t i = g * (size_t)s->width + (size_t)k;
            specs[k] = setup->specs[i < s->specimens ? i : s->specimens - 1];
        }
        schuler_chain_start(s->chain, s->states + g * s->state_size, specs);
    }
    *out = s;
    return SCHULER_OK;
}

void schuler_stand_free(schuler_stand *s)
{
    if (!s) return;
    schuler_chain_free(s->chain);
    free(s->states);
    free(s->measured);
    free(s);
}

static void move(schuler_stand *s, int n)
{
    static const double node[SCHULER_NODES] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    static const double weight[SCHULER_NODES] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    schuler_truth_block *const b = &s->truth;
    schuler_truth_nodes *const q = &s->nodes;
    b->first = s->done;
    b->n = n;
    b->dt_s = s->dt_s;
    q->nodes = SCHULER_NODES;
    memcpy(q->weight, weight, sizeof weight);
    memcpy(q->fraction, node, sizeof node);
    double f[3], omega[3];
    for (int k = 0; k < n; k++) {
        double sum_f[3] = { 0 }, sum_omega[3] = { 0 };
        for (int j = 0; j < SCHULER_NODES; j++) {
            s->input(s->user, ((double)(s->done + k) + node[j]) * s->dt_s, f, omega);
            for (int a = 0; a < 3; a++) {
                q->f_ib_b[a][j][k] = f[a];
                q->omega_ib_b[a][j][k] = omega[a];
                sum_f[a] += weight[j] * f[a];
                sum_omega[a] += weight[j] * omega[a];
            }
        }
        for (int a = 0; a < 3; a++) {
            b->dv_ib_b[a][k] = s->dt_s * sum_f[a];
            b->dtheta_ib_b[a][k] = s->dt_s * sum_omega[a];
        }
    }
    for (int k = 0; k <= n; k++) {
        s->input(s->user, (double)(s->done + k) * s->dt_s, f, omega);
        for (int a = 0; a < 3; a++) q->omega_end_b[a][k] = omega[a];
    }
}

void schuler_stand_next(schuler_stand *s, int n, double *out)
{
    move(s, n);
    schuler_chain_observe(s->chain, &s->truth, &s->nodes);
    for (size_t g = 0; g < s->groups; g++) {
        schuler_chain_apply(s->chain, s->states + g * s->state_size, s->measured);
        for (int k = 0; k < s->width; k++) {
            const size_t i = g * (size_t)s->width + (size_t)k;
            for (int at = 0; i < s->specimens && at < 3 * SCHULER_BLOCK; at++)
                if (at % SCHULER_BLOCK < n)
                    out[i * 3 * SCHULER_BLOCK + (size_t)at] = s->measured[at * s->width + k];
        }
    }
    s->done += n;
}

typedef struct {
    const double *f, *omega, *alpha;
} constant_input;

/* Over a step of a second that begins at 0 the rate goes from omega - alpha/2 to omega + alpha/2 at
 * its ends, as the angular acceleration needs; at the nodes it is taken as constant. */
static void constant(void *user, double t_s, double f[3], double omega[3])
{
    const constant_input *const x = user;
    const double turn = t_s == 0.0 ? -0.5 : t_s == 1.0 ? 0.5 : 0.0;
    for (int a = 0; a < 3; a++) {
        f[a] = x->f[a];
        omega[a] = x->omega[a] + turn * x->alpha[a];
    }
}

schuler_status schuler_indicate(const schuler_sensor_model *model, schuler_instrument instrument,
                                const schuler_lane_spec *values, const double f_ib_b[3],
                                const double omega_ib_b[3], const double alpha_ib_b[3],
                                double out[3])
{
    constant_input input = { f_ib_b, omega_ib_b, alpha_ib_b };
    static const bool no_stages[SCHULER_PARAMS_MAX];
    const schuler_stand_setup setup = {
        .chain = { .model = model,
                   .is_plugin = true, /* any table for one lane */
                   .instrument = instrument,
                   .isa = SCHULER_ISA_SCALAR,
                   .dt_s = 1.0,
                   .settings = values,
                   .given = no_stages },
        .specs = values,
        .specimens = 1,
        .input = constant,
        .user = &input,
    };
    schuler_stand *stand;
    const schuler_status status = schuler_stand_create(&stand, &setup, NULL);
    if (status != SCHULER_OK) return status;
    double measured[3][SCHULER_BLOCK];
    schuler_stand_next(stand, 1, measured[0]);
    for (int a = 0; a < 3; a++) out[a] = measured[a][0];
    schuler_stand_free(stand);
    return SCHULER_OK;
}

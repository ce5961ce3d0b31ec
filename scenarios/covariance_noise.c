/* SPDX-License-Identifier: MIT */
#include "scenarios/covariance_parts.h"
#include "sensors/processes.h"
#include <math.h>
#include <string.h>

enum { N = LINEAR_STATES };

static int find(const schuler_param *params, const char *key)
{
    for (int k = 0; params[k].key; k++)
        if (strcmp(params[k].key, key) == 0) return k;
    return -1;
}

/* A setting of a component: as given, or the table's default. */
static double setting(const schuler_triad *triad, const char *key, int component)
{
    const int k = find(triad->params, key);
    const schuler_value *const v = &triad->values[k];
    if (triad->params[k].components == 1) component = 0;
    return v->given ? v->a[component] : triad->params[k].def;
}

static void add(noise_source *n, int axis, double T_s, double sigma)
{
    if (sigma == 0.0) return;
    n->axis[n->members] = axis;
    n->member[n->members++] = (noise_member){
        .T_s = T_s, .sigma = sigma, .variance = T_s > 0.0 && isfinite(T_s) ? sigma * sigma : 0.0
    };
}

static void add_flicker(noise_source *n, const schuler_triad *triad, int axis, double B,
                        double dt_s)
{
    const schuler_flicker_bank bank =
        schuler_flicker_bank_of(setting(triad, "bias_instability_shortest", 0),
                                setting(triad, "bias_instability_longest", 0), dt_s);
    for (int i = 0; i < bank.members; i++) {
        const schuler_markov_process p = schuler_flicker_bank_member(&bank, B, i);
        add(n, axis, p.T_s, p.sigma);
    }
}

const char *noise_source_of(noise_source *out, const simulation_plan *plan, int index)
{
    const error_source *const s = &plan->sources[index];
    const schuler_scenario *const scenario = plan->scenario;
    *out = (noise_source){ .source = index };
    if (s->kind == SOURCE_BARO) {
        out->input = LINEAR_A;
        const double sigma = schuler_value_rms(s->value, 0);
        if (s->param == SCHULER_BARO_NOISE)
            add(out, 0, 0.0, sigma);
        else
            add(out, 0, scenario->gauss_markov_time_s, sigma);
        return NULL;
    }
    const schuler_triad *const triad = &scenario->imu.triad[s->instrument];
    const char *const key = triad->params[s->param].key;
    out->input = s->instrument == SCHULER_ACCEL ? LINEAR_DV : LINEAR_PSI;
    for (int axis = 0; axis < 3; axis++) {
        const double sigma = schuler_value_rms(s->value, axis);
        if (strcmp(key, "velocity_random_walk") == 0 || strcmp(key, "angle_random_walk") == 0)
            add(out, axis, 0.0, sigma);
        else if (strcmp(key, "bias_random_walk") == 0)
            add(out, axis, (double)INFINITY, sigma);
        else if (strcmp(key, "gauss_markov") == 0)
            add(out, axis, setting(triad, "gauss_markov_time", axis), sigma);
        else if (strcmp(key, "bias_instability") == 0)
            add_flicker(out, triad, axis, sigma, schuler_truth_dt(plan->truth));
        else
            return "its process has no linear form here";
    }
    return NULL;
}

/* Over T: b' = phi b + ..., integral = gain b + ... */
static schuler_process_step step_of(const noise_member *m, double T_s)
{
    if (m->T_s == 0.0) return (schuler_process_step){ .q22 = m->sigma * m->sigma * T_s };
    if (isinf(m->T_s)) return schuler_random_walk_step(m->sigma, T_s);
    return schuler_gauss_markov_step(m->sigma, m->T_s, T_s);
}

void noise_source_inject(noise_source *n, double T_s, double (*G)[LINEAR_STATES])
{
    for (int q = 0; q < n->members; q++) {
        noise_member *const m = &n->member[q];
        const schuler_process_step s = step_of(m, T_s);
        const double *const g = G[n->axis[q]];
        const double integral = s.gain * s.gain * m->variance + s.q22;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++)
                n->P[i][j] +=
                    s.gain * (m->cross[i] * g[j] + g[i] * m->cross[j]) + g[i] * integral * g[j];
        for (int i = 0; i < N; i++)
            m->cross[i] = s.phi * m->cross[i] + g[i] * (s.phi * s.gain * m->variance + s.q12);
        m->variance = s.phi * s.phi * m->variance + s.q11;
    }
}

void noise_source_step(noise_source *n, double T_s, const schuler_mat3 *C_b_e,
                       const linear_matrix *transition, const linear_matrix *drive)
{
    double half[N][N], G[3][N]; /* half: transition P; G: what the integral of an axis does */
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < N; i++) {
            G[a][i] = 0.0;
            if (n->input == LINEAR_A) {
                G[a][i] = drive->m[i][LINEAR_A];
                continue;
            }
            for (int k = 0; k < 3; k++) G[a][i] += drive->m[i][n->input + k] * C_b_e->m[k][a];
            if (n->input == LINEAR_PSI) G[a][i] = -G[a][i];
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            half[i][j] = 0.0;
            for (int k = 0; k < N; k++) half[i][j] += transition->m[i][k] * n->P[k][j];
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            double sum = 0.0;
            for (int k = 0; k < N; k++) sum += half[i][k] * transition->m[j][k];
            n->P[i][j] = sum;
        }
    for (int q = 0; q < n->members; q++) {
        double moved[N];
        for (int i = 0; i < N; i++) {
            moved[i] = 0.0;
            for (int k = 0; k < N; k++) moved[i] += transition->m[i][k] * n->member[q].cross[k];
        }
        memcpy(n->member[q].cross, moved, sizeof moved);
    }
    noise_source_inject(n, T_s, G);
}

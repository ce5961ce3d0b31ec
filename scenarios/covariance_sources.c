/* SPDX-License-Identifier: MIT */
/* From the sources of a scenario to what drives the linear error. */
#include "scenarios/covariance_parts.h"
#include "scenarios/start.h"
#include <math.h>
#include <string.h>

void covariance_moments(const error_source *s, int component, uint64_t seed, double *mean,
                        double *sigma)
{
    const schuler_value *const v = s->value;
    *mean = *sigma = 0.0;
    if (v->per_unit && s->unit >= 0)
        *mean = schuler_source_draw(s, component, seed, 0);
    else if (v->draw == SCHULER_DRAW_NORMAL)
        *sigma = v->a[component];
    else if (v->draw == SCHULER_DRAW_UNIFORM) {
        *mean = 0.5 * (v->a[component] + v->b[component]);
        *sigma = (v->b[component] - v->a[component]) / sqrt(12.0);
    } else {
        *mean = v->a[component];
    }
}

static error_vector *add_vector(covariance_run *c, int source, bool is_mean)
{
    error_vector *const v = &c->vectors[c->vector_count++];
    *v = (error_vector){ .source = source, .is_mean = is_mean };
    return v;
}

/* What a value of a source is to a vector: the start it gives, or the lane that drives it. */
static void give(covariance_run *c, int source, error_vector *vector, const double *value)
{
    const error_source *const s = &c->plan.sources[source];
    if (s->kind == SOURCE_BARO) return; /* its input is put in stretch by stretch */
    if (s->kind == SOURCE_SENSOR) {
        sensor_lane *const lane = &c->lanes[c->lane_count++];
        lane->vector = (int)(vector - c->vectors);
        lane->instrument = s->instrument;
        schuler_lane_spec_start(&c->plan.scenario->imu.triad[s->instrument], 0, &lane->spec);
        for (int k = 0; k < s->components; k++) lane->spec.value[s->param][k] = value[k];
        return;
    }
    schuler_truth_state truth;
    schuler_truth_at(c->truth, 0.0, &truth);
    schuler_vec3 e[3] = { { { 0 } } }; /* dr, dv, phi */
    if (s->kind == SOURCE_POSITION) memcpy(e[0].v, value, sizeof e[0].v);
    if (s->kind == SOURCE_VELOCITY) memcpy(e[1].v, value, sizeof e[1].v);
    if (s->kind == SOURCE_TILT) memcpy(e[2].v, value, 2 * sizeof(double));
    if (s->kind == SOURCE_HEADING) e[2].v[2] = -value[0];
    const schuler_nav_state start = schuler_start_with(&truth, e[0], e[1], e[2]);
    const schuler_vec3 minus_psi =
        schuler_quat_to_rotvec(schuler_quat_mul(start.q_b_e, schuler_quat_conj(truth.q_b_e)));
    for (int i = 0; i < 3; i++) {
        vector->x[LINEAR_DR + i] = start.r_e.v[i] - truth.r_e.v[i];
        vector->x[LINEAR_DV + i] = start.v_e.v[i] - truth.v_e.v[i];
        vector->x[LINEAR_PSI + i] = -minus_psi.v[i];
    }
}

/* Vectors of a source: its mean, and a sigma of each component. Returned: why not. */
static const char *add_vectors(covariance_run *c, int source)
{
    const error_source *const s = &c->plan.sources[source];
    const uint64_t seed = c->plan.scenario->seed;
    double mean[SCHULER_COMPONENTS_MAX] = { 0 }, sigma[SCHULER_COMPONENTS_MAX] = { 0 };
    bool has_mean = false, is_drawn = false;
    for (int k = 0; k < s->components; k++) {
        covariance_moments(s, k, seed, &mean[k], &sigma[k]);
        has_mean |= mean[k] != 0.0;
        is_drawn |= sigma[k] != 0.0;
    }
    if (s->kind == SOURCE_SENSOR && is_drawn) {
        const schuler_acts acts = c->plan.scenario->imu.triad[s->instrument].params[s->param].acts;
        if (acts == SCHULER_ACTS_RESPONSE || acts == SCHULER_ACTS_COUNTS)
            return "it is not linear in its value";
    }
    if (has_mean) give(c, source, add_vector(c, source, true), mean);
    for (int k = 0; k < s->components; k++) {
        if (sigma[k] == 0.0) continue;
        double one[SCHULER_COMPONENTS_MAX] = { 0 };
        one[k] = sigma[k];
        give(c, source, add_vector(c, source, false), one);
    }
    return NULL;
}

const char *covariance_add_source(covariance_run *c, int source)
{
    const error_source *const s = &c->plan.sources[source];
    if (s->kind == SOURCE_GRAVITY) {
        add_vector(c, source, true);
        return NULL;
    }
    if (s->kind == SOURCE_SENSOR) {
        const schuler_param *const p = &c->plan.scenario->imu.triad[s->instrument].params[s->param];
        if (p->acts == SCHULER_ACTS_PERIODIC) return "its phase is drawn";
        if (p->noisy != 0) {
            const char *const why = noise_source_of(&c->noises[c->noise_count], &c->plan, source);
            if (!why) c->noise_count++;
            return why;
        }
    }
    if (s->kind == SOURCE_BARO &&
        (s->param == SCHULER_BARO_NOISE || s->param == SCHULER_BARO_GAUSS_MARKOV)) {
        (void)noise_source_of(&c->noises[c->noise_count++], &c->plan, source);
        return NULL;
    }
    return add_vectors(c, source);
}

/* SPDX-License-Identifier: MIT */
/* From a source to its growth: what of it a navigator at rest sees. */
#include "core/geographic.h"
#include "scenarios/growth.h"
#include <string.h>

schuler_status schuler_rest_make(schuler_rest *out, double lat_rad, double h_m,
                                 const schuler_mat3 *C_b_n, schuler_error *err)
{
    schuler_field_model *field = NULL;
    const schuler_status status = schuler_field_open(&field, "wgs84", err);
    if (status != SCHULER_OK) return status;
    const schuler_vec3 r_e = schuler_ecef_from_llh((schuler_llh){ lat_rad, 0.0, h_m });
    const double g_mps2 = schuler_vec3_norm(schuler_field_gravity(field, r_e));
    schuler_field_close(field);
    *out = (schuler_rest){ .lat_rad = lat_rad,
                           .g_mps2 = g_mps2,
                           .radius_m = { schuler_earth_meridian_radius(lat_rad) + h_m,
                                         schuler_earth_transverse_radius(lat_rad) + h_m },
                           .C_b_n = *C_b_n };
    const schuler_vec3 f_n = { { 0.0, 0.0, -g_mps2 } },
                       omega_n = { { SCHULER_OMEGA_IE_RADPS * cos(lat_rad), 0.0,
                                     -SCHULER_OMEGA_IE_RADPS * sin(lat_rad) } };
    const schuler_mat3 C_n_b = schuler_mat3_transpose(C_b_n);
    const schuler_vec3 f_b = schuler_mat3_apply(&C_n_b, f_n),
                       omega_b = schuler_mat3_apply(&C_n_b, omega_n);
    memcpy(out->f_b, f_b.v, sizeof f_b.v);
    memcpy(out->omega_ib_b, omega_b.v, sizeof omega_b.v);
    return SCHULER_OK;
}

schuler_status schuler_rest_of(schuler_rest *out, const schuler_scenario *s, schuler_error *err)
{
    const schuler_motion start = schuler_path_at(&s->path, 0.0);
    const schuler_llh llh = schuler_llh_from_ecef(start.r_e);
    const schuler_mat3 C_n_e = schuler_C_n_e(llh.lat_rad, llh.lon_rad),
                       C_e_n = schuler_mat3_transpose(&C_n_e),
                       C_b_e = schuler_mat3_from_quat(start.q_b_e),
                       C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    return schuler_rest_make(out, llh.lat_rad, llh.h_m, &C_b_n, err);
}

schuler_growth schuler_growth_of_start(schuler_growth_entry entry)
{
    schuler_growth g = { .entry = entry, .process = SCHULER_GROWS_CONSTANT };
    g.components = entry == SCHULER_ENTERS_HEADING ? 1 : entry == SCHULER_ENTERS_TILT ? 2 : 3;
    for (int c = 0; c < g.components; c++) g.axis_n[c][c] = 1.0;
    /* Heading grows as the computed axes turn to the right, about down; psi is minus that. */
    if (entry == SCHULER_ENTERS_HEADING)
        memcpy(g.axis_n[0], (double[3]){ 0.0, 0.0, -1.0 }, sizeof g.axis_n[0]);
    return g;
}

static int find(const schuler_param *params, const char *key)
{
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    return -1;
}

/* A setting, for one axis. */
static double setting(const schuler_param *params, const schuler_value *values, const char *key,
                      int axis)
{
    const int i = find(params, key);
    if (i < 0) return 0.0;
    if (!values || !values[i].given) return params[i].def;
    return values[i].a[params[i].components == 1 ? 0 : axis];
}

/* Noise and drifts of the stages: every axis its own, whatever it measures. */
static const struct {
    const char *key, *time;
    schuler_growth_process process;
} drifts[] = {
    { "velocity_random_walk", "", SCHULER_GROWS_WHITE },
    { "angle_random_walk", "", SCHULER_GROWS_WHITE },
    { "bias_random_walk", "", SCHULER_GROWS_WALK },
    { "bias_ramp", "", SCHULER_GROWS_RAMP },
    { "thermal_transient", "thermal_transient_time", SCHULER_GROWS_DECAY },
    { "gauss_markov", "gauss_markov_time", SCHULER_GROWS_GAUSS_MARKOV },
    { "gauss_markov_2", "gauss_markov_2_time", SCHULER_GROWS_GAUSS_MARKOV_2 },
    { "bias_instability", "bias_instability_shortest", SCHULER_GROWS_FLICKER },
    { "sinusoid", "", SCHULER_GROWS_SINUSOID },
};
enum { DRIFTS = sizeof drifts / sizeof drifts[0] };

static int find_drift(const char *key)
{
    int i = 0;
    while (i < DRIFTS && strcmp(drifts[i].key, key) != 0) i++;
    return i;
}

/* One unit of component c acts on an axis of the body with this gain, always. false: not at rest, or
 * not in a way that is known here. */
static bool acts_on(const schuler_param *p, schuler_instrument instrument, const schuler_rest *rest,
                    int c, int *axis, double *gain)
{
    static const int other[6] = { 1, 2, 0, 2, 0, 1 }; /* xy, xz, yx, yz, zx, zy */
    const schuler_dim own = { instrument == SCHULER_ACCEL ? 2 : 0,
                              instrument == SCHULER_ACCEL ? -4 : -2,
                              instrument == SCHULER_ACCEL ? 0 : 2,
                              0,
                              0,
                              0 };
    const double *const input = instrument == SCHULER_ACCEL ? rest->f_b : rest->omega_ib_b;
    *axis = c;
    *gain = 1.0;
    switch (p->acts) {
    case SCHULER_ACTS_CONSTANT:
        return p->components == 3 && schuler_dim_equal(p->dim, own);
    case SCHULER_ACTS_SCALE:
        *gain = input[c];
        return strcmp(p->key, "scale_factor") == 0 || strcmp(p->key, "scale_residual") == 0 ||
               strcmp(p->key, "epsilon_K") == 0;
    case SCHULER_ACTS_CROSS:
        if (strcmp(p->key, "g_sensitivity") == 0) {
            *axis = c / 3;
            *gain = rest->f_b[c % 3];
            return true;
        }
        if (p->components != 6) return false;
        *axis = c / 2;
        *gain = input[other[c]];
        return strncmp(p->key, "misalignment", strlen("misalignment")) == 0;
    default:
        return false;
    }
}

bool schuler_growth_of_param(const schuler_param *params, int index, const schuler_value *values,
                             schuler_instrument instrument, const schuler_rest *rest, double dt_s,
                             schuler_growth *out)
{
    const schuler_param *const p = &params[index];
    /* Instruments along other axes than the body's spread their errors over all of them. */
    const int mounted = find(params, "input_axes"), drift = find_drift(p->key);
    if (values && mounted >= 0 && values[mounted].given) return false;
    schuler_growth g = { .entry = instrument == SCHULER_ACCEL ? SCHULER_ENTERS_ACCEL
                                                              : SCHULER_ENTERS_GYRO,
                         .process = drift < DRIFTS ? drifts[drift].process : SCHULER_GROWS_CONSTANT,
                         .components = p->components,
                         .longest_s = setting(params, values, "bias_instability_longest", 0),
                         .dt_s = dt_s };
    for (int c = 0; c < p->components; c++) {
        int axis = c;
        double gain = 1.0;
        if (drift == DRIFTS && !acts_on(p, instrument, rest, c, &axis, &gain)) return false;
        for (int i = 0; i < 3; i++) g.axis_n[c][i] = gain * rest->C_b_n.m[i][axis];
        if (drift < DRIFTS) g.time_s[c] = setting(params, values, drifts[drift].time, axis);
        g.frequency_hz[c] = setting(params, values, "sinusoid_frequency", axis);
    }
    *out = g;
    return true;
}

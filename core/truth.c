/* SPDX-License-Identifier: MIT */
#include "core/truth.h"
#include "core/truth_private.h"
#include <stdlib.h>
#include <string.h>

/* A joint this near to a step's end, in steps, counts as being there: the piece is continued that
 * far. */
static const double at_joint = 1e-6;
/* Longer steps are integrated in parts, so that three nodes do for any rate. */
static const double part_s = 0.02;

/* A piece is as long as its degree can follow, x rad of the quickest sinusoid in it on each side of
 * the middle, x < 1.7. Three nodes leave (x d)^6/2e6 of a part d long in s, six 2e-16 (2 x d)^12/4096:
 * with these lengths below 2e-13. */
static const double three_do = 0.05, six_do = 1.0;
static const schuler_quadrature three = {
    .count = 3, /* 1/2 -+ sqrt(15)/10 */
    .node = { 0.11270166537925831, 0.5, 0.88729833462074169 },
    .weight = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 },
};
static const schuler_quadrature six = {
    .count = 6,
    .node = { 0.03376524289842399, 0.16939530676686773, 0.38069040695840156, 0.6193095930415985,
              0.8306046932331322, 0.966234757101576 },
    .weight = { 0.08566224618958518, 0.1803807865240693, 0.23395696728634552, 0.23395696728634552,
                0.1803807865240693, 0.08566224618958518 },
};

/* For steps of run->ds. */
static void choose_rule(const schuler_truth *truth, schuler_truth_run *run)
{
    run->rule = &three;
    run->parts = truth->parts;
    if (run->ds <= three_do * run->parts) return;
    run->rule = &six;
    run->parts = (int)fmax(run->parts, ceil(run->ds / six_do));
}

const schuler_truth_lanes *schuler_truth_lanes_for(schuler_isa isa)
{
#define X(name) extern const schuler_truth_lanes schuler_truth_lanes_##name;
#include "schuler_isas.def"
#undef X
    static const schuler_truth_lanes *const all[] = {
#define X(name) &schuler_truth_lanes_##name,
#include "schuler_isas.def"
#undef X
    };
    const size_t count = sizeof(all) / sizeof(all[0]);
    return all[(size_t)isa < count ? (size_t)isa : 0];
}

/* Both sides' tables, and what the fields have beyond them along the path; nav NULL: the same. */
static schuler_status open_gravity(schuler_truth *truth, const char *real, const char *nav,
                                   double high_m, schuler_error *err)
{
    schuler_path_field f[2] = { { NULL, &truth->truth_table }, { NULL, &truth->nav_table } };
    schuler_field_model *field[2] = { NULL, NULL };
    schuler_status status = schuler_field_open(&field[0], real, err);
    if (status == SCHULER_OK && nav) status = schuler_field_open(&field[1], nav, err);
    if (status == SCHULER_OK)
        status = schuler_gravity_fit_to(&truth->truth_table, field[0], high_m, err);
    truth->nav_table = truth->truth_table;
    if (status == SCHULER_OK && nav)
        status = schuler_gravity_fit_to(&truth->nav_table, field[1], high_m, err);
    if (status == SCHULER_OK) {
        for (int i = 0; i < 2; i++) f[i].field = field[i];
        status = schuler_path_gravity_sample(&truth->dg, truth->path, &f[0], nav ? &f[1] : NULL);
        if (status != SCHULER_OK)
            schuler_fail(err, status, NULL, "out of memory for gravity along the path");
    }
    for (int i = 0; i < 2; i++) schuler_field_close(field[i]);
    return status;
}

/* The table is only good in its box, which is made as high as the path needs. */
static schuler_status check_heights(const schuler_path *path, double *high_m, schuler_error *err)
{
    *high_m = SCHULER_GRAVITY_HIGH_M;
    for (size_t i = 0; i < path->count; i++)
        for (int j = 0; j < 3; j++) {
            const double t_s = path->pieces[i].t0_s + 0.5 * j * path->pieces[i].duration_s;
            const double h_m = schuler_llh_from_ecef(schuler_path_at(path, t_s).r_e).h_m;
            if (!(h_m >= SCHULER_GRAVITY_LOW_M - 1.0 && h_m <= SCHULER_GRAVITY_HIGHEST_M))
                return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                                    "height %.0f m at %.1f s is outside %.0f .. %.0f m, where "
                                    "gravity is known",
                                    h_m, t_s, SCHULER_GRAVITY_LOW_M, SCHULER_GRAVITY_HIGHEST_M);
            if (h_m > SCHULER_GRAVITY_HIGH_M + 1.0) *high_m = SCHULER_GRAVITY_HIGHEST_M;
        }
    return SCHULER_OK;
}

static schuler_status divide_steps(schuler_truth *truth)
{
    const schuler_path *const path = truth->path;
    truth->pieces = malloc(path->count * sizeof(*truth->pieces));
    if (truth->pieces == NULL) return SCHULER_ERR_MEMORY;
    for (size_t i = 0; i < path->count; i++) {
        const schuler_piece *const piece = &path->pieces[i];
        const long double dt = truth->dt_s, t0 = piece->t0_s, t1 = t0 + piece->duration_s;
        const int64_t first = (int64_t)ceill(t0 / dt - at_joint);
        truth->pieces[i] = (piece_steps){
            .first = first,
            .end = (int64_t)floorl(t1 / dt + at_joint),
            .s0 = (double)(((long double)first * dt - t0) * 2.0L / piece->duration_s - 1.0L),
        };
    }
    /* Nodes must be as dense as the pieces are where those are short. */
    size_t oldest = 0, most = 1;
    for (size_t i = 0; i < path->count; i++) {
        while (path->pieces[i].t0_s - path->pieces[oldest].t0_s >= truth->dt_s) oldest++;
        if (i - oldest + 1 > most) most = i - oldest + 1;
    }
    truth->densest = (int)fmin((double)most, 1e6);
    return SCHULER_OK;
}

schuler_status schuler_truth_create(schuler_truth **out, const schuler_path *path, double dt_s,
                                    const char *truth_gravity, const char *nav_gravity,
                                    schuler_error *err)
{
    if (path->count == 0 || !(dt_s >= 1e-6) || !(dt_s <= 1e3))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "no truth for an empty path or a sample interval of %g s", dt_s);
    double high_m;
    schuler_status status = check_heights(path, &high_m, err);
    if (status != SCHULER_OK) return status;
    schuler_truth *const truth = calloc(1, sizeof(*truth));
    if (truth == NULL) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    truth->path = path;
    truth->dt_s = dt_s;
    /* A path's length is rounded to ticks of 1e-9 s. */
    truth->steps = (int64_t)floor(path->duration_s / dt_s + at_joint + 1e-9 / dt_s);
    truth->parts = (int)ceil(dt_s / part_s - 1e-9);
    status = divide_steps(truth);
    if (status != SCHULER_OK) schuler_fail(err, status, NULL, "out of memory for the truth");
    const int same = strcmp(truth_gravity, nav_gravity) == 0;
    if (status == SCHULER_OK)
        status = open_gravity(truth, truth_gravity, same ? NULL : nav_gravity, high_m, err);
    if (status != SCHULER_OK) {
        schuler_truth_free(truth);
        return status;
    }
    *out = truth;
    return SCHULER_OK;
}

void schuler_truth_free(schuler_truth *truth)
{
    if (truth == NULL) return;
    schuler_path_gravity_free(&truth->dg);
    free(truth->pieces);
    free(truth);
}

int64_t schuler_truth_steps(const schuler_truth *truth)
{
    return truth->steps;
}

const schuler_gravity_table *schuler_truth_nav_gravity(const schuler_truth *truth)
{
    return &truth->nav_table;
}

double schuler_truth_dt(const schuler_truth *truth)
{
    return truth->dt_s;
}

void schuler_truth_prepare(const schuler_truth *truth, const schuler_piece *piece,
                           schuler_truth_run *run)
{
    const double per_s = 2.0 / piece->duration_s;
    const schuler_mat3 C_b0_e = schuler_mat3_from_quat(piece->q0_b_e);
    run->dr_e = piece->dr_e;
    run->rho_b = piece->rho_b;
    run->gravity = &truth->truth_table;
    for (int i = 0; i < 3; i++) {
        run->r0_e[i] = piece->r0_e.v[i];
        run->omega_ie_b0[i] = C_b0_e.m[2][i] * SCHULER_OMEGA_IE_RADPS;
        for (int j = 0; j < 3; j++) run->C_e_b0[i][j] = C_b0_e.m[j][i];
        for (int k = 0; k < SCHULER_PIECE_DEGREE - 1; k++)
            run->rho_dot_b[i][k] = (k + 1) * piece->rho_b[i][k + 1] * per_s;
    }
    double v_e[3][SCHULER_PIECE_DEGREE], a_e[3][SCHULER_PIECE_DEGREE];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < SCHULER_PIECE_DEGREE; k++)
            v_e[i][k] = (k + 1) * piece->dr_e[i][k + 1] * per_s;
        for (int k = 0; k < SCHULER_PIECE_DEGREE - 1; k++)
            a_e[i][k] = (k + 1) * v_e[i][k + 1] * per_s;
        a_e[i][SCHULER_PIECE_DEGREE - 1] = 0.0;
    }
    for (int k = 0; k < SCHULER_PIECE_DEGREE; k++) {
        run->free_e[0][k] = a_e[0][k] - 2.0 * SCHULER_OMEGA_IE_RADPS * v_e[1][k];
        run->free_e[1][k] = a_e[1][k] + 2.0 * SCHULER_OMEGA_IE_RADPS * v_e[0][k];
        run->free_e[2][k] = a_e[2][k];
    }
}

/* One step of another length than dt, or with joints inside: the parts in each piece, added in time
 * order. */
static void split_step(const schuler_truth *truth, const schuler_truth_lanes *lanes, size_t p,
                       int64_t k, int at, const schuler_columns *dg_e, schuler_truth_block *out)
{
    const long double from = (long double)k * truth->dt_s, to = (long double)(k + 1) * truth->dt_s;
    for (int i = 0; i < 3; i++) out->dtheta_ib_b[i][at] = out->dv_ib_b[i][at] = 0.0;
    for (; p < truth->path->count; p++) {
        const schuler_piece *const piece = &truth->path->pieces[p];
        const long double t0 = piece->t0_s, t1 = t0 + piece->duration_s;
        const long double a = p == 0 || from > t0 ? from : t0;
        const long double b = p + 1 == truth->path->count || to < t1 ? to : t1;
        if (a >= to) return;
        schuler_truth_run run;
        schuler_truth_prepare(truth, piece, &run);
        run.s0 = (double)((a - t0) * 2.0L / piece->duration_s - 1.0L);
        run.ds = (double)((b - a) * 2.0L / piece->duration_s);
        run.dt_s = (double)(b - a);
        choose_rule(truth, &run);
        double dtheta[3][SCHULER_BLOCK], dv[3][SCHULER_BLOCK];
        schuler_columns dg;
        if (dg_e != NULL)
            for (int i = 0; i < 3; i++) dg.v[i][0] = dg_e->v[i][at];
        lanes->increments(&run, 0.0, 0, 1, dg_e != NULL ? &dg : NULL, dtheta, dv);
        for (int i = 0; i < 3; i++) {
            out->dtheta_ib_b[i][at] += dtheta[i][0];
            out->dv_ib_b[i][at] += dv[i][0];
        }
    }
}

/* Steps far outside the path, where a polynomial would run away: the motion of schuler_path_at
 * there. */
static int beyond_reach(const schuler_truth *truth, size_t p, double ds, int64_t k)
{
    const double reach = (SCHULER_PIECE_REACH - 1.0) / ds;
    const piece_steps *const steps = &truth->pieces[p];
    if (p == 0 && (double)k < -reach) return 1;
    return p + 1 == truth->path->count && (double)(k + 1 - steps->end) > reach;
}

int schuler_truth_next_run(const schuler_truth *truth, size_t *p, int64_t k, int left,
                           schuler_truth_run *run, double *index)
{
    const size_t count = truth->path->count;
    while (*p + 1 < count && truth->pieces[*p + 1].first <= k) ++*p;
    while (*p > 0 && truth->pieces[*p].first > k) --*p;
    const piece_steps *const steps = &truth->pieces[*p];
    const schuler_piece *const piece = &truth->path->pieces[*p];
    int64_t whole = *p + 1 == count ? left : steps->end - k;
    if (whole > left) whole = left;
    if (whole <= 0) return 0;
    schuler_truth_prepare(truth, piece, run);
    run->dt_s = truth->dt_s;
    run->s0 = steps->s0;
    run->ds = (double)((long double)truth->dt_s * 2.0L / piece->duration_s);
    choose_rule(truth, run);
    if (beyond_reach(truth, *p, run->ds, k) || beyond_reach(truth, *p, run->ds, k + whole - 1)) {
        whole = 1;
        if (beyond_reach(truth, *p, run->ds, k)) {
            run->s0 = k < 0 ? -SCHULER_PIECE_REACH : SCHULER_PIECE_REACH;
            run->ds = 0.0;
        }
    }
    *index = (double)(k - steps->first);
    return (int)whole;
}

void schuler_truth_block_compute(const schuler_truth *truth, schuler_isa isa, int64_t first, int n,
                                 schuler_truth_block *out)
{
    const schuler_truth_lanes *const lanes = schuler_truth_lanes_for(isa);
    out->first = first;
    out->n = n;
    out->dt_s = truth->dt_s;
    out->has_dg = truth->dg.count > 0;
    schuler_columns dg[SCHULER_PATH_PARTS];
    if (out->has_dg) {
        /* At mid-step: the change within a step is of no account, 2e-5 m/s^2 per second at most. */
        schuler_path_gravity_fill(&truth->dg, truth->dt_s, first, n, dg);
        memcpy(out->dg_nav_e, dg[SCHULER_PATH_NAV].v, sizeof out->dg_nav_e);
        memcpy(out->dg_truth_e, dg[SCHULER_PATH_ONLY_REAL].v, sizeof out->dg_truth_e);
    } else {
        memset(out->dg_nav_e, 0, sizeof out->dg_nav_e);
        memset(out->dg_truth_e, 0, sizeof out->dg_truth_e);
    }
    const schuler_columns *const dg_e = out->has_dg ? &dg[SCHULER_PATH_REAL] : NULL;

    size_t p = schuler_path_find(truth->path, (double)first * truth->dt_s);
    for (int i = 0; i < n;) {
        schuler_truth_run run;
        double index;
        const int whole = schuler_truth_next_run(truth, &p, first + i, n - i, &run, &index);
        if (whole > 0)
            lanes->increments(&run, index, i, whole, dg_e, out->dtheta_ib_b, out->dv_ib_b);
        else
            split_step(truth, lanes, p, first + i, i, dg_e, out);
        i += whole > 0 ? whole : 1;
    }
}

void schuler_truth_at(const schuler_truth *truth, double t_s, schuler_truth_state *out)
{
    const schuler_motion m = schuler_path_at(truth->path, t_s);
    out->t_s = t_s;
    out->llh = schuler_llh_from_ecef(m.r_e);
    out->C_n_e = schuler_C_n_e(out->llh.lat_rad, out->llh.lon_rad);
    out->r_e = m.r_e;
    out->v_e = m.v_e;
    out->v_n = schuler_mat3_apply_transposed(&out->C_n_e, m.v_e);
    for (int i = 0; i < 3; i++) out->v_n.v[i] += 0.0; /* at rest: no negative zero */
    out->q_b_e = m.q_b_e;
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&out->C_n_e);
    const schuler_mat3 C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    schuler_euler_from_mat3(&C_b_n, &out->roll_rad, &out->pitch_rad, &out->heading_rad);
}

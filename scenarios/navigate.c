/* SPDX-License-Identifier: MIT */
#include "scenarios/navigate.h"
#include "scenarios/comparator.h"
#include "scenarios/disturbance.h"
#include "scenarios/increments.h"
#include <math.h>
#include <stdlib.h>

typedef struct {
    const schuler_navigate_options *options;
    schuler_csv *reference;
    schuler_increments in;
    schuler_field_model *field;
    schuler_gravity_table table;
    schuler_disturbance disturbance;
    int has_disturbance;
    const schuler_mechanization *mechanization;
    void *state;
    int64_t step;
    int64_t before_step; /* of the reference row before */
    schuler_baro_gains gains;
    schuler_baro_loop loop;
    schuler_navigate_result result;
} navigation;

static int is_finite(const schuler_nav_state *s)
{
    double sum = s->q_b_e.w + s->q_b_e.x + s->q_b_e.y + s->q_b_e.z;
    for (int i = 0; i < 3; i++) sum += s->r_e.v[i] + s->v_e.v[i];
    return isfinite(sum);
}

/* The state as a row of a trajectory. C_b_n is handed out because Euler angles lose it at the
 * poles. */
static schuler_trajectory_row row_of(const schuler_nav_state *s, double t_s, schuler_mat3 *C_b_n)
{
    schuler_trajectory_row row = { .t_s = t_s, .llh = schuler_llh_from_ecef(s->r_e) };
    const schuler_mat3 C_n_e = schuler_C_n_e(row.llh.lat_rad, row.llh.lon_rad);
    const schuler_mat3 C_e_n = schuler_mat3_transpose(&C_n_e);
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(s->q_b_e);
    *C_b_n = schuler_mat3_mul(&C_e_n, &C_b_e);
    row.v_n = schuler_mat3_apply(&C_e_n, s->v_e);
    schuler_euler_from_mat3(C_b_n, &row.roll_rad, &row.pitch_rad, &row.heading_rad);
    return row;
}

/* rms holds the sum of squares until finish(). */
static void add_figure(schuler_error_figures *f, double error)
{
    f->final = error;
    f->max = fmax(f->max, fabs(error));
    f->rms += error * error;
}

static void add_errors(schuler_navigate_result *result, const schuler_nav_state *s, double h_m,
                       const schuler_mat3 *C_b_n, const schuler_trajectory_row *reference)
{
    const schuler_nav_state truth = schuler_trajectory_state(reference);
    const schuler_mat3 C_n_e = schuler_C_n_e(reference->llh.lat_rad, reference->llh.lon_rad);
    const schuler_vec3 dr_e = schuler_vec3_sub(s->r_e, truth.r_e);
    const schuler_vec3 dr_n = schuler_mat3_apply_transposed(&C_n_e, dr_e);
    add_figure(&result->horizontal_m, hypot(dr_n.v[0], dr_n.v[1]));
    add_figure(&result->height_m, h_m - reference->llh.h_m);
    add_figure(&result->velocity_mps, schuler_vec3_norm(schuler_vec3_sub(s->v_e, truth.v_e)));

    const schuler_mat3 C_b_n_true =
        schuler_mat3_from_euler(reference->roll_rad, reference->pitch_rad, reference->heading_rad);
    const schuler_mat3 C_n_b_true = schuler_mat3_transpose(&C_b_n_true);
    const schuler_mat3 rotation = schuler_mat3_mul(C_b_n, &C_n_b_true);
    const schuler_vec3 phi_n = schuler_quat_to_rotvec(schuler_quat_from_mat3(&rotation));
    add_figure(&result->attitude_rad, schuler_vec3_norm(phi_n));
}

/* The height of the row as a barometer reads it. */
static schuler_status follow_barometer(navigation *nav, const schuler_trajectory_row *reference,
                                       schuler_error *err)
{
    double height_m[1] __attribute__((aligned(64)));
    double dh_m[1] __attribute__((aligned(64))), dv_mps[1] __attribute__((aligned(64)));
    const double T_s = (double)(nav->step - nav->before_step) * nav->in.dt_s;
    nav->before_step = nav->step;
    if (T_s > SCHULER_BARO_TIME_S / SCHULER_BARO_UPDATES_MIN)
        return schuler_csv_refuse(nav->reference, 0, err,
                                  "this row comes %.9g s after the one before; as a barometer "
                                  "(vertical: baro) the reference needs rows at most %g s apart",
                                  T_s, SCHULER_BARO_TIME_S / SCHULER_BARO_UPDATES_MIN);
    nav->mechanization->height(nav->state, height_m);
    const double e_m = height_m[0] - reference->llh.h_m;
    schuler_baro_update(&nav->loop, &nav->gains, T_s, e_m, dh_m, dv_mps);
    nav->mechanization->correct_vertical(nav->state, dh_m, dv_mps);
    return SCHULER_OK;
}

static schuler_status steady(navigation *nav, const schuler_trajectory_row *reference,
                             schuler_error *err)
{
    if (nav->step == 0) return SCHULER_OK;
    if (nav->options->vertical == SCHULER_VERTICAL_BARO)
        return follow_barometer(nav, reference, err);
    if (nav->options->vertical == SCHULER_VERTICAL_TRUTH)
        nav->mechanization->hold_vertical(nav->state, reference->llh.h_m, -reference->v_n.v[2]);
    return SCHULER_OK;
}

/* At a reference time: hold, hand out the row, compare. The first row is the start itself. */
static schuler_status report(navigation *nav, const schuler_trajectory_row *reference,
                             schuler_error *err)
{
    const schuler_status status = steady(nav, reference, err);
    if (status != SCHULER_OK) return status;
    schuler_nav_state s;
    nav->mechanization->get(nav->state, 0, &s);
    if (!is_finite(&s))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "the navigator's state is no longer finite at %.9g s", reference->t_s);
    schuler_mat3 C_b_n;
    const schuler_trajectory_row row = row_of(&s, reference->t_s, &C_b_n);
    if (row.llh.h_m < COMPARATOR_HEIGHT_MIN_M || row.llh.h_m > COMPARATOR_HEIGHT_MAX_M)
        return schuler_fail(
            err, SCHULER_ERR_NUMERIC, NULL,
            "at %.9g s the navigator's height is %.4g km, where gravity is not known%s",
            reference->t_s, row.llh.h_m / 1000.0,
            nav->options->vertical != SCHULER_VERTICAL_FREE
                ? ""
                : " (a free vertical channel diverges; hold it with vertical: truth)");
    if (schuler_mechanization_ends(nav->mechanization, s.r_e))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "at %.9g s the navigator is at a latitude of %.3f deg; frame '%s' ends "
                            "at %g deg: use wander or ecef",
                            reference->t_s, row.llh.lat_rad / SCHULER_RAD_PER_DEG,
                            nav->mechanization->name,
                            nav->mechanization->latitude_max_rad / SCHULER_RAD_PER_DEG);
    if (nav->step > 0) add_errors(&nav->result, &s, row.llh.h_m, &C_b_n, reference);
    nav->result.rows++;
    return nav->options->row(nav->options->user, &row);
}

/* Advance by at most `limit` steps of what is read; returns how many. */
static int advance_some(navigation *nav, int64_t limit)
{
    schuler_increments *in = &nav->in;
    /* A recording has no gravity that only the real world knows. */
    static const double dg_truth_e[3 * SCHULER_INCREMENTS_BLOCK];
    double dg_nav_e[3 * SCHULER_INCREMENTS_BLOCK];
    int64_t n = in->n - in->used;
    if (n > limit) n = limit;
    if (nav->has_disturbance) {
        schuler_nav_state s;
        nav->mechanization->get(nav->state, 0, &s);
        const int64_t ahead =
            is_finite(&s) ? schuler_disturbance_ahead(&nav->disturbance, nav->step, s.r_e, s.v_e)
                          : n;
        if (n > ahead) n = ahead;
        schuler_disturbance_fill(&nav->disturbance, nav->step, (int)n, SCHULER_INCREMENTS_BLOCK,
                                 dg_nav_e);
    }
    const schuler_nav_block block = {
        .n = (int)n,
        .stride = SCHULER_INCREMENTS_BLOCK,
        .dtheta = &in->dtheta[0][in->used],
        .dv = &in->dv[0][in->used],
        .dg_nav_e = nav->has_disturbance ? dg_nav_e : NULL,
        .dg_truth_e = dg_truth_e,
    };
    nav->mechanization->advance(nav->state, &block);
    in->used += (int)n;
    nav->step += n;
    return (int)n;
}

/* To a step of the reference; *reached = 0 when the increments end before it. */
static schuler_status advance_to(navigation *nav, int64_t step, int *reached, schuler_error *err)
{
    *reached = 0;
    while (nav->step < step) {
        const schuler_status status = schuler_increments_more(&nav->in, err);
        if (status != SCHULER_OK) return status;
        if (nav->in.used == nav->in.n) return SCHULER_OK;
        if (nav->options->stop && *nav->options->stop)
            return schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
        advance_some(nav, step - nav->step);
    }
    *reached = 1;
    return SCHULER_OK;
}

static schuler_status reference_step(const navigation *nav, double t_s, int64_t *step,
                                     schuler_error *err)
{
    enum { TIME = 0 };
    const int on_grid = schuler_increments_on_grid(&nav->in, t_s, step);
    if (t_s <= nav->in.t0_s + nav->result.duration_s)
        return schuler_csv_refuse(nav->reference, TIME, err,
                                  "time %.17g s does not increase: the row before has %.17g s", t_s,
                                  nav->in.t0_s + nav->result.duration_s);
    if (on_grid && *step > nav->step) return SCHULER_OK;
    return schuler_csv_refuse(
        nav->reference, TIME, err,
        "time %.17g s is not a time of the increments, which come every %.9g s "
        "from %.9g s on",
        t_s, nav->in.dt_s, nav->in.t0_s);
}

static schuler_status follow_reference(navigation *nav, schuler_error *err)
{
    double shown = 0.0;
    for (;;) {
        schuler_trajectory_row row;
        int got_row, reached;
        int64_t step;
        schuler_status status = schuler_trajectory_next(nav->reference, &row, &got_row, err);
        if (status != SCHULER_OK || !got_row) return status;
        status = reference_step(nav, row.t_s, &step, err);
        if (status == SCHULER_OK) status = advance_to(nav, step, &reached, err);
        if (status != SCHULER_OK) return status;
        if (!reached) {
            nav->result.reference_goes_on = 1;
            return SCHULER_OK;
        }
        status = report(nav, &row, err);
        if (status != SCHULER_OK) return status;
        nav->result.duration_s = row.t_s - nav->in.t0_s;
        nav->result.steps = nav->step;
        const double fraction = schuler_csv_fraction(nav->reference);
        if (nav->options->progress && fraction >= shown + 0.002)
            nav->options->progress(nav->options->user, shown = fraction);
    }
}

/* Gravity, state and start of the mechanization. */
static schuler_status prepare(navigation *nav, const schuler_trajectory_row *start,
                              schuler_error *err)
{
    schuler_status status = schuler_field_open(&nav->field, nav->options->gravity, err);
    if (status == SCHULER_OK) status = schuler_gravity_fit(&nav->table, nav->field, err);
    if (status != SCHULER_OK) return status;
    nav->has_disturbance = schuler_field_has_disturbance(nav->field);
    nav->disturbance =
        (schuler_disturbance){ .field = nav->field, .table = &nav->table, .dt_s = nav->in.dt_s };
    nav->mechanization = schuler_mechanizations(SCHULER_ISA_SCALAR)[nav->options->frame];
    nav->state = aligned_alloc(
        64, schuler_mechanization_size(nav->mechanization,
                                       &schuler_coning_algorithms[nav->options->coning]));
    if (!nav->state) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    const schuler_nav_state state = schuler_trajectory_state(start);
    const double knows_truth = 0.0;
    schuler_nav_setup setup = { .dt_s = nav->in.dt_s,
                                .samples_per_update = 1,
                                .order = schuler_coning_algorithms[nav->options->coning].order,
                                .algorithm = &schuler_coning_algorithms[nav->options->coning],
                                .gravity = &nav->table,
                                .lanes = schuler_isa_lanes(SCHULER_ISA_SCALAR),
                                .start = &state,
                                .dg_coefficient = &knows_truth };
    schuler_increments_prime(&nav->in, &setup);
    nav->mechanization->init(nav->state, &setup);
    nav->gains = schuler_baro_gains_of(
        SCHULER_BARO_TIME_S, schuler_vec3_norm(schuler_gravity_at(&nav->table, state.r_e)),
        start->llh.lat_rad);
    return SCHULER_OK;
}

static void finish(schuler_error_figures *f, int64_t rows)
{
    f->rms = rows > 0 ? sqrt(f->rms / (double)rows) : 0.0;
}

schuler_status schuler_navigate(const schuler_navigate_options *options,
                                schuler_navigate_result *out, schuler_error *err)
{
    navigation *nav = calloc(1, sizeof(*nav));
    if (!nav) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    nav->options = options;
    schuler_trajectory_row start;
    int got_row = 0;
    schuler_status status =
        schuler_csv_open(&nav->reference, options->reference_file, SCHULER_TRAJECTORY_HEADER, err);
    if (status == SCHULER_OK)
        status = schuler_trajectory_next(nav->reference, &start, &got_row, err);
    if (status == SCHULER_OK && !got_row) {
        const schuler_place place = { options->reference_file, 0, 0, 0 };
        status =
            schuler_fail(err, SCHULER_ERR_INPUT, &place, "no row to start from after the header");
    }
    if (status == SCHULER_OK)
        status = schuler_increments_open(&nav->in, options->imu_file, start.t_s, err);
    if (status == SCHULER_OK) status = prepare(nav, &start, err);
    if (status == SCHULER_OK) status = report(nav, &start, err);
    if (status == SCHULER_OK) status = follow_reference(nav, err);
    if (status == SCHULER_OK) {
        nav->result.dt_s = nav->in.dt_s;
        *out = nav->result;
        finish(&out->horizontal_m, out->rows - 1);
        finish(&out->height_m, out->rows - 1);
        finish(&out->velocity_mps, out->rows - 1);
        finish(&out->attitude_rad, out->rows - 1);
    }
    schuler_csv_close(nav->reference);
    schuler_increments_close(&nav->in);
    schuler_field_close(nav->field);
    free(nav->state);
    free(nav);
    return status;
}

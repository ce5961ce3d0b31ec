/* SPDX-License-Identifier: MIT */
#include "scenarios/navigate.h"
#include "core/trajectories/velocity_doubt.h"
#include "scenarios/comparator.h"
#include "scenarios/disturbance.h"
#include "scenarios/increments.h"
#include "scenarios/navigate_errors.h"
#include <math.h>
#include <stdlib.h>
#include <time.h>

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
    schuler_recorded_sample before; /* the reference's row last read */
    schuler_navigate_result result;
    double *stage_s; /* where the time since since_s goes */
    double since_s;
} navigation;

/* From now on the time goes there. */
static void enter(navigation *nav, double *stage_s)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    const double now_s = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (nav->stage_s) *nav->stage_s += now_s - nav->since_s;
    nav->stage_s = stage_s;
    nav->since_s = now_s;
}

static int is_finite(const schuler_nav_state *s)
{
    double sum = s->q_b_e.w + s->q_b_e.x + s->q_b_e.y + s->q_b_e.z;
    for (int i = 0; i < 3; i++) sum += s->r_e.v[i] + s->v_e.v[i];
    return isfinite(sum);
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

/* At a reference time, off_s after the step: hold, hand out the row, compare. The first row is the
 * start itself. */
static schuler_status report(navigation *nav, const schuler_trajectory_row *reference, double off_s,
                             schuler_error *err)
{
    const schuler_status status = steady(nav, reference, err);
    if (status != SCHULER_OK) return status;
    schuler_nav_state s;
    nav->mechanization->get(nav->state, 0, &s);
    if (!is_finite(&s))
        return schuler_fail(err, SCHULER_ERR_NUMERIC, NULL,
                            "the navigator's state is no longer finite at %.9g s", reference->t_s);
    if (off_s != 0.0) s.r_e = schuler_vec3_add(s.r_e, schuler_vec3_scale(off_s, s.v_e));
    schuler_mat3 C_b_n;
    const schuler_trajectory_row row = navigate_row(&s, reference->t_s, &C_b_n);
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
    if (nav->step > 0)
        navigate_compare(&nav->result, &s, &row, &C_b_n, reference, &nav->before,
                         reference->t_s - nav->in.t0_s);
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
        if (nav->in.used == nav->in.n) {
            enter(nav, &nav->result.timing.reading_s);
            const schuler_status status = schuler_increments_more(&nav->in, err);
            enter(nav, &nav->result.timing.navigating_s);
            if (status != SCHULER_OK) return status;
        }
        if (nav->in.used == nav->in.n) return SCHULER_OK;
        if (nav->options->stop && *nav->options->stop)
            return schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
        advance_some(nav, step - nav->step);
    }
    *reached = 1;
    return SCHULER_OK;
}

/* The step of a time of the reference, and how long after it that is. */
static schuler_status reference_step(navigation *nav, double t_s, int64_t *step, double *off_s,
                                     schuler_error *err)
{
    enum { TIME = 0 };
    const schuler_increments *const in = &nav->in;
    const int on_grid = schuler_increments_on_grid(in->t0_s, in->dt_s, t_s, step);
    const double before_s = in->t0_s + nav->result.duration_s;
    *off_s = 0.0;
    if (t_s <= before_s)
        return schuler_csv_refuse(nav->reference, TIME, err,
                                  "time %.17g s does not increase: the row before has %.17g s", t_s,
                                  before_s);
    if (on_grid && *step > nav->step) return SCHULER_OK;
    const int noisy = in->irregular || in->read != in->rows ||
                      nav->result.faults.of[SCHULER_FAULT_JITTER].count > 0;
    if (noisy && *step > nav->step) {
        *off_s = t_s - in->t0_s - (double)*step * in->dt_s;
        schuler_fault_found(&nav->result.faults, SCHULER_FAULT_REFERENCE_BETWEEN,
                            schuler_csv_line(nav->reference), fabs(*off_s));
        return SCHULER_OK;
    }
    return schuler_csv_refuse(
        nav->reference, TIME, err,
        "time %.17g s is not a time of the increments, which come every %.9g s "
        "from %.9g s on",
        t_s, in->dt_s, in->t0_s);
}

static schuler_recorded_sample sample_of(const schuler_trajectory_row *row)
{
    const schuler_nav_state s = schuler_trajectory_state(row);
    return (schuler_recorded_sample){ row->t_s, s.r_e, s.v_e, s.q_b_e };
}

static void doubt_velocity(navigation *nav, const schuler_trajectory_row *row)
{
    const schuler_recorded_sample now = sample_of(row);
    const double off_mps = schuler_velocity_doubt(&nav->before, &now, now.t_s - nav->before.t_s);
    if (off_mps > 0.0)
        schuler_fault_found(&nav->result.faults, SCHULER_FAULT_REFERENCE_VELOCITY,
                            schuler_csv_line(nav->reference), off_mps);
    nav->before = now;
}

/* The increments are at their end: what is left of the reference is only counted. */
static schuler_status count_uncovered(navigation *nav, schuler_error *err)
{
    int got_row = 1;
    schuler_status status = SCHULER_OK;
    enter(nav, &nav->result.timing.reading_s);
    nav->result.reference_goes_on = 1;
    while (status == SCHULER_OK && got_row) {
        schuler_trajectory_row row;
        schuler_fault_found(&nav->result.faults, SCHULER_FAULT_REFERENCE_NOT_COVERED,
                            schuler_csv_line(nav->reference), 0.0);
        if (nav->options->stop && *nav->options->stop)
            return schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
        status = schuler_trajectory_next(nav->reference, &row, &got_row, err);
    }
    return status;
}

static schuler_status follow_row(navigation *nav, const schuler_trajectory_row *row, int *reached,
                                 schuler_error *err)
{
    int64_t step;
    double off_s;
    schuler_status status = reference_step(nav, row->t_s, &step, &off_s, err);
    if (status != SCHULER_OK) return status;
    doubt_velocity(nav, row);
    enter(nav, &nav->result.timing.navigating_s);
    status = advance_to(nav, step, reached, err);
    if (status != SCHULER_OK || !*reached) return status;
    enter(nav, &nav->result.timing.comparing_s);
    status = report(nav, row, off_s, err);
    nav->result.duration_s = row->t_s - nav->in.t0_s;
    nav->result.steps = nav->step;
    return status;
}

static schuler_status follow_reference(navigation *nav, schuler_error *err)
{
    double shown = 0.0;
    for (;;) {
        schuler_trajectory_row row;
        int got_row, reached;
        enter(nav, &nav->result.timing.reading_s);
        schuler_status status = schuler_trajectory_next(nav->reference, &row, &got_row, err);
        if (status != SCHULER_OK || !got_row) return status;
        status = follow_row(nav, &row, &reached, err);
        if (status != SCHULER_OK) return status;
        if (!reached) return count_uncovered(nav, err);
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

schuler_status schuler_navigate(const schuler_navigate_options *options,
                                schuler_navigate_result *out, schuler_error *err)
{
    navigation *nav = calloc(1, sizeof(*nav));
    if (!nav) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    nav->options = options;
    nav->in.bridge = options->bridge;
    nav->in.stop = options->stop;
    nav->in.faults = &nav->result.faults;
    schuler_trajectory_row start = { 0 };
    int got_row = 0;
    enter(nav, &nav->result.timing.reading_s);
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
    enter(nav, &nav->result.timing.navigating_s);
    if (status == SCHULER_OK) status = prepare(nav, &start, err);
    enter(nav, &nav->result.timing.comparing_s);
    nav->before = sample_of(&start);
    if (status == SCHULER_OK) status = report(nav, &start, 0.0, err);
    if (status == SCHULER_OK) status = follow_reference(nav, err);
    enter(nav, NULL);
    schuler_increments_judge(&nav->in);
    nav->result.dt_s = nav->in.dt_s;
    nav->result.rows_read = nav->in.rows;
    nav->result.irregular = nav->in.irregular;
    navigate_finish(&nav->result);
    out->faults = nav->result.faults;
    if (status == SCHULER_OK) *out = nav->result;
    schuler_csv_close(nav->reference);
    schuler_increments_close(&nav->in);
    schuler_field_close(nav->field);
    free(nav->state);
    free(nav);
    return status;
}

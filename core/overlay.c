/* SPDX-License-Identifier: MIT */
#include "core/overlay.h"
#include "core/overlay_sum.h"
#include "core/path_build.h"
#include <stdlib.h>

/* The derivatives of the pieces are exact whatever they follow, and pieces join in position, velocity and
 * attitude. These only say how nearly the pieces follow the sinusoids. */
static const long double velocity_tail = 1e-9L;  /* m/s */
static const long double attitude_tail = 1e-12L; /* rad */
static const size_t pieces_max = 4000000;        /* 2.5 GB */

void schuler_overlay_envelope(const overlay_window *w, double duration_s, long double t_s,
                              double *envelope, double *rate_ps)
{
    *rate_ps = 0.0;
    *envelope = 1.0;
    const long double since = t_s - w->from_s, left = w->to_s - t_s;
    if ((since <= 0.0L && w->from_s > 0.0) || (left <= 0.0L && w->to_s < duration_s))
        *envelope = 0.0;
    if (w->ramp_s == 0.0) return;
    const int fades_out = w->to_s < duration_s;
    const double sign = since < left || !fades_out ? 1.0 : -1.0;
    const double x = (double)(sign > 0.0 ? since : left) / w->ramp_s;
    if (x >= 1.0) return;
    *envelope = x <= 0.0 ? 0.0 : x * x * x * (10.0 - x * (15.0 - x * 6.0));
    *rate_ps = x <= 0.0 ? 0.0 : sign * 30.0 * x * x * (1.0 - x) * (1.0 - x) / w->ramp_s;
}

overlay_group *schuler_overlay_group(schuler_overlay *o, const schuler_overlay_times *times,
                                     size_t lines, const schuler_place *place,
                                     schuler_diagnostics *d)
{
    static const double usual_ramp_s = 10.0;
    overlay_window w = { .from_s = schuler_tick(times->from_s), .to_s = o->duration_s };
    if (!isnan(times->for_s)) w.to_s = fmin(schuler_tick(w.from_s + times->for_s), w.to_s);
    const int fades_out = w.to_s < o->duration_s;
    if (!isnan(times->ramp_s))
        w.ramp_s = schuler_tick(times->ramp_s);
    else if (w.from_s > 0.0 || fades_out)
        w.ramp_s = schuler_tick(fmin(usual_ramp_s, 0.25 * (w.to_s - w.from_s)));
    const int fades_in = w.from_s > 0.0 || w.ramp_s > 0.0;
    if (w.from_s >= o->duration_s) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, place,
                         "from: %.9g s is not within the trajectory, which lasts %.9g s",
                         times->from_s, o->duration_s);
        return NULL;
    }
    if ((fades_in || fades_out) &&
        !(w.ramp_s >= 0.1 && w.ramp_s * (fades_in + fades_out) <= w.to_s - w.from_s)) {
        schuler_diagnose(
            d, SCHULER_ERR_INPUT, place,
            "ramp: %.9g s; an overlay that begins or ends within the mission needs a ramp of "
            "0.1 s or more that fits into its %.9g s",
            w.ramp_s, w.to_s - w.from_s);
        return NULL;
    }
    overlay_group *const groups = realloc(o->groups, (o->count + 1) * sizeof *groups);
    if (groups) {
        o->groups = groups;
        groups[o->count] = (overlay_group){ .window = w, .count = lines };
        groups[o->count].lines = calloc(lines, sizeof(overlay_line));
    }
    if (!groups || !groups[o->count].lines) {
        schuler_diagnose(d, SCHULER_ERR_MEMORY, place, "out of memory for the overlay");
        return NULL;
    }
    return &groups[o->count++];
}

static double next_joint(const schuler_overlay *o, double t_s)
{
    double next_s = o->duration_s;
    for (size_t i = 0; i < o->count; i++) {
        const overlay_window *const w = &o->groups[i].window;
        const double joints_s[] = { w->from_s, w->from_s + w->ramp_s, w->to_s - w->ramp_s,
                                    w->to_s };
        for (int j = 0; j < 4; j++)
            if (joints_s[j] > t_s) next_s = fmin(next_s, joints_s[j]);
    }
    for (int i = 0; o->has_gimbals && i < 2; i++)
        next_s = fmin(next_s, schuler_gimbal_next_joint(&o->gimbals[i], t_s));
    return next_s;
}

typedef struct {
    const schuler_overlay *o;
    overlay_sum *sum;
    const schuler_piece *piece;
} follower;

static xvec widened(schuler_vec3 a)
{
    return xvec_make(a.v[0], a.v[1], a.v[2]);
}

/* The IMU in the axes b0: its place and velocity there, and the vehicle's axes v. */
static void place_in_vehicle(const follower *f, long double t_s, xvec *x_b0, xvec *x_dot_b0,
                             xvec axes_v[3])
{
    const schuler_vec3 lever = f->o->lever_m;
    double x[OVERLAY_CHANNELS], x_dot[OVERLAY_CHANNELS];
    schuler_overlay_sum_at(f->sum, t_s, x, x_dot);
    for (int i = 0; i < 3; i++) axes_v[i] = xvec_make(i == 0, i == 1, i == 2);
    xvec_turn(axes_v, 2, x[OVERLAY_YAW]);
    xvec_turn(axes_v, 1, x[OVERLAY_PITCH]);
    xvec_turn(axes_v, 0, x[OVERLAY_ROLL]);
    const long double sr = sinl(x[OVERLAY_ROLL]), cr = cosl(x[OVERLAY_ROLL]);
    const long double sp = sinl(x[OVERLAY_PITCH]), cp = cosl(x[OVERLAY_PITCH]);
    const double *const angle_dot = &x_dot[OVERLAY_ROLL];
    const xvec omega_v =
        xvec_make(angle_dot[0] - angle_dot[2] * sp, angle_dot[1] * cr + angle_dot[2] * sr * cp,
                  angle_dot[2] * cr * cp - angle_dot[1] * sr);
    const xvec at_v = xvec_make(lever.v[0] + x[OVERLAY_SHAKE_X], lever.v[1] + x[OVERLAY_SHAKE_Y],
                                lever.v[2] + x[OVERLAY_SHAKE_Z]);
    const xvec shake_v =
        xvec_make(x_dot[OVERLAY_SHAKE_X], x_dot[OVERLAY_SHAKE_Y], x_dot[OVERLAY_SHAKE_Z]);
    const xvec d = xvec_make(x[OVERLAY_SURGE], x[OVERLAY_SWAY], x[OVERLAY_HEAVE]);
    const xvec d_dot = xvec_make(x_dot[OVERLAY_SURGE], x_dot[OVERLAY_SWAY], x_dot[OVERLAY_HEAVE]);
    *x_b0 = xvec_add_scaled(d, 1.0L, xvec_along(axes_v, at_v));
    *x_dot_b0 = xvec_add_scaled(
        d_dot, 1.0L, xvec_along(axes_v, xvec_add_scaled(shake_v, 1.0L, xvec_cross(omega_v, at_v))));
}

static void flow(const void *user, schuler_instant at, const schuler_course *course,
                 schuler_flow *out)
{
    (void)course;
    const follower *const f = user;
    const schuler_piece *const piece = f->piece;
    const long double t_s = (long double)at.joint_s + at.after_s;
    const double s =
        (double)(((at.joint_s - piece->t0_s) + at.after_s) * 2.0L / piece->duration_s - 1.0L);
    const schuler_motion m = schuler_piece_at(piece, s);
    const schuler_mat3 C_b0_e = schuler_mat3_from_quat(m.q_b_e);
    xvec axes_b0[3], axes_v[3], x_b0, x_dot_b0;
    for (int i = 0; i < 3; i++)
        axes_b0[i] = xvec_make(C_b0_e.m[0][i], C_b0_e.m[1][i], C_b0_e.m[2][i]);
    place_in_vehicle(f, t_s, &x_b0, &x_dot_b0, axes_v);
    for (int i = 0; f->o->has_gimbals && i < 2; i++) {
        long double angle_rad, rate_radps;
        schuler_gimbal_at(&f->o->gimbals[i], at, &angle_rad, &rate_radps);
        xvec_turn(axes_v, f->o->gimbals[i].axis, angle_rad);
    }
    const xvec moving = xvec_add_scaled(x_dot_b0, 1.0L, xvec_cross(widened(m.omega_eb_b), x_b0));
    out->n_rate_e = out->u_rate_e = xvec_make(0.0L, 0.0L, 0.0L);
    out->v_e = xvec_add_scaled(widened(m.v_e), 1.0L, xvec_along(axes_b0, moving));
    for (int i = 0; i < 3; i++) out->axes_e[i] = xvec_along(axes_b0, axes_v[i]);
}

static schuler_status follow(const schuler_overlay *o, overlay_sum *sum, const schuler_path *base,
                             schuler_path *out)
{
    follower f = { o, sum, NULL };
    const schuler_motion m = schuler_path_at(base, 0.0);
    const schuler_mat3 C_b0_e = schuler_mat3_from_quat(m.q_b_e);
    xvec x_b0, x_dot_b0, axes_v[3], axes_b0[3];
    for (int i = 0; i < 3; i++)
        axes_b0[i] = xvec_make(C_b0_e.m[0][i], C_b0_e.m[1][i], C_b0_e.m[2][i]);
    place_in_vehicle(&f, 0.0L, &x_b0, &x_dot_b0, axes_v);
    schuler_path_builder b;
    schuler_path_begin_at(&b, out,
                          xvec_add_scaled(widened(m.r_e), 1.0L, xvec_along(axes_b0, x_b0)));
    b.velocity_tail = velocity_tail;
    b.attitude_tail = attitude_tail;
    b.pieces_max = pieces_max;
    for (size_t i = 0; i < base->count; i++) {
        f.piece = &base->pieces[i];
        const double end_s = i + 1 == base->count ? base->duration_s : base->pieces[i + 1].t0_s;
        for (double t_s = base->pieces[i].t0_s; t_s < end_s;) {
            const double next_s = fmin(next_joint(o, t_s), end_s);
            const schuler_status status = schuler_path_extend(&b, flow, &f, t_s, next_s);
            if (status != SCHULER_OK) return status;
            t_s = next_s;
        }
    }
    return SCHULER_OK;
}

static void release(schuler_overlay *o)
{
    for (size_t i = 0; i < o->count; i++) free(o->groups[i].lines);
    free(o->groups);
    for (int i = 0; i < 2; i++) free(o->gimbals[i].moves);
}

/* Some pieces a cycle of the quickest line: told beforehand what takes more than there is room for. */
static schuler_status check_size(const schuler_overlay *o, const schuler_place *place,
                                 schuler_diagnostics *d)
{
    double cycles = 0.0, fastest_Hz = 0.0;
    for (size_t g = 0; g < o->count; g++) {
        const overlay_group *const group = &o->groups[g];
        double f_Hz = 0.0;
        for (size_t i = 0; i < group->count; i++)
            f_Hz = fmax(f_Hz, (double)group->lines[i].frequency_Hz);
        fastest_Hz = fmax(fastest_Hz, f_Hz);
        cycles = fmax(cycles, f_Hz * (group->window.to_s - group->window.from_s));
    }
    if (cycles <= (double)pieces_max / 2.0) return SCHULER_OK;
    schuler_diagnose(d, SCHULER_ERR_INPUT, place,
                     "overlays: %.3g cycles of %.4g Hz are more than can be kept; allowed: %.3g "
                     "cycles. Shorten it with 'from' and 'for', or lower the highest frequency",
                     cycles, fastest_Hz, (double)pieces_max / 2.0);
    return SCHULER_ERR_INPUT;
}

schuler_status schuler_overlays_apply(const schuler_variant_list *list, schuler_path *path,
                                      const schuler_place *place, schuler_diagnostics *d)
{
    if (list->count == 0) return SCHULER_OK;
    schuler_overlay o = { .duration_s = path->duration_s };
    schuler_status status = SCHULER_OK;
    for (; o.index < list->count; o.index++) {
        const schuler_variant *const item = &list->items[o.index];
        size_t k = 0;
        while (schuler_overlay_kinds[k]->object != item->which) k++;
        const schuler_status added = schuler_overlay_kinds[k]->add(item->spec, &o, d);
        if (status == SCHULER_OK) status = added;
    }
    if (status == SCHULER_OK) status = check_size(&o, place, d);
    schuler_path result = { 0 };
    if (status == SCHULER_OK) {
        overlay_sum *const sum = schuler_overlay_sum_create(&o);
        status = sum ? follow(&o, sum, path, &result) : SCHULER_ERR_MEMORY;
        schuler_overlay_sum_free(sum);
        if (status != SCHULER_OK)
            schuler_diagnose(d, status, place,
                             status == SCHULER_ERR_MEMORY
                                 ? "out of memory for the overlays"
                                 : "overlays: the motion is too fast to be computed");
    }
    release(&o);
    if (status != SCHULER_OK) {
        schuler_path_free(&result);
        return status;
    }
    schuler_path_free(path);
    *path = result;
    return SCHULER_OK;
}

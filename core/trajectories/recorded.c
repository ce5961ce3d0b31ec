/* SPDX-License-Identifier: MIT */
/* A recorded trajectory: smooth curves through its rows. Position is of fifth degree between rows, through
 * their positions and velocities, with continuous acceleration and jerk; the rotation vector from row to
 * row is cubic, with continuous rate and angular acceleration. Rows are vectors and quaternions by then, so
 * neither the date line, a heading of 180 deg nor a pole is anything special. */
#include "core/trajectories/recorded.h"
#include "core/path_build.h"
#include "core/trajectories/fields.h"
#include "core/trajectories/velocity_doubt.h"
#include <stdlib.h>
#include <string.h>

enum { ROWS_MIN = 4, ROWS_MAX = 4000000 };

/* Beyond reason for a vehicle; a wrong unit or a torn file. */
static const double fastest_mps = 1e4, most_rad = 1.0;

static const char *const velocities[] = { "use", "ignore", NULL };

static const schuler_field fields[] = {
    { .key = "file",
      .kind = SCHULER_FIELD_TEXT,
      .offset = offsetof(schuler_recorded_spec, file),
      .required = true,
      .example = "flight.csv",
      .doc = "trajectory file, CSV as 'schuler truth' writes it; relative to the scenario" },
    { .key = "velocity",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(schuler_recorded_spec, velocity),
      .choices = velocities,
      .example = "use",
      .doc =
          "use: curves go through the file's velocities too; ignore: through its positions alone" },
    { 0 },
};

static const schuler_object object = {
    .name = "recorded",
    .doc = "smooth curves through the rows of a trajectory file",
    .size = sizeof(schuler_recorded_spec),
    .fields = fields,
};

static schuler_place line_of(const schuler_recorded_samples *s, size_t row)
{
    return (schuler_place){ s->file, (int)row + 2, 1, 0 };
}

static schuler_status refuse(const schuler_recorded_samples *s, size_t row, schuler_diagnostics *d,
                             const char *format, double a, double b)
{
    const schuler_place place = line_of(s, row);
    schuler_diagnose(d, SCHULER_ERR_INPUT, &place, format, a, b);
    return SCHULER_ERR_INPUT;
}

/* What no curve should go through. */
static schuler_status check_rows(const schuler_recorded_samples *s, const recorded_knot *knots,
                                 schuler_diagnostics *d)
{
    for (size_t i = 0; i + 1 < s->count; i++) {
        const schuler_recorded_sample *const a = &s->items[i], *const b = a + 1;
        const double h = knots[i + 1].t_s - knots[i].t_s;
        if (!(h >= 1e-6))
            return refuse(s, i + 1, d, "time %.9g s does not come after %.9g s", b->t_s, a->t_s);
        const double v = schuler_vec3_norm(schuler_vec3_sub(b->r_e, a->r_e)) / h;
        if (v > fastest_mps)
            return refuse(s, i + 1, d,
                          "the place is %.4g m/s from the row before; up to %g m/s is believed", v,
                          fastest_mps);
        const double angle = schuler_vec3_norm(knots[i].theta_b);
        if (angle > most_rad)
            return refuse(s, i + 1, d,
                          "the attitude turns by %.4g deg since the row before; between rows up to "
                          "%.3g deg can be followed: record faster",
                          angle / SCHULER_RAD_PER_DEG, most_rad / SCHULER_RAD_PER_DEG);
    }
    return SCHULER_OK;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Told, not hidden: rows missing, and velocities that are not those of the positions. */
static void warn_of_rows(const schuler_recorded_samples *s, const recorded_knot *knots,
                         int uses_velocity, double *work, schuler_diagnostics *d)
{
    const size_t n = s->count - 1;
    for (size_t i = 0; i < n; i++) work[i] = knots[i + 1].t_s - knots[i].t_s;
    qsort(work, n, sizeof *work, compare_doubles);
    const double usual_s = work[n / 2];
    size_t gaps = 0, first_gap = 0, wrong = 0, worst_row = 0;
    double longest_s = 0.0, worst_mps = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double h = knots[i + 1].t_s - knots[i].t_s;
        if (h > 3.0 * usual_s) {
            if (gaps++ == 0) first_gap = i + 1;
            longest_s = fmax(longest_s, h);
        }
        const double off = schuler_velocity_doubt(&s->items[i], &s->items[i + 1], h);
        if (off > 0.0) wrong++;
        if (off > worst_mps) worst_mps = off, worst_row = i + 1;
    }
    if (gaps > 0) {
        const schuler_place place = line_of(s, first_gap);
        schuler_warn(
            d, &place,
            "%zu gap%s of up to %.4g s where rows come every %.4g s; the curve goes straight "
            "across, the first before this line",
            gaps, gaps == 1 ? "" : "s", longest_s, usual_s);
    }
    if (wrong > 0 && uses_velocity) {
        const schuler_place place = line_of(s, worst_row);
        schuler_warn(
            d, &place,
            "%zu of %zu rows have a velocity that is not the change of position, this one by "
            "%.3g m/s; the truth will shake to follow both (velocity: ignore takes the "
            "positions alone)",
            wrong, n, worst_mps);
    }
}

typedef struct {
    const schuler_recorded_sample *row;
    const recorded_knot *knot;
    schuler_vec3 rotvec_rate_end;
} interval;

static void flow(const void *user, schuler_instant at, const schuler_course *course,
                 schuler_flow *out)
{
    (void)course;
    const interval *const in = user;
    const recorded_knot *const a = in->knot, *const b = a + 1;
    const long double h = b->t_s - a->t_s, x = ((at.joint_s - a->t_s) + at.after_s) / h;
    xvec rho, v;
    for (int i = 0; i < 3; i++) {
        /* Fifth degree in x: derivative of p0 + ..., per h. */
        const long double dp = in->row[1].r_e.v[i] - in->row[0].r_e.v[i];
        const long double v0 = a->v_e.v[i] * h, v1 = b->v_e.v[i] * h;
        const long double a0 = a->a_e.v[i] * h * h, a1 = b->a_e.v[i] * h * h;
        const long double c3 = 10.0L * dp - 6.0L * v0 - 4.0L * v1 - 1.5L * a0 + 0.5L * a1;
        const long double c4 = -15.0L * dp + 8.0L * v0 + 7.0L * v1 + 1.5L * a0 - a1;
        const long double c5 = 6.0L * dp - 3.0L * (v0 + v1) - 0.5L * (a0 - a1);
        v.v[i] = (v0 + x * (a0 + x * (3.0L * c3 + x * (4.0L * c4 + x * 5.0L * c5)))) / h;
        const long double w0 = a->omega_b.v[i] * h, w1 = in->rotvec_rate_end.v[i] * h;
        const long double theta = a->theta_b.v[i];
        rho.v[i] = x * (w0 + x * (3.0L * theta - 2.0L * w0 - w1 + x * (w0 + w1 - 2.0L * theta)));
    }
    out->n_rate_e = out->u_rate_e = xvec_make(0.0L, 0.0L, 0.0L);
    out->v_e = v;
    const schuler_quat q0 = in->row->q_b_e;
    const long double w = q0.w, qx = q0.x, qy = q0.y, qz = q0.z;
    const long double k = 2.0L / (w * w + qx * qx + qy * qy + qz * qz);
    const xvec C0[3] = {
        { { 1.0L - k * (qy * qy + qz * qz), k * (qx * qy + w * qz), k * (qx * qz - w * qy) } },
        { { k * (qx * qy - w * qz), 1.0L - k * (qx * qx + qz * qz), k * (qy * qz + w * qx) } },
        { { k * (qx * qz + w * qy), k * (qy * qz - w * qx), 1.0L - k * (qx * qx + qy * qy) } },
    };
    const long double angle2 = xvec_dot(rho, rho), angle = sqrtl(angle2);
    const long double f1 = angle < 1e-6L ? 1.0L - angle2 / 6.0L : sinl(angle) / angle;
    const long double half = sinl(0.5L * angle);
    const long double f2 = angle < 1e-6L ? 0.5L : 2.0L * half * half / angle2;
    for (int i = 0; i < 3; i++) {
        const xvec e = xvec_make(i == 0, i == 1, i == 2), once = xvec_cross(rho, e);
        const xvec turned =
            xvec_add_scaled(xvec_add_scaled(e, f1, once), f2, xvec_cross(rho, once));
        out->axes_e[i] = xvec_along(C0, turned);
    }
}

static schuler_status follow(const schuler_recorded_samples *s, const recorded_knot *knots,
                             schuler_path *path)
{
    schuler_path_builder b;
    const schuler_vec3 r_e = s->items[0].r_e;
    schuler_path_begin_at(&b, path, xvec_make(r_e.v[0], r_e.v[1], r_e.v[2]));
    b.pieces_max = 2 * (size_t)ROWS_MAX;
    for (size_t i = 0; i + 1 < s->count; i++) {
        const interval in = { &s->items[i], &knots[i],
                              recorded_rotvec_rate(knots[i].theta_b, knots[i + 1].omega_b) };
        b.trial_s = knots[i + 1].t_s - knots[i].t_s;
        const schuler_status status =
            schuler_path_extend(&b, flow, &in, knots[i].t_s, knots[i + 1].t_s);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

static void fill_knots(const schuler_recorded_samples *s, recorded_knot *knots)
{
    for (size_t i = 0; i < s->count; i++) {
        knots[i] = (recorded_knot){ .t_s = schuler_tick(s->items[i].t_s - s->items[0].t_s),
                                    .v_e = s->items[i].v_e };
        if (i == 0) continue;
        const schuler_quat a = s->items[i - 1].q_b_e;
        const schuler_quat back = { a.w, -a.x, -a.y, -a.z };
        knots[i - 1].theta_b = schuler_quat_to_rotvec(schuler_quat_mul(back, s->items[i].q_b_e));
    }
}

static schuler_status through_rows(const schuler_recorded_spec *spec, recorded_knot *knots,
                                   double *work, schuler_path *path, schuler_diagnostics *d)
{
    const schuler_recorded_samples *const s = &spec->samples;
    const int uses_velocity = strcmp(spec->velocity, "use") == 0;
    fill_knots(s, knots);
    schuler_status status = check_rows(s, knots, d);
    if (status != SCHULER_OK) return status;
    warn_of_rows(s, knots, uses_velocity, work, d);
    if (!uses_velocity) recorded_spline_velocity(s->items, knots, s->count, work);
    recorded_spline_acceleration(s->items, knots, s->count, work);
    status = recorded_spline_rate(s->items, knots, s->count, work) ? follow(s, knots, path)
                                                                   : SCHULER_ERR_NUMERIC;
    if (status != SCHULER_OK)
        schuler_diagnose(d, status, &spec->place,
                         "no smooth motion goes through the rows of %.200s", s->file);
    return status;
}

static schuler_status build(const void *spec, schuler_path *out, schuler_diagnostics *d)
{
    const schuler_recorded_spec *const r = spec;
    const schuler_recorded_samples *const s = &r->samples;
    if (s->count < ROWS_MIN || s->count > ROWS_MAX) {
        const schuler_place place = { s->file, 0, 0, 0 };
        schuler_diagnose(d, SCHULER_ERR_INPUT, &place,
                         "%zu rows; a trajectory has %d to %d of them", s->count, ROWS_MIN,
                         ROWS_MAX);
        return SCHULER_ERR_INPUT;
    }
    schuler_path path = { 0 };
    recorded_knot *const knots = malloc(s->count * sizeof *knots);
    double *const work = malloc(6 * s->count * sizeof *work);
    schuler_status status = SCHULER_ERR_MEMORY;
    if (knots && work)
        status = through_rows(r, knots, work, &path, d);
    else
        schuler_diagnose(d, status, &r->place, "out of memory for the trajectory");
    free(knots);
    free(work);
    if (status != SCHULER_OK) {
        schuler_path_free(&path);
        return status;
    }
    *out = path;
    return SCHULER_OK;
}

static schuler_recorded_samples *samples(void *spec, const char **file)
{
    schuler_recorded_spec *const s = spec;
    *file = s->file;
    return &s->samples;
}

extern const schuler_trajectory_kind schuler_trajectory_recorded;
const schuler_trajectory_kind schuler_trajectory_recorded = {
    .name = "recorded",
    .summary = "smooth curves through the rows of a trajectory file",
    .source = "quintic Hermite spline with continuous jerk; cubic rotation vectors with continuous "
              "angular acceleration",
    .object = &object,
    .build = build,
    .samples = samples,
};

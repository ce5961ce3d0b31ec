/* SPDX-License-Identifier: MIT */
/* Polynomials through the Chebyshev-Lobatto points of an interval instead of a cubic spline through
 * all points: local, no end conditions, nothing overshoots where the vehicle starts or stops, and
 * a sample every 14 km does what takes a spline one every 2. What is interpolated must be smooth in
 * time: an interval crosses a joint of the path only where the motion is near to a polynomial all
 * the same. */
#include "core/path_gravity.h"
#include <stdlib.h>

enum { TERMS = SCHULER_PATH_GRAVITY_TERMS, PARTS = SCHULER_PATH_PARTS };

/* A wave of length w over an interval of length L is cos(x s) with x = pi L/w; n points leave
 * 2 J_n(x) < 2 (x/2)^n/n! of it. Here w = 111 km, degree 360 on the ground, which has 1e-5 m/s^2 (some
 * times that on steep mountains), and n points may leave 5e-6 of it: 14 km with 5, 38 with 7, 107 with
 * 11, 237 with 17. Upwards the same waves grow by exp(2 pi h/w), and x is the same. */
static const double shortest_wave_m = 111e3, left_of_it = 5e-6;
/* The motion may be so far from a polynomial through the same points: the disturbance changes by
 * 1.3e-8 m/s^2 a metre (rms on the ground), ten times as much in the Himalayas. */
static const double off_m = 0.05;
/* Shorter stretches need only their ends; several pieces on one, as sway makes them, may be further
 * from a straight line, to and fro. */
static const double linear_m = 300.0, swaying_off_m = 3.0;
/* So many pieces are looked at together at most. */
enum { PIECES_MOST = 1024 };

typedef struct {
    double dg_e[PARTS][3];
} parts;

typedef struct {
    const schuler_path *path;
    schuler_path_field real, nav; /* nav.field NULL: the same */
    schuler_path_gravity *out;
    size_t capacity;
    schuler_vec3 last_r_e; /* where sampled last: joints are shared, and rest is */
    parts last;
    int has_last;
    double cosine[TERMS + 1][TERMS]; /* cos(pi j/(n - 1))      */
    double *speed_mps;               /* greatest of each piece */
} sampler;

static schuler_vec3 beyond(const schuler_path_field *f, schuler_vec3 r_e, schuler_vec3 table_e)
{
    if (!schuler_field_has_disturbance(f->field)) return (schuler_vec3){ { 0.0, 0.0, 0.0 } };
    return schuler_vec3_sub(schuler_field_gravity(f->field, r_e), table_e);
}

static parts sample(sampler *s, double t_s)
{
    const schuler_vec3 r_e = schuler_path_at(s->path, t_s).r_e;
    if (s->has_last && schuler_vec3_norm(schuler_vec3_sub(r_e, s->last_r_e)) <= 1e-3)
        return s->last;
    const schuler_vec3 real_table_e = schuler_gravity_at(s->real.table, r_e);
    const schuler_vec3 real_e = beyond(&s->real, r_e, real_table_e);
    schuler_vec3 nav_e = real_e, nav_table_e = real_table_e;
    if (s->nav.field) {
        nav_table_e = schuler_gravity_at(s->nav.table, r_e);
        nav_e = beyond(&s->nav, r_e, nav_table_e);
    }
    for (int i = 0; i < 3; i++) {
        s->last.dg_e[SCHULER_PATH_REAL][i] = real_e.v[i];
        s->last.dg_e[SCHULER_PATH_NAV][i] = nav_e.v[i];
        s->last.dg_e[SCHULER_PATH_ONLY_REAL][i] =
            (real_e.v[i] - nav_e.v[i]) + (real_table_e.v[i] - nav_table_e.v[i]);
    }
    s->last_r_e = r_e;
    s->has_last = 1;
    return s->last;
}

/* Where the points are, in parts of the interval. */
static double lobatto(const sampler *s, int n, int j)
{
    return 0.5 * (1.0 - s->cosine[n][j]);
}

/* Powers of s of the polynomial through values at those points, s = -cos(pi j/(n - 1)). */
static void interpolate(const sampler *s, const double *at, int n, double power[TERMS])
{
    const double *const cosine = s->cosine[n];
    const int last = n - 1;
    double before[TERMS] = { 0 }, T[TERMS] = { 1.0 }; /* powers of T_(k-1), T_k */
    for (int i = 0; i < n; i++) power[i] = 0.0;
    for (int k = 0; k < n; k++) {
        double c = 0.0;
        for (int j = 0; j < n; j++) {
            const int turn = k * (last - j) % (2 * last);
            c += (j == 0 || j == last ? 0.5 : 1.0) * at[j] *
                 cosine[turn <= last ? turn : 2 * last - turn];
        }
        c *= (k == 0 || k == last ? 1.0 : 2.0) / last;
        for (int i = 0; i <= k; i++) power[i] += c * T[i];
        for (int i = k + 1 < TERMS ? k + 1 : k; i >= 0; i--) {
            const double next = (k == 0 ? 1.0 : 2.0) * (i > 0 ? T[i - 1] : 0.0) - before[i];
            before[i] = T[i];
            T[i] = next;
        }
    }
}

static schuler_status add(sampler *s, double t0_s, double duration_s, int terms)
{
    schuler_path_gravity *const out = s->out;
    if (out->count == s->capacity) {
        const size_t capacity = s->capacity == 0 ? 64 : 2 * s->capacity;
        schuler_path_gravity_interval *const grown =
            realloc(out->intervals, capacity * sizeof(*grown));
        if (grown == NULL) return SCHULER_ERR_MEMORY;
        out->intervals = grown;
        s->capacity = capacity;
    }
    schuler_path_gravity_interval *const interval = &out->intervals[out->count++];
    *interval =
        (schuler_path_gravity_interval){ .t0_s = t0_s, .duration_s = duration_s, .terms = terms };
    parts at[TERMS];
    for (int j = 0; j < terms; j++) at[j] = sample(s, t0_s + lobatto(s, terms, j) * duration_s);
    for (int p = 0; p < PARTS; p++)
        for (int i = 0; i < 3; i++) {
            double values[TERMS];
            for (int j = 0; j < terms; j++) values[j] = at[j].dg_e[p][i];
            interpolate(s, values, terms, interval->dg_e[p][i]);
        }
    return SCHULER_OK;
}

/* What n points leave of the shortest wave. */
static double left_by(int n, double length_m)
{
    double left = 2.0;
    for (int k = 1; k <= n; k++) left *= 0.5 * SCHULER_PI * length_m / shortest_wave_m / k;
    return left;
}

/* Some pieces in a row. */
typedef struct {
    const schuler_piece *piece;
    size_t count;
    double t0_s, duration_s;
    double length_m; /* at its greatest speed */
} stretch;

static double speed_mps(const schuler_piece *piece)
{
    double v_mps = 0.0;
    for (int j = 0; j < 5; j++)
        v_mps = fmax(v_mps, schuler_vec3_norm(schuler_piece_at(piece, 0.5 * j - 1.0).v_e));
    return v_mps;
}

/* fastest_mps: of the first k pieces, k from 1 */
static stretch stretch_of(const schuler_piece *piece, size_t count, const double *fastest_mps)
{
    const schuler_piece *const last = &piece[count - 1];
    stretch s = { .piece = piece, .count = count, .t0_s = piece->t0_s };
    s.duration_s = last->t0_s + last->duration_s - s.t0_s;
    s.length_m = fastest_mps[count] * s.duration_s;
    return s;
}

/* Whether the motion keeps within limit_m of the polynomial through n points of it. */
static int is_near(const sampler *s, const stretch *on, int n, double limit_m)
{
    const schuler_vec3 from_e = schuler_piece_at(on->piece, -1.0).r_e;
    double at[3][TERMS], power[3][TERMS];
    for (int j = 0; j < n; j++) {
        const double t_s = on->t0_s + lobatto(s, n, j) * on->duration_s;
        const schuler_vec3 r_e = schuler_vec3_sub(schuler_path_at(s->path, t_s).r_e, from_e);
        for (int i = 0; i < 3; i++) at[i][j] = r_e.v[i];
    }
    for (int i = 0; i < 3; i++) interpolate(s, at[i], n, power[i]);
    for (size_t k = 0; k < on->count; k++)
        for (int j = 0; j < 3; j++) {
            const schuler_piece *const piece = &on->piece[k];
            const double t_s = piece->t0_s - on->t0_s + 0.5 * j * piece->duration_s;
            const double x = 2.0 * t_s / on->duration_s - 1.0;
            schuler_vec3 off = schuler_vec3_sub(schuler_piece_at(piece, j - 1.0).r_e, from_e);
            for (int i = 0; i < 3; i++) {
                double r_m = 0.0;
                for (int p = n - 1; p >= 0; p--) r_m = r_m * x + power[i][p];
                off.v[i] -= r_m;
            }
            if (!(schuler_vec3_norm(off) <= limit_m)) return 0;
        }
    return 1;
}

/* The fewest points that do; 0: none. What the most do not follow, fewer will not. */
static int points_for(const sampler *s, const stretch *on)
{
    const double sway_m = on->count > 1 ? swaying_off_m : off_m;
    if (on->length_m < linear_m && is_near(s, on, 2, sway_m)) return 2;
    if (left_by(TERMS, on->length_m) > left_of_it || !is_near(s, on, TERMS, off_m)) return 0;
    for (int n = 5; n < TERMS; n += 2)
        if (left_by(n, on->length_m) <= left_of_it && is_near(s, on, n, off_m)) return n;
    return TERMS;
}

static schuler_status sample_piece(sampler *s, const stretch *on)
{
    double count = 1.0;
    while (left_by(TERMS, on->length_m / count) > left_of_it) count += 1.0;
    const double part_s = on->duration_s / count;
    for (double p = 0.0; p < count; p += 1.0) {
        const schuler_status status = add(s, on->t0_s + p * part_s, part_s, TERMS);
        if (status != SCHULER_OK) return status;
    }
    return SCHULER_OK;
}

/* The pieces from one on that need the fewest points for their time. Returned: how many. */
static size_t sample_some(sampler *s, size_t first, schuler_status *status)
{
    const schuler_piece *const piece = &s->path->pieces[first];
    double fastest_mps[PIECES_MOST + 1] = { 0.0 };
    size_t count = 0;
    stretch on;
    do {
        fastest_mps[count + 1] = fmax(fastest_mps[count], s->speed_mps[first + count]);
        on = stretch_of(piece, ++count, fastest_mps);
    } while (count < PIECES_MOST && first + count < s->path->count &&
             left_by(TERMS, on.length_m) <= left_of_it);
    stretch best = stretch_of(piece, 1, fastest_mps);
    int points = points_for(s, &best);
    while (count > 1) {
        on = stretch_of(piece, count, fastest_mps);
        const int n = points_for(s, &on);
        count -= (count + 3) / 4;
        if (n == 0) continue;
        if (points > 0 && (n - 1) * best.duration_s >= (points - 1) * on.duration_s) continue;
        best = on;
        points = n;
    }
    *status = points ? add(s, best.t0_s, best.duration_s, points) : sample_piece(s, &best);
    return best.count;
}

schuler_status schuler_path_gravity_sample(schuler_path_gravity *out, const schuler_path *path,
                                           const schuler_path_field *real,
                                           const schuler_path_field *nav)
{
    *out = (schuler_path_gravity){ 0 };
    out->has[SCHULER_PATH_REAL] = schuler_field_has_disturbance(real->field);
    out->has[SCHULER_PATH_NAV] = schuler_field_has_disturbance(nav ? nav->field : real->field);
    out->has[SCHULER_PATH_ONLY_REAL] = nav != NULL;
    if (!out->has[SCHULER_PATH_REAL] && !nav) return SCHULER_OK;
    sampler s = { .path = path, .real = *real, .out = out };
    if (nav) s.nav = *nav;
    for (int n = 2; n <= TERMS; n++)
        for (int j = 0; j < n; j++) s.cosine[n][j] = cos(SCHULER_PI * j / (n - 1));
    s.speed_mps = malloc(path->count * sizeof *s.speed_mps);
    schuler_status status = s.speed_mps ? SCHULER_OK : SCHULER_ERR_MEMORY;
    for (size_t i = 0; status == SCHULER_OK && i < path->count; i++)
        s.speed_mps[i] = speed_mps(&path->pieces[i]);
    for (size_t i = 0; status == SCHULER_OK && i < path->count;) i += sample_some(&s, i, &status);
    free(s.speed_mps);
    if (status != SCHULER_OK) schuler_path_gravity_free(out);
    return status;
}

void schuler_path_gravity_free(schuler_path_gravity *g)
{
    free(g->intervals);
    *g = (schuler_path_gravity){ 0 };
}

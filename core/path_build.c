/* SPDX-License-Identifier: MIT */
#include "core/path_build.h"
#include <stdlib.h>

enum {
    NODES = SCHULER_BUILD_NODES,
    MIDDLE = NODES / 2,
    PICARD_MAX = 60,
    PATIENCE = 4,
};

static const double longest_s = 256.0, shortest_s = 1e-5;

/* Relative to the rounding that double leaves anyway. */
static const size_t usual_pieces_max = 200000; /* 125 MB */
static const long double usual_velocity_tail = 1e-14L, usual_attitude_tail = 5e-17L;

/* Everything about the nodes follows from T_k(cos x) = cos(k x) at x = pi j/(NODES - 1). */
static void set_up(schuler_collocation *c)
{
    const int n = NODES - 1;
    const long double pi = acosl(-1.0L);
    long double T[NODES][NODES]; /* T[k][j] = T_k(s_j) */
    for (int j = 0; j <= n; j++) {
        c->s[j] = -cosl(pi * j / n);
        if (2 * j == n) c->s[j] = 0.0L;
        for (int k = 0; k <= n; k++) T[k][j] = cosl(pi * k * (n - j) / n);
    }
    for (int k = 0; k <= n; k++)
        for (int j = 0; j <= n; j++) {
            const long double halves =
                (k == 0 || k == n ? 0.5L : 1.0L) * (j == 0 || j == n ? 0.5L : 1.0L);
            c->to_chebyshev[k][j] = 2.0L / n * halves * T[k][j];
        }

    /* Integral of T_k from -1: (T_{k+1}/(k+1) - T_{k-1}/(k-1))/2 less its value at -1. */
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            const long double x = pi * (n - i) / n;
            long double sum = 0.0L;
            for (int k = 0; k <= n; k++) {
                long double value;
                if (k == 0)
                    value = c->s[i] + 1.0L;
                else if (k == 1)
                    value = 0.5L * (c->s[i] * c->s[i] - 1.0L);
                else
                    value = 0.5L * (cosl((k + 1) * x) / (k + 1) - cosl((k - 1) * x) / (k - 1)) -
                            (k % 2 == 0 ? 1.0L : -1.0L) / ((long double)k * k - 1.0L);
                sum += value * c->to_chebyshev[k][j];
            }
            c->integral[i][j] = sum;
        }

    long double power[NODES][NODES] = { { 1.0L }, { 0.0L, 1.0L } }; /* power[k][p]: s^p in T_k */
    for (int k = 2; k <= n; k++)
        for (int p = 0; p <= n; p++)
            power[k][p] = (p > 0 ? 2.0L * power[k - 1][p - 1] : 0.0L) - power[k - 2][p];
    for (int p = 0; p <= n; p++)
        for (int j = 0; j <= n; j++) {
            long double sum = 0.0L;
            for (int k = 0; k <= n; k++) sum += power[k][p] * c->to_chebyshev[k][j];
            c->to_power[p][j] = sum;
        }
}

void schuler_path_begin_at(schuler_path_builder *b, schuler_path *path, xvec r_e)
{
    *b = (schuler_path_builder){ .path = path,
                                 .trial_s = 16.0,
                                 .velocity_tail = usual_velocity_tail,
                                 .attitude_tail = usual_attitude_tail,
                                 .pieces_max = usual_pieces_max,
                                 .r_e = r_e };
    set_up(&b->collocation);
}

void schuler_path_begin(schuler_path_builder *b, schuler_path *path, schuler_course course,
                        long double h_m)
{
    const long double a = SCHULER_WGS84_A_M, e2 = SCHULER_WGS84_E2;
    const xvec n = course.n_e;
    const long double R_P = a / sqrtl(1.0L - e2 * n.v[2] * n.v[2]);
    schuler_path_begin_at(
        b, path,
        xvec_make((R_P + h_m) * n.v[0], (R_P + h_m) * n.v[1], (R_P * (1.0L - e2) + h_m) * n.v[2]));
    b->course = course;
    b->course.h_m = b->lowest_m = b->highest_m = h_m;
}

/* Values of the three components at the nodes, times a row of a matrix. */
static xvec combine(const long double row[NODES], const xvec at[NODES])
{
    xvec sum = { { 0 } };
    for (int j = 0; j < NODES; j++) sum = xvec_add_scaled(sum, row[j], at[j]);
    return sum;
}

static long double combine_one(const long double row[NODES], const long double at[NODES])
{
    long double sum = 0.0L;
    for (int j = 0; j < NODES; j++) sum += row[j] * at[j];
    return sum;
}

static long double largest(xvec a)
{
    return fmaxl(fabsl(a.v[0]), fmaxl(fabsl(a.v[1]), fabsl(a.v[2])));
}

/* The course and the flow at all nodes of [t, t + T]; 0 when it does not settle. */
static int solve(const schuler_path_builder *b, schuler_flow_function *flow, const void *user,
                 schuler_instant start, long double T_s, schuler_course course[NODES],
                 schuler_flow at[NODES])
{
    const schuler_collocation *const c = &b->collocation;
    xvec n_rate[NODES], u_rate[NODES];
    long double h_rate[NODES];
    for (int j = 0; j < NODES; j++) course[j] = b->course;
    long double change = 0.0L;
    for (int iteration = 0; iteration < PICARD_MAX; iteration++) {
        for (int j = 0; j < NODES; j++) {
            const schuler_instant t = { start.joint_s,
                                        start.after_s + 0.5L * T_s * (c->s[j] + 1.0L) };
            at[j].h_rate_mps = 0.0L;
            flow(user, t, &course[j], &at[j]);
            n_rate[j] = at[j].n_rate_e;
            h_rate[j] = at[j].h_rate_mps;
            u_rate[j] = at[j].u_rate_e;
        }
        const long double before = change;
        change = 0.0L;
        for (int j = 1; j < NODES; j++) {
            const schuler_course next = {
                xvec_add_scaled(b->course.n_e, 0.5L * T_s, combine(c->integral[j], n_rate)),
                xvec_add_scaled(b->course.u_e, 0.5L * T_s, combine(c->integral[j], u_rate)),
                b->course.h_m + 0.5L * T_s * combine_one(c->integral[j], h_rate),
            };
            change = fmaxl(change, largest(xvec_add_scaled(next.n_e, -1.0L, course[j].n_e)));
            change = fmaxl(change, largest(xvec_add_scaled(next.u_e, -1.0L, course[j].u_e)));
            change = fmaxl(change, fabsl(next.h_m - course[j].h_m) / SCHULER_WGS84_A_M);
            course[j] = next;
        }
        if (!(change < 2.0L)) return 0; /* unit vectors cannot differ by more; also NaN */
        /* A few units of extended rounding: it has settled, or it only dances. */
        if (change < 1e-18L || (change < 1e-16L && change >= before && iteration > 2)) return 1;
    }
    return 0;
}

/* Rotation vectors of the body axes relative to the attitude q0, by the skew part of C0^T C. */
static int rotation_vectors(schuler_quat q0, const schuler_flow at[NODES], xvec rho[NODES])
{
    const long double w = q0.w, x = q0.x, y = q0.y, z = q0.z;
    const long double k = 2.0L / (w * w + x * x + y * y + z * z); /* q0 is unit to double only */
    const xvec C0[3] = {
        { { 1.0L - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y) } },
        { { k * (x * y - w * z), 1.0L - k * (x * x + z * z), k * (y * z + w * x) } },
        { { k * (x * z + w * y), k * (y * z - w * x), 1.0L - k * (x * x + y * y) } },
    };
    for (int j = 0; j < NODES; j++) {
        long double R[3][3];
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 3; i++) R[a][i] = xvec_dot(C0[a], at[j].axes_e[i]);
        const xvec half = xvec_make(0.5L * (R[2][1] - R[1][2]), 0.5L * (R[0][2] - R[2][0]),
                                    0.5L * (R[1][0] - R[0][1]));
        const long double sine = sqrtl(xvec_dot(half, half));
        const long double cosine = 0.5L * (R[0][0] + R[1][1] + R[2][2] - 1.0L);
        const long double angle = atan2l(sine, cosine);
        if (!(angle <= SCHULER_PIECE_ANGLE_RAD)) return 0;
        rho[j] = xvec_scale(sine < 1e-7L ? 1.0L + sine * sine / 6.0L : angle / sine, half);
    }
    return 1;
}

/* Size of the highest two coefficients. The last but one counts for a tenth: it shows what the
 * first one cut off would be when the function is odd. */
static long double tail(const schuler_collocation *c, const xvec at[NODES])
{
    return fmaxl(largest(combine(c->to_chebyshev[NODES - 1], at)),
                 0.1L * largest(combine(c->to_chebyshev[NODES - 2], at)));
}

/* Fill a piece from the nodes. Returned: position at its end. */
static xvec fill(const schuler_path_builder *b, long double T_s, const xvec v_e[NODES],
                 const xvec rho[NODES], schuler_piece *piece)
{
    const schuler_collocation *const c = &b->collocation;
    xvec start = { { 0 } }, end = { { 0 } }; /* displacement from the middle */
    for (int k = 0; k < NODES; k++) {
        const xvec v_k = combine(c->to_power[k], v_e), rho_k = combine(c->to_power[k], rho);
        for (int i = 0; i < 3; i++) {
            const double coefficient = (double)(0.5L * T_s * v_k.v[i] / (k + 1));
            piece->dr_e[i][k + 1] = coefficient;
            piece->rho_b[i][k] = (double)rho_k.v[i];
            end.v[i] += coefficient;
            start.v[i] += k % 2 == 0 ? -coefficient : coefficient;
        }
    }
    const xvec middle = xvec_add_scaled(b->r_e, -1.0L, start);
    piece->r0_e = xvec_round(middle);
    for (int i = 0; i < 3; i++) piece->dr_e[i][0] = (double)(middle.v[i] - piece->r0_e.v[i]);
    return xvec_add_scaled(middle, 1.0L, end);
}

static schuler_status append(schuler_path_builder *b, const schuler_piece *piece)
{
    schuler_path *const path = b->path;
    if (path->count == b->capacity) {
        const size_t capacity = b->capacity == 0 ? 16 : 2 * b->capacity;
        schuler_piece *const pieces = realloc(path->pieces, capacity * sizeof(*pieces));
        if (pieces == NULL) return SCHULER_ERR_MEMORY;
        path->pieces = pieces;
        b->capacity = capacity;
    }
    path->pieces[path->count++] = *piece;
    path->duration_s = piece->t0_s + piece->duration_s;
    return SCHULER_OK;
}

typedef enum { TOO_LONG, GOOD, EASY } verdict;

/* What a piece gives. */
typedef struct {
    schuler_piece piece;
    schuler_course course; /* at its end */
    xvec r_e;              /* there */
    long double lowest_m, highest_m;
} trial;

/* Solve one piece of length T and judge it. */
static verdict try_piece(const schuler_path_builder *b, schuler_flow_function *flow,
                         const void *user, schuler_instant start, double T_s, trial *out)
{
    schuler_piece *const piece = &out->piece;
    schuler_course courses[NODES];
    schuler_flow at[NODES];
    xvec v_e[NODES], rho[NODES];
    if (!solve(b, flow, user, start, T_s, courses, at)) return TOO_LONG;
    long double fastest = 0.0L;
    for (int j = 0; j < NODES; j++) {
        v_e[j] = at[j].v_e;
        fastest = fmaxl(fastest, largest(v_e[j]));
    }
    schuler_mat3 C_b_e;
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < 3; a++) C_b_e.m[a][i] = (double)at[MIDDLE].axes_e[i].v[a];
    *piece = (schuler_piece){
        .t0_s = b->t_s,
        .duration_s = T_s,
        .q0_b_e = schuler_quat_from_mat3(&C_b_e),
    };
    if (!rotation_vectors(piece->q0_b_e, at, rho)) return TOO_LONG;
    const long double excess =
        fmaxl(tail(&b->collocation, v_e) / (b->velocity_tail * (1.0L + 0.01L * fastest)),
              tail(&b->collocation, rho) / b->attitude_tail);
    if (!(excess <= 1.0L)) return TOO_LONG;
    out->r_e = fill(b, T_s, v_e, rho, piece);
    if (!isfinite(out->r_e.v[0] + out->r_e.v[1] + out->r_e.v[2])) return TOO_LONG;
    out->course = courses[NODES - 1];
    out->course.n_e = xvec_unit(out->course.n_e);
    out->lowest_m = out->highest_m = out->course.h_m;
    for (int j = 0; j < NODES; j++) {
        out->lowest_m = fminl(out->lowest_m, courses[j].h_m);
        out->highest_m = fmaxl(out->highest_m, courses[j].h_m);
    }
    const long double turned = fmaxl(largest(rho[0]), largest(rho[NODES - 1]));
    return excess < 1e-3L && turned < 0.4L * SCHULER_PIECE_ANGLE_RAD ? EASY : GOOD;
}

schuler_status schuler_path_extend(schuler_path_builder *b, schuler_flow_function *flow,
                                   const void *user, double from_s, double to_s)
{
    int good = 0; /* pieces in a row */
    for (double t_s = from_s; t_s < to_s;) {
        /* Equal parts of what is left, so that no sliver remains at the end. */
        const double parts = ceil((to_s - t_s) / b->trial_s);
        const double T_s = parts > 1.0 ? schuler_tick((to_s - t_s) / parts) : to_s - t_s;
        trial next;
        const verdict v =
            try_piece(b, flow, user, (schuler_instant){ from_s, t_s - from_s }, T_s, &next);
        if (v == TOO_LONG) {
            b->trial_s = 0.5 * T_s;
            good = 0;
            if (b->trial_s < shortest_s) {
                b->trial_s = shortest_s;
                return SCHULER_ERR_NUMERIC;
            }
            continue;
        }
        if (++b->count > b->pieces_max) return SCHULER_ERR_NUMERIC;
        if (b->path != NULL) {
            const schuler_status status = append(b, &next.piece);
            if (status != SCHULER_OK) return status;
        }
        b->course = next.course;
        b->lowest_m = fminl(b->lowest_m, next.lowest_m);
        b->highest_m = fmaxl(b->highest_m, next.highest_m);
        b->r_e = next.r_e;
        b->t_s += T_s;
        t_s += T_s;
        /* Longer ones are also tried now and then where rounding hides how easy it was. */
        if (v == EASY || ++good % PATIENCE == 0)
            b->trial_s = fmin(2.0 * fmax(T_s, 0.5 * b->trial_s), longest_s);
    }
    return SCHULER_OK;
}

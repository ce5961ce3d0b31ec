/* SPDX-License-Identifier: MIT */
/* What a process makes of the response to one impulse. */
#include "scenarios/growth.h"
#include "scenarios/growth_kernel.h"
#include "sensors/processes.h"
#include <string.h>

/* Steps of an integral: a fiftieth of a radian of the pendulum (w = 1.24e-3 rad/s), so that a
 * straight line within a step is off by (w dt)^2/12 = 3e-5, and Simpson's rule by less. */
static int64_t steps_for(double t_s)
{
    const int64_t half = (int64_t)ceil(t_s / 32.0);
    return 2 * (half < 256 ? 256 : half);
}

static double simpson(int64_t j, int64_t n, double dt_s)
{
    return (j == 0 || j == n ? 1.0 : j % 2 ? 4.0 : 2.0) * dt_s / 3.0;
}

/* Errors that are the same in shape each time: the kernel itself. The state model goes one long step
 * after another, the closed form needs none. */
static void determined(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                       int component, kernel_shape shape, double t_s, double out_m[2])
{
    const int64_t n = law == SCHULER_GROWTH_EARTH ? steps_for(t_s) : 1;
    growth_kernel k;
    growth_kernel_start(&k, g, component, rest, law, shape, t_s / (double)n);
    for (int64_t j = 0; j < n; j++) growth_kernel_step(&k);
    growth_kernel_at(&k, out_m);
}

/* sigma^2 = the integral of the square of the kernel. */
static void noise(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                  int component, kernel_shape shape, double t_s, double out_m[2])
{
    const int64_t n = steps_for(t_s);
    const double dt_s = t_s / (double)n;
    double sum[2] = { 0.0, 0.0 }, h[2];
    growth_kernel k;
    growth_kernel_start(&k, g, component, rest, law, shape, dt_s);
    for (int64_t j = 0; j <= n; j++) {
        growth_kernel_at(&k, h);
        for (int i = 0; i < 2; i++) sum[i] += simpson(j, n, dt_s) * h[i] * h[i];
        growth_kernel_step(&k);
    }
    for (int i = 0; i < 2; i++) out_m[i] = sqrt(sum[i]);
}

/* y(t) = integral of h(u) exp(-(t - u)/T) du and z with (t - u)/T exp(-(t - u)/T): h straight within
 * a step, so that T may be as short as it likes. */
typedef struct {
    double phi, old, new, T_s, y[2], z[2], h[2];
} fading;

static fading fading_start(double T_s, double dt_s, const double h[2])
{
    const double x = dt_s / T_s, first = -T_s * expm1(-x);
    fading f = { .phi = exp(-x), .T_s = T_s };
    f.new = x < 1e-4 ? T_s *x *(0.5 - x / 6.0) : T_s - first / x;
    f.old = first - f.new;
    memcpy(f.h, h, sizeof f.h);
    return f;
}

static void fading_step(fading *f, const double h[2])
{
    for (int i = 0; i < 2; i++) {
        const double y = f->phi * f->y[i] + f->old * f->h[i] + f->new *h[i];
        f->z[i] = f->phi * f->z[i] + (f->old * f->y[i] + f->new *y) / f->T_s;
        f->y[i] = y;
        f->h[i] = h[i];
    }
}

static void decay(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                  int component, double t_s, double out_m[2])
{
    const int64_t n = steps_for(t_s);
    double h[2];
    growth_kernel k;
    growth_kernel_start(&k, g, component, rest, law, KERNEL_IMPULSE, t_s / (double)n);
    growth_kernel_at(&k, h);
    fading f = fading_start(g->time_s[component], k.dt_s, h);
    for (int64_t j = 0; j < n; j++) {
        growth_kernel_step(&k);
        growth_kernel_at(&k, h);
        fading_step(&f, h);
    }
    memcpy(out_m, f.y, sizeof f.y);
}

/* sigma^2 = 2 times the integral over u of h(u) and that of h(v) C(u - v) over v < u, for a sum of
 * Gauss-Markov processes of sigma 1. */
enum { MEMBERS_MAX = 32 };

static void correlated(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                       int component, const double *T_s, int members, double t_s, double out_m[2])
{
    const bool second = g->process == SCHULER_GROWS_GAUSS_MARKOV_2;
    const int64_t n = steps_for(t_s);
    const double dt_s = t_s / (double)n;
    double h[2], sum[2] = { 0.0, 0.0 };
    growth_kernel k;
    growth_kernel_start(&k, g, component, rest, law, KERNEL_IMPULSE, dt_s);
    growth_kernel_at(&k, h);
    fading f[MEMBERS_MAX];
    for (int m = 0; m < members; m++) f[m] = fading_start(T_s[m], dt_s, h);
    for (int64_t j = 1; j <= n; j++) {
        growth_kernel_step(&k);
        growth_kernel_at(&k, h);
        for (int m = 0; m < members; m++) {
            fading_step(&f[m], h);
            for (int i = 0; i < 2; i++)
                sum[i] +=
                    2.0 * simpson(j, n, dt_s) * h[i] * (f[m].y[i] + (second ? f[m].z[i] : 0.0));
        }
    }
    for (int i = 0; i < 2; i++) out_m[i] = sqrt(fmax(0.0, sum[i]));
}

static void flicker(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                    int component, double t_s, double out_m[2])
{
    const schuler_flicker_bank bank =
        schuler_flicker_bank_of(g->time_s[component], g->longest_s, g->dt_s);
    double T_s[MEMBERS_MAX];
    const int members = bank.members < MEMBERS_MAX ? bank.members : MEMBERS_MAX;
    for (int m = 0; m < members; m++) T_s[m] = m == 0 ? bank.shortest_s : T_s[m - 1] * bank.ratio;
    correlated(g, rest, law, component, T_s, members, t_s, out_m);
    for (int i = 0; i < 2; i++) out_m[i] *= schuler_flicker_bank_sigma(bank.ratio);
}

/* rms over the phase = |the integral of h(u) exp(-i nu u)|/sqrt(2), h straight within a step, so that
 * nu may be as fast as it likes. */
static void sinusoid(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                     int component, double t_s, double out_m[2])
{
    const int64_t n = steps_for(t_s);
    const double dt_s = t_s / (double)n, nu = 2.0 * SCHULER_PI * g->frequency_hz[component];
    const double y = nu * dt_s, c = cos(y), s = sin(y);
    /* Integrals over a step of exp(-i nu u) and of u/dt exp(-i nu u), over dt. */
    const bool slow = y < 1e-3;
    const double all[2] = { slow ? 1.0 - y * y / 6.0 : s / y, slow ? -y / 2.0 : (c - 1.0) / y };
    const double new[2] = { slow ? 0.5 - y * y / 8.0 : (c + y * s - 1.0) / (y * y),
                            slow ? -y / 3.0 : (y * c - s) / (y * y) };
    double sum[2][2] = { { 0.0 } }, h[2], next[2];
    growth_kernel k;
    growth_kernel_start(&k, g, component, rest, law, KERNEL_IMPULSE, dt_s);
    growth_kernel_at(&k, h);
    for (int64_t j = 0; j < n; j++) {
        const double phase = nu * (dt_s * (double)j), re = cos(phase), im = -sin(phase);
        growth_kernel_step(&k);
        growth_kernel_at(&k, next);
        for (int i = 0; i < 2; i++) {
            const double a = h[i] * (all[0] - new[0]) + next[i] * new[0],
                         b = h[i] * (all[1] - new[1]) + next[i] * new[1];
            sum[i][0] += dt_s * (a * re - b * im);
            sum[i][1] += dt_s * (a * im + b * re);
            h[i] = next[i];
        }
    }
    for (int i = 0; i < 2; i++) out_m[i] = hypot(sum[i][0], sum[i][1]) / sqrt(2.0);
}

void schuler_growth_response(const schuler_growth *g, const schuler_rest *rest,
                             schuler_growth_law law, int component, double t_s, double out_m[2])
{
    const bool of_start = g->entry < SCHULER_ENTERS_ACCEL;
    switch (g->process) {
    case SCHULER_GROWS_CONSTANT:
        determined(g, rest, law, component, of_start ? KERNEL_IMPULSE : KERNEL_STEP, t_s, out_m);
        return;
    case SCHULER_GROWS_RAMP:
        determined(g, rest, law, component, KERNEL_RAMP, t_s, out_m);
        return;
    case SCHULER_GROWS_DECAY:
        decay(g, rest, law, component, t_s, out_m);
        return;
    case SCHULER_GROWS_WHITE:
        noise(g, rest, law, component, KERNEL_IMPULSE, t_s, out_m);
        return;
    case SCHULER_GROWS_WALK:
        noise(g, rest, law, component, KERNEL_STEP, t_s, out_m);
        return;
    case SCHULER_GROWS_GAUSS_MARKOV:
    case SCHULER_GROWS_GAUSS_MARKOV_2:
        correlated(g, rest, law, component, &g->time_s[component], 1, t_s, out_m);
        return;
    case SCHULER_GROWS_FLICKER:
        flicker(g, rest, law, component, t_s, out_m);
        return;
    case SCHULER_GROWS_SINUSOID:
        sinusoid(g, rest, law, component, t_s, out_m);
        return;
    }
}

static void moments(const schuler_value *v, int c, double *mean, double *variance)
{
    const double half = 0.5 * (v->b[c] - v->a[c]);
    *mean = v->draw == SCHULER_DRAW_FIXED     ? v->a[c]
            : v->draw == SCHULER_DRAW_UNIFORM ? v->a[c] + half
                                              : 0.0;
    *variance = v->draw == SCHULER_DRAW_FIXED     ? 0.0
                : v->draw == SCHULER_DRAW_UNIFORM ? half * half / 3.0
                                                  : v->a[c] * v->a[c];
}

double schuler_growth_rms(const schuler_growth *g, const schuler_rest *rest, schuler_growth_law law,
                          const schuler_value *value, double t_s)
{
    const bool random = g->process >= SCHULER_GROWS_WHITE;
    double sum_m2 = 0.0, together_m[2] = { 0.0, 0.0 };
    for (int c = 0; c < g->components; c++) {
        double mean, variance, r_m[2];
        moments(value, c, &mean, &variance);
        if (mean == 0.0 && variance == 0.0) continue;
        schuler_growth_response(g, rest, law, c, t_s, r_m);
        for (int i = 0; i < 2; i++) {
            sum_m2 += (variance + (random ? mean * mean : 0.0)) * r_m[i] * r_m[i];
            together_m[i] += random ? 0.0 : mean * r_m[i];
        }
    }
    return sqrt(sum_m2 + together_m[0] * together_m[0] + together_m[1] * together_m[1]);
}

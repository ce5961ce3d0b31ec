/* SPDX-License-Identifier: MIT */
#include "core/profile.h"
#include <math.h>

double schuler_tick(double t_s)
{
    return floor(t_s * SCHULER_TICKS_PER_S + 0.5) / SCHULER_TICKS_PER_S;
}

schuler_trapezoid schuler_trapezoid_make(double change, double rate_limit, double ramp_s)
{
    if (change == 0.0) return (schuler_trapezoid){ 0 };
    schuler_trapezoid z = { .change = change };
    /* A millisecond at least: a ramp of no length would be a jump. */
    z.ramp_s = schuler_tick(fmax(ramp_s, 1e-3));
    z.plateau_s = schuler_tick(fmax(fabs(change) / rate_limit - z.ramp_s, 0.0));
    z.rate = (long double)change / (z.ramp_s + z.plateau_s);
    return z;
}

double schuler_trapezoid_duration(const schuler_trapezoid *z)
{
    return 2.0 * z->ramp_s + z->plateau_s;
}

static long double smoothstep(long double x)
{
    return x * x * x * (10.0L - x * (15.0L - x * 6.0L));
}

/* From 0 to x; half at x = 1. */
static long double smoothstep_integral(long double x)
{
    return x * x * x * x * (2.5L - x * (3.0L - x));
}

/* Differences of ticks are exact, so the small of two times keeps its digits. */
static long double since_start(schuler_instant t)
{
    return t.joint_s + t.after_s;
}

static long double until_end(const schuler_trapezoid *z, schuler_instant t)
{
    return (schuler_trapezoid_duration(z) - t.joint_s) - t.after_s;
}

long double schuler_trapezoid_value(const schuler_trapezoid *z, schuler_instant t)
{
    const long double t_s = since_start(t), rest_s = until_end(z, t);
    if (t_s <= 0.0L) return 0.0L;
    if (rest_s <= 0.0L) return z->change;
    const long double rate = z->rate, ramp_s = z->ramp_s;
    if (t_s < ramp_s) return rate * ramp_s * smoothstep_integral(t_s / ramp_s);
    if (rest_s < ramp_s) return z->change - rate * ramp_s * smoothstep_integral(rest_s / ramp_s);
    return rate * (t_s - 0.5L * ramp_s);
}

long double schuler_trapezoid_rate(const schuler_trapezoid *z, schuler_instant t)
{
    const long double t_s = since_start(t), rest_s = until_end(z, t);
    if (t_s <= 0.0L || rest_s <= 0.0L) return 0.0L;
    if (t_s < z->ramp_s) return z->rate * smoothstep(t_s / z->ramp_s);
    if (rest_s < z->ramp_s) return z->rate * smoothstep(rest_s / z->ramp_s);
    return z->rate;
}

static schuler_instant shifted(const schuler_channel *c, schuler_instant t)
{
    return (schuler_instant){ t.joint_s - c->start_s, t.after_s };
}

/* The Bernstein polynomial of the points of a curve less its start, at x in [0, 1], by de
 * Casteljau's scheme. Returned beside it: the derivative by x. */
static long double curve_change(const schuler_channel *c, long double x, long double *slope)
{
    long double p[SCHULER_CURVE_POINTS + 5] = { 0.0L, 0.0L, 0.0L };
    const schuler_curve *const curve = &c->curve;
    const size_t last = curve->count + 4;
    for (size_t i = 3; i <= last; i++)
        p[i] = (long double)curve->to[i - 3 < curve->count ? i - 3 : curve->count - 1] - c->from;
    for (size_t n = last; n > 1; n--)
        for (size_t i = 0; i < n; i++) p[i] += x * (p[i + 1] - p[i]);
    *slope = (long double)last * (p[1] - p[0]);
    return p[0] + x * (p[1] - p[0]);
}

static long double curve_at(const schuler_channel *c, schuler_instant t, long double *rate)
{
    const long double T_s = c->curve.duration_s;
    const long double x = fminl(fmaxl(since_start(t) / T_s, 0.0L), 1.0L);
    const long double change = curve_change(c, x, rate);
    *rate /= T_s;
    return change;
}

long double schuler_channel_value(const schuler_channel *c, schuler_instant t)
{
    long double rate;
    if (c->curve.count > 0) return c->from + curve_at(c, t, &rate);
    return c->from + schuler_trapezoid_value(&c->trapezoid, shifted(c, t));
}

long double schuler_channel_rate(const schuler_channel *c, schuler_instant t)
{
    long double rate;
    if (c->curve.count > 0) {
        (void)curve_at(c, t, &rate);
        return rate;
    }
    return schuler_trapezoid_rate(&c->trapezoid, shifted(c, t));
}

double schuler_channel_end(const schuler_channel *c)
{
    return c->curve.count > 0 ? c->curve.to[c->curve.count - 1] : c->from + c->trapezoid.change;
}

int schuler_phase_joints(const schuler_phase *phase, double joints_s[SCHULER_PHASE_JOINTS])
{
    const schuler_channel *const channels[SCHULER_PHASE_CHANNELS] = {
        &phase->speed, &phase->height, &phase->path_angle, &phase->heading,
        &phase->yaw,   &phase->pitch,  &phase->roll,
    };
    int count = 0;
    joints_s[count++] = 0.0;
    joints_s[count++] = phase->duration_s;
    for (int i = 0; i < SCHULER_PHASE_CHANNELS; i++) {
        const schuler_trapezoid *const z = &channels[i]->trapezoid;
        if (z->change == 0.0) continue;
        const double start_s = channels[i]->start_s;
        joints_s[count++] = start_s;
        joints_s[count++] = start_s + z->ramp_s;
        joints_s[count++] = start_s + z->ramp_s + z->plateau_s;
        joints_s[count++] = start_s + schuler_trapezoid_duration(z);
    }
    for (int i = 1; i < count; i++) /* insertion sort */
        for (int j = i; j > 0 && joints_s[j] < joints_s[j - 1]; j--) {
            const double swap = joints_s[j];
            joints_s[j] = joints_s[j - 1];
            joints_s[j - 1] = swap;
        }
    int distinct = 1;
    for (int i = 1; i < count; i++)
        if (joints_s[i] > joints_s[distinct - 1]) joints_s[distinct++] = joints_s[i];
    return distinct;
}

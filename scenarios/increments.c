/* SPDX-License-Identifier: MIT */
#include "scenarios/increments.h"
#include "scenarios/sampling.h"
#include "scenarios/trajectory_file.h"
#include <float.h>
#include <math.h>
#include <stdio.h>

enum { TIME = 0 };

int schuler_increments_on_grid(double t0_s, double dt_s, double t_s, int64_t *step)
{
    const double steps = nearbyint((t_s - t0_s) / dt_s);
    if (!(fabs(steps) < 9e15)) return 0; /* beyond that a double has no fractions */
    *step = (int64_t)steps;
    const double off_s = t_s - t0_s - steps * dt_s;
    return fabs(off_s) <= 1e-6 * dt_s + 8.0 * DBL_EPSILON * (fabs(t_s) + fabs(t0_s));
}

/* The first row: where the interval is settled, at the latest. */
static schuler_status start(schuler_increments *in, double t_s, schuler_error *err)
{
    if (t_s <= in->t0_s)
        return schuler_csv_refuse(in->csv, TIME, err,
                                  "time %.17g s is not after the reference's first time, %.17g s, "
                                  "where the first interval starts",
                                  t_s, in->t0_s);
    if (!(in->dt_s > 0.0)) in->dt_s = schuler_increments_step(in->t0_s, t_s);
    if (in->dt_s >= 1e-6 && in->dt_s <= 3600.0) return SCHULER_OK;
    return schuler_csv_refuse(in->csv, TIME, err,
                              "time %.17g s, with the reference's first time %.17g s: the interval "
                              "is not in 1 us .. 1 h",
                              t_s, in->t0_s);
}

static const schuler_fault_kind kind_of[] = {
    [SAMPLING_REPEATED] = SCHULER_FAULT_REPEATED,
    [SAMPLING_BACKWARD] = SCHULER_FAULT_BACKWARD,
    [SAMPLING_SOON] = SCHULER_FAULT_SOON,
    [SAMPLING_GAP] = SCHULER_FAULT_GAP,
};

/* What ends the navigation is kept, and the rest of the file still looked at. */
static void fail_once(schuler_increments *in, const char *text, const char *advice)
{
    if (!in->failed) schuler_csv_refuse(in->csv, TIME, &in->first_error, "%s%s", text, advice);
    in->failed = 1;
}

/* A row out of time: a gap, or a row to leave out. */
static void step_aside(schuler_increments *in, sampling_step step, double t_s)
{
    const double off_s = fabs(t_s - in->before_s);
    char text[SCHULER_MESSAGE_MAX];
    schuler_fault_found(in->faults, kind_of[step], schuler_csv_line(in->csv), off_s);
    sampling_describe(text, sizeof text, step, in->before_s, t_s, in->dt_s);
    if (!in->bridge) fail_once(in, text, "; --bridge goes on across it");
    in->repeat = 0;
    if (step != SAMPLING_GAP) return;
    if (off_s > SCHULER_BRIDGED_S && in->bridge)
        fail_once(in, text, "; more than a minute is not bridged");
    if (in->failed) {
        in->repeat = 1;
    } else {
        in->repeat = (int64_t)nearbyint((t_s - in->t0_s) / in->dt_s) - in->read;
        if (in->repeat < 1) in->repeat = 1;
    }
}

static void take_time(schuler_increments *in, double t_s)
{
    const sampling_step step = sampling_step_of(in->before_s, t_s, in->dt_s);
    int64_t nearest;
    in->repeat = 1;
    if (step != SAMPLING_NEXT) step_aside(in, step, t_s);
    if (in->repeat == 0) return;
    in->before_s = t_s;
    if (schuler_increments_on_grid(in->t0_s, in->dt_s, t_s, &nearest) &&
        nearest == in->read + in->repeat)
        return;
    const double off_s = fabs(t_s - in->t0_s - (double)(in->read + in->repeat) * in->dt_s);
    if (in->failed) return; /* after a gap that was not bridged nothing is on the grid */
    schuler_fault_found(in->faults, SCHULER_FAULT_JITTER, schuler_csv_line(in->csv), off_s);
    if (!(off_s > in->dt_s)) return;
    char text[SCHULER_MESSAGE_MAX];
    snprintf(text, sizeof text,
             "the rate is not constant: time %.12g s is %.3g s off an interval of %.9g s", t_s,
             off_s, in->dt_s);
    fail_once(in, text, "");
}

static schuler_status next_row(schuler_increments *in, int *got, schuler_error *err)
{
    schuler_status status = schuler_csv_next(in->csv, in->row, got, err);
    if (status != SCHULER_OK || !*got) return status;
    if (in->rows == 0) status = start(in, in->row[TIME], err);
    if (status != SCHULER_OK) return status;
    in->rows++;
    take_time(in, in->row[TIME]);
    schuler_increments_look(in, in->row);
    return SCHULER_OK;
}

/* The rest of a file that cannot be navigated. */
static schuler_status look_at_rest(schuler_increments *in, schuler_error *err)
{
    int got = 1;
    schuler_status status = SCHULER_OK;
    while (status == SCHULER_OK && got) {
        if (in->rows % SCHULER_INCREMENTS_BLOCK == 0 && in->stop && *in->stop)
            return schuler_fail(err, SCHULER_ERR_INTERRUPTED, NULL, "interrupted");
        status = next_row(in, &got, NULL);
        in->read += in->repeat;
    }
    if (err) *err = in->first_error;
    return SCHULER_ERR_INPUT;
}

schuler_status schuler_increments_more(schuler_increments *in, schuler_error *err)
{
    if (in->used < in->n) return SCHULER_OK;
    in->n = in->used = 0;
    while (in->n < SCHULER_INCREMENTS_BLOCK) {
        if (in->repeat == 0) {
            int got;
            const schuler_status status = next_row(in, &got, err);
            if (status != SCHULER_OK) return status;
            if (in->failed) return look_at_rest(in, err);
            if (!got) break;
            continue;
        }
        for (int i = 0; i < 3; i++) {
            in->dtheta[i][in->n] = in->row[1 + i];
            in->dv[i][in->n] = in->row[4 + i];
        }
        in->repeat--;
        in->n++;
        in->read++;
    }
    return SCHULER_OK;
}

schuler_status schuler_increments_open(schuler_increments *in, const char *path, double t0_s,
                                       schuler_error *err)
{
    in->t0_s = in->before_s = t0_s;
    in->dt_s = schuler_increments_interval(path, t0_s, &in->irregular);
    schuler_status status = schuler_csv_open(&in->csv, path, SCHULER_IMU_HEADER, err);
    if (status == SCHULER_OK) status = schuler_increments_more(in, err);
    if (status != SCHULER_OK || in->n > 0) return status;
    const schuler_place place = { path, 0, 0, 0 };
    return schuler_fail(err, SCHULER_ERR_INPUT, &place, "no increments after the header");
}

void schuler_increments_close(schuler_increments *in)
{
    schuler_csv_close(in->csv);
}

void schuler_increments_prime(const schuler_increments *in, schuler_nav_setup *setup)
{
    /* Row `points - 1`, then how far back: weights of the first samples in the polynomial through
     * them. */
    static const double weights[4][SCHULER_PRIME][4] = {
        { { 1, 0, 0, 0 }, { 1, 0, 0, 0 }, { 1, 0, 0, 0 } },
        { { 2, -1, 0, 0 }, { 3, -2, 0, 0 }, { 4, -3, 0, 0 } },
        { { 3, -3, 1, 0 }, { 6, -8, 3, 0 }, { 10, -15, 6, 0 } },
        { { 4, -6, 4, -1 }, { 10, -20, 15, -4 }, { 20, -45, 36, -10 } },
    };
    const int points = in->n < 4 ? in->n : 4;
    for (int back = 0; back < SCHULER_PRIME; back++)
        for (int i = 0; i < 3; i++) {
            double dtheta = 0.0, dv = 0.0;
            for (int j = 0; j < points; j++) {
                dtheta += weights[points - 1][back][j] * in->dtheta[i][j];
                dv += weights[points - 1][back][j] * in->dv[i][j];
            }
            setup->prime_dtheta[back][i] = dtheta;
            setup->prime_dv[back][i] = dv;
        }
}

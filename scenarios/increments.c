/* SPDX-License-Identifier: MIT */
#include "scenarios/increments.h"
#include "scenarios/trajectory_file.h"
#include <float.h>
#include <math.h>

/* Both ends of the first interval carry the rounding of their size, which matters for clocks that
 * count from long ago: where a whole number of samples a second explains the interval, that is the
 * rate. */
static double interval(double t0_s, double t1_s)
{
    const double dt_s = t1_s - t0_s;
    const double rounding_s = DBL_EPSILON * (fabs(t0_s) + fabs(t1_s));
    const double rate_hz = nearbyint(1.0 / dt_s);
    return rate_hz >= 1.0 && fabs(1.0 / rate_hz - dt_s) <= rounding_s ? 1.0 / rate_hz : dt_s;
}

int schuler_increments_on_grid(const schuler_increments *in, double t_s, int64_t *step)
{
    const double steps = nearbyint((t_s - in->t0_s) / in->dt_s);
    if (!(fabs(steps) < 9e15)) return 0; /* beyond that a double has no fractions */
    *step = (int64_t)steps;
    const double off_s = t_s - in->t0_s - steps * in->dt_s;
    return fabs(off_s) <= 1e-6 * in->dt_s + 8.0 * DBL_EPSILON * (fabs(t_s) + fabs(in->t0_s));
}

static schuler_status check_time(schuler_increments *in, double t_s, schuler_error *err)
{
    enum { TIME = 0 };
    if (in->read == 0) {
        in->dt_s = interval(in->t0_s, t_s);
        if (in->dt_s >= 1e-6 && in->dt_s <= 3600.0) return SCHULER_OK;
        return schuler_csv_refuse(in->csv, TIME, err,
                                  in->dt_s <= 0.0
                                      ? "time %.17g s is not after the reference's first "
                                        "time, %.17g s, where the first interval starts"
                                      : "time %.17g s, with the reference's first time "
                                        "%.17g s: the interval is not in 1 us .. 1 h",
                                  t_s, in->t0_s);
    }
    int64_t step;
    if (schuler_increments_on_grid(in, t_s, &step) && step == in->read + 1) return SCHULER_OK;
    const double before_s = in->t0_s + (double)in->read * in->dt_s;
    if (t_s <= before_s)
        return schuler_csv_refuse(in->csv, TIME, err,
                                  "time %.17g s does not increase: the row before has %.17g s", t_s,
                                  before_s);
    return schuler_csv_refuse(in->csv, TIME, err,
                              "the rate is not constant: time %.17g s, but %.17g s is expected "
                              "(interval %.9g s, from the first row)",
                              t_s, before_s + in->dt_s, in->dt_s);
}

schuler_status schuler_increments_more(schuler_increments *in, schuler_error *err)
{
    if (in->used < in->n) return SCHULER_OK;
    in->n = in->used = 0;
    while (in->n < SCHULER_INCREMENTS_BLOCK) {
        double x[SCHULER_CSV_COLUMNS_MAX];
        int got_row;
        schuler_status status = schuler_csv_next(in->csv, x, &got_row, err);
        if (status == SCHULER_OK && !got_row) break;
        if (status == SCHULER_OK) status = check_time(in, x[0], err);
        if (status != SCHULER_OK) return status;
        for (int i = 0; i < 3; i++) {
            in->dtheta[i][in->n] = x[1 + i];
            in->dv[i][in->n] = x[4 + i];
        }
        in->n++;
        in->read++;
    }
    return SCHULER_OK;
}

schuler_status schuler_increments_open(schuler_increments *in, const char *path, double t0_s,
                                       schuler_error *err)
{
    in->t0_s = t0_s;
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

/* SPDX-License-Identifier: MIT */
/* The interval of recorded times. */
#include "scenarios/increments.h"
#include "scenarios/sampling.h"
#include "scenarios/trajectory_file.h"
#include <float.h>
#include <math.h>
#include <sys/stat.h>

enum { FIRST = 100 }; /* rows that a constant interval shows in */

/* Both ends carry the rounding of their size, which matters for clocks that count from long ago. */
double schuler_increments_step(double t0_s, double t1_s)
{
    const double dt_s = t1_s - t0_s;
    const double rounding_s = DBL_EPSILON * (fabs(t0_s) + fabs(t1_s));
    const double rate_hz = nearbyint(1.0 / dt_s);
    return rate_hz >= 1.0 && fabs(1.0 / rate_hz - dt_s) <= rounding_s ? 1.0 / rate_hz : dt_s;
}

/* 0 at the end, and where the row is wrong: reading it again tells. */
static int next_time(schuler_csv *csv, double *t_s)
{
    double x[SCHULER_CSV_COLUMNS_MAX];
    int got;
    if (schuler_csv_next(csv, x, &got, NULL) != SCHULER_OK || !got) return 0;
    *t_s = x[0];
    return 1;
}

/* An interval whose grid, from the first time on, holds at least half of the times; 0 when there is
 * none. It is the first step, or the usual one. */
static double constant_step(const double *times_s, int count)
{
    double steps_s[FIRST];
    int usual = 0;
    for (int i = 0; i < count; i++) steps_s[i] = times_s[i + 1] - times_s[i];
    const double usual_s = sampling_median(steps_s, count);
    while (usual + 1 < count && times_s[usual + 1] - times_s[usual] != usual_s) usual++;
    const int tried[2] = { 0, usual };
    for (int k = 0; k < 2; k++) {
        const double *const from_s = &times_s[tried[k]];
        const double dt_s = schuler_increments_step(from_s[0], from_s[1]);
        int fit = 0;
        if (!(dt_s > 0.0)) continue;
        for (int i = 1; i <= count; i++) {
            int64_t step;
            fit += schuler_increments_on_grid(times_s[0], dt_s, times_s[i], &step);
        }
        if (2 * fit >= count) return dt_s;
    }
    return 0.0;
}

/* The mean of all that are no gap and not out of time; a whole number of samples a second where that
 * explains it to a millionth, or to the noise of the times at both ends. */
static double mean_step(schuler_csv *csv, const double *times_s, int count)
{
    double steps_s[FIRST];
    for (int i = 0; i < count; i++) steps_s[i] = times_s[i + 1] - times_s[i];
    const double usual_s = sampling_median(steps_s, count);
    double before_s = times_s[0], sum_s = 0.0, noise_s = 0.0, t_s;
    int64_t good = 0;
    for (int64_t i = 1;; i++) {
        if (i <= count)
            t_s = times_s[i];
        else if (!next_time(csv, &t_s))
            break;
        const sampling_step step = sampling_step_of(before_s, t_s, usual_s);
        if (step == SAMPLING_NEXT) {
            sum_s += t_s - before_s;
            noise_s = fmax(noise_s, fabs(t_s - before_s - usual_s));
            good++;
        }
        if (step == SAMPLING_NEXT || step == SAMPLING_GAP) before_s = t_s;
    }
    if (good == 0) return usual_s;
    const double mean_s = sum_s / (double)good, rate_hz = nearbyint(1.0 / mean_s);
    if (rate_hz < 1.0) return mean_s;
    const double off_s = fabs(mean_s - 1.0 / rate_hz);
    return off_s < 1e-6 * mean_s || off_s * (double)good < noise_s ? 1.0 / rate_hz : mean_s;
}

double schuler_increments_interval(const char *path, double t0_s, int *irregular)
{
    struct stat info;
    schuler_csv *csv = NULL;
    double times_s[FIRST + 1] = { t0_s }, dt_s = 0.0;
    int count = 0;
    *irregular = 0;
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode)) return 0.0;
    if (schuler_csv_open(&csv, path, SCHULER_IMU_HEADER, NULL) != SCHULER_OK) return 0.0;
    while (count < FIRST && next_time(csv, &times_s[count + 1])) count++;
    if (count > 0) dt_s = constant_step(times_s, count);
    if (count > 0 && !(dt_s > 0.0)) {
        *irregular = 1;
        dt_s = mean_step(csv, times_s, count);
    }
    schuler_csv_close(csv);
    return dt_s;
}

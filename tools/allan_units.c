/* SPDX-License-Identifier: MIT */
#include "core/units.h"
#include "tools/allan_report.h"
#include <math.h>
#include <stdio.h>

static const struct {
    const char *name, *key, *unit;
} coefficients[SCHULER_INSTRUMENTS][SCHULER_ALLAN_TERMS] = {
    [SCHULER_ACCEL] = {
        { "quantization", "quantization", "m/s" },
        { "velocity random walk", "velocity_random_walk", "m/s/sqrt(h)" },
        { "bias instability", "bias_instability", "ug" },
        { "acceleration random walk", "bias_random_walk", "ug/sqrt(h)" },
        { "acceleration ramp", "bias_ramp", "ug/h" },
    },
    [SCHULER_GYRO] = {
        { "quantization", "quantization", "arcsec" },
        { "angle random walk", "angle_random_walk", "deg/sqrt(h)" },
        { "bias instability", "bias_instability", "deg/h" },
        { "rate random walk", "bias_random_walk", "deg/h/sqrt(h)" },
        { "rate ramp", "bias_ramp", "deg/h/h" },
    },
};

static double si_of(const char *unit)
{
    double si = 1.0;
    schuler_dim dim;
    return schuler_unit_parse(unit, &si, &dim, NULL) == SCHULER_OK ? si : 1.0;
}

allan_unit allan_unit_of(schuler_instrument instrument, schuler_allan_term term)
{
    const char *const unit = coefficients[instrument][term].unit;
    return (allan_unit){ coefficients[instrument][term].name, coefficients[instrument][term].key,
                         unit, si_of(unit) };
}

const char *allan_rate_unit(schuler_instrument instrument, double *si)
{
    const char *const unit = instrument == SCHULER_GYRO ? "deg/h" : "ug";
    *si = si_of(unit);
    return unit;
}

void allan_time(char *text, size_t size, double t_s)
{
    if (t_s < 120.0)
        snprintf(text, size, "%.3g s", t_s);
    else if (t_s < 7200.0)
        snprintf(text, size, "%.3g min", t_s / 60.0);
    else
        snprintf(text, size, "%.3g h", t_s / 3600.0);
}

int allan_reason(char *text, size_t size, const allan_report *r, int column, int term)
{
    const schuler_allan_coefficient *const c = &r->found->column[column].fit.term[term];
    const allan_unit unit =
        allan_unit_of(r->recording->column[column].instrument, (schuler_allan_term)term);
    const double duration_s = (double)r->found->n * r->found->dt_s;
    char all[32], twice[32];
    allan_time(all, sizeof all, duration_s);
    allan_time(twice, sizeof twice, 2.0 * duration_s);
    switch (c->state) {
    case SCHULER_ALLAN_FITTED:
        return 0;
    case SCHULER_ALLAN_NOT_SEEN:
        snprintf(text, size, "not seen in %s: below %.3g", all, c->upper / unit.si);
        break;
    case SCHULER_ALLAN_UNSURE:
        snprintf(text, size, "between %.2g and %.2g: needs > %s of data", c->lower / unit.si,
                 c->upper / unit.si, twice);
        break;
    case SCHULER_ALLAN_NO_DATA:
        snprintf(text, size, "needs > %s of data", twice);
        break;
    case SCHULER_ALLAN_NOT_ASKED:
        snprintf(text, size, "not asked for");
        break;
    }
    return 1;
}

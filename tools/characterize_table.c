/* SPDX-License-Identifier: MIT */
/* The tables of `schuler characterize`. */
#include "core/earth.h"
#include "tools/characterize_report.h"
#include "tools/page.h"
#include <math.h>

enum { NAME_COLUMNS = 24 };

characterize_units characterize_units_of(schuler_instrument instrument)
{
    if (instrument == SCHULER_GYRO)
        return (characterize_units){ "deg/s", "deg/h", SCHULER_RAD_PER_DEG,
                                     SCHULER_RAD_PER_DEG / 3600.0 };
    return (characterize_units){ "g", "mg", SCHULER_G0_MPS2, 1e-3 * SCHULER_G0_MPS2 };
}

static void put_head(FILE *out, const characterize_report *r)
{
    const characterize_units u = characterize_units_of(r->instrument);
    const schuler_characterize_options *const o = r->options;
    fprintf(out, "%s, first axis: input %.6g %s, across it %.6g %s, %g s\n",
            r->instrument == SCHULER_GYRO ? "Gyro" : "Accelerometer", o->along / u.output_si,
            u.output, o->across / u.output_si, u.output, o->duration_s);
    fprintf(out, "%d unit%s of each, seed %llu\n", o->units, o->units == 1 ? "" : "s",
            (unsigned long long)o->seed);
}

static void put_output(FILE *out, const characterize_report *r)
{
    const characterize_units u = characterize_units_of(r->instrument);
    fprintf(out, "\nMean output of a unit, %s\n  %-*s %10s %9s %10s %9s %10s %10s\n", u.output,
            NAME_COLUMNS, "", "mean", "error", "spread", "error", "least", "most");
    for (int i = 0; i < r->count; i++) {
        const schuler_over_units *const x = &r->sensor[i].found->output;
        fputs("  ", out);
        page_cell(out, r->sensor[i].imu->name, NAME_COLUMNS);
        fprintf(out, " %#10.6g %9.2g %10.4g %9.2g %#10.6g %#10.6g\n", x->mean / u.output_si,
                x->mean_error / u.output_si, x->spread / u.output_si, x->spread_error / u.output_si,
                x->least / u.output_si, x->most / u.output_si);
    }
}

static void put_noise(FILE *out, const characterize_report *r)
{
    const characterize_units u = characterize_units_of(r->instrument);
    fprintf(out, "\nNoise of a unit, rms, %s\n  %-*s %10s %9s %10s %10s %12s\n", u.noise,
            NAME_COLUMNS, "", "mean", "error", "least", "most", "samples/s");
    for (int i = 0; i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        fputs("  ", out);
        page_cell(out, r->sensor[i].imu->name, NAME_COLUMNS);
        fprintf(out, " %10.4g %9.2g %10.4g %10.4g %12.6g\n", f->noise.mean / u.noise_si,
                f->noise.mean_error / u.noise_si, f->noise.least / u.noise_si,
                f->noise.most / u.noise_si, 1.0 / f->dt_s);
    }
}

/* sqrt of a variance with an error: half of it relative. */
static void put_point(FILE *out, const schuler_characterized *f, int p, double si)
{
    const double deviation = sqrt(f->sigma2[p]);
    const double error = deviation > 0.0 ? 0.5 * f->sigma2_error[p] / deviation : 0.0;
    fprintf(out, " %10.6g %10.4g %9.2g", f->tau_s[p], deviation / si, error / si);
    if (f->promised[p] > 0.0)
        fprintf(out, " %11.4g %8.3f\n", sqrt(f->promised[p]) / si,
                sqrt(f->sigma2[p] / f->promised[p]));
    else
        fprintf(out, " %11s %8s\n", "-", "-");
}

/* One sensor: three points in a decade. More: each at its shortest tau and nearest to 0.1 and 1 s. */
static void put_allan(FILE *out, const characterize_report *r)
{
    const characterize_units u = characterize_units_of(r->instrument);
    fprintf(out, "\nAllan deviation, %s\n  %-*s %10s %10s %9s %11s %8s\n", u.noise, NAME_COLUMNS,
            "", "tau, s", "simulated", "error", "data sheet", "ratio");
    for (int i = 0; i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        double due_s = 0.0;
        for (int p = 0; p < f->points; p++) {
            if (f->tau_s[p] < due_s * (1.0 - 1e-9) && p + 1 < f->points) continue;
            fputs("  ", out);
            page_cell(out, due_s == 0.0 ? r->sensor[i].imu->name : "", NAME_COLUMNS);
            put_point(out, f, p, u.noise_si);
            if (r->count == 1)
                due_s = 2.0 * f->tau_s[p];
            else
                due_s = f->tau_s[p] < 0.1 ? 0.1 : f->tau_s[p] < 1.0 ? 1.0 : HUGE_VAL;
            if (due_s > f->tau_s[f->points - 1]) break;
        }
    }
}

exit_code characterize_print(const characterize_report *r)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    put_head(p.out, r);
    put_output(p.out, r);
    put_noise(p.out, r);
    put_allan(p.out, r);
    return page_show(&p);
}

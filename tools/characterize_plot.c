/* SPDX-License-Identifier: MIT */
/* The picture of `schuler characterize`: the first unit over time, and Allan deviations. */
#include "tools/characterize_report.h"
#include "tools/gnuplot.h"
#include <math.h>

enum { POINTS_MAX = 2000 };

/* At most POINTS_MAX points: beyond that least and most of each stretch, which look the same. */
static void put_series(FILE *out, const schuler_characterized *f, int i, double si)
{
    const int64_t stretch = f->n <= POINTS_MAX ? 1 : (2 * f->n + POINTS_MAX - 1) / POINTS_MAX;
    fprintf(out, "$s%d << EOD\n", i);
    for (int64_t k = 0; k < f->n; k += stretch) {
        double least = f->series[k], most = least;
        for (int64_t at = k; at < k + stretch && at < f->n; at++) {
            least = fmin(least, f->series[at]);
            most = fmax(most, f->series[at]);
        }
        const double t_s = (double)(k + 1) * f->dt_s;
        fprintf(out, "%.9g %.9g\n", t_s, least / si);
        if (stretch > 1)
            fprintf(out, "%.9g %.9g\n", t_s + 0.5 * (double)stretch * f->dt_s, most / si);
    }
    fputs("EOD\n", out);
}

static void put_allan(FILE *out, const schuler_characterized *f, int i, double si)
{
    fprintf(out, "$a%d << EOD\n", i);
    for (int p = 0; p < f->points; p++)
        if (f->sigma2[p] > 0.0)
            fprintf(out, "%.9g %.9g %.9g\n", f->tau_s[p], sqrt(f->sigma2[p]) / si,
                    f->promised[p] > 0.0 ? sqrt(f->promised[p]) / si : (double)NAN);
    fputs("EOD\n", out);
}

static void put_script(FILE *out, const void *what)
{
    const characterize_report *const r = what;
    const characterize_units u = characterize_units_of(r->instrument);
    for (int i = 0; i < r->count; i++) {
        put_series(out, r->sensor[i].found, i, u.output_si);
        put_allan(out, r->sensor[i].found, i, u.noise_si);
    }
    fputs("set multiplot layout 1,2\nset grid\nunset key\nset autoscale xfix\n", out);
    fprintf(out, "set xlabel 'time, s'\nset ylabel 'output of the first unit, %s'\nplot ",
            u.output);
    for (int i = 0; i < r->count; i++)
        fprintf(out, "%s$s%d using 1:2 with lines lt %d", i ? ", " : "", i, i + 1);
    fprintf(out,
            "\nset logscale xy\nset key noenhanced outside right center\nset xlabel 'tau, s'\n"
            "set ylabel 'Allan deviation, %s (lines: data sheet)'\nplot ",
            u.noise);
    for (int i = 0; i < r->count; i++) {
        fprintf(out, "%s$a%d using 1:2 with points lt %d pt 7 ps 0.5 title ", i ? ", " : "", i,
                i + 1);
        gnuplot_quote(out, r->sensor[i].imu->name);
        fprintf(out, ", $a%d using 1:3 with lines lt %d notitle", i, i + 1);
    }
    fputs("\nunset multiplot\n", out);
}

exit_code characterize_plot(const characterize_report *r, const char *path)
{
    return gnuplot_draw(path, 1400, 600, put_script, r);
}

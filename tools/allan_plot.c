/* SPDX-License-Identifier: MIT */
/* Allan deviations as a picture. */
#include "tools/allan_report.h"
#include "tools/gnuplot.h"
#include <math.h>

static void put_column(FILE *out, const allan_report *r, int i)
{
    double si;
    const schuler_identified *const f = r->found;
    const schuler_identified_column *const c = &f->column[i];
    allan_rate_unit(r->recording->column[i].instrument, &si);
    fprintf(out, "$c%d << EOD\n", i);
    for (int p = 0; p < f->points; p++)
        if (c->sigma2[p] > 0.0)
            fprintf(out, "%.9g %.9g %.9g %.9g %.9g\n", f->tau_s[p], sqrt(c->sigma2[p]) / si,
                    sqrt(c->limits[p][0]) / si, sqrt(c->limits[p][1]) / si, sqrt(c->model[p]) / si);
    fputs("EOD\n", out);
}

static int count_of(const allan_report *r, int instrument)
{
    int count = 0;
    for (int i = 0; i < r->found->columns; i++)
        count += (int)r->recording->column[i].instrument == instrument;
    return count;
}

/* One picture for each instrument, side by side. */
static void put_script(FILE *out, const void *what)
{
    const allan_report *const r = what;
    const int both = count_of(r, SCHULER_ACCEL) && count_of(r, SCHULER_GYRO);
    for (int i = 0; i < r->found->columns; i++) put_column(out, r, i);
    fputs("set logscale xy\nset grid\nset key noenhanced\nset xlabel 'tau, s'\n", out);
    if (both) fputs("set multiplot layout 1,2\n", out);
    for (int k = SCHULER_INSTRUMENTS - 1; k >= 0; k--) {
        double si;
        if (!count_of(r, k)) continue;
        fprintf(out, "set ylabel 'Allan deviation, %s'\nplot ",
                allan_rate_unit((schuler_instrument)k, &si));
        const char *comma = "";
        for (int i = 0; i < r->found->columns; i++) {
            if ((int)r->recording->column[i].instrument != k) continue;
            fprintf(out, "%s$c%d using 1:2:3:4 with yerrorbars lt %d pt 7 ps 0.4 title ", comma, i,
                    i + 1);
            gnuplot_quote(out, r->recording->column[i].name);
            fprintf(out, ", $c%d using 1:5 with lines lt %d notitle", i, i + 1);
            comma = ", ";
        }
        fputc('\n', out);
    }
    if (both) fputs("unset multiplot\n", out);
}

exit_code allan_plot(const allan_report *r, const char *path)
{
    const int both = count_of(r, SCHULER_ACCEL) && count_of(r, SCHULER_GYRO);
    return gnuplot_draw(path, both ? 1400 : 800, 600, put_script, r);
}

/* SPDX-License-Identifier: MIT */
/* A budget as a picture: every source over time, and its share at the end. */
#include "tools/budget_plot.h"
#include "tools/gnuplot.h"
#include "tools/result_units.h"
#include <math.h>

typedef struct {
    const schuler_result *result;
    const schuler_covariance *linear; /* or NULL */
} picture;

enum { SHOWN = 9 }; /* sources with a line of their own: as many as gnuplot has colours */

/* Sources by share, the largest first; how many there are. */
static int order(const schuler_result *r, const schuler_budget_row *rows[SHOWN])
{
    int count = 0;
    for (const schuler_budget_row *row = budget_largest(r, NULL);
         row && count < SHOWN && row->share > 0.0; row = budget_largest(r, row))
        rows[count++] = row;
    return count;
}

static void put_curve(FILE *out, const char *name, const double *t_s, const double *m, size_t n)
{
    fprintf(out, "$%s << EOD\n", name);
    for (size_t i = 0; i < n; i++)
        if (m[i] > 0.0) fprintf(out, "%.9g %.9g\n", t_s[i] / 3600.0, m[i]);
    fputs("EOD\n", out);
}

static void put_script(FILE *out, const void *what)
{
    const picture *const p = what;
    const schuler_result *const r = p->result;
    const schuler_budget_row *rows[SHOWN];
    const int count = order(r, rows);
    char name[16];
    for (int i = 0; i < count; i++) {
        snprintf(name, sizeof name, "c%d", i);
        put_curve(out, name, r->times_s, rows[i]->rms_curve_m, r->time_count);
    }
    put_curve(out, "all", r->times_s, r->all.rms_curve_m, r->time_count);
    if (p->linear)
        put_curve(out, "linear", p->linear->times_s, p->linear->total.rms_curve_m,
                  p->linear->time_count);
    double largest_m = r->none.rms_max_m;
    for (size_t i = 0; i < r->time_count; i++) largest_m = fmax(largest_m, r->all.rms_curve_m[i]);
    fprintf(out, "set yrange [%.3g:*]\nset format y '%%g'\n",
            largest_m > 0.0 ? 1e-5 * largest_m : 1e-9);
    fputs("set multiplot layout 1,2\nset grid\nset key noenhanced bottom right\n"
          "set logscale y\nset xlabel 'time, h'\nset ylabel 'horizontal rms, m'\nset title ",
          out);
    gnuplot_quote(out, r->scenario->name);
    fputs(" noenhanced\nplot $all with lines lw 2 lc 'black' title 'all sources at once'", out);
    if (p->linear) fputs(", $linear with lines dt 2 lc 'black' title 'linear covariance'", out);
    /* The bars beside have the same colours: they are the legend. */
    for (int i = 0; i < count; i++) fprintf(out, ", $c%d with lines lt %d notitle", i, i + 1);
    fputs("\nunset logscale y\nset format y\nunset key\nset xlabel 'share of the variance at the "
          "end, %'\nunset "
          "ylabel\n"
          "set title ",
          out);
    gnuplot_quote(out, r->scenario->imu.title ? r->scenario->imu.title : r->scenario->imu.name);
    fprintf(out, " noenhanced\nset yrange [-0.5:%d.5]\nset xrange [0:*]\nset ytics noenhanced (",
            count > 0 ? count - 1 : 0);
    for (int i = 0; i < count; i++) {
        if (i > 0) fputs(", ", out);
        gnuplot_quote(out, rows[i]->id);
        fprintf(out, " %d", count - 1 - i);
    }
    fputs(")\n$shares << EOD\n", out);
    for (int i = 0; i < count; i++)
        fprintf(out, "%d %.6g %d\n", count - 1 - i, 100.0 * rows[i]->share, i + 1);
    fputs("EOD\nset style fill solid 0.6\n"
          "plot $shares using ($2*0.5):1:($2*0.5):(0.35):3 with boxxyerror lc variable\nunset "
          "multiplot\n",
          out);
}

exit_code budget_plot(const char *path, const schuler_result *result,
                      const schuler_covariance *linear)
{
    const picture p = { result, linear };
    return gnuplot_draw(path, 1500, 700, put_script, &p);
}

/* SPDX-License-Identifier: MIT */
#include "tools/navigate_report.h"
#include "mechanization/mechanization.h"
#include "tools/messages.h"
#include "tools/page.h"
#include "tools/result_units.h"

const navigate_figure navigate_figures[NAVIGATE_FIGURES] = {
    { "horizontal position", "horizontal_m", "m", 1.0,
      offsetof(schuler_navigate_result, horizontal_m),
      offsetof(schuler_navigate_errors, horizontal_m) },
    { "height", "height_m", "m", 1.0, offsetof(schuler_navigate_result, height_m),
      offsetof(schuler_navigate_errors, height_m) },
    { "velocity", "velocity_mps", "m/s", 1.0, offsetof(schuler_navigate_result, velocity_mps),
      offsetof(schuler_navigate_errors, velocity_mps) },
    { "attitude", "attitude_arcsec", "arcsec", SCHULER_ARCSEC_PER_RAD,
      offsetof(schuler_navigate_result, attitude_rad),
      offsetof(schuler_navigate_errors, attitude_rad) },
};

const schuler_error_figures *navigate_figures_of(const schuler_navigate_result *r, int i)
{
    return (const schuler_error_figures *)(const void *)((const char *)r +
                                                         navigate_figures[i].figures);
}

double navigate_error_of(const schuler_navigate_errors *e, int i)
{
    const char *const at = (const char *)e + navigate_figures[i].error;
    return navigate_figures[i].per_si * *(const double *)(const void *)at;
}

navigate_speed navigate_speed_of(const schuler_navigate_result *r)
{
    const schuler_navigate_timing *const t = &r->timing;
    const double s = t->reading_s + t->navigating_s + t->comparing_s;
    return (navigate_speed){ s, (double)r->rows_read / s, t->reading_s / s, t->navigating_s / s,
                             t->comparing_s / s };
}

/* "gaps where samples are missing: 3, first here, up to 0.04 s" */
static void describe(char *text, size_t size, const schuler_fault *f, const schuler_fault_text *is)
{
    char worst[64] = "";
    if (is->unit) snprintf(worst, sizeof worst, ", up to %.4g %s", f->worst, is->unit);
    snprintf(text, size, "%s: %lld, %s%s", is->what, (long long)f->count,
             f->count > 1 ? "the first here" : "here", worst);
}

void navigate_warn(const schuler_navigate_result *r, const schuler_navigate_options *o)
{
    for (int k = 0; k < SCHULER_FAULT_KINDS; k++) {
        const schuler_fault *const f = &r->faults.of[k];
        const schuler_fault_text *const is = &schuler_fault_texts[k];
        if (f->count == 0 || is->may_be_so) continue;
        schuler_error warning = {
            .is_warning = 1,
            .place = { is->in_reference ? o->reference_file : o->imu_file, f->first_line, 0, 0 },
        };
        describe(warning.message, sizeof warning.message, f, is);
        say_error(&warning);
    }
}

/* What exact data may have too. */
static void print_notes(FILE *out, const schuler_navigate_result *r)
{
    for (int k = 0; k < SCHULER_FAULT_KINDS; k++) {
        const schuler_fault *const f = &r->faults.of[k];
        if (f->count == 0 || !schuler_fault_texts[k].may_be_so) continue;
        fprintf(out, "\n  Note: line %d: %s: %lld, up to %.0f one after the other.", f->first_line,
                schuler_fault_texts[k].what, (long long)f->count, f->worst);
        fputs(" Fine for exact data.\n", out);
    }
}

static void print_figures(FILE *out, const schuler_navigate_result *r)
{
    fprintf(out, "  %-22s %15s %15s %15s\n", "error", "final", "max", "rms");
    for (int i = 0; i < NAVIGATE_FIGURES; i++) {
        const schuler_error_figures *const f = navigate_figures_of(r, i);
        const double k = navigate_figures[i].per_si;
        fprintf(out, "  %-22s %15.6g %15.6g %15.6g  %s\n", navigate_figures[i].name, k * f->final,
                k * f->max, k * f->rms, navigate_figures[i].unit);
    }
}

/* The last of the times: those that matter for a mission of that length. */
static void print_growth(FILE *out, const schuler_navigate_result *r)
{
    enum { LINES = 10 };
    if (r->growth_times < 2) return;
    fprintf(out, "\n  %-12s", "after");
    for (int i = 0; i < NAVIGATE_FIGURES; i++) {
        char head[48];
        snprintf(head, sizeof head, "%s, %s", i == 0 ? "horizontal" : navigate_figures[i].name,
                 navigate_figures[i].unit);
        fprintf(out, " %17s", head);
    }
    fputc('\n', out);
    for (int n = r->growth_times > LINES ? r->growth_times - LINES : 0; n < r->growth_times; n++) {
        page time;
        page_open(&time);
        if (time.out) page_duration(time.out, r->growth[n].time_s);
        if (time.out) fflush(time.out);
        fprintf(out, "  %-12s", time.text ? time.text : "");
        page_drop(&time);
        for (int i = 0; i < NAVIGATE_FIGURES; i++)
            fprintf(out, " %17.6g", navigate_error_of(&r->growth[n].errors, i));
        fputc('\n', out);
    }
}

static void print_speed(FILE *out, const schuler_navigate_result *r)
{
    const navigate_speed speed = navigate_speed_of(r);
    if (!(speed.seconds > 0.0)) return;
    fprintf(out,
            "\n%lld rows in %.3g s, %.3g million a second: reading %.0f %%, navigating %.0f %%, "
            "comparing and writing %.0f %%\n",
            (long long)r->rows_read, speed.seconds, 1e-6 * speed.rows_per_s, 100 * speed.reading,
            100 * speed.navigating, 100 * speed.comparing);
}

exit_code navigate_print(const schuler_navigate_result *r, const schuler_navigate_options *o,
                         const navigate_names *names)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    page_duration(p.out, r->duration_s);
    fprintf(p.out, "   %lld increments of %g s   frame %s, gravity %s, vertical %s, coning %s\n\n",
            (long long)r->steps, r->dt_s, names->frame, o->gravity, names->vertical,
            schuler_coning_algorithms[o->coning].name);
    print_figures(p.out, r);
    print_growth(p.out, r);
    print_notes(p.out, r);
    print_speed(p.out, r);
    return page_show(&p);
}

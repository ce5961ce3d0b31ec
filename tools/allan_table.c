/* SPDX-License-Identifier: MIT */
/* The tables of `schuler allan`. */
#include "tools/allan_report.h"
#include "tools/page.h"
#include <math.h>
#include <stdio.h>

enum { NAME_COLUMNS = 16, DECADES_MAX = 16 };

static const schuler_recording_column *column_of(const allan_report *r, int i)
{
    return &r->recording->column[i];
}

static int count_of(const allan_report *r, schuler_instrument instrument)
{
    int count = 0;
    for (int i = 0; i < r->found->columns; i++) count += column_of(r, i)->instrument == instrument;
    return count;
}

static void put_head(FILE *out, const allan_report *r)
{
    const schuler_identified *const f = r->found;
    char first[32] = "", last[32] = "";
    page_cell(out, r->file, 32);
    fputs("   ", out);
    page_duration(out, (double)f->n * f->dt_s);
    fprintf(out, "   %lld samples at %.6g Hz\n", (long long)f->n, 1.0 / f->dt_s);
    if (f->points > 0) {
        allan_time(first, sizeof first, f->tau_s[0]);
        allan_time(last, sizeof last, f->tau_s[f->points - 1]);
    }
    fprintf(out, "overlapping Allan deviation, fit over %s – %s, %g %% limits\n", first, last,
            100.0 * r->level);
}

static void put_coefficients(FILE *out, const allan_report *r, schuler_instrument instrument)
{
    for (int term = 0; term < SCHULER_ALLAN_TERMS; term++) {
        const allan_unit unit = allan_unit_of(instrument, (schuler_allan_term)term);
        if (!(r->terms >> term & 1)) continue;
        fprintf(out, "  %s, %s\n", unit.name, unit.unit);
        for (int i = 0; i < r->found->columns; i++) {
            const schuler_allan_coefficient *const c = &r->found->column[i].fit.term[term];
            char reason[128];
            if (column_of(r, i)->instrument != instrument) continue;
            fputs("    ", out);
            page_cell(out, column_of(r, i)->name, NAME_COLUMNS);
            if (allan_reason(reason, sizeof reason, r, i, term))
                fprintf(out, "%10s   %s\n", "-", reason);
            else
                fprintf(out, "%#10.4g   %#.4g – %#.4g\n", c->value / unit.si, c->lower / unit.si,
                        c->upper / unit.si);
        }
    }
}

static void put_names(FILE *out, const allan_report *r, schuler_instrument instrument)
{
    for (int i = 0; i < r->found->columns; i++) {
        if (column_of(r, i)->instrument != instrument) continue;
        fputs("  ", out);
        page_cell(out, column_of(r, i)->name, NAME_COLUMNS);
    }
    fputc('\n', out);
}

/* At the powers of ten of the averaging factor, and at the longest tau. */
static void put_deviations(FILE *out, const allan_report *r, schuler_instrument instrument)
{
    double si;
    const schuler_identified *const f = r->found;
    fprintf(out, "\n  Allan deviation, %s\n    %10s", allan_rate_unit(instrument, &si), "tau, s");
    put_names(out, r, instrument);
    int64_t power = 1;
    for (int p = 0; p < f->points; p++) {
        if (f->m[p] < power && p + 1 < f->points) continue;
        while (power <= f->m[p]) power *= 10;
        fprintf(out, "    %10.6g", f->tau_s[p]);
        for (int i = 0; i < f->columns; i++)
            if (column_of(r, i)->instrument == instrument)
                fprintf(out, "  %-*.4g", NAME_COLUMNS, sqrt(f->column[i].sigma2[p]) / si);
        fputc('\n', out);
    }
}

static void put_spectrum(FILE *out, const allan_report *r, schuler_instrument instrument)
{
    enum { PER_DECADE = 3, MAX = 64 };
    double si;
    const schuler_identified *const f = r->found;
    schuler_spectrum_point point[MAX];
    const char *const unit = allan_rate_unit(instrument, &si);
    const double step_hz = 1.0 / ((double)f->segment * f->dt_s);
    int count = 0;
    fprintf(out,
            "\n  Root of the two-sided spectral density, %s/sqrt(Hz) (one-sided: times sqrt(2)),\n"
            "  segments of %d samples\n    %10s",
            unit, f->segment, "f, Hz");
    put_names(out, r, instrument);
    double density[SCHULER_RECORDING_COLUMNS_MAX][MAX];
    for (int i = 0; i < f->columns; i++) {
        count = schuler_spectrum_log_bins(f->column[i].density, f->segment / 2 + 1, step_hz,
                                          PER_DECADE, point, MAX);
        for (int k = 0; k < count; k++) density[i][k] = point[k].density;
    }
    for (int k = 0; k < count; k++) {
        fprintf(out, "    %10.4g", point[k].f_hz);
        for (int i = 0; i < f->columns; i++)
            if (column_of(r, i)->instrument == instrument)
                fprintf(out, "  %-*.4g", NAME_COLUMNS, sqrt(density[i][k]) / si);
        fputc('\n', out);
    }
}

exit_code allan_print(const allan_report *r, int with_spectrum)
{
    page p;
    page_open(&p);
    if (!p.out) return page_show(&p);
    put_head(p.out, r);
    for (int i = SCHULER_INSTRUMENTS - 1; i >= 0; i--) {
        const schuler_instrument instrument = (schuler_instrument)i;
        if (count_of(r, instrument) == 0) continue;
        fprintf(p.out, "\n%s\n", instrument == SCHULER_GYRO ? "Gyros" : "Accelerometers");
        put_coefficients(p.out, r, instrument);
        put_deviations(p.out, r, instrument);
        if (with_spectrum) put_spectrum(p.out, r, instrument);
    }
    return page_show(&p);
}

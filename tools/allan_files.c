/* SPDX-License-Identifier: MIT */
/* What `schuler allan` writes for programs: JSON and tables. */
#include "tools/allan_report.h"
#include "tools/json.h"
#include <math.h>
#include <string.h>

static const char *const states[] = { "not asked", "fitted", "not seen", "unsure", "no data" };

/* null when it is not known */
static json_t *known(int is_known, double value)
{
    return is_known ? json_of_number(value) : json_null();
}

static json_t *coefficients_json(const allan_report *r, int column)
{
    json_t *root = json_object();
    for (int term = 0; root && term < SCHULER_ALLAN_TERMS; term++) {
        const schuler_allan_coefficient *const c = &r->found->column[column].fit.term[term];
        const allan_unit unit =
            allan_unit_of(r->recording->column[column].instrument, (schuler_allan_term)term);
        const int fitted = c->state == SCHULER_ALLAN_FITTED;
        if (c->state == SCHULER_ALLAN_NOT_ASKED) continue;
        const int limited = fitted || c->state == SCHULER_ALLAN_UNSURE;
        const int bounded = limited || c->state == SCHULER_ALLAN_NOT_SEEN;
        json_object_set_new(root, unit.key,
                            json_pack("{s:s, s:s, s:s, s:o, s:o, s:o}", "symbol",
                                      (const char *[]){ "Q", "N", "B", "K", "R" }[term], "unit",
                                      unit.unit, "state", states[c->state], "value",
                                      known(fitted, c->value / unit.si), "lower",
                                      known(limited, c->lower / unit.si), "upper",
                                      known(bounded, c->upper / unit.si)));
    }
    return root;
}

static json_t *numbers(const double *x, int count, int stride, int root)
{
    json_t *list = json_array();
    for (int i = 0; list && i < count; i++) {
        const double value = x[(ptrdiff_t)i * stride];
        json_array_append_new(list, json_of_number(root ? sqrt(value) : value));
    }
    return list;
}

static json_t *spectrum_json(const schuler_identified *f, const double *density)
{
    enum { PER_DECADE = 10, MAX = 128 };
    schuler_spectrum_point point[MAX];
    if (!density) return json_null();
    const int count = schuler_spectrum_log_bins(
        density, f->segment / 2 + 1, 1.0 / ((double)f->segment * f->dt_s), PER_DECADE, point, MAX);
    json_t *frequency = json_array(), *level = json_array();
    for (int i = 0; frequency && level && i < count; i++) {
        json_array_append_new(frequency, json_of_number(point[i].f_hz));
        json_array_append_new(level, json_of_number(point[i].density));
    }
    return json_pack("{s:i, s:o, s:o}", "segment", f->segment, "frequency_hz", frequency,
                     "two_sided_density", level);
}

static json_t *column_json(const allan_report *r, int i)
{
    const schuler_identified *const f = r->found;
    const schuler_recording_column *const in = &r->recording->column[i];
    const schuler_identified_column *const c = &f->column[i];
    return json_pack(
        "{s:o, s:s, s:s, s:s, s:o, s:o, s:{s:o, s:o}, s:o, s:o, s:o, s:o, s:o}", "name",
        json_of_text(in->name), "instrument", schuler_instrument_name(in->instrument), "data",
        in->increments ? "increments" : "rates", "si_unit",
        in->instrument == SCHULER_GYRO ? "rad/s" : "m/s^2", "mean", json_of_number(c->mean),
        "coefficients", coefficients_json(r, i), "worst_of_fit", "standard_deviations",
        json_of_number(c->fit.worst), "tau_s", json_of_number(c->fit.worst_tau_s), "deviation",
        numbers(c->sigma2, f->points, 1, 1), "lower", numbers(&c->limits[0][0], f->points, 2, 1),
        "upper", numbers(&c->limits[0][1], f->points, 2, 1), "fit",
        numbers(c->model, f->points, 1, 1), "spectrum", spectrum_json(f, c->density));
}

json_t *allan_json(const allan_report *r)
{
    const schuler_identified *const f = r->found;
    json_t *columns = json_array();
    for (int i = 0; columns && i < f->columns; i++)
        json_array_append_new(columns, column_json(r, i));
    return json_pack("{s:s, s:s, s:o, s:I, s:o, s:o, s:o, s:o, s:o}", "format", "schuler-allan-1",
                     "version", SCHULER_VERSION, "file", json_of_text(r->file), "samples",
                     (json_int_t)f->n, "rate_hz", json_of_number(1.0 / f->dt_s), "duration_s",
                     json_of_number((double)f->n * f->dt_s), "level", json_of_number(r->level),
                     "tau_s", numbers(f->tau_s, f->points, 1, 0), "columns", columns);
}

static const char *suffix(const allan_report *r, int column)
{
    return r->recording->column[column].instrument == SCHULER_GYRO ? "radps" : "mps2";
}

void allan_put_deviations(FILE *out, const void *report)
{
    const allan_report *const r = report;
    static const char *const what[] = { "deviation", "lower", "upper", "fit" };
    const schuler_identified *const f = r->found;
    fputs("tau_s", out);
    for (int i = 0; i < f->columns; i++)
        for (int k = 0; k < 4; k++)
            fprintf(out, ",%s_%s_%s", r->recording->column[i].name, what[k], suffix(r, i));
    fputc('\n', out);
    for (int p = 0; p < f->points; p++) {
        fprintf(out, "%.12g", f->tau_s[p]);
        for (int i = 0; i < f->columns; i++) {
            const schuler_identified_column *const c = &f->column[i];
            fprintf(out, ",%.12g,%.12g,%.12g,%.12g", sqrt(c->sigma2[p]), sqrt(c->limits[p][0]),
                    sqrt(c->limits[p][1]), sqrt(c->model[p]));
        }
        fputc('\n', out);
    }
}

void allan_put_spectrum(FILE *out, const void *report)
{
    const allan_report *const r = report;
    const schuler_identified *const f = r->found;
    fputs("frequency_hz", out);
    for (int i = 0; i < f->columns; i++)
        fprintf(out, ",%s_two_sided_%s2_per_hz", r->recording->column[i].name, suffix(r, i));
    fputc('\n', out);
    for (int k = 0; k <= f->segment / 2; k++) {
        fprintf(out, "%.12g", (double)k / ((double)f->segment * f->dt_s));
        for (int i = 0; i < f->columns; i++) fprintf(out, ",%.9g", f->column[i].density[k]);
        fputc('\n', out);
    }
}

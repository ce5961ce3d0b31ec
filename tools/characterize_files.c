/* SPDX-License-Identifier: MIT */
/* What `schuler characterize` writes for programs: JSON and tables. */
#include "tools/characterize_report.h"
#include "tools/json.h"
#include <math.h>

static const char *suffix(const characterize_report *r)
{
    return r->instrument == SCHULER_GYRO ? "radps" : "mps2";
}

static double deviation(double variance)
{
    return sqrt(variance);
}

/* Standard deviation of the root of a variance. */
static double deviation_error(const schuler_characterized *f, int p)
{
    return f->sigma2[p] > 0.0 ? 0.5 * f->sigma2_error[p] / sqrt(f->sigma2[p]) : 0.0;
}

static json_t *over_units_json(const schuler_over_units *x)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "mean", json_of_number(x->mean),
                     "mean_error", json_of_number(x->mean_error), "spread",
                     json_of_number(x->spread), "spread_error", json_of_number(x->spread_error),
                     "least", json_of_number(x->least), "most", json_of_number(x->most));
}

static json_t *allan_json(const schuler_characterized *f)
{
    json_t *list = json_array();
    for (int p = 0; list && p < f->points; p++)
        json_array_append_new(list, json_pack("{s:o, s:o, s:o, s:o}", "tau_s",
                                              json_of_number(f->tau_s[p]), "simulated",
                                              json_of_number(deviation(f->sigma2[p])), "error",
                                              json_of_number(deviation_error(f, p)), "data_sheet",
                                              json_of_number(deviation(f->promised[p]))));
    return list;
}

json_t *characterize_json(const characterize_report *r)
{
    const schuler_characterize_options *const o = r->options;
    json_t *sensors = json_array();
    for (int i = 0; sensors && i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        const schuler_imu *const imu = r->sensor[i].imu;
        json_array_append_new(
            sensors, json_pack("{s:o, s:o, s:s, s:o, s:I, s:o, s:o, s:o}", "sensor",
                               json_of_text(imu->name), "title", json_of_text(imu->title), "model",
                               imu->triad[r->instrument].model->name, "rate_hz",
                               json_of_number(1.0 / f->dt_s), "samples", (json_int_t)f->n, "output",
                               over_units_json(&f->output), "noise", over_units_json(&f->noise),
                               "allan_deviation", allan_json(f)));
    }
    return json_pack(
        "{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:i, s:I, s:o}", "format", "schuler-characterize-1",
        "version", SCHULER_VERSION, "instrument", schuler_instrument_name(r->instrument), "si_unit",
        r->instrument == SCHULER_GYRO ? "rad/s" : "m/s^2", "input", json_of_number(o->along),
        "cross_input", json_of_number(o->across), "duration_s", json_of_number(o->duration_s),
        "units", o->units, "seed", (json_int_t)o->seed, "sensors", sensors);
}

static void put_columns(FILE *out, const char *what, const char *unit)
{
    static const char *const parts[] = { "mean",         "mean_error", "spread",
                                         "spread_error", "least",      "most" };
    for (int k = 0; k < 6; k++) fprintf(out, ",%s_%s_%s", what, parts[k], unit);
}

static void put_over_units(FILE *out, const schuler_over_units *x)
{
    fprintf(out, ",%.12g,%.12g,%.12g,%.12g,%.12g,%.12g", x->mean, x->mean_error, x->spread,
            x->spread_error, x->least, x->most);
}

void characterize_put_table(FILE *out, const void *report)
{
    const characterize_report *const r = report;
    fputs("sensor,rate_hz,samples,units", out);
    put_columns(out, "output", suffix(r));
    put_columns(out, "noise", suffix(r));
    fputc('\n', out);
    for (int i = 0; i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        fprintf(out, "%s,%.12g,%lld,%d", r->sensor[i].imu->name, 1.0 / f->dt_s, (long long)f->n,
                f->units);
        put_over_units(out, &f->output);
        put_over_units(out, &f->noise);
        fputc('\n', out);
    }
}

void characterize_put_series(FILE *out, const void *report)
{
    const characterize_report *const r = report;
    fprintf(out, "sensor,time_s,output_%s\n", suffix(r));
    for (int i = 0; i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        for (int64_t k = 0; k < f->n; k++)
            fprintf(out, "%s,%.12g,%.12g\n", r->sensor[i].imu->name, (double)(k + 1) * f->dt_s,
                    f->series[k]);
    }
}

void characterize_put_allan(FILE *out, const void *report)
{
    const characterize_report *const r = report;
    fprintf(out, "sensor,tau_s,simulated_%s,error_%s,data_sheet_%s\n", suffix(r), suffix(r),
            suffix(r));
    for (int i = 0; i < r->count; i++) {
        const schuler_characterized *const f = r->sensor[i].found;
        for (int p = 0; p < f->points; p++)
            fprintf(out, "%s,%.12g,%.12g,%.12g,%.12g\n", r->sensor[i].imu->name, f->tau_s[p],
                    deviation(f->sigma2[p]), deviation_error(f, p), deviation(f->promised[p]));
    }
}

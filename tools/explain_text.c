/* SPDX-License-Identifier: MIT */
#include "scenarios/motion_extent.h"
#include "tools/explain_report.h"
#include "tools/page.h"
#include "tools/registry.h"
#include "tools/result_units.h"
#include "tools/terminal.h"
#include <math.h>
#include <string.h>

enum { LABEL = 11 };

static void put_labelled(FILE *out, const char *label, const char *text)
{
    if (!text) return;
    fprintf(out, "  %-*s", LABEL, label);
    page_wrap(out, text, 2 + LABEL, 2 + LABEL);
}

/* The model or stage, and other models that have the key too. */
static void put_models(FILE *out, const explanation *e)
{
    const explain_subject *const s = &e->subject;
    const char *const kind = schuler_instrument_name(s->instrument);
    char text[1000];
    if (s->owner != s->model) {
        snprintf(text, sizeof text, "the stage %s, behind every %s model", s->owner->name, kind);
        put_labelled(out, "part of", text);
        return;
    }
    size_t at = (size_t)snprintf(text, sizeof text, "the %s model %.60s", kind, s->model->name);
    const schuler_sensor_model *m;
    bool first = true;
    for (int i = 0; (m = explain_model(e->plugins, i)) != NULL && at < sizeof text - 100; i++) {
        if (m == s->model || !explain_model_has(m, s->instrument, s->params[s->index].key))
            continue;
        at += (size_t)snprintf(text + at, sizeof text - at, "%s%.60s", first ? "; also of " : ", ",
                               m->name);
        first = false;
    }
    put_labelled(out, "part of", text);
}

static void put_head(FILE *out, const explanation *e)
{
    const explain_subject *const s = &e->subject;
    const schuler_param *const p = s->other ? NULL : &s->params[s->index];
    fprintf(out, "%s%s%s: ", terminal_colour(stdout, COLOUR_BOLD), s->id, terminal_plain(stdout));
    const int at = terminal_width(s->id) + 2;
    page_wrap(out, p ? p->doc : s->other->doc, at, 2);
    put_labelled(out, "formula", p ? p->formula : s->other->formula);
    if (p) {
        put_models(out, e);
        put_labelled(out, "source", s->owner->source);
    }
    put_labelled(out, "acts", s->text->process);
    put_labelled(out, "example", p ? p->example : s->other->example);
    fputs("\nHow its position error grows\n", out);
    put_labelled(out, "at first", s->text->first);
    put_labelled(out, "later", s->text->later);
    put_labelled(out, "depends", s->text->depends);
    fputs("  ", out);
    page_wrap(
        out,
        "t time, g gravity, R earth's radius, w = sqrt(g/R) = 2 pi/84.4 min, W earth's rate, L "
        "latitude. Level: in the horizontal plane. Source:",
        2, 2);
    fputs("  ", out);
    page_wrap(out, schuler_growth_source(), 2, 2);
}

int explain_times(double duration_s, double times_s[EXPLAIN_TIMES])
{
    static const double usual_s[] = { 60, 600, 1800, 3600, 14400, 36000, 86400, 259200 };
    int n = 0;
    for (size_t i = 0; i < sizeof usual_s / sizeof usual_s[0]; i++)
        if (usual_s[i] < 0.95 * duration_s) times_s[n++] = usual_s[i];
    times_s[n++] = duration_s;
    return n;
}

/* Metres with four digits; below a nanometre it is rounding. */
static void put_metres(FILE *out, int width, double metres)
{
    if (metres < 1e-9)
        fprintf(out, "%*d", width, 0);
    else if (metres >= 1e-3)
        fprintf(out, "%*.*f", width, decimals_for(metres), metres);
    else
        fprintf(out, "%*.2g", width, metres);
}

static void put_value(FILE *out, const explanation *e)
{
    fprintf(out, "%s%s%s", e->value.text ? e->value.text : "", e->value.assumed ? " (assumed)" : "",
            e->is_example ? " (an example)" : "");
}

static void put_at_rest(FILE *out, const explanation *e)
{
    enum { TIME = 14, COLUMN = 20 };
    double roll_rad, pitch_rad, heading_rad;
    schuler_euler_from_mat3(&e->rest.C_b_n, &roll_rad, &pitch_rad, &heading_rad);
    fprintf(out,
            "\nHorizontal rms error, m, at rest at latitude %.4g deg, heading %.4g deg\n  for ",
            e->rest.lat_rad / SCHULER_RAD_PER_DEG, heading_rad / SCHULER_RAD_PER_DEG);
    put_value(out, e);
    fputc('\n', out);
    fprintf(out, "  %-*s%*s%*s%*s\n", TIME, "after", COLUMN, "at first", COLUMN, "later", COLUMN,
            "with earth's rate");
    double times_s[EXPLAIN_TIMES];
    const int n = explain_times(e->duration_s, times_s);
    for (int i = 0; i < n; i++) {
        char shown[32] = "";
        FILE *const text = fmemopen(shown, sizeof shown, "w");
        if (text) {
            page_duration(text, times_s[i]);
            fclose(text);
        }
        fprintf(out, "  %-*s", TIME, shown);
        for (int law = 0; law < SCHULER_GROWTH_LAWS; law++)
            if (!explain_holds((schuler_growth_law)law, times_s[i]))
                fprintf(out, "%*s", COLUMN, "-");
            else
                put_metres(out, COLUMN,
                           schuler_growth_rms(&e->growth, &e->rest, (schuler_growth_law)law,
                                              &e->value, times_s[i]));
        fputc('\n', out);
    }
}

double explain_sampling_m(const schuler_budget_row *row)
{
    if (row->runs < 2 || row->rms_end_m == 0.0) return 0.0;
    double sum = 0.0;
    for (int i = 0; i < row->runs; i++) {
        const double x = row->end_m[i] / row->rms_end_m;
        sum += (x * x - 1.0) * (x * x - 1.0);
    }
    return row->rms_end_m * 0.5 * sqrt(sum / (row->runs - 1.0) / row->runs);
}

static bool is_moving(const schuler_motion_extent *m)
{
    return m->speed_mps > 0.0 || m->rate_radps > 0.0;
}

static void put_motion(FILE *out, const schuler_motion_extent *m)
{
    char text[200] = "at rest";
    if (is_moving(m))
        snprintf(text, sizeof text,
                 "speed to %.3g m/s, acceleration to %.3g m/s^2, rate to %.3g deg/s; the heading "
                 "turns by %.0f deg in all, by %+.0f in the end",
                 m->speed_mps, m->accel_mps2, m->rate_radps / SCHULER_RAD_PER_DEG,
                 m->turned_rad / SCHULER_RAD_PER_DEG, m->turned_on_rad / SCHULER_RAD_PER_DEG);
    put_labelled(out, "motion", text);
}

static void put_drift(FILE *out, const schuler_budget_row *row, const schuler_judgement *limits)
{
    const double cep = nmi_per_h(row->cep_mps);
    int decimals = decimals_for(10.0 * cep);
    if (decimals > 6) decimals = 6;
    fprintf(out, "  %-*s%.*f nmi/h CEP", LABEL, "drift", decimals, cep);
    if (row->drawn && isfinite(limits->upper_mps))
        fprintf(out, ", %g %% limits %.*f to %.*f nmi/h", 100.0 * limits->confidence, decimals,
                nmi_per_h(limits->lower_mps), decimals, nmi_per_h(limits->upper_mps));
    else if (row->drawn)
        fprintf(out, "; too few runs for limits: %d", row->runs);
    fputc('\n', out);
}

static void put_simulated(FILE *out, const explanation *e)
{
    const schuler_scenario *const s = e->scenario;
    fprintf(out, "\nIn the scenario %s\n  ", s->name);
    page_duration(out, s->path.duration_s);
    fprintf(out, "   %s   %g Hz   %d run%s, seed %llu\n", s->imu.title ? s->imu.title : s->imu.name,
            s->imu.rate_hz, s->runs, s->runs == 1 ? "" : "s", (unsigned long long)s->seed);
    const schuler_motion_extent motion = schuler_motion_extent_of(&s->path);
    put_motion(out, &motion);
    if (e->absent) {
        put_labelled(out, "value", e->absent);
        return;
    }
    if (e->has_value) {
        fprintf(out, "  %-*s", LABEL, "value");
        put_value(out, e);
        fputc('\n', out);
    }
    const schuler_budget_row *const row = e->row;
    fprintf(out, "  %-*s", LABEL, "at the end");
    put_metres(out, 0, row->rms_end_m);
    fprintf(out, " m");
    if (row->drawn && row->runs > 1) {
        fputs(" rms, +- ", out);
        put_metres(out, 0, explain_sampling_m(row));
        fprintf(out, " m by the number of runs (one sigma)");
    } else
        fputs(row->drawn ? ", of the only run" : ", the same in every run", out);
    fputc('\n', out);
    if (e->has_growth) {
        fprintf(out, "  %-*s", LABEL, "by theory");
        put_metres(out, 0,
                   schuler_growth_rms(&e->growth, &e->rest, SCHULER_GROWTH_EARTH, &e->value,
                                      e->result->duration_s));
        fprintf(out, " m at rest, as above%s\n", is_moving(&motion) ? ", had it stood still" : "");
    }
    put_drift(out, row, &e->result->judgement);
}

void explain_print(FILE *out, const explanation *e)
{
    put_head(out, e);
    if (e->has_growth && e->has_value)
        put_at_rest(out, e);
    else if (!e->subject.other)
        fprintf(out,
                "\nNo closed form at rest: it depends on the motion or on the surroundings.\n%s",
                e->scenario ? "" : "'schuler explain SOURCE FILE' simulates it in a scenario.\n");
    if (e->scenario) put_simulated(out, e);
}

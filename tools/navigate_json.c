/* SPDX-License-Identifier: MIT */
#include "mechanization/mechanization.h"
#include "tools/json.h"
#include "tools/navigate_report.h"

static json_t *errors_json(const schuler_navigate_result *r)
{
    json_t *const errors = json_object();
    for (int i = 0; errors && i < NAVIGATE_FIGURES; i++) {
        const schuler_error_figures *const f = navigate_figures_of(r, i);
        const double k = navigate_figures[i].per_si;
        json_object_set_new(errors, navigate_figures[i].key,
                            json_pack("{s:o, s:o, s:o}", "final", json_of_number(k * f->final),
                                      "max", json_of_number(k * f->max), "rms",
                                      json_of_number(k * f->rms)));
    }
    return errors;
}

static json_t *growth_json(const schuler_navigate_result *r)
{
    json_t *const growth = json_array();
    for (int n = 0; growth && n < r->growth_times; n++) {
        json_t *const at = json_pack("{s:o}", "time_s", json_of_number(r->growth[n].time_s));
        for (int i = 0; at && i < NAVIGATE_FIGURES; i++)
            json_object_set_new(at, navigate_figures[i].key,
                                json_of_number(navigate_error_of(&r->growth[n].errors, i)));
        json_array_append_new(growth, at);
    }
    return growth;
}

static json_t *faults_json(const schuler_navigate_result *r, const schuler_navigate_options *o)
{
    json_t *const faults = json_array();
    for (int k = 0; faults && k < SCHULER_FAULT_KINDS; k++) {
        const schuler_fault *const f = &r->faults.of[k];
        const schuler_fault_text *const is = &schuler_fault_texts[k];
        if (f->count == 0) continue;
        json_t *const fault =
            json_pack("{s:s, s:I, s:i, s:o, s:s, s:s}", "kind", is->key, "count",
                      (json_int_t)f->count, "first_line", f->first_line, "file",
                      json_of_text(is->in_reference ? o->reference_file : o->imu_file), "what",
                      is->what, "severity", is->may_be_so ? "note" : "warning");
        if (fault && is->unit) {
            json_object_set_new(fault, "worst", json_of_number(f->worst));
            json_object_set_new(fault, "unit", json_string(is->unit));
        }
        json_array_append_new(faults, fault);
    }
    return faults;
}

static json_t *timing_json(const schuler_navigate_result *r)
{
    const schuler_navigate_timing *const t = &r->timing;
    const navigate_speed speed = navigate_speed_of(r);
    return json_pack("{s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "rows", (json_int_t)r->rows_read,
                     "reading_s", json_of_number(t->reading_s), "navigating_s",
                     json_of_number(t->navigating_s), "comparing_s", json_of_number(t->comparing_s),
                     "rows_per_s", json_of_number(speed.rows_per_s), "reading_share",
                     json_of_number(speed.reading), "navigating_share",
                     json_of_number(speed.navigating), "comparing_share",
                     json_of_number(speed.comparing));
}

json_t *navigate_json(const schuler_navigate_result *r, const schuler_navigate_options *o,
                      const navigate_names *names)
{
    return json_pack("{s:s, s:s, s:s, s:o, s:s, s:s, s:o, s:o, s:I, s:I, s:o, s:o, s:o, s:o}",
                     "format", "schuler-navigate-1", "version", SCHULER_VERSION, "frame",
                     names->frame, "gravity", json_of_text(o->gravity), "vertical", names->vertical,
                     "coning", schuler_coning_algorithms[o->coning].name, "dt_s",
                     json_of_number(r->dt_s), "duration_s", json_of_number(r->duration_s),
                     "increments", (json_int_t)r->steps, "rows", (json_int_t)r->rows, "errors",
                     errors_json(r), "growth", growth_json(r), "faults", faults_json(r, o),
                     "timing", timing_json(r));
}

/* SPDX-License-Identifier: MIT */
#include "tools/explain_report.h"
#include "tools/registry.h"
#include "tools/result_units.h"

/* Frees both and gives NULL unless the item could be added. */
static json_t *append(json_t *list, json_t *item)
{
    if (list && item && json_array_append_new(list, item) == 0) return list;
    if (!list) json_decref(item);
    json_decref(list);
    return NULL;
}

static json_t *at_rest(const explanation *e)
{
    if (!e->has_growth || !e->has_value) return json_null();
    double times_s[EXPLAIN_TIMES];
    const int n = explain_times(e->duration_s, times_s);
    json_t *rows = json_array();
    for (int i = 0; rows && i < n; i++) {
        json_t *m[SCHULER_GROWTH_LAWS];
        for (int k = 0; k < SCHULER_GROWTH_LAWS; k++) {
            const schuler_growth_law law = (schuler_growth_law)k;
            m[k] = explain_holds(law, times_s[i])
                       ? json_of_number(
                             schuler_growth_rms(&e->growth, &e->rest, law, &e->value, times_s[i]))
                       : json_null();
        }
        rows = append(rows, json_pack("{s:o, s:o, s:o, s:o}", "time_s", json_of_number(times_s[i]),
                                      "first_m", m[SCHULER_GROWTH_FIRST], "pendulum_m",
                                      m[SCHULER_GROWTH_PENDULUM], "earth_rate_m",
                                      m[SCHULER_GROWTH_EARTH]));
    }
    return json_pack("{s:o, s:o, s:b, s:o}", "lat_deg",
                     json_of_number(e->rest.lat_rad / SCHULER_RAD_PER_DEG), "value",
                     json_of_text(e->value.text), "is_example", (int)e->is_example,
                     "horizontal_rms", rows);
}

static json_t *simulated(const explanation *e)
{
    const schuler_scenario *const s = e->scenario;
    if (!s) return json_null();
    const schuler_budget_row *const row = e->row;
    return json_pack(
        "{s:o, s:o, s:I, s:i, s:o, s:o, s:b, s:o, s:o, s:o, s:o, s:o, s:o}", "scenario",
        json_of_text(s->name), "imu", json_of_text(s->imu.name), "seed", (json_int_t)s->seed,
        "runs", s->runs, "duration_s", json_of_number(s->path.duration_s), "absent",
        json_of_text(e->absent), "drawn", row ? (int)row->drawn : 0, "value",
        json_of_text(e->absent || !e->has_value ? NULL : e->value.text), "horizontal_rms_m",
        row ? json_of_number(row->rms_end_m) : json_null(), "standard_error_m",
        row ? json_of_number(explain_sampling_m(row)) : json_null(), "drift_cep_nmi_per_h",
        row ? json_of_number(nmi_per_h(row->cep_mps)) : json_null(), "lower",
        row ? json_of_number(nmi_per_h(e->result->judgement.lower_mps)) : json_null(), "upper",
        row ? json_of_number(nmi_per_h(e->result->judgement.upper_mps)) : json_null());
}

json_t *explain_json(const explanation *e)
{
    const explain_subject *const s = &e->subject;
    const schuler_param *const p = s->other ? NULL : &s->params[s->index];
    return json_pack(
        "{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:{s:o, s:o, s:o, s:o}, s:o, s:o}", "format",
        "schuler-explain-1", "version", SCHULER_VERSION, "source", json_of_text(s->id), "doc",
        json_of_text(p ? p->doc : s->other->doc), "formula",
        json_of_text(p ? p->formula : s->other->formula), "example",
        json_of_text(p ? p->example : s->other->example), "model",
        json_of_text(p ? s->owner->name : NULL), "literature",
        json_of_text(p ? s->owner->source : NULL), "acts",
        json_of_text(p ? registry_acts(p->acts) : NULL), "growth", "process",
        json_of_text(s->text->process), "first", json_of_text(s->text->first), "later",
        json_of_text(s->text->later), "depends", json_of_text(s->text->depends), "at_rest",
        at_rest(e), "simulated", simulated(e));
}

/* SPDX-License-Identifier: MIT */
#include "tools/comparison.h"
#include "tools/result_json.h"
#include "tools/result_units.h"

static json_t *one(const comparison *c, size_t i)
{
    const compared *const item = &c->items[i];
    const schuler_paired *const p = &item->against_best;
    return json_pack("{s:i, s:o, s:o, s:o, s:o, s:{s:o, s:o, s:o, s:o, s:i}, s:o}", "rank",
                     (int)i + 1, "imu", json_of_text(item->name), "drift_nmi_per_h",
                     json_of_number(nmi_per_h(comparison_drift(item))), "lower",
                     json_of_number(nmi_per_h(item->judgement.lower_mps)), "upper",
                     json_of_number(nmi_per_h(item->judgement.upper_mps)), "times_the_best",
                     "ratio", json_of_number(p->ratio), "lower", json_of_number(p->lower), "upper",
                     json_of_number(p->upper), "confidence", json_of_number(p->confidence), "pairs",
                     p->pairs, "result", result_json(item->result, NULL));
}

json_t *comparison_json(const comparison *c)
{
    json_t *const list = json_array();
    for (size_t i = 0; list && i < c->count; i++)
        if (json_array_append_new(list, one(c, i)) != 0) {
            json_decref(list);
            return NULL;
        }
    const schuler_scenario *const s = c->items[0].scenario;
    return json_pack("{s:s, s:s, s:{s:o, s:s}, s:I, s:i, s:s, s:o}", "format", "schuler-compare-1",
                     "version", SCHULER_VERSION, "scenario", "name", json_of_text(s->name),
                     "sha256", s->sha256, "seed", (json_int_t)s->seed, "runs",
                     c->items[0].result->runs, "statistic", statistic_name(c->statistic), "imus",
                     list);
}

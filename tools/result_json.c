/* SPDX-License-Identifier: MIT */
#include "tools/result_json.h"
#include "scenarios/source_size.h"
#include "tools/result_units.h"

static json_t *horizontal(const schuler_budget_row *row)
{
    return json_pack("{s:o, s:o}", "at_end", json_of_number(row->rms_end_m), "max",
                     json_of_number(row->rms_max_m));
}

/* The figure of a source by linear covariance, when there is one. */
static bool put_linear(json_t *item, const schuler_covariance *linear, const char *id)
{
    const schuler_covariance_row *const row = schuler_covariance_find(linear, id);
    return !row || row->uncovered ||
           json_object_set_new(item, "covariance_rms_m",
                               json_pack("{s:o}", "at_end", json_of_number(row->end_m))) == 0;
}

/* Where the two methods differ, and what only the simulation covers. */
static json_t *comparison(const schuler_result *result, const schuler_covariance *linear)
{
    json_t *const differ = json_array(), *const uncovered = json_array();
    for (size_t i = 0; i < linear->row_count; i++) {
        const schuler_covariance_row *const row = &linear->rows[i];
        const schuler_agreement a =
            schuler_covariance_against(row, &result->rows[i], linear->total.end_m);
        if (row->uncovered)
            json_array_append_new(
                uncovered, json_pack("{s:s, s:s}", "source", row->id, "because", row->uncovered));
        else if (a.differs)
            json_array_append_new(differ, json_pack("{s:s, s:o, s:o}", "source", row->id,
                                                    "relative", json_of_number(a.relative),
                                                    "sigmas", json_of_number(a.sigmas)));
    }
    return json_pack("{s:{s:o}, s:o, s:o}", "horizontal_rms_m", "at_end",
                     json_of_number(linear->total.end_m), "differs", differ, "not_covered",
                     uncovered);
}

static json_t *budget(const schuler_result *result, const schuler_covariance *linear)
{
    json_t *list = json_array();
    for (size_t i = 0; list && i < result->row_count; i++) {
        const schuler_budget_row *row = &result->rows[i];
        json_t *item =
            json_pack("{s:s, s:s, s:o, s:b, s:o, s:o, s:o}", "source", row->id, "group", row->group,
                      "value", json_of_text(row->value_text), "assumed", (int)row->assumed,
                      "horizontal_rms_m", horizontal(row), "drift_cep_nmi_per_h",
                      json_of_number(nmi_per_h(row->cep_mps)), "share", json_of_number(row->share));
        const double margin = schuler_source_margin(result, row);
        if (item && result->scenario->requirement.given && margin >= 0.0)
            json_object_set_new(item, "margin", json_of_number(margin));
        if (item && !put_linear(item, linear, row->id)) {
            json_decref(item);
            item = NULL;
        }
        if (!item || json_array_append_new(list, item) != 0) {
            json_decref(list);
            return NULL;
        }
    }
    return list;
}

static json_t *requirement(const schuler_result *result)
{
    const schuler_requirement *required = &result->scenario->requirement;
    const schuler_judgement *judged = &result->judgement;
    return json_pack("{s:o, s:s, s:o, s:o, s:o, s:o, s:s}", "limit_nmi_per_h",
                     json_of_number(nmi_per_h(required->drift_mps)), "statistic",
                     statistic_name(required->statistic), "value_nmi_per_h",
                     json_of_number(nmi_per_h(judged->value_mps)), "lower",
                     json_of_number(nmi_per_h(judged->lower_mps)), "upper",
                     json_of_number(nmi_per_h(judged->upper_mps)), "confidence",
                     json_of_number(judged->confidence), "verdict", verdict_name(judged->verdict));
}

/* Share: of all samples of the joint runs' axes. */
static json_t *saturation(const schuler_result *result)
{
    json_t *root = json_object();
    for (int i = 0; root && i < SCHULER_INSTRUMENTS; i++) {
        const schuler_clipping *const c = &result->clipped[i];
        const double all = 3.0 * (double)result->steps * result->all.runs;
        json_object_set_new(root, schuler_instrument_name((schuler_instrument)i),
                            json_pack("{s:i, s:o}", "runs", c->runs, "share",
                                      json_of_number((double)c->samples / all)));
    }
    return root;
}

json_t *result_json(const schuler_result *result, const schuler_covariance *linear)
{
    const schuler_scenario *scenario = result->scenario;
    json_t *root =
        json_pack("{s:s, s:s, s:{s:o, s:s}, s:o, s:I, s:i, s:o, s:o, s:{s:o, s:o, s:o}, s:{s:o}, "
                  "s:{s:{s:o}}, s:o}",
                  "format", "schuler-result-1", "version", SCHULER_VERSION, "scenario", "name",
                  json_of_text(scenario->name), "sha256", scenario->sha256, "imu",
                  json_of_text(scenario->imu.name), "seed", (json_int_t)scenario->seed, "runs",
                  result->runs, "duration_s", json_of_number(result->duration_s), "budget",
                  budget(result, linear), "all", "horizontal_rms_m", horizontal(&result->all),
                  "drift_cep_nmi_per_h", json_of_number(nmi_per_h(result->all.cep_mps)),
                  "drift_r95_nmi_per_h", json_of_number(nmi_per_h(result->all.r95_mps)), "none",
                  "horizontal_rms_m", horizontal(&result->none), "rss", "horizontal_rms_m",
                  "at_end", json_of_number(result->rss_end_m), "saturation", saturation(result));
    static const char *const rows[SCHULER_ROWS_KINDS] = { "sources", "groups", "without", "none" };
    if (root && json_object_set_new(root, "rows", json_of_text(rows[result->rows_are])) != 0) {
        json_decref(root);
        return NULL;
    }
    if (root && linear &&
        json_object_set_new(root, "covariance", comparison(result, linear)) != 0) {
        json_decref(root);
        return NULL;
    }
    if (root && scenario->requirement.given &&
        json_object_set_new(root, "requirement", requirement(result)) != 0) {
        json_decref(root);
        return NULL;
    }
    return root;
}

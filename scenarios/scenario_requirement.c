/* SPDX-License-Identifier: MIT */
/* What a scenario requires of its navigator. */
#include "scenarios/reader.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void check_statistic(schuler_reading *r, const schuler_scenario_file *file,
                            schuler_requirement *out)
{
    static const char *const names[SCHULER_STATISTICS] = { "CEP", "R95", "rms", "R99", "one_axis" };
    const schuler_node *const node = file->requirement.statistic;
    if (!node) {
        schuler_diagnose(
            r->d, SCHULER_ERR_INPUT, &file->requirement.place,
            "'requirement' needs the key 'statistic': CEP, R95, R99, rms or one_axis. There is no "
            "default, because a drift limit means nothing without it: the sensors that "
            "drift 0.5 nmi/h CEP drift 1.0 nmi/h R95");
        return;
    }
    const char *text = schuler_read_scalar(r, node, "requirement.statistic",
                                           "one of CEP, R95, R99, rms and one_axis");
    if (!text) return;
    for (int i = 0; i < SCHULER_STATISTICS; i++) {
        if (strcmp(text, names[i]) != 0) continue;
        out->statistic = (schuler_statistic)i;
        return;
    }
    char lead[160];
    snprintf(lead, sizeof lead, "requirement.statistic: unknown '%.60s'", text);
    schuler_diagnose_unknown(r, &node->place, lead, text, names, SCHULER_STATISTICS);
}

/* Whether the value of a key was complained of already: then it is not missing. */
static bool is_refused(const schuler_diagnostics *d, const char *key)
{
    for (size_t i = 0; i < d->kept; i++)
        if (strncmp(d->items[i].message, key, strlen(key)) == 0) return true;
    return false;
}

void schuler_read_requirement(schuler_reading *r, const schuler_scenario_file *file,
                              schuler_requirement *out)
{
    const schuler_place *const place = &file->requirement.place;
    if (!place->file) return;
    const bool has_position = !isnan(file->requirement.position_m);
    *out = (schuler_requirement){ .given = true,
                                  .drift_mps = file->requirement.drift_mps,
                                  .position_m = has_position ? file->requirement.position_m : 0.0,
                                  .place = *place };
    for (int i = 0; i < SCHULER_METRICS; i++)
        if (strcmp(file->requirement.metric, schuler_metric_names[i]) == 0)
            out->metric = (schuler_metric)i;
    check_statistic(r, file, out);
    const bool has_drift = !isnan(file->requirement.drift_mps);
    if (has_position && has_drift)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, place,
                         "'requirement' has 'drift' and 'position'; one of them is meant");
    if (!has_position && !has_drift && !is_refused(r->d, "requirement.drift") &&
        !is_refused(r->d, "requirement.position") && !is_refused(r->d, "unknown key"))
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, place,
                         "'requirement' needs the key 'drift', for example: 1 nmi/h");
    if (has_position && out->metric != SCHULER_METRIC_SLOPE && out->metric != SCHULER_METRIC_FINAL)
        schuler_diagnose(
            r->d, SCHULER_ERR_INPUT, place,
            "'requirement': an error at the end is not a metric of the drift; leave out "
            "'metric'");
    if (has_position) out->metric = SCHULER_METRIC_FINAL;
    if (out->statistic == SCHULER_STAT_ONE_AXIS && out->metric == SCHULER_METRIC_TRMS)
        schuler_diagnose(
            r->d, SCHULER_ERR_INPUT, place,
            "'requirement': trms is of the radial error; one_axis does not go with it");
}

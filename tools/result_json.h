/* SPDX-License-Identifier: MIT */
/* The result of a simulation as JSON, format schuler-result-1. */
#ifndef SCHULER_TOOLS_RESULT_JSON_H
#define SCHULER_TOOLS_RESULT_JSON_H

#include "scenarios/covariance.h"
#include "scenarios/simulation.h"
#include "tools/json.h"

/** Owned by the caller; NULL when out of memory. */
/** Given   linear   the same scenario's covariance, or NULL: no figures of it */
json_t *result_json(const schuler_result *result, const schuler_covariance *linear);

#endif

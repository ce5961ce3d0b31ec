/* SPDX-License-Identifier: MIT */
/* The sensor models as compiled for one instruction set. */
#include "sensors/model_table.h"
#include "core/lanes.h"

#define X(name) extern const schuler_sensor_model SCHULER_LANE_NAME(schuler_model_##name);
#include "schuler_sensor_models.def"
#undef X

#define X(name) extern const schuler_sensor_model SCHULER_LANE_NAME(schuler_stage_##name);
#include "schuler_sensor_stages.def"
#undef X

#define X(name) &SCHULER_LANE_NAME(schuler_model_##name),
const schuler_sensor_model *const SCHULER_LANE_NAME(schuler_model_table)[] = {
#include "schuler_sensor_models.def"
    NULL,
};
#undef X

#define X(name) &SCHULER_LANE_NAME(schuler_stage_##name),
const schuler_sensor_model *const SCHULER_LANE_NAME(schuler_stage_table)[] = {
#include "schuler_sensor_stages.def"
    NULL,
};
#undef X

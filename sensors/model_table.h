/* SPDX-License-Identifier: MIT */
#ifndef SCHULER_SENSORS_MODEL_TABLE_H
#define SCHULER_SENSORS_MODEL_TABLE_H

#include "sensors/model.h"

/* One table for each instruction set of this build. */
#define X(isa)                                                                                     \
    extern const schuler_sensor_model *const schuler_model_table_##isa[];                          \
    extern const schuler_sensor_model *const schuler_stage_table_##isa[];
#include "schuler_isas.def"
#undef X

#endif

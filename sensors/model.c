/* SPDX-License-Identifier: MIT */
#include "sensors/model.h"
#include "sensors/model_table.h"
#include <string.h>

const schuler_sensor_model *const *schuler_sensor_models(schuler_isa isa)
{
    const char *const wanted = schuler_isa_name(isa);
#define X(name)                                                                                    \
    if (strcmp(wanted, #name) == 0) return schuler_model_table_##name;
#include "schuler_isas.def"
#undef X
    return schuler_model_table_scalar;
}

const schuler_sensor_model *const *schuler_sensor_stages(schuler_isa isa)
{
    const char *const wanted = schuler_isa_name(isa);
#define X(name)                                                                                    \
    if (strcmp(wanted, #name) == 0) return schuler_stage_table_##name;
#include "schuler_isas.def"
#undef X
    return schuler_stage_table_scalar;
}

int schuler_sensor_model_find(const char *name)
{
    const schuler_sensor_model *const *const models = schuler_sensor_models(SCHULER_ISA_SCALAR);
    for (int i = 0; models[i]; i++)
        if (strcmp(models[i]->name, name) == 0) return i;
    return -1;
}

const char *schuler_instrument_name(schuler_instrument i)
{
    return i == SCHULER_ACCEL ? "accel" : "gyro";
}

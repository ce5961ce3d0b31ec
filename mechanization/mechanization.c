/* SPDX-License-Identifier: MIT */
#include "mechanization/mechanization.h"
#include "core/earth.h"
#include "mechanization/mechanization_table.h"
#include <math.h>
#include <string.h>

const schuler_mechanization *const *schuler_mechanizations(schuler_isa isa)
{
    const char *const wanted = schuler_isa_name(isa);
#define X(name)                                                                                    \
    if (strcmp(wanted, #name) == 0) return schuler_frame_table_##name;
#include "schuler_isas.def"
#undef X
    return schuler_frame_table_scalar;
}

int schuler_mechanization_find(const char *name)
{
    const schuler_mechanization *const *const frames = schuler_mechanizations(SCHULER_ISA_SCALAR);
    for (int i = 0; frames[i]; i++)
        if (strcmp(frames[i]->name, name) == 0) return i;
    return -1;
}

int schuler_mechanization_ends(const schuler_mechanization *m, schuler_vec3 r_e)
{
    return m->latitude_max_rad > 0.0 &&
           !(fabs(schuler_llh_from_ecef(r_e).lat_rad) <= m->latitude_max_rad);
}

size_t schuler_mechanization_size(const schuler_mechanization *m,
                                  const schuler_coning_algorithm *algorithm)
{
    const size_t group = algorithm && algorithm->samples > 1 ? m->group_size : 0;
    return (m->state_size + group + 63) / 64 * 64;
}

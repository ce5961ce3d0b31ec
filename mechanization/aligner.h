/* SPDX-License-Identifier: MIT */
/* What self-alignment needs of the sensors: the body's attitude and the velocity of specific force, both
 * relative to the inertial frame b0 that the body had at the start. Lane code, one table for each
 * instruction set. Swaying of the body is in both, so it is in neither of the unknowns. */
#ifndef SCHULER_MECHANIZATION_ALIGNER_H
#define SCHULER_MECHANIZATION_ALIGNER_H

#include "mechanization/mechanization.h"

SCHULER_BEGIN_C

typedef struct {
    size_t state_size; /* bytes, aligned to 64, for one vector of lanes */
    void (*init)(void *state);
    void (*advance)(void *state, const schuler_nav_block *block);
    /** C_b_b0 now, and the integral of C_b_b0 f_ib_b since the start, m/s. */
    void (*get)(const void *state, int lane, schuler_quat *q_b_b0, schuler_vec3 *v_b0);
} schuler_aligner;

SCHULER_API const schuler_aligner *schuler_aligner_for(schuler_isa isa);

SCHULER_END_C

#endif

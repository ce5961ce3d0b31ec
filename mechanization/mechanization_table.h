/* SPDX-License-Identifier: MIT */
#ifndef SCHULER_MECHANIZATION_MECHANIZATION_TABLE_H
#define SCHULER_MECHANIZATION_MECHANIZATION_TABLE_H

#include "mechanization/mechanization.h"

/* One table for each instruction set of this build. */
#define X(isa) extern const schuler_mechanization *const schuler_frame_table_##isa[];
#include "schuler_isas.def"
#undef X

#endif

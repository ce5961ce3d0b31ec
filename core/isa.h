/* SPDX-License-Identifier: MIT */
/* Instruction sets that lane code is compiled for. The choice never changes a result, only the
 * time. */
#ifndef SCHULER_CORE_ISA_H
#define SCHULER_CORE_ISA_H

#include "core/error.h"

SCHULER_BEGIN_C

typedef enum {
    SCHULER_ISA_SCALAR, /* one lane: the measure for the others        */
    SCHULER_ISA_SSE2,   /* two lanes; also the portable build          */
    SCHULER_ISA_AVX2,   /* four                                        */
    SCHULER_ISA_AVX512, /* eight                                       */
    SCHULER_ISA_COUNT,
} schuler_isa;

/** The widest this processor and this build can do. */
SCHULER_API schuler_isa schuler_isa_best(void);
/** 1 when this processor and this build have it. */
SCHULER_API int schuler_isa_available(schuler_isa isa);
/** "scalar", "sse2", "avx2", "avx512"; and back (SCHULER_ISA_COUNT when unknown). */
SCHULER_API const char *schuler_isa_name(schuler_isa isa);
SCHULER_API schuler_isa schuler_isa_find(const char *name);
/** Lanes in a vector. */
SCHULER_API int schuler_isa_lanes(schuler_isa isa);

SCHULER_END_C

#endif

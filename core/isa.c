/* SPDX-License-Identifier: MIT */
#include "core/isa.h"
#include <string.h>

static const struct {
    const char *name;
    int lanes;
} isas[SCHULER_ISA_COUNT] = {
    [SCHULER_ISA_SCALAR] = { "scalar", 1 },
    [SCHULER_ISA_SSE2] = { "sse2", 2 },
    [SCHULER_ISA_AVX2] = { "avx2", 4 },
    [SCHULER_ISA_AVX512] = { "avx512", 8 },
};

int schuler_isa_available(schuler_isa isa)
{
    switch (isa) {
    case SCHULER_ISA_SCALAR:
    case SCHULER_ISA_SSE2:
        return 1;
#if defined(__x86_64__)
    case SCHULER_ISA_AVX2:
        return __builtin_cpu_supports("avx2") != 0;
    case SCHULER_ISA_AVX512:
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#endif
    default:
        return 0;
    }
}

schuler_isa schuler_isa_best(void)
{
    for (int isa = SCHULER_ISA_COUNT - 1; isa > 0; isa--)
        if (schuler_isa_available((schuler_isa)isa)) return (schuler_isa)isa;
    return SCHULER_ISA_SCALAR;
}

const char *schuler_isa_name(schuler_isa isa)
{
    return isa < SCHULER_ISA_COUNT ? isas[isa].name : "unknown";
}

schuler_isa schuler_isa_find(const char *name)
{
    for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++)
        if (strcmp(isas[isa].name, name) == 0) return (schuler_isa)isa;
    return SCHULER_ISA_COUNT;
}

int schuler_isa_lanes(schuler_isa isa)
{
    return isa < SCHULER_ISA_COUNT ? isas[isa].lanes : 0;
}

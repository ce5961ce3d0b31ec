/* SPDX-License-Identifier: MIT */
/* A vector of lanes: the native width of the instruction set this file is compiled for. Only
 * included by files that are compiled once per instruction set (schuler_lane_sources in CMake).
 *
 * What may be written here: + - * / on lanes, and the functions below. Nothing else, so that every
 * lane gets the same bits at any width: no libm, no compare but lanes_greater, no reduction across
 * lanes. */
#ifndef SCHULER_CORE_LANES_H
#define SCHULER_CORE_LANES_H

#include <stdint.h>
#include <string.h>

#if !defined(SCHULER_LANES) || !defined(SCHULER_ISA_SUFFIX)
#if defined(SCHULER_BUILDING)
#error "lane code is compiled once per instruction set: add it with schuler_lane_sources()"
#endif
/* In a plug-in (sensors/plugin.h). */
#define SCHULER_LANES      1
#define SCHULER_ISA_SUFFIX plugin
#endif

#if SCHULER_LANES == 1
typedef double lanes;
typedef uint64_t lanes_u64;
#else
typedef double lanes __attribute__((vector_size(8 * SCHULER_LANES)));
typedef uint64_t lanes_u64 __attribute__((vector_size(8 * SCHULER_LANES)));
#endif

#if SCHULER_LANES > 1 && defined(__x86_64__)
#include <immintrin.h>
#elif SCHULER_LANES >= 1
#include <math.h>
#endif

/* NAME -> NAME_avx512 and so on: one symbol per instruction set. */
#define SCHULER_PASTE_(a, b)    a##_##b
#define SCHULER_PASTE(a, b)     SCHULER_PASTE_(a, b)
#define SCHULER_LANE_NAME(name) SCHULER_PASTE(name, SCHULER_ISA_SUFFIX)

#define LANES_INLINE static inline __attribute__((always_inline, unused))

/* The same number in every lane. Subtracting zero is exact and folds to one broadcast. */
LANES_INLINE lanes lanes_set(double x)
{
    return x - (lanes){ 0 };
}

LANES_INLINE lanes_u64 lanes_u64_set(uint64_t x)
{
    return x - (lanes_u64){ 0 };
}

LANES_INLINE lanes lanes_load(const double *p)
{
    lanes x;
    memcpy(&x, __builtin_assume_aligned(p, sizeof(lanes)), sizeof(x));
    return x;
}

LANES_INLINE void lanes_store(double *p, lanes x)
{
    memcpy(__builtin_assume_aligned(p, sizeof(lanes)), &x, sizeof(x));
}

LANES_INLINE lanes lanes_from_bits(lanes_u64 bits)
{
    lanes x;
    memcpy(&x, &bits, sizeof(x));
    return x;
}

LANES_INLINE lanes_u64 lanes_bits(lanes x)
{
    lanes_u64 bits;
    memcpy(&bits, &x, sizeof(bits));
    return bits;
}

LANES_INLINE lanes lanes_sqrt(lanes x)
{
#if SCHULER_LANES == 1
    return sqrt(x);
#elif defined(__x86_64__) && SCHULER_LANES == 2
    return (lanes)_mm_sqrt_pd((__m128d)x);
#elif defined(__x86_64__) && SCHULER_LANES == 4
    return (lanes)_mm256_sqrt_pd((__m256d)x);
#elif defined(__x86_64__) && SCHULER_LANES == 8
    return (lanes)_mm512_sqrt_pd((__m512d)x);
#else
    for (int i = 0; i < SCHULER_LANES; i++) x[i] = sqrt(x[i]);
    return x;
#endif
}

/* All bits set where a > b. */
LANES_INLINE lanes_u64 lanes_greater(lanes a, lanes b)
{
#if SCHULER_LANES == 1
    return a > b ? ~(uint64_t)0 : 0;
#else
    return (lanes_u64)(a > b);
#endif
}

/* a where the bits of mask are set, b where they are not. */
LANES_INLINE lanes lanes_select(lanes_u64 mask, lanes a, lanes b)
{
    return lanes_from_bits((lanes_bits(a) & mask) | (lanes_bits(b) & ~mask));
}

LANES_INLINE lanes lanes_max(lanes a, lanes b)
{
    return lanes_select(lanes_greater(a, b), a, b);
}

LANES_INLINE lanes lanes_min(lanes a, lanes b)
{
    return lanes_select(lanes_greater(a, b), b, a);
}

LANES_INLINE lanes lanes_abs(lanes x)
{
    return lanes_from_bits(lanes_bits(x) & lanes_u64_set(~(1ULL << 63)));
}

LANES_INLINE lanes lanes_copysign(lanes magnitude, lanes sign)
{
    const lanes_u64 bit = lanes_u64_set(1ULL << 63);
    return lanes_from_bits((lanes_bits(magnitude) & ~bit) | (lanes_bits(sign) & bit));
}

/* To the nearest whole number, ties to even, |x| < 2^51. */
LANES_INLINE lanes lanes_round(lanes x)
{
    const lanes magic = lanes_set(6755399441055744.0); /* 1.5 * 2^52 */
    return (x + magic) - magic;
}

#endif

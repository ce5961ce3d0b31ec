/* SPDX-License-Identifier: MIT */
/* Random numbers as a pure function of (seed, run, source, axis, use, index): Threefry2x64-20 as a
 * counter-based generator. No state, so order, lanes, threads and machines do not matter. This is
 * the scalar door, for values drawn once per run; lane code has core/normal.h with the same
 * numbers.
 *
 * Key   = (seed, run).
 * Counter = (index, source << 16 | axis << 8 | use).
 * One call gives two 64-bit words; each word gives two normals (Box-Muller: high 32 bits the
 * radius, next 31 the angle, last one the sign). So index i of a stream of normals holds numbers 4i
 * .. 4i+3. */
#ifndef SCHULER_CORE_RANDOM_H
#define SCHULER_CORE_RANDOM_H

#include "core/api.h"
#include <stdint.h>

SCHULER_BEGIN_C

/* What a stream is used for. Never renumbered. */
typedef enum {
    SCHULER_USE_DRAW = 0,  /* values drawn once per run                     */
    SCHULER_USE_WHITE = 1, /* white noise at the full rate                  */
    SCHULER_USE_SLOW = 2,  /* drives of processes that have a memory        */
    SCHULER_USE_START = 3, /* stationary start of a process                 */
} schuler_use;

typedef struct {
    uint64_t seed, run;
    unsigned source; /* source number, < 2^32 */
    unsigned axis;   /* < 256 */
    schuler_use use;
} schuler_stream;

/** Threefry2x64-20 block function: counter c, key k -> two words. Random123's known answers hold.
 */
SCHULER_API void schuler_threefry2x64(const uint64_t c[2], const uint64_t k[2], uint64_t out[2]);

/** Number n of the stream: standard normal (|x| < 6.8), or uniform in (-1, 1). */
SCHULER_API double schuler_stream_normal(schuler_stream s, uint64_t n);
SCHULER_API double schuler_stream_uniform(schuler_stream s, uint64_t n);

SCHULER_END_C

#endif

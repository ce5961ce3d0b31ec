/* SPDX-License-Identifier: MIT */
/* The scalar door is the lane code at one lane: there is no second implementation to disagree with.
 */
#define SCHULER_LANES      1
#define SCHULER_ISA_SUFFIX one
#include "core/normal.h"

void schuler_threefry2x64(const uint64_t c[2], const uint64_t k[2], uint64_t out[2])
{
    lanes_threefry(c[0], c[1], k[0], k[1], &out[0], &out[1]);
}

double schuler_stream_normal(schuler_stream s, uint64_t n)
{
    lanes four[4];
    lanes_normals(s.seed, s.run, stream_counter(s.source, s.axis, s.use), n / 4, 1, four);
    return four[n % 4];
}

double schuler_stream_uniform(schuler_stream s, uint64_t n)
{
    uint64_t words[2];
    const uint64_t counter[2] = { n / 2, stream_counter(s.source, s.axis, s.use) };
    const uint64_t key[2] = { s.seed, s.run };
    schuler_threefry2x64(counter, key, words);
    /* The middle of one of 2^52 equal cells of (-1, 1): never an end, symmetric about zero. */
    return ((double)(words[n % 2] >> 12) + 0.5) * 0x1p-51 - 1.0;
}

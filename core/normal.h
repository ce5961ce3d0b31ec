/* SPDX-License-Identifier: MIT */
/* Threefry2x64-20 and normal numbers on lanes: the vector twin of core/random.h, same numbers. */
#ifndef SCHULER_CORE_NORMAL_H
#define SCHULER_CORE_NORMAL_H

#include "core/lanes.h"
#include "core/random.h"

/* Counter words are built in one place only. */
LANES_INLINE uint64_t stream_counter(unsigned source, unsigned axis, schuler_use use)
{
    return (uint64_t)source << 16 | (uint64_t)axis << 8 | (uint64_t)use;
}

LANES_INLINE lanes_u64 lanes_rotate(lanes_u64 x, int n)
{
    return x << n | x >> (64 - n);
}

/* J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel random numbers: as easy as 1, 2,
 * 3", SC'11: rotation constants of Threefry2x64, key schedule of Skein. c0, c1 counter; k0, k1 key.
 */
LANES_INLINE void lanes_threefry(lanes_u64 c0, lanes_u64 c1, lanes_u64 k0, lanes_u64 k1,
                                 lanes_u64 *out0, lanes_u64 *out1)
{
    const lanes_u64 key[3] = { k0, k1, lanes_u64_set(0x1BD11BDAA9FC1A22ULL) ^ k0 ^ k1 };
    lanes_u64 x = c0 + key[0], y = c1 + key[1];
#define ROUND(r)  x += y, y = lanes_rotate(y, r) ^ x
#define INJECT(n) x += key[(n) % 3], y += key[((n) + 1) % 3] + lanes_u64_set(n)
    ROUND(16), ROUND(42), ROUND(12), ROUND(31), INJECT(1);
    ROUND(16), ROUND(32), ROUND(24), ROUND(21), INJECT(2);
    ROUND(16), ROUND(42), ROUND(12), ROUND(31), INJECT(3);
    ROUND(16), ROUND(32), ROUND(24), ROUND(21), INJECT(4);
    ROUND(16), ROUND(42), ROUND(12), ROUND(31), INJECT(5);
#undef ROUND
#undef INJECT
    *out0 = x;
    *out1 = y;
}

/* Two normals from one word: high 32 bits the radius, next 31 the angle, last one the sign.
 *
 * Radius sqrt(-2 ln u), u = (high + 1/2) / 2^32: never 0 or 1, tail to 6.76 sigma. ln by splitting
 * off the exponent so that the mantissa lies in [sqrt(1/2), sqrt(2)), then f P9(f), f = mantissa -
 * 1, relative error 5e-9. Angle 2 phi with |phi| <= pi/4: sin and cos of phi by short polynomials
 * (3e-9, 7e-11) and the double-angle formula cover half the circle, the sign bit the other half. No
 * compare, no octants. Polynomials: interpolation at the Chebyshev points of the interval. */
LANES_INLINE void lanes_box_muller(lanes_u64 word, lanes *n0, lanes *n1)
{
    const lanes_u64 two52 =
        lanes_u64_set(0x4330000000000000ULL); /* 2^52: low bits are an integer */
    const lanes high =
        (lanes_from_bits(word >> 32 | two52) - lanes_set(4503599627370496.0)) + lanes_set(0.5);

    /* 64 << 52 keeps the difference positive; it is taken off again with the 32 of the 2^32. */
    const lanes_u64 root_half = lanes_u64_set(0x3FE6A09E667F3BCDULL); /* bits of sqrt(1/2) */
    const lanes_u64 shifted = lanes_bits(high) - root_half + lanes_u64_set(64ULL << 52);
    const lanes exponent =
        lanes_from_bits(shifted >> 52 | two52) - lanes_set(4503599627370496.0 + 64.0 + 32.0);
    const lanes mantissa =
        lanes_from_bits((shifted & lanes_u64_set(0x000FFFFFFFFFFFFFULL)) + root_half);
    const lanes f = mantissa - lanes_set(1.0);
    lanes p = lanes_set(-0.07451186226757509);
    p = p * f + lanes_set(0.12806610435006952);
    p = p * f + lanes_set(-0.1326603136091708);
    p = p * f + lanes_set(0.14199650097916022);
    p = p * f + lanes_set(-0.16608369414088409);
    p = p * f + lanes_set(0.20000939440373094);
    p = p * f + lanes_set(-0.2500157909915946);
    p = p * f + lanes_set(0.33333345349807464);
    p = p * f + lanes_set(-0.49999988496142866);
    p = p * f + lanes_set(0.999999999383255);
    const lanes log_u = exponent * lanes_set(0.69314718055994530942) + p * f;
    const lanes radius = lanes_sqrt(log_u * lanes_set(-2.0));

    const lanes_u64 angle = word >> 1 & lanes_u64_set(0x7FFFFFFFULL);
    /* (angle + 1/2 - 2^30) pi/4 / 2^30 */
    const lanes phi =
        (lanes_from_bits(angle | two52) - lanes_set(4503599627370496.0 + 1073741824.0 - 0.5)) *
        lanes_set(7.314590396335798e-10);
    const lanes q = phi * phi;
    lanes s = lanes_set(-0.000195039042508408);
    s = s * q + lanes_set(0.00833203578559731);
    s = s * q + lanes_set(-0.16666650673996775);
    s = (s * q + lanes_set(0.9999999969177036)) * phi;
    lanes c = lanes_set(2.4379831251175367e-05);
    c = c * q + lanes_set(-0.0013886617999647076);
    c = c * q + lanes_set(0.041666616692532826);
    c = c * q + lanes_set(-0.4999999961485761);
    c = c * q + lanes_set(0.9999999999524894);
    const lanes signed_radius = lanes_from_bits(lanes_bits(radius) | word << 63);
    const lanes twice = s + s;
    *n0 = signed_radius * (lanes_set(1.0) - twice * s);
    *n1 = signed_radius * (twice * c);
}

enum { LANES_NORMALS_MAX = 64 }; /* numbers in one call below */

/* Numbers 4 index .. 4 index + 4 count - 1 of a stream whose run differs from lane to lane. Two
 * passes, words first: one fused chain is too long for the reorder window to overlap with the next.
 */
LANES_INLINE void lanes_normals(uint64_t seed, lanes_u64 run, uint64_t counter, uint64_t index,
                                int count, lanes *out)
{
    lanes_u64 words[LANES_NORMALS_MAX / 2];
    for (int i = 0; i < count; i++)
        lanes_threefry(lanes_u64_set(index + (uint64_t)i), lanes_u64_set(counter),
                       lanes_u64_set(seed), run, &words[2 * i], &words[2 * i + 1]);
    for (int i = 0; i < 2 * count; i++) lanes_box_muller(words[i], &out[2 * i], &out[2 * i + 1]);
}

#endif

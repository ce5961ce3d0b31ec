/* SPDX-License-Identifier: MIT */
#include "scenarios/bootstrap.h"
#include "core/random.h"

/* The interval is a property of the runs, so its luck must not depend on the scenario's seed. */
static const uint64_t BOOTSTRAP_SEED = 0x626f6f7473747261u;

/* One block of the generator gives four numbers of 32 bits; scaling them to n < 2^17 runs favours none by
 * more than 2^-15. */
void schuler_resample(int n, uint64_t k, int *run)
{
    const uint64_t key[2] = { BOOTSTRAP_SEED, k };
    for (int i = 0; i < n; i += 4) {
        const uint64_t counter[2] = { (uint64_t)i, 0 };
        uint64_t word[2];
        schuler_threefry2x64(counter, key, word);
        for (int j = 0; j < 4 && i + j < n; j++) {
            const uint64_t bits = (word[j / 2] >> (32 * (j % 2))) & 0xffffffffu;
            run[i + j] = (int)((bits * (uint64_t)n) >> 32);
        }
    }
}

/* SPDX-License-Identifier: MIT */
#include "mechanization/algorithms.h"
#include <stddef.h>
#include <string.h>

#define OPTIMAL(N, PAIRS)                                                                          \
    {                                                                                              \
        .name = "optimal_" #N, .summary = #N " samples, optimal in pure coning",                   \
        .source = "R. B. Miller, J. Guidance 6(4), 1983; M. B. Ignagni, J. Guidance 13(2), 1990; " \
                  "J. G. Lee et al., J. Guidance 13(6), 1990",                                     \
        .order = 4, .samples = N, .pair = PAIRS, .law = OPTIMAL_##N                                \
    }
#define TAYLOR(N, DEGREE, PAIRS)                                                                   \
    {                                                                                              \
        .name = "taylor_" #N, .summary = #N " samples, exact for rates of degree " #DEGREE,        \
        .source = "time-Taylor series of the rotation vector; derived", .order = 4, .samples = N,  \
        .pair = PAIRS, .law = "any motion: that of a rate of degree " #DEGREE " over the group"    \
    }

/* h is the time of a group, W the coning frequency, a the half angle. */
#define OPTIMAL_2 "coning: a^2 W (W h)^4/960"
#define OPTIMAL_3 "coning: a^2 W (W h)^6/204120; other motion: not exact, assumes coning"
#define OPTIMAL_4 "coning: a^2 W (W h)^8/82575360; other motion: not exact, assumes coning"
#define OPTIMAL_5 "coning: a^2 W (W h)^10/54140625000; other motion: not exact, assumes coning"

/* Braces and commas cannot be arguments of a macro as they stand. */
#define PAIRS_2                                                                                    \
    {                                                                                              \
        [1] = { 2.0 / 3.0 }                                                                        \
    }
#define PAIRS_3                                                                                    \
    {                                                                                              \
        [2] = { 9.0 / 20.0, 27.0 / 20.0 }                                                          \
    }
#define PAIRS_4                                                                                    \
    {                                                                                              \
        [3] = { 54.0 / 105.0, 92.0 / 105.0, 214.0 / 105.0 }                                        \
    }
#define PAIRS_5                                                                                    \
    {                                                                                              \
        [4] = { 125.0 / 252.0, 25.0 / 24.0, 325.0 / 252.0, 1375.0 / 504.0 }                        \
    }
#define TAYLOR_PAIRS_3                                                                             \
    {                                                                                              \
        [1] = { 57.0 / 80.0 }, [2] = { 33.0 / 80.0, 57.0 / 80.0 }                                  \
    }
#define TAYLOR_PAIRS_4                                                                             \
    {                                                                                              \
        [1] = { 736.0 / 945.0 }, [2] = { 334.0 / 945.0, 654.0 / 945.0 }, [3] = {                   \
            526.0 / 945.0,                                                                         \
            334.0 / 945.0,                                                                         \
            736.0 / 945.0                                                                          \
        }                                                                                          \
    }

const schuler_coning_algorithm schuler_coning_algorithms[] = {
    { .name = "cubic",
      .summary = "recursion over four samples: exact for rates of degree 3",
      .source = "P. G. Savage's recursion, J. Guidance 21(1), 1998, carried to the cubic; derived",
      .law =
          "coning: 37/1512 a^2 W (W h)^6, h the interval of the samples; any motion: of order h^6",
      .order = 4,
      .samples = 1 },
    { .name = "previous",
      .summary = "this sample and the previous one: exact for rates that change linearly",
      .source = "P. G. Savage, J. Guidance 21(1), 1998",
      .law = "coning: a^2 W (W h)^4/60, h the interval of the samples; any motion: of order h^4",
      .order = 2,
      .samples = 1 },
    { .name = "none",
      .summary = "no correction: the sum of the increments is the rotation",
      .source = "for comparison",
      .law = "coning: a^2 W/2 (1 - sin(W h)/(W h)), h the interval of the samples",
      .order = 1,
      .samples = 1 },
    OPTIMAL(2, PAIRS_2),
    OPTIMAL(3, PAIRS_3),
    OPTIMAL(4, PAIRS_4),
    OPTIMAL(5, PAIRS_5),
    TAYLOR(3, 2, TAYLOR_PAIRS_3),
    TAYLOR(4, 3, TAYLOR_PAIRS_4),
    { .name = NULL },
};

int schuler_coning_algorithm_find(const char *name)
{
    for (int i = 0; schuler_coning_algorithms[i].name; i++)
        if (strcmp(schuler_coning_algorithms[i].name, name) == 0) return i;
    return -1;
}

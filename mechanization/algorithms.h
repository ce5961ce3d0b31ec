/* SPDX-License-Identifier: MIT */
/* Attitude algorithms by name: what corrects sums of increments for the body's rotation in between. */
#ifndef SCHULER_MECHANIZATION_ALGORITHMS_H
#define SCHULER_MECHANIZATION_ALGORITHMS_H

#include "core/api.h"

SCHULER_BEGIN_C

enum { SCHULER_GROUP_MAX = 5 };

typedef struct {
    const char *name, *summary, *source;
    const char *law; /* of its error in pure coning, and in other motion      */
    int order;       /* of the recursion at every sample: 1 (none), 2 or 4     */
    int samples;     /* in a group; 1: the recursion alone                     */
    double pair[SCHULER_GROUP_MAX][SCHULER_GROUP_MAX]; /* pair[j][i], i < j: of d_i x d_j */
} schuler_coning_algorithm;

/** All of them, ended by name NULL; the first is the default. */
SCHULER_API extern const schuler_coning_algorithm schuler_coning_algorithms[];
/** The index of one, or -1. */
SCHULER_API int schuler_coning_algorithm_find(const char *name);

SCHULER_END_C

#endif

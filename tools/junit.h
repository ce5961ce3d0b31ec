/* SPDX-License-Identifier: MIT */
/* Verdicts as JUnit XML, which continuous-integration systems read. */
#ifndef SCHULER_TOOLS_JUNIT_H
#define SCHULER_TOOLS_JUNIT_H

#include "scenarios/simulation.h"
#include <stdio.h>

typedef struct {
    const char *file, *name; /* of the scenario; name NULL: it could not be simulated */
    char message[200];
    double seconds;
    schuler_judgement judgement;
} verified;

typedef struct {
    size_t count;
    verified *items;
} verification;

/** One test case a file: a failure when the requirement is not met, an error when it could not be told. what
 *  is a verification. */
void junit_put(FILE *out, const void *what);

#endif

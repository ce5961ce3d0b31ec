/* SPDX-License-Identifier: MIT */
/* Reading the command line with argp: usage errors end the program with status 2. */
#ifndef SCHULER_TOOLS_ARGUMENTS_H
#define SCHULER_TOOLS_ARGUMENTS_H

#include "core/units.h"
#include <argp.h>
#include <stdint.h>

/* Last lines of every verb's --help. */
#define ARGUMENTS_EXIT_STATUS                                                                      \
    "\nExit status: 0 done, 2 bad command line or input, 3 failed while running."
#define ARGUMENTS_VERDICT_STATUS                                                                   \
    "\nExit status: 0 done and the requirement met if there is one, 1 not met, 2 bad "             \
    "command line or input, 3 failed while running, 4 too few runs to tell, 130 interrupted."

/** argp_parse, with "did you mean" for an unknown long option. Does not come back from --help or
 * from a usage error. */
void arguments_parse(const struct argp *argp, int argc, char **argv, void *input);

/** The value of an option as a whole number in [min, max]; a usage error when it is none. */
int64_t arguments_integer(struct argp_state *state, const char *option, const char *text,
                          int64_t min, int64_t max);
/** The option's value with its unit, in SI, in [least, most]; a usage error when it is none. */
double arguments_quantity(struct argp_state *state, const char *option, const char *text,
                          schuler_dim dim, double least, double most);
/** The option's value as a position in a NULL-terminated list of words; a usage error that lists
 * them. */
int arguments_choice(struct argp_state *state, const char *option, const char *text,
                     const char *const *words);
/** A usage error that takes a wrong name and the known ones: "unknown WHAT 'x'; did you mean 'y'?".
 */
void arguments_unknown(struct argp_state *state, const char *what, const char *written,
                       const char *const *known);

#endif

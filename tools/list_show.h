/* SPDX-License-Identifier: MIT */
/* Command line of the verbs that list something or show one of it: [list] or show NAME. */
#ifndef SCHULER_TOOLS_LIST_SHOW_H
#define SCHULER_TOOLS_LIST_SHOW_H

#include <argp.h>

typedef struct {
    const char *what;   /* "part", "model"; given                       */
    const char *action; /* "list" (also when nothing is said) or "show" */
    const char *name;   /* of the one to show; NULL for list            */
} list_show_arguments;

/** An argp parser; its input is a list_show_arguments. */
error_t list_show_parse(int key, char *arg, struct argp_state *state);

#endif

/* SPDX-License-Identifier: MIT */
#include "tools/list_show.h"
#include "tools/arguments.h"
#include <string.h>

error_t list_show_parse(int key, char *arg, struct argp_state *state)
{
    static const char *const actions[] = { "list", "show", NULL };
    list_show_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        if (!a->action)
            a->action = actions[arguments_choice(state, "the action", arg, actions)];
        else if (!a->name && strcmp(a->action, "show") == 0)
            a->name = arg;
        else
            argp_error(state, "too many arguments: '%s'", arg);
        return 0;
    case ARGP_KEY_END:
        if (!a->action) a->action = actions[0];
        if (strcmp(a->action, "show") == 0 && !a->name)
            argp_error(state, "show which %s? '%s list' lists them", a->what, state->name);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

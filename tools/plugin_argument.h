/* SPDX-License-Identifier: MIT */
/* --plugin FILE.so, for verbs that read scenarios or list models. */
#ifndef SCHULER_TOOLS_PLUGIN_ARGUMENT_H
#define SCHULER_TOOLS_PLUGIN_ARGUMENT_H

#include "sensors/plugins.h"
#include <argp.h>

/* A row of a verb's table of options. */
#define PLUGIN_OPTION(KEY)                                                                         \
    {                                                                                              \
        "plugin", KEY, "FILE.so", 0, "with the error models of a plug-in too", 0                   \
    }

/** Load what the option names into a set (sensors/plugins.h), which the verb frees at its end. Says
 *  what is wrong and ends the program with status 2, as for any wrong value of an option. */
void plugin_argument(schuler_plugins **set, const char *file);

#endif

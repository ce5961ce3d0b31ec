/* SPDX-License-Identifier: MIT */
#include "tools/plugin_argument.h"
#include "tools/messages.h"
#include <stdlib.h>

void plugin_argument(schuler_plugins **set, const char *file)
{
    schuler_error error = { 0 };
    const schuler_status status = schuler_plugins_load(set, file, &error);
    if (status == SCHULER_OK) return;
    say_error(&error);
    exit((int)exit_of(status));
}
